#include "window/modes/mode_charts.h"

#include <optional>

#include "window/modes/window_layout.h"
#include "window/strain/strain_panel.h"
#include "window/timeline/volume_panel.h"

namespace viscera::app {

ModeCharts::ModeCharts(ModeController& modes, VolumePanel* volumes, StrainPanel* strain, WindowLayout& layout)
    : modes_(modes), volumes_(volumes), strain_(strain), layout_(layout) {
  addWidget(volumes);
  addWidget(strain);
  connect(strain, &StrainPanel::wantedChanged, this, &ModeCharts::follow);
  connect(volumes, &VolumePanel::wantedHeightChanged, this, &ModeCharts::follow);
  for (const auto& mode : modes.all()) {
    QWidget* own = mode->makeChart();
    if (own)
      addWidget(own);
    ofModes_.push_back(own ? own : volumes);
    connect(mode.get(), &Mode::chartWantedChanged, this, &ModeCharts::follow);
  }
  connect(&modes, &ModeController::changed, this, &ModeCharts::follow);
}

void ModeCharts::follow() {
  const bool ownWanted = modes_.present().chartWanted();
  QWidget* shown = strain_->wanted() ? strain_
                   : ownWanted       ? ofModes_[static_cast<std::size_t>(modes_.index())]
                                     : volumes_;
  setCurrentWidget(shown);
  layout_.fitCharts(shown == volumes_ ? volumes_->wantedHeight() : std::optional(shown->sizeHint().height()));
}

} // namespace viscera::app
