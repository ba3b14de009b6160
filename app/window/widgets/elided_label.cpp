#include "window/widgets/elided_label.h"

#include <QResizeEvent>

namespace viscera::app {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  setTextFormat(Qt::PlainText);
}

void ElidedLabel::setFullText(const QString& text) {
  if (text == full_)
    return;
  full_ = text;
  setToolTip(text);
  updateGeometry();
  elide();
}

int ElidedLabel::widthFor(const QString& text) const {
  // The advance is rounded: half a pixel less would cut the last letters off.
  return fontMetrics().horizontalAdvance(text) + width() - contentsRect().width() + 1;
}

QSize ElidedLabel::sizeHint() const {
  return {widthFor(full_), QLabel::sizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  elide();
}

} // namespace viscera::app
