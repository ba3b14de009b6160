#include "window/widgets/elided_label.h"

#include <QResizeEvent>

namespace viscera::app {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  setTextFormat(Qt::PlainText);
}

void ElidedLabel::setFullText(const QString& text, const QStringList& shorter) {
  if (text == full_ && shorter == shorter_)
    return;
  full_ = text;
  shorter_ = shorter;
  setToolTip(text);
  updateGeometry();
  elide();
}

void ElidedLabel::setFewestLetters(int letters) {
  fewest_ = letters;
  elide();
}

/// The last pixel is the one that `widthFor` adds: with it, the ellipsis would lose a dot.
void ElidedLabel::elide() {
  ensurePolished(); // A style sheet's padding and font leave less room.
  const int room = contentsRect().width() - 1;
  QString shown = full_;
  for (const QString& form : shorter_)
    if (fontMetrics().horizontalAdvance(shown) > room)
      shown = form;
  if (fontMetrics().horizontalAdvance(shown) <= room)
    return setText(shown);
  const QString elided = fontMetrics().elidedText(shown, Qt::ElideRight, room);
  setText(elided.size() <= fewest_ ? QString() : elided);
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

void ElidedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    elide();
}

} // namespace viscera::app
