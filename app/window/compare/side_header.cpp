#include "window/compare/side_header.h"

namespace viscera::app {
namespace {
constexpr int kHeaderHeight = 36;
/// Two of them leave the panels beside the views their width in a small window.
constexpr int kNarrowestHeader = 160;
} // namespace

SideHeader::SideHeader(int number, QWidget* parent)
    : QFrame(parent), row_(new QHBoxLayout(this)), title_(new QLabel(this)), phase_(new ElidedLabel(this)),
      volumes_(new ElidedLabel(this)) {
  setObjectName(QStringLiteral("sideHeader"));
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(kHeaderHeight);
  setMinimumWidth(kNarrowestHeader);
  row_->setContentsMargins(12, 0, 4, 0);
  row_->setSpacing(8);
  auto* badge = new QLabel(QString::number(number), this);
  badge->setObjectName(QStringLiteral("sideNumber"));
  badge->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Maximum);
  QFont bold = title_->font();
  bold.setBold(true);
  badge->setFont(bold);
  title_->setFont(bold);
  phase_->setObjectName(QStringLiteral("muted"));
  phase_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  volumes_->setObjectName(QStringLiteral("sideVolumes"));
  row_->addWidget(badge);
  row_->addWidget(title_);
  row_->addWidget(phase_);
  row_->addWidget(volumes_, 1);
}

void SideHeader::setState(const QString& phase, const QString& volumes) {
  phase_->setFullText(phase);
  if (volumes_->fullText() != volumes)
    volumes_->setFullText(volumes);
}

} // namespace viscera::app
