#include "viscera/live/textbook_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/geometry/volume.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/tracking/motion_rig.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;

constexpr const char* kName = "Textbook heartbeat";
constexpr int kDiastoleInstants = 400; ///< At which the end of diastole is looked for.
constexpr double kLeastEjection = 0.1, kMostEjection = 0.8;
/// Atria hold between these parts of what they hold at the end of diastole.
constexpr double kLeastAtrial = 0.7, kMostAtrial = 2.5;

double volumeMl(const Points& points, const TriangleMesh& surface) {
  return geometry::volume(points, surface.triangles) / kMm3PerMl;
}

Vec3 middleOf(const Points& points) {
  return points.colwise().mean().transpose();
}

/// Moves `points` towards the line through `anchor` along `axis` so that they enclose `part` of the volume:
/// an affine map whose determinant is that.
void narrow(Points& points, const Vec3& anchor, const Vec3& axis, double part) {
  const double scale = std::sqrt(part);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 from = points.row(i).transpose() - anchor;
    const Vec3 along = from.dot(axis) * axis;
    points.row(i) = (anchor + along + scale * (from - along)).transpose();
  }
}

/// Grows `points` about their middle to `part` of the volume.
void swell(Points& points, double part) {
  const Vec3 middle = middleOf(points);
  points = (std::cbrt(part) * (points.rowwise() - middle.transpose())).rowwise() + middle.transpose();
}

/// Moves the surfaces of a heart through a beat.
class TextbookHeart {
public:
  TextbookHeart(const std::vector<std::shared_ptr<const TriangleMesh>>& rest,
                const std::vector<std::string>& names, double ejection, const Vec3& axis)
      : axis_(axis) {
    for (std::size_t i = 0; i < rest.size(); ++i) {
      rest_.push_back(*rest[i]);
      restMl_.push_back(volumeMl(rest[i]->points, *rest[i]));
      chambers_.push_back(i == 0 ? std::nullopt : anatomy::chamberNamed(names[i]));
      if (chambers_[i] == anatomy::kLeftVentricle)
        left_ = static_cast<int>(i);
      if (chambers_[i] == anatomy::kRightVentricle)
        right_ = static_cast<int>(i);
      if (isAtrium(i))
        atriaMl_ += restMl_[i];
      tissueMl_ += (i == 0 ? 1 : -1) * restMl_[i];
    }
    if (left_ < 0 && right_ < 0)
      throw DataError("No cavity is a ventricle by its name", "heart",
                      "call the left ventricle's cavity LV and the right one's RV");
    leftEjection_ = ejection;
    rightEjection_ = ejection;
    if (left_ >= 0 && right_ >= 0) // Both ventricles eject as much.
      rightEjection_ =
          std::clamp(ejection * restMl_[at(left_)] / restMl_[at(right_)], kLeastEjection, kMostEjection);
  }

  /// Whether the right ventricle is too small to eject what the left one does.
  bool rightFallsShort() const {
    return left_ >= 0 && right_ >= 0 &&
           leftEjection_ * restMl_[at(left_)] > kMostEjection * restMl_[at(right_)];
  }

  /// `moved` are the surfaces as the outer one carries them; `emptying` of both ventricles, 0 at first.
  void beat(std::vector<Points>& moved, double leftEmptying, double rightEmptying) const {
    double ventricles = 0, still = 0;
    for (std::size_t i = 1; i < moved.size(); ++i) {
      if (chambers_[i] == anatomy::kLeftVentricle || chambers_[i] == anatomy::kRightVentricle) {
        const bool isLeft = chambers_[i] == anatomy::kLeftVentricle;
        const double wanted =
            restMl_[i] * (1 - (isLeft ? leftEjection_ * leftEmptying : rightEjection_ * rightEmptying));
        narrow(moved[i], isLeft ? middleOf(moved[i]) : septalAnchor(moved), axis_,
               wanted / volumeMl(moved[i], rest_[i]));
        ventricles += wanted;
      } else if (!isAtrium(i)) {
        still += volumeMl(moved[i], rest_[i]);
      }
    }
    if (atriaMl_ > 0) {
      // V_outer = tissue + ventricles + atria + the rest, and the tissue keeps its volume: the atria hold
      // what is left.
      const double left = volumeMl(moved[0], rest_[0]) - tissueMl_ - ventricles - still;
      const double part = std::clamp(left / atriaMl_, kLeastAtrial, kMostAtrial);
      for (std::size_t i = 1; i < moved.size(); ++i)
        if (isAtrium(i))
          swell(moved[i], part * restMl_[i] / volumeMl(moved[i], rest_[i]));
    } else {
      narrow(moved[0], middleOf(moved[0]), axis_,
             (tissueMl_ + ventricles + still) / volumeMl(moved[0], rest_[0]));
    }
  }

private:
  static std::size_t at(int surface) { return static_cast<std::size_t>(surface); }
  bool isAtrium(std::size_t i) const {
    return chambers_[i] == anatomy::kLeftAtrium || chambers_[i] == anatomy::kRightAtrium;
  }
  /// Where the right ventricle lies on the septum, which it narrows towards; its middle without a left one.
  Vec3 septalAnchor(const std::vector<Points>& moved) const {
    const Points& right = moved[at(right_)];
    const Vec3 middle = middleOf(right);
    if (left_ < 0)
      return middle;
    Vec3 towards = middleOf(moved[at(left_)]) - middle;
    towards = (towards - towards.dot(axis_) * axis_).normalized();
    const double reach = ((right.rowwise() - middle.transpose()) * towards).maxCoeff();
    return middle + reach * towards;
  }

  Vec3 axis_;
  std::vector<TriangleMesh> rest_;
  std::vector<double> restMl_;
  std::vector<std::optional<anatomy::Part>> chambers_;
  int left_ = -1, right_ = -1;
  double leftEjection_ = 0, rightEjection_ = 0;
  double tissueMl_ = 0, atriaMl_ = 0;
};

/// When the left ventricle is fullest, as a part of the beat.
double endOfDiastole(const heart::CardiacBeat& beat, double period) {
  double best = 0, least = 1;
  for (int i = 0; i < kDiastoleInstants; ++i) {
    const double part = static_cast<double>(i) / kDiastoleInstants;
    if (const double emptying = beat.at(part * period).leftEmptying; emptying < least) {
      least = emptying;
      best = part;
    }
  }
  return best;
}

/// The closed cavities of a heart that are chambers.
std::vector<std::shared_ptr<const document::Organ>> chambersOf(const document::OrganList& organs,
                                                               document::OrganId heart) {
  std::vector<std::shared_ptr<const document::Organ>> chambers;
  std::copy_if(organs.begin(), organs.end(), std::back_inserter(chambers), [&](const auto& organ) {
    return organ->parent == heart && organ->closed() && anatomy::chamberNamed(organ->name);
  });
  return chambers;
}

std::vector<Points> surfacesAt(const tracking::MotionRig& rig, const Points& pose) {
  std::vector<Points> surfaces;
  for (std::size_t i = 0; i < rig.surfaces().size(); ++i)
    surfaces.push_back(rig.vertices(pose, i));
  return surfaces;
}

} // namespace

MotionSeries textbookSeries(const MotionSeries& heart, const TextbookBeat& beat, Progress& progress,
                            Threads threads) {
  if (!(beat.ejectionFraction > kLeastEjection) || !(beat.ejectionFraction < kMostEjection))
    throw UsageError(phrase("An ejection fraction of %1 is out of range", inFixed(beat.ejectionFraction, 2)),
                     "--ejection-fraction", "give one between 0.1 and 0.8");
  const MeasuredPhase rest = measuredPhase(heart, 0, progress, threads);
  const document::Organ outer = document::makeOrgan(heart.names[0], rest.surfaces[0]);
  RetargetedSequence fitted;
  runPart(progress, 0.1, 0.5,
          [&](Progress& part) { fitted = retargetSequence("heartbeat", outer, beat.given, part, threads); });
  std::vector<TriangleMesh> surfaces;
  for (const auto& surface : rest.surfaces)
    surfaces.push_back(*surface);
  const Points handles = fitted.sequence->restHandles();
  const auto& parameters = fitted.system.parameters.all();
  const tracking::MotionRig rig(surfaces, handles, parameters.at("locality"), parameters.at("softness"),
                                progress, threads);
  const Vec3 axis =
      (fitted.landmarks.find("base")->position - fitted.landmarks.find("apex")->position).normalized();
  const TextbookHeart textbook(rest.surfaces, heart.names, beat.ejectionFraction, axis);

  MotionSeries series;
  series.names = heart.names;
  series.warnings = heart.warnings;
  series.warnings.insert(series.warnings.end(), fitted.warnings.begin(), fitted.warnings.end());
  series.warnings.push_back(
      "the motion is the textbook's, fitted to one image: it is not this patient's own");
  if (textbook.rightFallsShort())
    series.warnings.push_back("the right ventricle is too small to eject as much as the left one");
  const double period = 60 / beat.ratePerMinute;
  series.times = tracking::PhaseTimes::even(beat.phases, period);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    series.corresponding.push_back({heart.names[i], surfaces[i].triangles, {}});
  const heart::CardiacBeat cycle = heart::CardiacCycle().beat(beat.ratePerMinute);
  const double begin = endOfDiastole(cycle, period) * period;
  const heart::CardiacInstant full = cycle.at(begin);
  Points pose;
  fitted.sequence->poseAt(begin, beat.ratePerMinute, pose);
  const std::vector<Points> first = surfacesAt(rig, pose);
  for (const double seconds : series.times.seconds) {
    progress.throwIfCancelled();
    fitted.sequence->poseAt(std::fmod(begin + seconds, period), beat.ratePerMinute, pose);
    std::vector<Points> moved = surfacesAt(rig, pose);
    for (std::size_t i = 0; i < moved.size(); ++i) // From the image on, which is the end of diastole.
      moved[i] = seconds > 0 ? Points(moved[i] + (surfaces[i].points - first[i])) : surfaces[i].points;
    const heart::CardiacInstant now = cycle.at(begin + seconds);
    if (seconds > 0) // The first phase is the image, to the bit.
      textbook.beat(moved, now.leftEmptying - full.leftEmptying, now.rightEmptying - full.rightEmptying);
    std::vector<double>& volumes = series.volumesMl.emplace_back();
    for (std::size_t i = 0; i < moved.size(); ++i) {
      volumes.push_back(volumeMl(moved[i], surfaces[i]));
      series.corresponding[i].phases.push_back(std::move(moved[i]));
    }
  }
  progress.report(1);
  return series;
}

std::shared_ptr<const document::Organ> heartWithCavities(const document::OrganList& organs,
                                                         const document::Organ& organ) {
  const document::OrganId wanted =
      organ.parent && anatomy::chamberNamed(organ.name) ? organ.parent : organ.id;
  const auto heart =
      std::find_if(organs.begin(), organs.end(), [&](const auto& one) { return one->id == wanted; });
  const std::vector<std::shared_ptr<const document::Organ>> chambers = chambersOf(organs, wanted);
  const bool ventricle = std::any_of(chambers.begin(), chambers.end(), [](const auto& one) {
    const auto chamber = anatomy::chamberNamed(one->name);
    return chamber == anatomy::kLeftVentricle || chamber == anatomy::kRightVentricle;
  });
  return heart != organs.end() && (*heart)->closed() && ventricle ? *heart : nullptr;
}

PatientMotion textbookMotion(const document::OrganList& organs, const document::Organ& heart,
                             const TextbookBeat& beat, Progress& progress, Threads threads) {
  MotionSeries image;
  image.names = {heart.name};
  image.times = tracking::PhaseTimes::even(1, 1);
  image.meshes = {{heart.mesh}};
  image.volumesMl = {{heart.restVolumeMm3 / kMm3PerMl}};
  for (const auto& chamber : chambersOf(organs, heart.id)) {
    image.names.push_back(chamber->name);
    image.meshes.front().push_back(chamber->mesh);
    image.volumesMl.front().push_back(chamber->restVolumeMm3 / kMm3PerMl);
  }
  MotionSeries series;
  runPart(progress, 0, 0.4, [&](Progress& part) { series = textbookSeries(image, beat, part, threads); });
  PatientMotion found;
  runPart(progress, 0.4, 1, [&](Progress& part) { found = trackMotion(series, {}, part, threads); });
  found.sequence.track.name = kName;
  return found;
}

} // namespace viscera::live
