#include "window/circulation/circulation_panel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "window/circulation/numbers_table.h"
#include "window/timeline/person_box.h"
#include "window/view/view_model.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr int kNumbersWidth = 372;
} // namespace

CirculationPanel::CirculationPanel(CirculationModel& model, Playback& playback, VolumeMonitor& volumes,
                                   ViewModel& view, QWidget* parent)
    : QWidget(parent), model_(model), charts_(new CirculationCharts(model, playback, volumes, this)),
      numbers_(new NumbersTable(this)) {
  setObjectName(QStringLiteral("panel"));
  setAttribute(Qt::WA_StyledBackground);
  auto* row = makeLayout<QHBoxLayout>(this, 8, {8, 4, 8, 4});
  row->addWidget(charts_, 1);
  auto* numbers = makeLayout<QVBoxLayout>(nullptr, 2);
  numbers->addWidget(numbers_, 1);
  numbers->addWidget(new PersonBox(view, this));
  row->addLayout(numbers);
  numbers_->setFixedWidth(kNumbersWidth);
  numbers_->setPerson(view.state().person);
  connect(&model, &CirculationModel::changed, this, &CirculationPanel::showNumbers);
  connect(&view, &ViewModel::changed, this, [this, &view] {
    numbers_->setPerson(view.state().person);
    showNumbers();
  });
}

void CirculationPanel::setTheme(const Theme& theme) {
  Theme here = theme;
  here.lecture = false; // A lecture has charts of its own.
  charts_->setTheme(here);
  numbers_->setTheme(theme);
}

void CirculationPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showNumbers();
}

void CirculationPanel::showNumbers() {
  if (!isVisible())
    return;
  const CirculationModel::Shown* present = model_.present();
  const CirculationModel::Shown* kept = model_.kept();
  numbers_->setIndices(present ? &present->indices : nullptr, kept ? &kept->indices : nullptr);
}

} // namespace viscera::app
