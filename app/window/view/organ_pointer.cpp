#include "window/view/organ_pointer.h"

#include <QMenu>

#include <algorithm>

#include "viscera/presentation/presenter.h"
#include "window/language.h"

namespace viscera::app {
namespace {
constexpr int kRestMilliseconds = 120;
constexpr QPoint kBeside{14, 12};
} // namespace

OrganPointer::OrganPointer(Workspace& workspace, Picture& picture, ViewWidget& view, QMenu* menu,
                           QObject* parent)
    : QObject(parent), workspace_(workspace), picture_(picture), view_(view), menu_(menu),
      name_(new QLabel(&view)) {
  name_->setObjectName(QStringLiteral("organUnderCursor"));
  name_->setAttribute(Qt::WA_TransparentForMouseEvents);
  name_->hide();
  rested_.setSingleShot(true);
  rested_.setInterval(kRestMilliseconds);
  connect(&rested_, &QTimer::timeout, this, &OrganPointer::showName);
  connect(&view, &ViewWidget::hovered, this, &OrganPointer::hover);
  if (!menu)
    return;
  connect(&view, &ViewWidget::doubleClicked, this, &OrganPointer::isolate);
  connect(&view, &ViewWidget::menuWanted, this, &OrganPointer::openMenu);
}

std::shared_ptr<const document::Organ> OrganPointer::organAt(const QPointF& place) const {
  const double ratio = view_.devicePixelRatioF();
  const auto pick = view_.view().pick(ratio * place.x(), ratio * (view_.height() - 1 - place.y()));
  return pick ? workspace_.document().organ(picture_.organOf(pick->organ)) : nullptr;
}

void OrganPointer::hover(const std::optional<QPointF>& place) {
  name_->hide();
  // With one organ, its name is not useful.
  if (!place || workspace_.document().organs().size() < 2) {
    picture_.setPointedOrgan({});
    return rested_.stop();
  }
  place_ = *place;
  rested_.start();
}

void OrganPointer::showName() {
  const auto organ = organAt(place_);
  picture_.setPointedOrgan(organ ? organ->id : document::OrganId{});
  if (!organ)
    return;
  name_->setText(inWords(presentation::labelOf(*organ)));
  name_->adjustSize();
  const QPoint at = place_.toPoint() + kBeside;
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
