#include "bound_organ.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/document/validate.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/live/movable_binding.h"

namespace viscera::live {
namespace {

using State = BindingStatus::State;

/// Fewer handles span no volume.
constexpr std::size_t kFewestHandles = 4;

bool sameGroups(const coordinates::HandleSet& a, const coordinates::HandleSet& b) {
  return std::equal(a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(),
                    [](const coordinates::HandleGroup& x, const coordinates::HandleGroup& y) {
                      return x.name == y.name && x.handles == y.handles;
                    });
}

bool sameCage(const coordinates::HandleSet& a, const coordinates::HandleSet& b) {
  return a.cage.rows() == b.cage.rows() && a.cage == b.cage;
}

bool needsCage(const BindingTarget& target) {
  return target.system && target.system->traits().needsCage;
}

/// Moving a handle by its column costs more than its share of a full pose; below this part of all handles it
/// pays.
constexpr Eigen::Index kFewHandles = 8;

int countOutside(const Points& handles, const Points& points) {
  try {
    return static_cast<int>(geometry::ConvexHull(handles).outside(points).size());
  } catch (const DataError&) {
    return 0; // The handles have no hull: that was the error then.
  }
}

} // namespace

bool usesGivenCage(const BindingTarget& target) {
  return needsCage(target) && target.handles.cage.rows() > 0;
}

BindingTarget makeTarget(const document::DocumentState& state, const coordinates::Registry& registry) {
  BindingTarget target;
  target.parameters = state.system->parameters;
  target.handles = document::handleSet(*state.rig);
  for (const document::Handle& handle : state.rig->handles)
    target.ids.push_back(handle.id);
  try {
    target.system = registry.find(state.system->id);
    target.parameters.requireWithin(target.system->parameters());
  } catch (const Error& error) {
    target.system.reset();
    target.problem = error.explanation();
  }
  return target;
}

bool sameBinding(const BindingTarget& a, const BindingTarget& b) {
  const bool groupsMatter =
      (a.system && a.system->traits().usesGroups) || (b.system && b.system->traits().usesGroups);
  return a.system == b.system && a.problem == b.problem && a.ids == b.ids &&
         a.handles.positions == b.handles.positions && a.parameters.all() == b.parameters.all() &&
         (!groupsMatter || sameGroups(a.handles, b.handles)) &&
         (!(needsCage(a) || needsCage(b)) || sameCage(a.handles, b.handles));
}

bool worthWaitingFor(const BindingTarget& underWay, const BindingTarget& wanted) {
  return underWay.system == wanted.system && underWay.ids == wanted.ids &&
         (!needsCage(wanted) || sameCage(underWay.handles, wanted.handles));
}

std::optional<BindingStatus> statusWithoutBinding(const BindingTarget& target) {
  const std::size_t count = target.ids.size();
  if (count == 0)
    return BindingStatus{State::unbound};
  if (count < kFewestHandles)
    return BindingStatus{State::unbound, phrase("An organ needs at least four handles around it: add %1 more",
                                                kFewestHandles - count)};
  if (!target.system)
    return BindingStatus{State::failed, target.problem};
  return std::nullopt;
}

BindingResult bindToTarget(const document::Organ& organ, const BindingTarget& target, Threads threads,
                           Progress& progress) {
  BindingResult result;
  try {
    auto binding = bindMovable(organ, *target.system, target.handles, {target.parameters, threads}, progress);
    progress.throwIfCancelled();
    result.deformer = std::make_unique<deformation::Deformer>(organ.mesh, std::move(binding),
                                                              target.handles.positions, threads);
  } catch (const Cancelled&) {
    throw;
  } catch (const deformation::UnboundVertices& error) {
    result.failure = BindingStatus{State::failed, error.explanation()};
    if (error.cageCounts())
      result.failure->outsideCage = static_cast<int>(error.vertices().size());
    else
      result.failure->outsideHull = error.outsideHull();
    if (error.groupsCount())
      result.failure->inNoRegion = error.vertices();
  } catch (const DataError& error) {
    result.failure = BindingStatus{State::failed, error.explanation()};
    if (!usesGivenCage(target)) // Adding handles that are not corners of the cage would not help.
      result.failure->outsideHull = countOutside(target.handles.positions, organ.mesh->points);
  } catch (const std::exception& error) {
    result.failure = BindingStatus{State::failed, explanationOf(error)};
  }
  if (result.failure)
    result.failure->givenCage = usesGivenCage(target);
  return result;
}

void BoundOrgan::take(BindingResult result, std::shared_ptr<const BindingTarget> of) {
  if (result.failure) {
    fail(std::move(*result.failure));
    return;
  }
  deformer = std::move(result.deformer);
  boundTo = std::move(of);
  rough_ = false;
  status = {State::bound};
  status.report = deformer->binding().report();
  pending.replaced = pending.moved = pending.status = true;
  ++revision;
}

void BoundOrgan::fail(BindingStatus failure) {
  if (deformer) {
    pending.replaced = pending.moved = true;
    ++revision;
  }
  deformer.reset();
  boundTo.reset();
  status = std::move(failure);
  pending.status = true;
}

void BoundOrgan::setState(State state) {
  BindingStatus changed{state};
  changed.report = std::move(status.report);
  status = std::move(changed);
  pending.status = true;
}

/// The pose for the handles that the organ is still bound to: each is displaced as its namesake is now; one
/// that is gone is at rest.
std::shared_ptr<const Points> BoundOrgan::translated(const BindingTarget& now, const Points& pose) const {
  auto own = std::make_shared<Points>(boundTo->handles.positions);
  for (std::size_t i = 0; i < boundTo->ids.size(); ++i) {
    const auto found = std::find(now.ids.begin(), now.ids.end(), boundTo->ids[i]);
    if (found == now.ids.end())
      continue;
    const auto row = static_cast<Eigen::Index>(found - now.ids.begin());
    const auto mine = static_cast<Eigen::Index>(i);
    own->row(mine) += pose.row(row) - now.handles.positions.row(row);
  }
  return own;
}

/// The handles that are not where they are in `pose`; none when too many have moved for moving one by one.
std::optional<std::vector<int>> BoundOrgan::fewMoved(const Points& pose) const {
  std::vector<int> moved;
  for (Eigen::Index i = 0; i < pose.rows(); ++i)
    if (pose.row(i) != deformer->pose().row(i))
      moved.push_back(static_cast<int>(i));
  if (moved.size() > 1 && static_cast<Eigen::Index>(moved.size()) * kFewHandles > pose.rows())
    return std::nullopt;
  return moved;
}

void BoundOrgan::moves(bool roughly) {
  rough_ = roughly;
  pending.moved = true;
  ++revision;
}

std::optional<deformation::NewPose>
BoundOrgan::poseFor(const BindingTarget& now, const std::shared_ptr<const Points>& pose, bool interactive) {
  if (!deformer)
    return std::nullopt;
  const bool current = boundTo.get() == &now;
  std::shared_ptr<const Points> own = current ? pose : translated(now, *pose);
  if (interactive)
    if (auto moved = fewMoved(*own)) {
      if (moved->empty())
        return std::nullopt;
      moves(true);
      return deformation::NewPose{deformer.get(), std::move(own), std::move(*moved)};
    }
  if (!rough_ && *own == deformer->pose())
    return std::nullopt;
  moves(false);
  if (*own == deformer->restHandles()) {
    deformer->reset();
    return std::nullopt;
  }
  return deformation::NewPose{deformer.get(), std::move(own)};
}

OrganVolume BoundOrgan::volume() const {
  OrganVolume volume;
  volume.closed = organ->closed();
  volume.restMl = organ->restVolumeMm3 / kMm3PerMl;
  volume.nowMl = volume.closed && deformer ? deformer->volumeMm3() / kMm3PerMl : volume.restMl;
  return volume;
}

Values BoundOrgan::influence(document::HandleId handle) const {
  if (!deformer)
    return {};
  const auto& ids = boundTo->ids;
  const auto found = std::find(ids.begin(), ids.end(), handle);
  return found == ids.end() ? Values{} : deformer->binding().influence(static_cast<int>(found - ids.begin()));
}

Values BoundOrgan::weightsAt(Eigen::Index vertex, const std::vector<document::Handle>& handles) const {
  if (!deformer || vertex >= deformer->binding().pointCount())
    return {};
  const coordinates::Binding& binding = deformer->binding();
  const auto& ids = boundTo->ids;
  Values weights = Values::Zero(static_cast<Eigen::Index>(handles.size()));
  for (std::size_t row = 0; row < handles.size(); ++row) {
    // The organ is, as a rule, bound to the handles in the order that they have.
    const auto at = row < ids.size() && ids[row] == handles[row].id
                        ? ids.begin() + static_cast<std::ptrdiff_t>(row)
                        : std::find(ids.begin(), ids.end(), handles[row].id);
    if (at != ids.end())
      weights[static_cast<Eigen::Index>(row)] = binding.weight(vertex, static_cast<int>(at - ids.begin()));
  }
  return weights;
}

const deformation::Deformer* BoundOrgan::bound() const {
  if (status.state == State::binding || status.state == State::stale)
    throw DataError("its volume can be kept only after it is bound to the present handles",
                    named(organ->name), status.state == State::binding ? "wait a moment" : "bind it first");
  return status.state == State::bound ? deformer.get() : nullptr;
}

std::unique_ptr<BoundOrgans> BoundOrgans::copy() const {
  auto other = std::make_unique<BoundOrgans>(*this);
  for (auto& [id, organ] : other->organs)
    if (organ.deformer)
      organ.deformer = std::make_shared<deformation::Deformer>(*organ.deformer);
  return other;
}

const BoundOrgan& BoundOrgans::require(document::OrganId id) const {
  const auto found = organs.find(id);
  if (found == organs.end())
    throw UsageError("There is no such organ any more", phrase("organ %1", id.value));
  return found->second;
}

void BoundOrgans::requirePose(const Points& pose) const {
  const auto handles = static_cast<Eigen::Index>(target->ids.size());
  if (pose.rows() != handles)
    throw DataError(misuse("The pose has %1 handles, the document %2", pose.rows(), handles));
  if (!(pose.array().abs() <= document::kFarthestMm).all())
    throw DataError("The pose has a position that is not a finite number, or too far away");
}

void BoundOrgans::setShownPose(const Points& pose) {
  requirePose(pose);
  shownPose = std::make_shared<const Points>(pose);
}

void BoundOrgans::poseAll(bool interactive) {
  std::vector<deformation::NewPose> poses;
  for (auto& [id, organ] : organs)
    if (auto pose = organ.poseFor(*target, shownPose, interactive))
      poses.push_back(std::move(*pose));
  deformation::poseTogether(poses, threads);
}

void BoundOrgans::poseOne(BoundOrgan& organ) {
  if (auto pose = organ.poseFor(*target, shownPose, false))
    deformation::poseTogether({std::move(*pose)}, threads);
}

OrganVolume BoundOrgans::volume(document::OrganId id) {
  const BoundOrgan& organ = require(id);
  if (!organ.volumeKnown())
    measureMoved();
  return organ.volume();
}

/// Whoever shows one volume of a pose shows the others as well: one loop measures all.
void BoundOrgans::measureMoved() {
  std::vector<deformation::Deformer*> moved;
  for (const auto& [id, organ] : organs)
    if (!organ.volumeKnown())
      moved.push_back(organ.deformer.get());
  deformation::volumesTogether(moved, threads);
  ++measurings;
}

} // namespace viscera::live
