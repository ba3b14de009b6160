#include "window/view/pose_editor.h"

#include <utility>

#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/presentation/presenter.h"
#include "viscera/presentation/space_parts.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {
/// A drag at rest binds anew more often than this.
constexpr int kPrepareMilliseconds = 150;
/// mm; a handle that is nearer to where it was sent counts as being there.
constexpr double kAsAsked = 0.05;
} // namespace

PoseEditor::PoseEditor(Workspace& workspace, const ViewModel& model, QObject* parent)
    : QObject(parent), workspace_(workspace), model_(model),
      keeper_(workspace.state(), workspace.live(), {}, &workspace.jobs()) {
  keeper_.setSystems(workspace.registry());
  prepareSoon_.setSingleShot(true);
  prepareSoon_.setInterval(kPrepareMilliseconds);
  connect(&prepareSoon_, &QTimer::timeout, this,
          [this] { workspace_.guarded([this] { keeper_.prepare(); }); });
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      prepareLocks();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (event.status || event.replaced)
      prepareLocks();
  }));
}

/// Prepares the locks after the locked organs or their bindings have changed.
void PoseEditor::prepareLocks() {
  keeper_.dropOutdated();
  prepareSoon_.start();
}

bool PoseEditor::begin(const QString& name, const std::vector<document::HandleId>& handles, bool mirrored,
                       const std::optional<Vec3>& plane) {
  cancel();
  const bool begun = workspace_.guarded([&] {
    motion_.emplace(keeper_.begin(handles, mirrored ? mirrorPlane() : std::nullopt, plane, others()));
    step_.emplace(workspace_.undo(), name.toStdString());
  });
  if (!begun)
    motion_.reset();
  Q_EMIT gestureChanged();
  return begun;
}

/// Applies the motion as far as the locks allow. An error is reported once per gesture.
void PoseEditor::follow(const std::function<void(live::LockedMotion&)>& wish) {
  if (!motion_)
    return;
  try {
    wish(*motion_);
    workspace_.undo().perform(document::setPose(motion_->sharedPose()));
    setObstacle(motion_->obstacle().empty() ? shortfall(*motion_) : inWords(motion_->obstacle()));
  } catch (const Error& error) {
    if (obstacle_.isEmpty())
      workspace_.report(error);
    setObstacle(inWords(error.problem()));
  }
  Q_EMIT gestureChanged();
}

void PoseEditor::end(void (document::UndoStack::Step::*close)()) {
  if (!motion_)
    return;
  const auto motion = std::exchange(motion_, std::nullopt);
  auto step = std::exchange(step_, std::nullopt);
  workspace_.guarded([&] { (*step.*close)(); });
  setObstacle({});
  Q_EMIT gestureChanged();
  if (close == &document::UndoStack::Step::finish)
    tellDifference(*motion);
}

live::Others PoseEditor::others() const {
  if (model_.state().freeHandlesFollow)
    return live::Others::follow;
  return model_.state().exactly ? live::Others::compensate : live::Others::asMarked;
}

/// How much of a translation the locked volume has left; empty where it is all.
QString PoseEditor::shortfall(const live::LockedMotion& motion) const {
  if (!motion.asked() || motion.selection().empty() || (motion.given() - *motion.asked()).norm() < kAsAsked)
    return {};
  return tr("the locked volume leaves %1 of %2 mm")
      .arg(formatNumber(motion.given().norm(), 2), formatNumber(motion.asked()->norm(), 2));
}

/// Says after a move what the locked volume has left of it, and offers the whole of it.
void PoseEditor::tellDifference(const live::LockedMotion& motion) {
  if (!told_.isEmpty())
    workspace_.retract(std::exchange(told_, {}));
  const QString left = shortfall(motion);
  if (left.isEmpty())
    return;
  std::vector<document::HandleId> handles;
  for (const int row : motion.selection())
    handles.push_back(workspace_.document().rig().handles[static_cast<std::size_t>(row)].id);
  const Vec3 there = motion.start().row(motion.selection().front()).transpose() + *motion.asked();
  told_ = tr("Only partly possible: %1").arg(left);
  Message message{Message::Severity::info, told_, {}, 12};
  message.offers.push_back({tr("Move exactly, others compensate"), [this, handles, there] {
                              const document::Document& document = workspace_.document();
                              if (const int row = document.rig().indexOf(handles.front()); row >= 0)
                                moveExactly(handles, there - document.pose().row(row).transpose());
                            }});
  workspace_.say(message);
}

document::Command PoseEditor::moveCommand(const live::LockedMotion& motion,
                                          const std::vector<document::HandleId>& handles) const {
  document::Command command = document::setPose(motion.sharedPose());
  const document::Handle& first =
      workspace_.document().rig().handles[static_cast<std::size_t>(motion.selection().front())];
  command.name = handles.size() == 1
                     ? tr("Move handle %1").arg(inWords(first.label)).toStdString()
                     : tr("Move %n handles", nullptr, static_cast<int>(handles.size())).toStdString();
  return command;
}

bool PoseEditor::moveExactly(const std::vector<document::HandleId>& handles, const Vec3& by) {
  finish();
  return workspace_.guarded([&] {
    live::LockedMotion motion = keeper_.begin(handles, mirrorPlane(), std::nullopt, live::Others::compensate);
    motion.translate(by);
    if (motion.selection().empty())
      return;
    live::requireExact(motion, by);
    workspace_.undo().perform(moveCommand(motion, handles));
  });
}

void PoseEditor::setObstacle(const QString& obstacle) {
  if (std::exchange(obstacle_, obstacle) != obstacle)
    Q_EMIT obstacleChanged(obstacle);
}

std::optional<Vec3> PoseEditor::moveBy(const std::vector<document::HandleId>& handles, const Vec3& by) {
  std::optional<Vec3> moved;
  workspace_.guarded([&] {
    live::LockedMotion motion = keeper_.begin(handles, mirrorPlane(), std::nullopt, others());
    motion.translate(by);
    if (motion.selection().empty())
      return;
    workspace_.undo().perform(moveCommand(motion, handles));
    moved = motion.given();
    tellDifference(motion);
  });
  return moved;
}

void PoseEditor::reset(const std::vector<document::HandleId>& handles) {
  workspace_.guarded([&] {
    live::LockedMotion motion = keeper_.begin(handles);
    Points wanted = motion.start();
    for (const int row : motion.selection())
      wanted.row(row) = workspace_.document().rig().handles[static_cast<std::size_t>(row)].rest.transpose();
    motion.reach(wanted);
    workspace_.undo().perform(
        document::setPose(motion.sharedPose(),
                          tr("Reset %n handles", nullptr, static_cast<int>(handles.size())).toStdString()));
    if (motion.obstacle().empty())
      return;
    workspace_.say({Message::Severity::warning,
                    tr("The handles could not move back all the way: %1.").arg(inWords(motion.obstacle())),
                    {},
                    0});
  });
}

bool PoseEditor::setVolume(document::OrganId organ, double milliliters) {
  finish();
  return workspace_.guarded([&] {
    const Points pose = keeper_.poseOfVolume(organ, milliliters * kMm3PerMl);
    workspace_.undo().perform(
        document::setPose(pose, tr("Volume %1").arg(formatMilliliters(milliliters)).toStdString()));
  });
}

void PoseEditor::setLocked(const std::vector<document::OrganId>& organs, bool locked) {
  finish();
  std::vector<document::Command> commands;
  std::vector<document::OrganId> open;
  for (const document::OrganId id : organs) {
    const auto organ = workspace_.document().organ(id);
    if (!organ || organ->volumeLocked == locked)
      continue;
    if (locked && !organ->closed())
      open.push_back(id);
    else
      commands.push_back(document::setVolumeLocked(id, locked));
  }
  if (!commands.empty()) {
    const Text name = commands.front().name;
    workspace_.perform(document::combined(name, std::move(commands)));
  }
  if (!open.empty())
    offerToClose(open);
}

void PoseEditor::offerToClose(const std::vector<document::OrganId>& organs) {
  QStringList names;
  int edges = 0;
  std::vector<document::Command> commands;
  for (const document::OrganId id : organs) {
    const auto organ = workspace_.document().organ(id);
    names.push_back(inWords(presentation::labelOf(*organ)));
    edges += organ->boundaryEdges;
    commands.push_back(document::closeHoles(id));
    commands.push_back(document::setVolumeLocked(id, true));
  }
  Message message;
  message.severity = Message::Severity::warning;
  message.text =
      organs.size() == 1
          ? tr("%1 is open (%n boundary edges), so it has no volume that could be locked.", nullptr, edges)
                .arg(names.front())
          : tr("These organs are open, so they have no volumes that could be locked: %1.")
                .arg(names.join(QStringLiteral(", ")));
  message.offers.push_back(
      {tr("Close the holes and lock"), [this, commands] {
         workspace_.perform(document::combined(tr("Close holes and lock volume").toStdString(), commands));
       }});
  workspace_.say(message);
}

void PoseEditor::setCompensating(bool compensating) {
  finish();
  document::HandleEdit edit;
  edit.compensates = compensating;
  workspace_.perform(document::editHandles(workspace_.selection().handles(), edit));
}

std::optional<deformation::MirrorPlane> PoseEditor::mirrorPlane() const {
  return presentation::mirrorPlaneOf(workspace_.state(), workspace_.selection().organ(),
                                     model_.state().mirror);
}

std::vector<document::HandleId> PoseEditor::partnersOfSelection() const {
  const auto plane = mirrorPlane();
  std::vector<document::HandleId> partners;
  if (!plane)
    return partners;
  const document::Rig& rig = workspace_.document().rig();
  for (const int row : keeper_.partners(workspace_.selection().handles(), *plane))
    if (row >= 0)
      partners.push_back(rig.handles[static_cast<std::size_t>(row)].id);
  return partners;
}

} // namespace viscera::app
