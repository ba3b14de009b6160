#include "window/view/view_area.h"

#include <QGridLayout>
#include <QLabel>
#include <QTimer>

#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr int kViewMargin = 12;
constexpr int kBetweenViews = 4;
constexpr int kBetweenSlices = 2;
constexpr int kBadgeMilliseconds = 4000;
} // namespace

ViewArea::ViewArea(QWidget* parent)
    : QWidget(parent), grid_(new QGridLayout(this)), views_(new QWidget(this)), view_(new ViewWidget(views_)),
      four_(makeLayout<QGridLayout>(nullptr, kBetweenSlices)), messages_(new MessageBar(this)),
      badge_(new QLabel(this)), badgeTimer_(new QTimer(this)) {
  setObjectName(QStringLiteral("central"));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(0);
  // The view fills all nine cells; the inner ones hold what lies over it, away from the edges.
  for (const int edge : {0, 2}) {
    grid_->setRowMinimumHeight(edge, kViewMargin);
    grid_->setColumnMinimumWidth(edge, kViewMargin);
  }
  grid_->setRowStretch(1, 1);
  grid_->setColumnStretch(1, 1);
  auto* column = makeLayout<QVBoxLayout>(nullptr, 0);
  four_->addWidget(view_, 0, 1);
  column->addLayout(four_, 1);
  auto* row = makeLayout<QHBoxLayout>(views_, kBetweenViews);
  row->addLayout(column, 1);
  grid_->addWidget(views_, 0, 0, 3, 3);
  grid_->addWidget(messages_, 1, 1, Qt::AlignTop);
  grid_->addWidget(badge_, 1, 1, Qt::AlignTop | Qt::AlignLeft);
  badge_->setObjectName(QStringLiteral("viewBadge"));
  badge_->setAttribute(Qt::WA_TransparentForMouseEvents);
  badge_->hide();
  badgeTimer_->setSingleShot(true);
  connect(badgeTimer_, &QTimer::timeout, badge_, &QWidget::hide);
}

void ViewArea::addSlices(const std::array<QWidget*, 3>& slices) {
  slices_ = slices;
  const std::array<std::array<int, 2>, 3> cells = {{{0, 0}, {1, 0}, {1, 1}}};
  for (std::size_t i = 0; i < slices.size(); ++i) {
    slices[i]->setParent(views_);
    four_->addWidget(slices[i], cells[i][0], cells[i][1]);
  }
  arrange(true, {});
}

void ViewArea::arrange(bool view, const std::array<bool, 3>& slices) {
  // An empty row or column takes no room.
  four_->setRowStretch(0, view || slices[0] ? 1 : 0);
  four_->setRowStretch(1, slices[1] || slices[2] ? 1 : 0);
  four_->setColumnStretch(0, slices[0] || slices[1] ? 1 : 0);
  four_->setColumnStretch(1, view || slices[2] ? 1 : 0);
  view_->setVisible(view);
  for (std::size_t i = 0; i < slices_.size(); ++i)
    if (slices_[i])
      slices_[i]->setVisible(slices[i]);
}

void ViewArea::splitView(QWidget* header, QWidget* second) {
  joinViews();
  header_ = header;
  second_ = second;
  auto* row = static_cast<QHBoxLayout*>(views_->layout());
  static_cast<QVBoxLayout*>(row->itemAt(0)->layout())->insertWidget(0, header_);
  row->addWidget(second_, 1);
  setHeaderHeight(header_->minimumHeight());
  header_->show();
  second_->show();
}

void ViewArea::setHeaderHeight(int height) {
  if (!header_)
    return;
  header_->setFixedHeight(height);
  // Widgets over the view begin below the header.
  grid_->setRowMinimumHeight(0, height + kViewMargin);
}

void ViewArea::joinViews() {
  delete header_;
  delete second_;
  header_ = nullptr;
  second_ = nullptr;
  grid_->setRowMinimumHeight(0, kViewMargin);
}

void ViewArea::frameSoon() {
  QTimer::singleShot(0, view_, [this] {
    view_->view().frame();
    view_->scheduleRender();
  });
}

void ViewArea::showBadge(const QString& text) {
  badge_->setText(text);
  badge_->setVisible(messages_->isHidden());
  badge_->raise();
  badgeTimer_->start(kBadgeMilliseconds);
}

void ViewArea::retractBadge(const QString& text) {
  if (badge_->text() == text)
    badge_->hide();
}

void ViewArea::reserveBelow(int pixels) {
  if (views_->layout()->contentsMargins().bottom() != pixels)
    views_->layout()->setContentsMargins(0, 0, 0, pixels);
}

void ViewArea::addCard(QWidget* card, Qt::Alignment alignment) {
  grid_->addWidget(card, 1, 1, alignment);
  card->raise();
}

} // namespace viscera::app
