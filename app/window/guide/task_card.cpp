#include "window/guide/task_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>

#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr int kTaskWidth = 360;
constexpr int kPraiseMs = 6000; ///< So long the card stays when the task is done.

} // namespace

TaskCard::TaskCard(Workspace& workspace, QWidget* parent)
    : QFrame(parent), workspace_(workspace), text_(new QLabel(this)), end_(new QTimer(this)),
      subscription_(workspace.onChange([this](const document::Change& change) { look(change); })) {
  setObjectName(QStringLiteral("welcomeCard"));
  setFixedWidth(kTaskWidth);
  auto* row = makeLayout<QHBoxLayout>(this, 8, {16, 10, 10, 10});
  text_->setObjectName(QStringLiteral("taskText"));
  text_->setWordWrap(true);
  row->addWidget(text_, 1);
  auto* closeButton = makeIconButton("close", tr("Close (Esc)"), this, 14);
  closeButton->setAccessibleName(tr("Close"));
  connect(closeButton, &QToolButton::clicked, this, &QWidget::hide);
  row->addWidget(closeButton, 0, Qt::AlignTop);
  end_->setSingleShot(true);
  end_->setInterval(kPraiseMs);
  connect(end_, &QTimer::timeout, this, &QWidget::hide);
  hide();
}

void TaskCard::start() {
  done_ = moved_ = false;
  end_->stop();
  text_->setText(tr("Drag the bright dot: the organ follows."));
  show();
  raise();
}

void TaskCard::look(const document::Change& change) {
  if (done_ || isHidden())
    return;
  moved_ = moved_ || change.pose();
  if (!moved_ || change.interactive) // The end of a drag is a change by itself, after those of the pose.
    return;
  done_ = true;
  text_->setText(tr("Done. Ctrl+Z takes it back. F1 opens the guide at what you are doing."));
  end_->start();
}

} // namespace viscera::app
