#include "window/widgets/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QVariant>

#include "window/style/icon.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::app {
namespace {

const char* nameOf(Message::Severity severity) {
  switch (severity) {
  case Message::Severity::warning:
    return "warning";
  case Message::Severity::error:
    return "error";
  case Message::Severity::info:
    break;
  }
  return "info";
}

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), icon_(new QLabel(this)), text_(new WrappedLabel(this)), offersBox_(new QWidget(this)),
      offers_(new QHBoxLayout(offersBox_)), timer_(new QTimer(this)) {
  setObjectName(QStringLiteral("messageBar"));
  auto* row = makeLayout<QHBoxLayout>(this, 8, {12, 8, 8, 8});
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setMinimumWidth(120);
  offers_->setContentsMargins(0, 0, 0, 0);
  offers_->setSpacing(8);
  auto* closeButton = makeIconButton("close", tr("Close this message (Esc)"), this);
  closeButton->setAccessibleName(tr("Close this message"));
  row->addWidget(icon_, 0);
  row->addWidget(text_, 1);
  row->addWidget(offersBox_, 0);
  row->addWidget(closeButton, 0);
  timer_->setSingleShot(true);
  connect(closeButton, &QToolButton::clicked, this, &MessageBar::dismiss);
  connect(timer_, &QTimer::timeout, this, &MessageBar::dismiss);
  hide();
}

void MessageBar::showMessage(const Message& message) {
  const char* severity = nameOf(message.severity);
  setProperty("severity", QString::fromLatin1(severity));
  style()->unpolish(this);
  style()->polish(this);
  icon_->setPixmap(viscera::app::icon(severity).pixmap(20, 20));
  text_->setText(message.text);
  rebuildOffers(message.offers);
  timer_->stop();
  if (message.seconds > 0)
    timer_->start(1000 * message.seconds);
  open_ = true;
  showOrHide();
}

QString MessageBar::text() const {
  return open_ ? text_->text() : QString();
}

void MessageBar::setHeldBack(bool held) {
  held_ = held;
  showOrHide();
}

void MessageBar::showOrHide() {
  setVisible(open_ && !held_);
  if (!isHidden())
    raise();
}

void MessageBar::dismiss() {
  timer_->stop();
  open_ = false;
  showOrHide();
}

void MessageBar::retract(const QString& text) {
  if (text == this->text())
    dismiss();
}

void MessageBar::rebuildOffers(const std::vector<Message::Offer>& offers) {
  while (QLayoutItem* item = offers_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  for (const Message::Offer& offer : offers) {
    auto* button = new QPushButton(offer.label, offersBox_);
    button->setObjectName(QStringLiteral("offer"));
    connect(button, &QPushButton::clicked, this, [this, accept = offer.accept] {
      dismiss();
      if (accept)
        accept();
    });
    offers_->addWidget(button);
    button->show();
  }
  offersBox_->setVisible(!offers.empty());
}

} // namespace viscera::app
