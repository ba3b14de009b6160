#include "window/widgets/job_indicator.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "window/style/icon.h"

namespace viscera::app {

JobIndicator::JobIndicator(QWidget* parent)
    : QWidget(parent), step_(new QLabel(this)), bar_(new QProgressBar(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 4, 0);
  row->setSpacing(8);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(120);
  auto* cancel = new QToolButton(this);
  cancel->setObjectName(QStringLiteral("cancelJob"));
  cancel->setIcon(icon("close"));
  cancel->setIconSize(QSize(12, 12));
  cancel->setToolTip(tr("Cancel this task"));
  cancel->setAccessibleName(tr("Cancel this task"));
  row->addWidget(step_);
  row->addWidget(bar_);
  row->addWidget(cancel);
  connect(cancel, &QToolButton::clicked, this, &JobIndicator::cancelRequested);
  hide();
}

void JobIndicator::showJob(const QString& step, double fraction) {
  step_->setText(step);
  bar_->setRange(0, fraction < 0 ? 0 : 1000);
  if (fraction >= 0)
    bar_->setValue(static_cast<int>(1000 * fraction));
  show();
}

void JobIndicator::clear() {
  hide();
}

} // namespace viscera::app
