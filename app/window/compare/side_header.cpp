#include "window/compare/side_header.h"

#include <QEvent>

#include <algorithm>

#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr int kHeaderHeight = 36, kSecondRowHeight = 32;
constexpr int kHeaderSpacing = 8;
/// Two of them leave the panels beside the views their width in a small window.
constexpr int kNarrowestHeader = 160;
/// Where title and phase do not fit, the phase has one in so many parts of the room of both.
constexpr int kPartsWithTitle = 3;
} // namespace

SideHeader::SideHeader(int number, QWidget* parent)
    : QFrame(parent), rows_(makeLayout<QVBoxLayout>(this, 0)), row_(new QHBoxLayout),
      controls_(new QWidget(this)), title_(new ElidedLabel(this)), phase_(new ElidedLabel(this)),
      volumes_(new ElidedLabel(this)) {
  setObjectName(QStringLiteral("sideHeader"));
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(kHeaderHeight);
  setMinimumWidth(kNarrowestHeader);
  rows_->setContentsMargins(12, 0, 4, 0);
  rows_->addLayout(row_, 1);
  row_->setSpacing(kHeaderSpacing);
  makeLayout<QHBoxLayout>(controls_, kHeaderSpacing);
  auto* badge = new QLabel(QString::number(number), this);
  badge->setObjectName(QStringLiteral("sideNumber"));
  badge->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Maximum);
  QFont bold = title_->font();
  bold.setBold(true);
  badge->setFont(bold);
  title_->setFont(bold);
  title_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  phase_->setObjectName(QStringLiteral("muted"));
  phase_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  volumes_->setObjectName(QStringLiteral("sideVolumes"));
  // The volumes have what the title and the phase leave.
  volumes_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row_->addWidget(badge);
  row_->addWidget(title_);
  row_->addWidget(controls_);
  row_->addWidget(phase_);
  row_->addWidget(volumes_, 1);
}

void SideHeader::setPhases(const QStringList& phases) {
  if (phases == phases_)
    return;
  phases_ = phases;
  sharePhase();
}

void SideHeader::setState(const QString& phase, const QString& volumes) {
  phase_->setFullText(phase);
  if (volumes_->fullText() != volumes)
    volumes_->setFullText(volumes);
}

bool SideHeader::event(QEvent* event) {
  const bool done = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest)
    arrange(); // The title may be another one.
  return done;
}

void SideHeader::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  arrange();
}

void SideHeader::arrange() {
  const bool two = !controls_->layout()->isEmpty() && widthInOneRow() > width();
  if (two != twoRows_)
    arrangeIn(two);
  sharePhase();
}

void SideHeader::arrangeIn(bool two) {
  twoRows_ = two;
  if (two) {
    row_->removeWidget(controls_);
    rows_->addWidget(controls_, 1, Qt::AlignLeft);
  } else {
    rows_->removeWidget(controls_);
    row_->insertWidget(row_->indexOf(phase_), controls_);
  }
  setFixedHeight(two ? kHeaderHeight + kSecondRowHeight : kHeaderHeight);
  Q_EMIT heightChanged(minimumHeight());
}

void SideHeader::sharePhase() {
  int widest = 0;
  for (const QString& phase : phases_)
    widest = std::max(widest, phase_->widthFor(phase));
  if (phases_.isEmpty()) {
    phase_->setMinimumWidth(0);
    phase_->setMaximumWidth(QWIDGETSIZE_MAX);
  } else {
    const int left = width() - widthInOneRow() + (twoRows_ ? controls_->sizeHint().width() : 0);
    const int withTitle = std::max(0, left + title_->sizeHint().width());
    phase_->setFixedWidth(std::min(widest, std::max(left, withTitle / kPartsWithTitle)));
  }
}

/// The same wherever the controls are now, else they would go to and fro.
int SideHeader::widthInOneRow() const {
  const QMargins around = rows_->contentsMargins();
  int wide = around.left() + around.right() + controls_->sizeHint().width();
  for (int i = 0; i < row_->count(); ++i) {
    const QWidget* widget = row_->itemAt(i)->widget();
    if (widget == controls_)
      continue;
    wide += kHeaderSpacing;
    if (widget != phase_ && widget != volumes_)
      wide += widget->sizeHint().width();
  }
  return wide;
}

} // namespace viscera::app
