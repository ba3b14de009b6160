#include "window/widgets/wrapped_label.h"

#include <QPainter>
#include <QTextLayout>

#include <algorithm>
#include <cmath>

namespace viscera::app {
namespace {

/// A label that may break words asks for that many letters in a line.
constexpr int kFewestLetters = 18;

} // namespace

WrappedLabel::WrappedLabel(const QString& text, QWidget* parent) : QLabel(text, parent) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
}

QSize WrappedLabel::around() const {
  return size() - contentsRect().size() + QSize(2 * margin(), 2 * margin());
}

bool WrappedLabel::breaksWords(int width) const {
  return QLabel::minimumSizeHint().width() > width; // Qt's is as wide as the longest word.
}

double WrappedLabel::layOut(QTextLayout& lines, int width) const {
  QTextOption option(alignment());
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  lines.setTextOption(option);
  double height = 0;
  lines.beginLayout();
  for (QTextLine line = lines.createLine(); line.isValid(); line = lines.createLine()) {
    line.setLineWidth(std::max(1, width - around().width()));
    line.setPosition({0, height});
    height += line.height();
  }
  lines.endLayout();
  return height;
}

int WrappedLabel::heightForWidth(int width) const {
  ensurePolished();
  if (!breaksWords(width))
    return QLabel::heightForWidth(width);
  QString said = text();
  QTextLayout lines(said.replace(QLatin1Char('\n'), QChar::LineSeparator), font());
  return static_cast<int>(std::ceil(layOut(lines, width))) + around().height();
}

QSize WrappedLabel::sizeHint() const {
  const QSize narrow = minimumSizeHint();
  const QSize wanted = QLabel::sizeHint();
  return breaksWords(wanted.width()) ? QSize(narrow.width(), heightForWidth(narrow.width())) : wanted;
}

QSize WrappedLabel::minimumSizeHint() const {
  const QSize whole = QLabel::minimumSizeHint();
  const int few = kFewestLetters * fontMetrics().averageCharWidth() + around().width();
  return {std::min(whole.width(), few), whole.height()};
}

void WrappedLabel::paintEvent(QPaintEvent* event) {
  if (!breaksWords(width()))
    return QLabel::paintEvent(event);
  QString said = text();
  QTextLayout lines(said.replace(QLatin1Char('\n'), QChar::LineSeparator), font());
  const double height = layOut(lines, width());
  QPainter painter(this);
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, foregroundRole()));
  const QRect room = contentsRect().adjusted(margin(), margin(), -margin(), -margin());
  const double above = alignment() & Qt::AlignVCenter ? std::max(0.0, (room.height() - height) / 2) : 0;
  lines.draw(&painter, QPointF(room.left(), room.top() + above));
}

} // namespace viscera::app
