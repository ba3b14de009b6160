#include "viscera/deformation/volume_lock.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/QR>

#include "viscera/core/cubic_root.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

constexpr int kMostNewtonSteps = 20;
/// The polynomial's root is as good as rounding allows; more Newton steps than this only follow noise.
constexpr double kRoundingOfVolume = 1e-13;

void requireClosed(const LockedSurface& surface) {
  const auto report = geometry::checkSurface(*surface.rest);
  if (!report.closed())
    throw DataError(
        phrase("the surface is open (%n boundary {edge|edges}), so it has no volume that could be locked",
               report.boundaryEdges),
        named(surface.name), "close its holes first");
}

void requireTarget(const LockedSurface& surface) {
  if (!(surface.targetMm3 > 0) || !std::isfinite(surface.targetMm3))
    throw DataError("a locked volume must be positive", named(surface.name),
                    "turn the surface outward, or choose a target above 0 ml");
}

double longestRow(const Points& rows) {
  return rows.rows() == 0 ? 0.0 : rows.rowwise().norm().maxCoeff();
}

double innerProduct(const Points& a, const Points& b) {
  return a.cwiseProduct(b).sum();
}

} // namespace

VolumeLock::VolumeLock(std::vector<LockedSurface> surfaces, Threads threads)
    : VolumeLock(std::move(surfaces), threads, Forms::whenAsked, {}) {}

VolumeLock::VolumeLock(std::vector<LockedSurface> surfaces, Threads threads, Forms forms,
                       const std::vector<std::shared_ptr<const VolumeLock>>& known)
    : surfaces_(std::move(surfaces)), threads_(threads) {
  for (const auto& surface : surfaces_) {
    assert(surface.rest->points.rows() == surface.binding->pointCount());
    assert(surface.binding->handleCount() == surfaces_.front().binding->handleCount());
    Surface own;
    for (const auto& other : known)
      if (other)
        other->takeOver(own, surface);
    if (!own.around) {
      requireClosed(surface);
      own.around = std::make_shared<const geometry::VertexTriangles>(
          geometry::vertexTriangles(surface.rest->points.rows(), surface.rest->triangles));
    }
    requireTarget(surface);
    if (!own.form && forms == Forms::whenAsked)
      own.form = std::make_shared<Form>();
    known_.push_back(std::move(own));
  }
}

/// Adds to `own` what is known here about a surface.
void VolumeLock::takeOver(Surface& own, const LockedSurface& surface) const {
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    if (surfaces_[k].rest != surface.rest)
      continue;
    own.around = known_[k].around;
    if (!own.form && surfaces_[k].binding == surface.binding)
      own.form = known_[k].form;
  }
}

void VolumeLock::setTarget(std::size_t surface, double targetMm3) {
  LockedSurface changed = surfaces_.at(surface);
  changed.targetMm3 = targetMm3;
  requireTarget(changed);
  surfaces_[surface] = std::move(changed);
}

const VolumeForm* VolumeLock::form(std::size_t surface) const {
  Progress ignored;
  return form(surface, ignored);
}

const VolumeForm* VolumeLock::form(std::size_t surface, Progress& progress) const {
  if (!known_[surface].form)
    return nullptr;
  const LockedSurface& locked = surfaces_[surface];
  Form& own = *known_[surface].form;
  if (!own.asked) {
    const std::lock_guard lock(own.making);
    if (!own.asked && VolumeForm::pays(locked.binding->pointCount(), locked.binding->handleCount()))
      own.made = VolumeForm::of(*locked.rest, *locked.binding, threads_, progress);
    own.asked = true;
  }
  return own.made ? &*own.made : nullptr;
}

void VolumeLock::makeForms(Progress& progress) const {
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(k) / static_cast<double>(surfaces_.size()));
    form(k, progress);
  }
  progress.report(1);
}

void VolumeLock::shape(std::size_t surface, const Points& pose, Points& points) const {
  surfaces_[surface].binding->deform(pose, points, threads_);
}

std::vector<double> VolumeLock::volumes(const Points& pose) const {
  if (surfaces_.size() == 1) // A binding that has no pieces then still has all threads.
    return {volumeOnSurface(0, pose)};
  std::vector<Points> points(surfaces_.size());
  std::vector<PiecesOfWork> works;
  for (std::size_t k = 0; k < surfaces_.size(); ++k)
    works.push_back(surfaces_[k].binding->deformInPieces(pose, points[k]));
  parallelPieces(works, threads_);
  std::vector<geometry::VolumeSum> sums;
  sums.reserve(surfaces_.size()); // They must stay where they are.
  works.clear();
  for (std::size_t k = 0; k < surfaces_.size(); ++k)
    works.push_back(sums.emplace_back(points[k], surfaces_[k].rest->triangles).pieces());
  parallelPieces(works, threads_);
  std::vector<double> result;
  for (const geometry::VolumeSum& sum : sums)
    result.push_back(sum.volume());
  return result;
}

/// The surface in this pose, which is computed unless `posed` holds it.
const VolumeLock::PosedSurface& VolumeLock::posedSurface(std::size_t surface, const Points& pose,
                                                         PosedSurfaces& posed) const {
  PosedSurface& there = posed[surface];
  if (there.pose.rows() == pose.rows() && there.pose == pose)
    return there;
  shape(surface, pose, there.points);
  there.volume = geometry::volume(there.points, surfaces_[surface].rest->triangles, threads_);
  there.pose = pose;
  return there;
}

double VolumeLock::volume(std::size_t surface, const Points& pose, PosedSurfaces& posed) const {
  const VolumeForm* known = form(surface);
  return known ? known->volume(pose) : posedSurface(surface, pose, posed).volume;
}

double VolumeLock::volumeOnSurface(std::size_t surface, const Points& pose) const {
  Points points;
  shape(surface, pose, points);
  return geometry::volume(points, surfaces_[surface].rest->triangles, threads_);
}

double VolumeLock::error(const std::vector<double>& volumes) const {
  double worst = 0;
  for (std::size_t k = 0; k < surfaces_.size(); ++k)
    worst = std::max(worst, std::abs(volumes[k] - surfaces_[k].targetMm3) / surfaces_[k].targetMm3);
  return worst;
}

/// Measures on the surfaces themselves.
double VolumeLock::measuredError(const Points& pose, PosedSurfaces& posed) const {
  std::vector<double> now;
  for (std::size_t k = 0; k < surfaces_.size(); ++k)
    now.push_back(posedSurface(k, pose, posed).volume);
  return error(now);
}

/// Uses the forms, where there are some.
double VolumeLock::expectedError(const Points& pose, PosedSurfaces& posed) const {
  std::vector<double> now;
  for (std::size_t k = 0; k < surfaces_.size(); ++k)
    now.push_back(volume(k, pose, posed));
  return error(now);
}

Points VolumeLock::gradientOnSurface(std::size_t surface, const Points& pose) const {
  const auto& locked = surfaces_[surface];
  Points points, ofPoints, ofHandles;
  shape(surface, pose, points);
  geometry::volumeGradient(points, locked.rest->triangles, *known_[surface].around, ofPoints, threads_);
  locked.binding->pullBack(pose, ofPoints, ofHandles, threads_);
  return ofHandles;
}

Points VolumeLock::gradientOnSurface(std::size_t surface, const Points& pose, PosedSurfaces& posed) const {
  const auto& locked = surfaces_[surface];
  Points ofPoints, ofHandles;
  geometry::volumeGradient(posedSurface(surface, pose, posed).points, locked.rest->triangles,
                           *known_[surface].around, ofPoints, threads_);
  locked.binding->pullBack(pose, ofPoints, ofHandles, threads_);
  return ofHandles;
}

Points VolumeLock::gradient(std::size_t surface, const Points& pose, PosedSurfaces& posed) const {
  const VolumeForm* known = form(surface);
  if (!known)
    return gradientOnSurface(surface, pose, posed);
  Points ofHandles;
  known->gradient(pose, ofHandles);
  return ofHandles;
}

std::vector<double> VolumeLock::expectedVolumes(const Points& pose) const {
  PosedSurfaces posed(surfaces_.size());
  std::vector<double> found;
  for (std::size_t k = 0; k < surfaces_.size(); ++k)
    found.push_back(volume(k, pose, posed));
  return found;
}

std::vector<Points> VolumeLock::gradients(const Points& pose) const {
  PosedSurfaces posed(surfaces_.size());
  std::vector<Points> found;
  for (std::size_t k = 0; k < surfaces_.size(); ++k)
    found.push_back(gradient(k, pose, posed));
  return found;
}

Points VolumeLock::translationGradient(const Points& pose, const std::vector<int>& selection) const {
  Points rows = Points::Zero(static_cast<Eigen::Index>(surfaces_.size()), 3);
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    const Points handles = gradientOnSurface(k, pose);
    for (const int handle : selection)
      rows.row(static_cast<Eigen::Index>(k)) += handles.row(handle);
  }
  return rows;
}

/// The only surface's volume at `pose + s direction` as a cubic in s.
std::array<double, 4> VolumeLock::along(const Points& pose, const Points& direction,
                                        PosedSurfaces& posed) const {
  if (const VolumeForm* known = form(0))
    return known->along(pose, direction);
  const auto& triangles = surfaces_.front().rest->triangles;
  const auto& around = *known_.front().around;
  const PosedSurface& here = posedSurface(0, pose, posed);
  const Points& points = here.points;
  Points moved, gradientAtPoints, gradientAtMotion;
  shape(0, pose + direction, moved);
  const Points motion = moved - points;
  // V is a cubic form of the points: V(P + sQ) = V(P) + s DV(P)[Q] + s^2 DV(Q)[P] + s^3 V(Q).
  geometry::volumeGradient(points, triangles, around, gradientAtPoints, threads_);
  geometry::volumeGradient(motion, triangles, around, gradientAtMotion, threads_);
  return {here.volume, innerProduct(gradientAtPoints, motion), innerProduct(gradientAtMotion, points),
          geometry::volume(motion, triangles, threads_)};
}

/// The step along `direction` that gives the only surface its target; NaN when there is none within
/// `limitMm`.
double VolumeLock::cubicStep(const Points& pose, const Points& direction, double limitMm,
                             PosedSurfaces& posed) const {
  const double longest = longestRow(direction);
  if (longest == 0)
    return std::nan("");
  // The root of V(pose + s direction) - target nearest to s = 0.
  std::array<double, 4> cubic = along(pose, direction, posed);
  cubic[0] -= surfaces_.front().targetMm3;
  return nearestCubicRoot(cubic, -limitMm / longest, limitMm / longest).value_or(std::nan(""));
}

/// One Newton step of all volumes at once, in the span of the surfaces' restoring directions; false when
/// singular.
bool VolumeLock::newtonStep(Points& pose, const std::vector<int>& free, const RestorationModel& model,
                            PosedSurfaces& posed) const {
  const auto count = static_cast<Eigen::Index>(surfaces_.size());
  std::vector<Points> gradients, directions;
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    gradients.push_back(gradient(k, pose, posed));
    directions.push_back(model.direction(pose, gradients.back(), free));
  }
  // sum_j <g_k, d_j> s_j = target_k - V_k for each surface k, then pose += sum_j s_j d_j.
  Eigen::MatrixXd system(count, count);
  Values missing(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    missing[k] = surfaces_[std::size_t(k)].targetMm3 - volume(std::size_t(k), pose, posed);
    for (Eigen::Index j = 0; j < count; ++j)
      system(k, j) = innerProduct(gradients[std::size_t(k)], directions[std::size_t(j)]);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(system);
  if (!solver.isInvertible())
    return false;
  const Values steps = solver.solve(missing);
  for (Eigen::Index j = 0; j < count; ++j)
    pose += steps[j] * directions[std::size_t(j)];
  return pose.allFinite();
}

RestoredPose VolumeLock::restore(const Points& wanted, const std::vector<int>& free,
                                 const RestorationModel& model, double limitMm) const {
  PosedSurfaces posed(surfaces_.size()), posedNext(surfaces_.size());
  RestoredPose result{wanted, false, 0, measuredError(wanted, posed), {}};
  const auto fail = [&](const Text& reason) {
    result.reason = reason;
    return result;
  };
  Points pose = wanted;
  double left = result.relativeError;
  if (left > kRoundingOfVolume && free.empty())
    return fail("no handle is left to compensate the change of volume");
  if (left > kRoundingOfVolume && surfaces_.size() == 1) {
    Points slope = gradient(0, pose, posed);
    pose += model.relaxation(pose, slope, free);
    if (pose != wanted)
      slope = gradient(0, pose, posed);
    Points direction = model.direction(pose, slope, free);
    // A step of a millimetre: where points are not linear in the pose, the cubic is what holds near by.
    if (const double longest = longestRow(direction); longest > 0)
      direction /= longest;
    const double step = cubicStep(pose, direction, limitMm, posed);
    if (!std::isfinite(step))
      return fail(phrase("no compensation within %1 mm restores the volume", std::lround(limitMm)));
    pose += step * direction;
    left = expectedError(pose, posed);
  }
  // Rounding, several surfaces, or coordinates that are not linear: Newton's steps double the digits.
  for (int i = 0; i < kMostNewtonSteps && left > kRoundingOfVolume; ++i) {
    Points next = pose;
    if (!newtonStep(next, free, model, posed))
      break;
    const double nextLeft = expectedError(next, posedNext);
    if (!(nextLeft < left))
      break;
    pose = std::move(next);
    std::swap(posed, posedNext);
    left = nextLeft;
  }
  const double shift = longestRow(pose - wanted);
  const double reached = measuredError(pose, posed);
  if (!(reached <= kRelativeTolerance))
    return fail("the handles that may compensate cannot restore the volume");
  if (shift > limitMm)
    return fail(phrase("restoring the volume would move a handle by %1 mm", std::lround(shift)));
  return {std::move(pose), true, shift, reached, {}};
}

std::vector<int> restingHandles(const Points& restHandles, const Points& pose) {
  std::vector<int> resting;
  for (Eigen::Index i = 0; i < restHandles.rows(); ++i)
    if (restHandles.row(i) == pose.row(i))
      resting.push_back(static_cast<int>(i));
  return resting;
}

void restoreVolume(Deformer& deformer, double targetMm3, const std::vector<int>& compensating,
                   const RestorationModel& model) {
  if (compensating.empty())
    throw UsageError("no handle is left to compensate the change of volume", {}, "name compensating handles");
  std::vector<int> free = compensating;
  std::sort(free.begin(), free.end());
  if (free.front() < 0 || free.back() >= deformer.pose().rows())
    throw UsageError(misuse("there is no handle %1", free.front() < 0 ? free.front() : free.back()),
                     "compensating handles");
  const VolumeLock lock({{"organ", deformer.sharedRest(), deformer.sharedBinding(), targetMm3}});
  const double limit = boundsOf(deformer.restHandles()).diagonal();
  const auto restored = lock.restore(deformer.pose(), free, model, limit);
  if (!restored.restored)
    throw DataError(restored.reason, "volume",
                    "let more handles compensate, or ask for a volume nearer to the present one");
  deformer.setPose(restored.pose);
}

} // namespace viscera::deformation
