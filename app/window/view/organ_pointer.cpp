#include "window/view/organ_pointer.h"

#include <QEvent>
#include <QMenu>

#include <algorithm>

#include "viscera/presentation/presenter.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {
constexpr int kRestMilliseconds = 120;
constexpr QPoint kBeside{14, 12};
} // namespace

OrganPointer::OrganPointer(const Parts& parts, QMenu* menu, QObject* parent)
    : QObject(parent), workspace_(parts.workspace), picture_(parts.picture), view_(parts.view), menu_(menu),
      name_(new QLabel(&view_)) {
  name_->setObjectName(QStringLiteral("organUnderCursor"));
  name_->setAttribute(Qt::WA_TransparentForMouseEvents);
  name_->hide();
  rested_.setSingleShot(true);
  rested_.setInterval(kRestMilliseconds);
  connect(&rested_, &QTimer::timeout, this, &OrganPointer::showName);
  connect(&view_, &ViewWidget::hovered, this, &OrganPointer::hover);
  connect(&parts.model, &ViewModel::changed, this, &OrganPointer::lookAgain);
  subscription_ = workspace_.onChange([this](const document::Change&) { lookAgain(); });
  view_.installEventFilter(this);
  // The window ends with the picture before the view.
  connect(&picture_, &QObject::destroyed, this, [this] {
    view_.removeEventFilter(this);
    view_.disconnect(this);
  });
  if (!menu)
    return;
  connect(&view_, &ViewWidget::doubleClicked, this, &OrganPointer::isolate);
  connect(&view_, &ViewWidget::menuWanted, this, &OrganPointer::openMenu);
}

/// Organs are elsewhere in a view of another size, and the place of the mouse in it is not known.
bool OrganPointer::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
    hover(std::nullopt);
  return QObject::eventFilter(watched, event);
}

std::shared_ptr<const document::Organ> OrganPointer::organAt(const QPointF& place) const {
  const double ratio = view_.devicePixelRatioF();
  const auto pick = view_.view().pick(ratio * place.x(), ratio * (view_.height() - 1 - place.y()));
  return pick ? workspace_.document().organ(picture_.organOf(pick->organ)) : nullptr;
}

void OrganPointer::hover(const std::optional<QPointF>& place) {
  name_->hide();
  place_ = place;
  if (place_)
    return rested_.start();
  rested_.stop();
  picture_.setPointedOrgan({});
}

void OrganPointer::lookAgain() {
  name_->hide();
  if (place_ && !rested_.isActive())
    rested_.start();
}

void OrganPointer::showName() {
  // One organ's name tells nothing.
  const auto organ = workspace_.document().organs().size() > 1 ? organAt(*place_) : nullptr;
  picture_.setPointedOrgan(organ ? organ->id : document::OrganId{});
  if (!organ)
    return;
  name_->setText(inWords(presentation::labelOf(*organ)));
  name_->adjustSize();
  const QPoint at = place_->toPoint() + kBeside;
  name_->move(std::min(at.x(), view_.width() - name_->width()),
              std::min(at.y(), view_.height() - name_->height()));
  name_->show();
}

void OrganPointer::isolate(const QPointF& place) {
  const auto organ = organAt(place);
  if (!organ)
    return;
  const document::OrganList& all = workspace_.document().organs();
  const bool alone = std::none_of(all.begin(), all.end(), [&organ](const auto& other) {
    return other->look.visible && other->id != organ->id && other->parent != organ->id;
  });
  workspace_.selection().setOrgan(organ->id);
  alone ? Q_EMIT allWanted() : Q_EMIT aloneWanted();
}

void OrganPointer::openMenu(const QPointF& place) {
  if (const auto organ = organAt(place))
    workspace_.selection().setOrgan(organ->id);
  menu_->popup(view_.mapToGlobal(place.toPoint()));
}

} // namespace viscera::app
