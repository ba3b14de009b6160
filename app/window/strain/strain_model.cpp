#include "window/strain/strain_model.h"

#include <algorithm>
#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/core/background.h"
#include "viscera/document/rig.h"
#include "window/strain/segment_map.h"
#include "window/timeline/measured_motion.h"
#include "window/work/mailbox.h"

namespace viscera::app {
namespace {

/// mm up to which a key is the pose that was tracked.
constexpr double kSameKeyMm = 1e-6;
constexpr const char* kStrainSlot = "strain";

bool samePoses(const std::vector<Points>& poses, const live::PatientMotion& motion) {
  const auto& keys = motion.sequence.track.keys;
  return poses.size() == keys.size() &&
         std::equal(poses.begin(), poses.end(), keys.begin(), [](const Points& pose, const auto& key) {
           return pose.rows() == key.pose.rows() && (pose - key.pose).cwiseAbs().maxCoeff() < kSameKeyMm;
         });
}

bool isLeftVentricle(const document::Organ& organ) {
  return anatomy::chamberNamed(organ.name) == anatomy::kLeftVentricle;
}

} // namespace

StrainModel::StrainModel(Workspace& workspace, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), playback_(playback), jobs_(mailbox()) {
  connect(&playback, &Playback::stateChanged, this, &StrainModel::syncSoon);
  connect(&playback, &Playback::advanced, this, [this] { // Another mode may want another pose.
    if (std::exchange(poseWanted_, playback_.wantedPose()) != playback_.wantedPose())
      syncSoon();
  });
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs() || change.rig() || change.system() || change.pose() || change.keySequence())
      syncSoon();
  }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (event.status)
      syncSoon();
  }));
}

void StrainModel::setMeasured(const MeasuredMotion& measured) {
  measured_ = &measured;
  connect(&measured, &MeasuredMotion::changed, this, [this] {
    cycleOf_.reset();
    syncSoon();
  });
}

void StrainModel::choose(const StrainChoice& choice) {
  const StrainChoice before = std::exchange(choice_, choice);
  if (before == choice)
    return;
  if (before.reference != choice.reference)
    cycleOf_.reset();
  syncSoon();
}

void StrainModel::setWanted(bool wanted) {
  if (std::exchange(wanted_, wanted) != wanted)
    syncSoon();
}

/// After all observers of a change: the pose is then that of the organs.
void StrainModel::syncSoon() {
  if (!std::exchange(asked_, true))
    QMetaObject::invokeMethod(this, &StrainModel::sync, Qt::QueuedConnection);
}

StrainModel::Basis StrainModel::basis() const {
  const document::DocumentState& state = workspace_.state();
  Basis found{{}, state.rig, state.system};
  if (const auto left = state.organ(leftVentricle()); left && left->mesh == choice_.axesOf)
    found.axes = choice_.axes;
  for (const auto& organ : *state.organs)
    if (workspace_.live().status(organ->id).state == live::BindingStatus::State::bound)
      found.organs.emplace_back(organ->id, organ->mesh);
  return found;
}

document::OrganId StrainModel::leftVentricle() const {
  for (const auto& organ : workspace_.document().organs())
    if (isLeftVentricle(*organ))
      return organ->id;
  return {};
}

bool StrainModel::posed() const {
  if (playback_.showing() || playback_.wantedPose() == live::WantedPose::rest)
    return false;
  const Points& pose = workspace_.document().pose();
  const Points rest = workspace_.state().rig->restPositions();
  return pose.rows() == rest.rows() && pose != rest;
}

live::MovedOrgans StrainModel::atRest(const Basis& basis) const {
  live::MovedOrgans moved;
  for (const auto& [id, mesh] : basis.organs)
    moved.organs.push_back({workspace_.document().organ(id)->name, mesh});
  moved.handles = document::handleSet(*basis.rig);
  moved.system = workspace_.registry().find(basis.system->id);
  moved.parameters = basis.system->parameters;
  return moved;
}

std::optional<StrainModel::Series> StrainModel::series(const Basis& basis) const {
  const MeasuredMotion::Found* found = measured_ ? measured_->present() : nullptr;
  if (!found)
    return std::nullopt;
  Series series{found->series, found->motion, {}};
  for (const auto& [id, mesh] : basis.organs)
    if (const auto surface = measured_->surfaceOf(id))
      series.surfaces.push_back(*surface);
  return series.surfaces.size() == basis.organs.size() ? std::optional(series) : std::nullopt;
}

void StrainModel::sync() {
  asked_ = false;
  if (!wanted_ || workspace_.live().busy() || playback_.wantedPose() == live::WantedPose::rest)
    return; // The organs tell when they are bound.
  const Basis now = basis();
  if (running_) {
    if (gaugeOf_ != now) // Of other organs: not worth waiting for.
      jobs_.cancelAll();
    return;
  }
  if (gaugeOf_ != now)
    forget(now);
  if (std::none_of(now.organs.begin(), now.organs.end(), [this](const auto& organ) {
        return isLeftVentricle(*workspace_.document().organ(organ.first));
      }))
    return tell(tr("Strain needs the cavity of a left ventricle, by its name, that follows the handles."));
  if (refused_)
    return tell(failureReason_);
  if (posed() && poseOf_ != workspace_.state().pose)
    return readPose(now);
  if (!playback_.player().movable()) {
    cycleOf_.reset();
    cycle_.reset();
    return tell(pose() ? QString()
                       : tr("Choose a motion, or drag a handle: strain is the change of the heart's wall."));
  }
  const live::MotionCause cause = live::causeOf(playback_.player().runner());
  if (cycleOf_ != cause)
    return readCycle(now, cause);
  tell(cycle_ ? QString() : failureReason_);
}

void StrainModel::forget(const Basis& now) {
  gaugeOf_ = now;
  gauge_.reset();
  refused_ = false;
  cycle_.reset();
  pose_.reset();
  cycleOf_.reset();
  poseOf_.reset();
  failureReason_.clear();
}

void StrainModel::tell(const QString& reason) {
  failureReason_ = reason;
  Q_EMIT changed();
}

void StrainModel::readPose(const Basis& basis) {
  live::MovedOrgans moved = atRest(basis);
  moved.seconds = {0, 1};
  moved.poses = {moved.handles.positions, workspace_.document().pose()};
  moved.corresponding = true;
  submit(
      basis, [moved = std::move(moved)](Progress&) { return moved; },
      0, // Also a pose that fills the ventricle.
      [this, pose = workspace_.state().pose](const Reading& reading) {
        pose_ = reading;
        poseOf_ = pose;
      });
}

void StrainModel::readCycle(const Basis& basis, const live::MotionCause& cause) {
  auto copy = std::make_shared<live::MotionCopy>(playback_.player().runner(), workspace_.live().copy());
  submit(
      basis,
      [copy, systems = workspace_.registry(), series = series(basis)](Progress& progress) {
        live::MovedOrgans moved = live::movedOrgans(copy->runner(), systems, live::kStrainInstants, progress);
        if (!series || !samePoses(moved.poses, *series->motion))
          return moved;
        moved.corresponding = series->motion->corresponding;
        if (!series->series->corresponding.empty())
          for (const std::size_t surface : series->surfaces)
            moved.measured.push_back(series->series->corresponding[surface].phases);
        return moved;
      },
      choice_.reference > 0 ? std::optional(static_cast<std::size_t>(choice_.reference - 1)) : std::nullopt,
      [this, cause, reference = choice_.reference](const Reading& reading) {
        cycle_ = reading;
        if (reference == choice_.reference) // Else it is read again.
          cycleOf_ = cause;
      });
}

/// What fails is not tried again until organs, handles or the motion are others.
void StrainModel::submit(const Basis& basis, std::function<live::MovedOrgans(Progress&)> motion,
                         std::optional<std::size_t> reference, std::function<void(const Reading&)> take) {
  running_ = true;
  Q_EMIT changed();
  auto made = std::make_shared<std::shared_ptr<const live::StrainGauge>>(gauge_);
  const std::shared_ptr<const live::StrainGauge> before = lastGauge_;
  live::StrainOptions options;
  options.landmarks = basis.axes;
  options.witnesses = witnesses_;
  auto work = [made, before, rest = atRest(basis), state = workspace_.state(), motion = std::move(motion),
               reference, options](Progress& progress) mutable {
    Reading reading;
    inBackground([&] {
      if (!*made)
        runPart(progress, 0, 0.7, [&](Progress& part) {
          live::addOwnWall(state, part, rest);
          *made = std::make_shared<const live::StrainGauge>(rest, options, part, Threads{}, before.get());
        });
      runPart(progress, 0.7, 1, [&](Progress& part) {
        const live::MovedOrgans moved = motion(part);
        const bool has = reference && *reference < moved.seconds.size();
        reading = std::make_shared<const live::StrainReading>(
            (*made)->read(moved, part, {}, has ? reference : std::nullopt));
      });
    });
    return reading;
  };
  auto done = [this, basis, made, take = std::move(take)](const JobResult<Reading>& result) {
    running_ = false;
    if (gaugeOf_ == basis && !result.cancelled()) {
      gauge_ = *made;
      lastGauge_ = gauge_;
      refused_ = !gauge_;
      failureReason_ = result.error ? sentenceOf(*result.error) : QString();
      if (gauge_)
        take(result.value.value_or(nullptr));
    }
    syncSoon();
  };
  jobs_.submit<Reading>(tr("Strain").toStdString(), kStrainSlot, std::move(work), std::move(done));
}

std::size_t StrainModel::phaseNow() const {
  if (!cycle_)
    return 0;
  if (!playing())
    return cycle_->strain.reference;
  return strainPhaseAt(*cycle_, secondsNow(), playback_.player().periodSeconds());
}

const std::vector<int>* StrainModel::segmentsOn(document::OrganId organ) const {
  for (std::size_t i = 0; gauge_ && i < gaugeOf_.organs.size(); ++i)
    if (gaugeOf_.organs[i].first == organ && !gauge_->segmentsOn(i).empty())
      return &gauge_->segmentsOn(i);
  return nullptr;
}

} // namespace viscera::app
