#include "viscera/live/live_warp.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bound_organ.h"
#include "viscera/core/error.h"
#include "viscera/deformation/stiff_bodies.h"
#include "viscera/live/movable_binding.h"

namespace viscera::live {

using deformation::InverseMap;

namespace {

constexpr const char* kSlot = "bend"; ///< Of the job queue.

using StiffOrgans = std::vector<std::shared_ptr<const document::Organ>>;

/// A map with what does not bend in it, and what binding a point for it took.
struct BoundMap {
  std::shared_ptr<InverseMap> map = nullptr;
  std::shared_ptr<deformation::StiffBodies> stiff = nullptr;
  double secondsPerPoint = 0;
};

bool sameBodies(const StiffOrgans& a, const StiffOrgans& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one->id == other->id && one->mesh == other->mesh;
  });
}

/// `known` are the bodies, where they are known already.
BoundMap bindMap(const BindingTarget& target, const StiffOrgans& stiff,
                 std::shared_ptr<deformation::StiffBodies> known, const Points& pose, Threads threads,
                 Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  BoundMap bound;
  bound.map = std::make_shared<InverseMap>(*target.system, target.handles, pose,
                                           coordinates::BindOptions{target.parameters, threads},
                                           deformation::InverseMapOptions(), progress);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  bound.secondsPerPoint =
      took.count() / static_cast<double>(std::max<Eigen::Index>(bound.map->boundPoints(), 1));
  bound.stiff = known ? std::move(known) : stiffBodies(stiff, threads, progress);
  return bound;
}

} // namespace

struct LiveWarp::Impl {
  const document::Document& document;
  LiveBinding& live;
  const coordinates::Registry& registry;
  JobQueue& jobs;
  Options options;
  Signal<> changed = {};
  Subscription subscription = {};
  bool wanted = false;
  bool binding = false;
  std::uint64_t jobsBegun = 0;
  std::optional<BindingTarget> target = {}; ///< Of `bound`, or of what is being bound.
  StiffOrgans stiff = {};                   ///< The same.
  BoundMap bound = {};
  std::shared_ptr<const Points> pose = {};        ///< That the map is in; null: none.
  std::vector<std::uint64_t> stiffRevisions = {}; ///< Of the organs' points that `bound.stiff` is in.
  std::uint64_t revision = 0;
  Text problem = {};

  bool posed() const {
    const Points rest = document.rig().restPositions();
    const Points& shown = live.shownPose();
    return shown.rows() == rest.rows() && rest.rows() > 0 && shown != rest;
  }
  void follow();
  void bind(std::shared_ptr<const deformation::StiffBodies> known);
  void giveUp();
  void take(const JobResult<BoundMap>& result);
  bool poseStiff();
};

/// Binds anew if the map is needed and the present one belongs to other handles. At rest nothing is bound:
/// the grid is made as fine as the first pose asks for.
void LiveWarp::Impl::follow() {
  if (!wanted || !posed())
    return;
  BindingTarget now = makeTarget(document.state(), registry);
  StiffOrgans stiffNow = stiffOrgans(document.organs());
  if (target && sameBinding(*target, now) && sameBodies(stiff, stiffNow))
    return;
  if (binding && target && worthWaitingFor(*target, now))
    return;
  const auto known = sameBodies(stiff, stiffNow) ? bound.stiff : nullptr;
  bound = {};
  ++revision;
  problem = {};
  target = now;
  stiff = std::move(stiffNow);
  if (!now.system) {
    problem = now.problem;
    giveUp();
    return;
  }
  bind(known);
}

/// Cancels a binding that is no longer needed.
void LiveWarp::Impl::giveUp() {
  ++jobsBegun;
  binding = false;
  jobs.cancelSlot(kSlot);
}

void LiveWarp::Impl::bind(std::shared_ptr<const deformation::StiffBodies> known) {
  binding = true;
  // A copy: those that are shown go on moving while the worker is at it.
  const auto own = known ? std::make_shared<deformation::StiffBodies>(*known) : nullptr;
  jobs.submit<BoundMap>(
      "Warping the scan", kSlot,
      [to = *target, bodies = stiff, own, first = live.shownPose(), threads = options.threads](
          Progress& progress) { return bindMap(to, bodies, own, first, threads, progress); },
      [this, job = ++jobsBegun](const JobResult<BoundMap>& result) {
        if (job == jobsBegun) // Else another one has taken its place.
          take(result);
      });
}

void LiveWarp::Impl::take(const JobResult<BoundMap>& result) {
  binding = false;
  if (result.cancelled()) { // The job was cancelled; the next change tries again.
    target.reset();
    return;
  }
  if (result.value)
    bound = *result.value;
  if (result.error)
    problem = result.error->explanation();
  pose.reset();
  stiffRevisions.clear();
  ++revision;
  follow(); // For changes in the meantime.
  changed.emit();
}

/// Moves the bodies to where their organs are now; whether that was another place.
bool LiveWarp::Impl::poseStiff() {
  if (stiff.empty() || !bound.stiff)
    return false;
  std::vector<std::uint64_t> revisions;
  std::vector<std::shared_ptr<const Points>> points;
  for (const auto& organ : stiff) {
    revisions.push_back(live.revision(organ->id));
    points.push_back(live.sharedPoints(organ->id));
  }
  if (revisions == stiffRevisions)
    return false;
  stiffRevisions = std::move(revisions);
  std::vector<const Points*> posedPoints;
  for (const auto& own : points)
    posedPoints.push_back(own.get());
  bound.stiff->setPose(posedPoints, *bound.map);
  return true;
}

LiveWarp::LiveWarp(const document::Document& document, LiveBinding& live,
                   const coordinates::Registry& registry, JobQueue& jobs, Options options)
    : impl_(new Impl{document, live, registry, jobs, options}) {
  impl_->subscription = live.onDerive([this] { impl_->follow(); });
}

LiveWarp::~LiveWarp() = default;

void LiveWarp::setWanted(bool wanted) {
  if (std::exchange(impl_->wanted, wanted) == wanted)
    return;
  impl_->follow();
  if (impl_->bound.map)
    impl_->changed.emit();
}

bool LiveWarp::warpsScan() {
  return impl_->document.state().scan && map();
}

const InverseMap* LiveWarp::map() {
  Impl& p = *impl_;
  p.follow();
  if (!p.wanted || !p.bound.map || !p.target || !p.target->system || !p.posed())
    return nullptr;
  const std::shared_ptr<const Points> shown = p.live.sharedPose();
  const bool another = !p.pose || !samePose(*p.pose, *shown);
  if (another) {
    p.bound.map->setPose(*shown);
    p.pose = shown;
    p.stiffRevisions.clear();
  }
  if (p.poseStiff() || another)
    ++p.revision;
  if (another) {
    if (p.bound.map->wantsFinerGrid() && !p.binding && p.problem.empty())
      p.bind(p.bound.stiff); // This one serves until that is there.
  }
  return p.bound.map.get();
}

void LiveWarp::restPlane(const deformation::SamplePlane& plane, deformation::RestPoints& rest) {
  const InverseMap& known = *map();
  known.restPlane(plane, rest);
  const double most = impl_->options.refineSeconds / std::max(impl_->bound.secondsPerPoint, 1e-12);
  deformation::Refinement refinement{.toleranceMm = kWarpToleranceMm};
  if (most < static_cast<double>(rest.points.rows()))
    refinement.mostPoints = static_cast<Eigen::Index>(most);
  Progress quiet;
  known.refinePlane(*impl_->target->system, plane, refinement, rest, quiet);
  impl_->bound.stiff->stiffen(plane, rest);
}

Vec3 LiveWarp::restOf(const Vec3& place) {
  const InverseMap* known = map();
  return known ? impl_->bound.stiff->restOf(*known, place) : place;
}

Vec3 LiveWarp::posedOf(const Vec3& rest) {
  const InverseMap* known = map();
  return known ? impl_->bound.stiff->posedOf(*known, rest) : rest;
}

double LiveWarp::foldedMl() {
  const InverseMap* known = map();
  return known ? known->foldedMl() : 0;
}

std::uint64_t LiveWarp::revision() const {
  return impl_->revision;
}

const Text& LiveWarp::problem() const {
  return impl_->problem;
}

Subscription LiveWarp::onChange(std::function<void()> observer) {
  return impl_->changed.connect(std::move(observer));
}

document::TissueMotion tissueMotionOf(LiveWarp& warp) {
  if (!warp.warpsScan())
    return {};
  return [&warp](const Vec3& rest) { return warp.posedOf(rest); };
}

document::TissueMotion measuredTissueOf(LiveWarp& warp, const document::MeasurementList& measurements) {
  if (!warp.warpsScan())
    return {};
  std::vector<std::pair<Vec3, Vec3>> places;
  for (const document::Measurement& measurement : measurements)
    for (const document::MeasuredPoint& point : measurement.points)
      if (!point.organ)
        places.emplace_back(point.rest, warp.posedOf(point.rest));
  return [places = std::move(places)](const Vec3& rest) {
    const auto known =
        std::find_if(places.begin(), places.end(), [&](const auto& place) { return place.first == rest; });
    return known == places.end() ? rest : known->second;
  };
}

} // namespace viscera::live
