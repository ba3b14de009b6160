#include "window/handles/handles_page.h"

#include <QLabel>
#include <QPushButton>

#include "viscera/presentation/presenter.h"
#include "window/handles/group_panel.h"
#include "window/handles/position_box.h"
#include "window/handles/system_box.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

QString nameOf(live::BindingStatus::State state) {
  using State = live::BindingStatus::State;
  switch (state) {
  case State::unbound:
    return HandlesPage::tr("not bound");
  case State::binding:
    return HandlesPage::tr("binding...");
  case State::bound:
    return HandlesPage::tr("bound");
  case State::stale:
    return HandlesPage::tr("cancelled");
  case State::failed:
    return HandlesPage::tr("not possible");
  }
  return {};
}

} // namespace

HandlesPage::HandlesPage(Workspace& workspace, const Actions& actions, QWidget* parent)
    : Page(parent), workspace_(workspace) {
  addSection(tr("Coordinates"));
  add(new SystemBox(workspace, this));
  cage_ = addRemark(QString());
  for (const char* id : {"cage.load", "cage.hull"})
    cageButtons_.push_back(addButton(actions[id]));
  addButton(actions["play.compareSystems"]);
  addSection(tr("Groups"));
  add(new GroupPanel(workspace, this));
  for (const char* shown : {"handles.regions", "handles.zones", "handles.superRegions"})
    addCheck(actions[shown]);
  addSection(tr("Binding"));
  organ_ = addFact(tr("Organ"));
  organ_->setObjectName(QStringLiteral("boundOrgan"));
  state_ = addFact(tr("State"));
  time_ = addFact(tr("Time"));
  identity_ = addFact(tr("Rest error"));
  identity_->setToolTip(tr("The largest distance of the bound organ at rest from the original"));
  smallest_ = addFact(tr("Smallest weight"));
  message_ = addRemark(QString());
  addSection(tr("Handle at rest"));
  add(new PositionBox(workspace, PositionBox::Of::rest, this));
  addCheck(actions["handles.influence"]);
  finish();
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      sync();
    if (change.rig() || change.system())
      syncCage();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (event.status)
      sync();
  }));
  sync();
  syncCage();
}

void HandlesPage::syncCage() {
  const document::Rig& rig = workspace_.document().rig();
  const bool needed = workspace_.systemTraits().needsCage;
  cage_->setText(
      rig.cage.empty()
          ? tr("The cage is the convex hull of the handles.")
          : tr("The cage has %1 triangles over %2 handles.").arg(rig.cage.size()).arg(rig.cornerCount()));
  cage_->setVisible(needed);
  for (QWidget* button : cageButtons_)
    button->setVisible(needed);
}

void HandlesPage::sync() {
  const auto organ = workspace_.currentOrgan();
  live::BindingStatus status;
  if (organ)
    status = workspace_.live().status(organ->id);
  const bool bound = organ && workspace_.live().deformer(organ->id);
  const QString none = QStringLiteral("-");
  setFactShown(organ_,
               workspace_.document().organs().size() > 1); // Else it is clear whose numbers these are.
  organ_->setText(organ ? inWords(presentation::labelOf(*organ)) : none);
  state_->setText(nameOf(status.state));
  time_->setText(bound ? tr("%1 ms, %n threads", nullptr, status.report.threads)
                             .arg(formatNumber(1000 * status.report.seconds, 1))
                       : none);
  identity_->setText(bound ? tr("%1 mm").arg(formatDigits(status.report.identityError, 2)) : none);
  smallest_->setText(bound ? formatDigits(status.report.minWeight, 2) : none);
  QStringList remarks;
  for (const Text& note : status.report.notes)
    remarks.push_back(asSentence(note));
  if (!status.message.empty())
    remarks = QStringList{asSentence(status.message)};
  message_->setText(remarks.join(QLatin1Char('\n')));
  message_->setVisible(!remarks.isEmpty());
}

} // namespace viscera::app
