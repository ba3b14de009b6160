#include "click_mode.h"

#include <QLabel>

namespace viscera::app {

ClickMode::ClickMode(const ModeParts& parts)
    : Mode(parts, {"click", "explore", Qt::Key_6, tr("Click"),
                   tr("Click an organ to read the place in millimetres")}) {}

QWidget* ClickMode::makePage(const Actions&) {
  said_ = new QLabel(tr("Nothing was clicked"));
  return said_;
}

void ClickMode::click(const ClickedPlace* place) {
  Mode::click(place); // Selects the organ, as in every mode.
  if (place && said_)
    said_->setText(tr("%1, %2, %3 mm (LPS)")
                       .arg(place->position.x(), 0, 'f', 1)
                       .arg(place->position.y(), 0, 'f', 1)
                       .arg(place->position.z(), 0, 'f', 1));
}

} // namespace viscera::app
