#include "viscera/live/locked_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::live {
namespace {

/// A motion with a gradient this much smaller than the surface cannot change the volume.
constexpr double kNoInfluence = 1e-12;
/// The best that rounding allows; more steps would follow noise.
constexpr double kRoundingOfVolume = 1e-13;
constexpr int kMostSteps = 12;
/// Fractions of the way to a target that are tried if all of it is too much.
constexpr double kParts[] = {1, 0.5, 0.25, 0.125};

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

} // namespace

LockedMotion::LockedMotion(Setup setup)
    : setup_(std::move(setup)), pose_(std::make_shared<const Points>(setup_.start)), wanted_(setup_.start) {
  if (setup_.mirror)
    for (const int partner : setup_.mirror->partners)
      if (partner >= 0 && !contains(setup_.selection, partner) && !contains(partners_, partner))
        partners_.push_back(partner);
  for (std::vector<int>* others : {&setup_.compensating, &setup_.following})
    std::erase_if(*others,
                  [&](int row) { return contains(setup_.selection, row) || contains(partners_, row); });
  if (setup_.tissue)
    translations_ = Way::compensated;
  else if (setup_.lock)
    chooseWay();
}

/// How translations keep the volumes: that depends on how many surfaces the motion has an influence on.
void LockedMotion::chooseWay() {
  const auto& surfaces = setup_.lock->surfaces();
  const Points gradients = gradientsOfMotion(setup_.start);
  int influenced = 0;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const Vec3 gradient = gradients.row(static_cast<Eigen::Index>(k)).transpose();
    if (gradient.norm() <= leastInfluence(k))
      continue;
    ++influenced;
    bending_ = k;
    gradient_ = gradient;
  }
  if (influenced > 0)
    translations_ = influenced > 1 || setup_.alwaysCompensate ? Way::compensated : Way::bent;
}

double LockedMotion::leastInfluence(std::size_t surface) const {
  return kNoInfluence * std::pow(setup_.lock->surfaces()[surface].targetMm3, 2.0 / 3);
}

/// The component of a vector in the plane in which translations stay.
Vec3 LockedMotion::inPlane(const Vec3& vector) const {
  return setup_.plane ? Vec3(vector - setup_.plane->dot(vector) * *setup_.plane) : vector;
}

/// The way along which a translation is corrected. Zero where it cannot be: in a plane that has only the
/// gradient's rounding, the correction would go in any direction.
Vec3 LockedMotion::correction(const Vec3& gradient) const {
  const Vec3 way = inPlane(gradient);
  return way.norm() <= leastInfluence(bending_) ? Vec3(Vec3::Zero()) : way;
}

/// The start with the selection, and the partners, translated.
Points LockedMotion::moved(const Vec3& by) const {
  if (!setup_.mirror)
    return deformation::translated(setup_.start, setup_.selection, by);
  return deformation::mirroredTranslation(setup_.start, setup_.selection, setup_.mirror->partners,
                                          setup_.mirror->plane, by);
}

/// How the volumes change with the vector of the motion, `surfaces x 3`.
Points LockedMotion::gradientsOfMotion(const Points& pose) const {
  Points gradients = setup_.lock->translationGradient(pose, setup_.selection);
  if (partners_.empty())
    return gradients;
  const Points ofPartners = setup_.lock->translationGradient(pose, partners_);
  for (Eigen::Index k = 0; k < gradients.rows(); ++k)
    gradients.row(k) += setup_.mirror->plane.reflectedDirection(ofPartners.row(k).transpose()).transpose();
  return gradients;
}

Vec3 LockedMotion::planeNormal() const {
  return translations_ == Way::bent ? Vec3(gradient_.normalized()) : Vec3(Vec3::Zero());
}

double LockedMotion::relativeError(const std::vector<double>& volumes) const {
  double worst = 0;
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    const double target = setup_.lock->surfaces()[k].targetMm3;
    worst = std::max(worst, std::abs(volumes[k] - target) / target);
  }
  return worst;
}

/// Goes to the point nearest to `wanted` on the surface of constant volume, by Newton's steps: one is enough
/// where that surface is a plane. `wanted` lies in the plane that holds translations, and so does what is
/// added.
bool LockedMotion::bend(const Vec3& wanted) {
  const double target = setup_.lock->surfaces()[bending_].targetMm3;
  Vec3 way = correction(gradient_);
  Vec3 by = Vec3::Zero();
  double missing = target - setup_.lock->volumes(setup_.start)[bending_];
  double error = 0;
  Points pose;
  for (int step = 0; step < kMostSteps; ++step) {
    // The nearest point of the tangent plane at `by`, where the volume is short of `missing`.
    // by' = wanted + way (missing - way . (wanted - by)) / |way|^2, of which way . (by' - by) = missing.
    const double steepness = way.squaredNorm();
    by = steepness > 0 ? Vec3(wanted + way * ((missing - way.dot(wanted - by)) / steepness)) : wanted;
    pose = moved(by);
    const auto volumes = setup_.lock->volumes(pose);
    const double before = std::exchange(error, relativeError(volumes));
    if (error <= kRoundingOfVolume || (step > 0 && error >= before))
      break;
    missing = target - volumes[bending_];
    way = correction(gradientsOfMotion(pose).row(static_cast<Eigen::Index>(bending_)).transpose());
    if (way.squaredNorm() == 0)
      break;
  }
  if (!(error <= deformation::VolumeLock::kRelativeTolerance) || !pose.allFinite())
    return false;
  take(std::move(pose));
  wantedBy_ = wanted;
  return true;
}

/// The wanted pose with the following handles where the energy is least, from where they are now.
Points LockedMotion::followed(const Points& wanted) const {
  if (!setup_.tissue || wanted == setup_.start)
    return wanted;
  Points start = wanted;
  for (const int row : setup_.following)
    start.row(row) = pose_->row(row);
  return setup_.tissue->relax(start, setup_.following, setup_.lock.get()).pose;
}

bool LockedMotion::compensate(const Points& wanted) {
  Points target = followed(wanted);
  if (!setup_.lock) {
    take(std::move(target));
    wanted_ = wanted;
    return true;
  }
  deformation::RestoredPose restored =
      setup_.lock->restore(target, setup_.compensating, deformation::LeastDisplacement(), setup_.limitMm);
  if (!restored.restored) {
    if (obstacle_.empty())
      obstacle_ = restored.reason;
    return false;
  }
  take(std::move(restored.pose));
  wanted_ = wanted;
  return true;
}

const Points& LockedMotion::translate(const Vec3& wanted) {
  const Vec3 by = inPlane(wanted);
  obstacle_ = {};
  asked_ = by;
  if (translations_ == Way::free) {
    take(moved(by));
    return *pose_;
  }
  if (translations_ == Way::compensated)
    return compensateUpTo(moved(by));
  const Vec3 from = wantedBy_;
  for (const double part : kParts)
    if (bend(from + part * (by - from)))
      return *pose_;
  obstacle_ = "no motion near to this one keeps the volume";
  return *pose_;
}

const Points& LockedMotion::rotate(const Vec3& center, const Vec3& axis, double angle) {
  return reach(deformation::rotated(setup_.start, setup_.selection, center, axis, angle));
}

const Points& LockedMotion::scale(const Vec3& center, const Vec3& factors) {
  return reach(deformation::scaled(setup_.start, setup_.selection, center, factors));
}

Vec3 LockedMotion::given() const {
  if (setup_.selection.empty())
    return Vec3::Zero();
  const int first = setup_.selection.front();
  return (pose_->row(first) - setup_.start.row(first)).transpose();
}

const Points& LockedMotion::reach(const Points& wanted) {
  asked_.reset();
  return compensateUpTo(wanted);
}

/// Goes to `wanted`, or as far on the way there as the others can compensate.
const Points& LockedMotion::compensateUpTo(const Points& wanted) {
  obstacle_ = {};
  if (!setup_.lock && !setup_.tissue) {
    take(wanted);
    return *pose_;
  }
  const Points from = wanted_;
  for (const double part : kParts)
    if (compensate(part == 1 ? wanted : Points(from + part * (wanted - from))))
      break;
  return *pose_;
}

void requireExact(const LockedMotion& motion, const Vec3& by) {
  if (!motion.obstacle().empty())
    throw DataError(
        phrase("the handles cannot move by exactly %1 mm: %2", inFixed(by.norm(), 2), motion.obstacle()), {},
        "move less far, or let more handles compensate");
}

} // namespace viscera::live
