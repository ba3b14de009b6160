#include "window/timeline/mode_charts.h"

#include <optional>

#include "window/timeline/volume_panel.h"
#include "window/window_layout.h"

namespace viscera::app {

ModeCharts::ModeCharts(ModeController& modes, VolumePanel* volumes, WindowLayout& layout)
    : modes_(modes), volumes_(volumes), layout_(layout) {
  addWidget(volumes);
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
  QWidget* own = ofModes_[static_cast<std::size_t>(modes_.index())];
  const bool wanted = modes_.present().chartWanted();
  setCurrentWidget(wanted ? own : volumes_);
  layout_.fitCharts(wanted && own != volumes_ ? std::optional(own->sizeHint().height())
                                              : volumes_->wantedHeight());
}

} // namespace viscera::app
