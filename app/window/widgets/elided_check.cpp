#include "window/widgets/elided_check.h"

#include <QStyleOptionButton>
#include <QStylePainter>

#include <algorithm>

namespace viscera::app {
namespace {

constexpr int kFewestShownLetters = 8;

} // namespace

ElidedCheck::ElidedCheck(const QString& text, const QString& tip, QWidget* parent)
    : QCheckBox(text, parent), tip_(tip) {
  setToolTip(tip);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed, QSizePolicy::CheckBox);
  setSizePolicy(policy);
}

QSize ElidedCheck::minimumSizeHint() const {
  const QSize whole = sizeHint();
  const int beside = whole.width() - fontMetrics().size(Qt::TextShowMnemonic, text()).width();
  return {std::min(whole.width(), beside + kFewestShownLetters * fontMetrics().averageCharWidth()),
          whole.height()};
}

QString ElidedCheck::shownText() const {
  QStyleOptionButton option;
  initStyleOption(&option);
  const int room = style()->subElementRect(QStyle::SE_CheckBoxContents, &option, this).width();
  return fontMetrics().elidedText(text(), Qt::ElideMiddle, room, Qt::TextShowMnemonic);
}

void ElidedCheck::resizeEvent(QResizeEvent* event) {
  QCheckBox::resizeEvent(event);
  setToolTip(shownText() == text() ? tip_ : text() + QLatin1Char('\n') + tip_);
}

void ElidedCheck::paintEvent(QPaintEvent*) {
  QStyleOptionButton option;
  initStyleOption(&option);
  option.text = shownText();
  QStylePainter(this).drawControl(QStyle::CE_CheckBox, option);
}

} // namespace viscera::app
