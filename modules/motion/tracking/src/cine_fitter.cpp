#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "cine_fit_parts.h"
#include "contour_constraint.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::tracking {
namespace {

constexpr double kStay = 0.2;          ///< The cost of a mean square displacement by a correction, mm^2.
constexpr double kReachOfCycle = 0.15; ///< As far as phases follow a corrected one.
constexpr double kSamePlaneMm = 1, kSameDirection = 0.999;

/// One contour in the phases in which it was corrected.
struct CorrectedSite {
  std::size_t surface = 0;
  geometry::Plane plane;
  std::vector<std::size_t> phases;                            ///< Ascending.
  std::vector<std::vector<const CorrectedContour*>> contours; ///< One list for each of them.
  std::vector<Points> changes;                                ///< Of the handles in each of them.
  std::vector<std::uint8_t> heldBack;                         ///< Whether tissue would have folded there.
};

bool isSite(const CorrectedSite& site, const CorrectedContour& contour) {
  return site.surface == contour.surface &&
         std::abs(site.plane.normal.dot(contour.plane.normal)) > kSameDirection &&
         std::abs(site.plane.height(contour.plane.origin)) < kSamePlaneMm;
}

std::vector<CorrectedSite> sitesOf(std::vector<const CorrectedContour*> contours) {
  std::stable_sort(contours.begin(), contours.end(),
                   [](const CorrectedContour* a, const CorrectedContour* b) { return a->phase < b->phase; });
  std::vector<CorrectedSite> sites;
  for (const CorrectedContour* contour : contours) {
    auto site = std::find_if(sites.begin(), sites.end(),
                             [&](const CorrectedSite& each) { return isSite(each, *contour); });
    if (site == sites.end())
      site = sites.insert(sites.end(), {contour->surface, contour->plane, {}, {}, {}, {}});
    if (site->phases.empty() || site->phases.back() != contour->phase) {
      site->phases.push_back(contour->phase);
      site->contours.emplace_back();
    }
    site->contours.back().push_back(contour);
  }
  return sites;
}

/// The cost of a change of the handles by a correction: as stiff as where they follow the images, which are
/// overruled, and of displacement, so that it stays near the contour.
Eigen::MatrixXd costOf(const CineFitter::Parts& parts) {
  const MotionRig& rig = parts.rig;
  const CineStiffness& hold = parts.hold;
  Eigen::MatrixXd cost = hold.strain * parts.stiffness->strain() + hold.bending * parts.stiffness->bending() +
                         hold.handles * rig.bending() +
                         kStay * rig.weights().transpose() * rig.shares().asDiagonal() * rig.weights();
  cost.diagonal().array() += 1e-6 * cost.diagonal().mean();
  return cost;
}

/// The corrections of a fit.
class CineCorrector {
public:
  CineCorrector(const CineFitter::Parts& parts, const std::vector<CorrectedContour>& contours)
      : parts_(parts), meeting_(parts.rig, *parts.stiffness, costOf(parts)), places_(parts.times.count()) {
    for (const FreePhase& place : parts.free)
      places_[place.segment->phases[place.at]] = place;
    std::vector<const CorrectedContour*> all;
    for (const CorrectedContour& contour : contours) {
      require(contour);
      all.push_back(&contour);
    }
    sites_ = sitesOf(std::move(all));
  }

  /// What each correction alone changes in its phase.
  void findChanges(Progress& progress, Threads threads) {
    std::vector<std::pair<CorrectedSite*, std::size_t>> all;
    for (CorrectedSite& site : sites_) {
      site.changes.resize(site.phases.size());
      site.heldBack.resize(site.phases.size());
      for (std::size_t i = 0; i < site.phases.size(); ++i)
        all.emplace_back(&site, i);
    }
    parallelRanges(static_cast<Eigen::Index>(all.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
      progress.throwIfCancelled();
      const auto& [site, i] = all[static_cast<std::size_t>(begin)];
      const std::size_t phase = site->phases[i];
      Points pose = parts_.fit.motion.poses[phase];
      site->heldBack[i] = meet(site->contours[i], pose).heldBack;
      site->changes[i] = pose - parts_.fit.motion.poses[phase];
    });
  }

  /// The phases that change.
  std::vector<std::size_t> reached() const {
    std::vector<std::size_t> phases;
    for (std::size_t phase = 0; phase < places_.size(); ++phase)
      if (places_[phase] && std::any_of(sites_.begin(), sites_.end(), [&](const CorrectedSite& site) {
            return std::any_of(site.phases.begin(), site.phases.end(),
                               [&](std::size_t corrected) { return weightOf(site, corrected, phase) > 0; });
          }))
        phases.push_back(phase);
    return phases;
  }

  /// Sets the pose of one of them and what is known of it; whether it was held back.
  bool correct(std::size_t phase, CineFit& fit) const {
    const Points& free = parts_.fit.motion.poses[phase];
    Points pose = free;
    std::vector<const CorrectedContour*> own;
    bool held = false;
    for (const CorrectedSite& site : sites_)
      for (std::size_t i = 0; i < site.phases.size(); ++i) {
        if (const double weight = weightOf(site, site.phases[i], phase); weight > 0)
          pose += weight * site.changes[i];
        if (site.phases[i] == phase) {
          own.insert(own.end(), site.contours[i].begin(), site.contours[i].end());
          held = held || site.heldBack[i] != 0;
        }
      }
    const CinePose images = parts_.imagesOf(*places_[phase]);
    held = CinePose::holdBack(free, *parts_.stiffness, pose) || held;
    fit.motion.freeVolumesMl[phase] = parts_.rig.volumesMl(parts_.rig.vertices(pose));
    if (!own.empty()) {
      const ContoursMet met = meet(own, pose);
      if (!fit.motion.volumes.empty())
        fit.motion.volumes[phase] = met.volumes;
      held = held || met.heldBack;
    }
    keepVolumes(images, phase, pose, fit);
    fit.planes[phase] = images.shares(pose);
    fit.motion.poses[phase] = std::move(pose);
    return held;
  }

private:
  void require(const CorrectedContour& contour) const {
    const Text where = phrase("correction of phase %1", contour.phase);
    if (contour.surface >= parts_.rig.surfaces().size() || contour.points.rows() == 0 ||
        !contour.points.allFinite())
      throw DataError("It has no points, or is of no surface that is fitted", where,
                      "give the points of a contour");
    for (const LabelledPose& label : parts_.poses)
      if (label.phase == contour.phase)
        throw DataError(phrase("Phase %1 has labels, which are exact: only phases between them are corrected",
                               contour.phase),
                        where, "change its labels, or leave this correction out");
    if (contour.phase >= places_.size() || !places_[contour.phase])
      throw DataError(phrase("Phase %1 does not lie between labelled phases", contour.phase), where,
                      "correct a phase that the images are fitted in");
  }

  ContoursMet meet(const std::vector<const CorrectedContour*>& contours, Points& pose) const {
    std::function<Values(const Values&)> within;
    if (parts_.keepsVolumes())
      within = [this](const Values& volumes) { return parts_.labels.within(volumes); };
    return meeting_.meet(ContourConstraint(parts_.rig, contours), within, pose);
  }

  void keepVolumes(const CinePose& images, std::size_t phase, Points& pose, CineFit& fit) const {
    const Values volumes = parts_.rig.volumesMl(parts_.rig.vertices(pose));
    const Values wanted = parts_.labels.within(volumes);
    const Values beyond = (volumes - wanted).cwiseAbs();
    if (parts_.keepsVolumes() && (beyond.array() > 1e-9 * volumes.array().abs()).any())
      fit.motion.volumes[phase] = images.giveVolumes(wanted, *parts_.stiffness, pose);
  }

  /// Seconds from one phase onward to another.
  double secondsTo(std::size_t from, std::size_t to) const {
    const double seconds = parts_.times.seconds[to] - parts_.times.seconds[from];
    return seconds >= 0 || !parts_.times.loop ? seconds : seconds + parts_.times.periodSeconds;
  }

  /// How much a phase follows a corrected one: cos^2 to zero at the reach, the next label, or the next
  /// correction of the same contour; the last together with that one's is 1.
  double weightOf(const CorrectedSite& site, std::size_t corrected, std::size_t phase) const {
    if (phase == corrected)
      return 1;
    double most = 0;
    for (const bool onward : {true, false}) {
      const auto apart = [&](std::size_t other) {
        return onward ? secondsTo(corrected, other) : secondsTo(other, corrected);
      };
      double reach = kReachOfCycle * parts_.times.periodSeconds;
      const auto endAt = [&](std::size_t other) {
        if (other != corrected && apart(other) > 0)
          reach = std::min(reach, apart(other));
      };
      for (const LabelledPose& label : parts_.poses)
        endAt(label.phase);
      for (const std::size_t other : site.phases)
        endAt(other);
      if (const double way = apart(phase); way > 0 && way < reach) {
        const double falling = std::cos(0.5 * std::numbers::pi * way / reach);
        most = std::max(most, falling * falling);
      }
    }
    return most;
  }

  const CineFitter::Parts& parts_;
  ContourMeeting meeting_;
  std::vector<std::optional<FreePhase>> places_; ///< Of each phase of the cycle; none where it is labelled.
  std::vector<CorrectedSite> sites_;
};

} // namespace

CineFit CineFitter::corrected(const std::vector<CorrectedContour>& contours, Progress& progress,
                              Threads threads) const {
  CineCorrector corrector(*parts_, contours);
  CineFit fit = parts_->fit;
  if (contours.empty())
    return fit;
  progress.report(0, "meeting corrected contours");
  corrector.findChanges(progress, threads);
  const std::vector<std::size_t> phases = corrector.reached();
  std::vector<std::uint8_t> held(parts_->times.count(), 0);
  parallelRanges(static_cast<Eigen::Index>(phases.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    progress.throwIfCancelled();
    const std::size_t phase = phases[static_cast<std::size_t>(begin)];
    held[phase] = corrector.correct(phase, fit);
  });
  for (const CorrectedContour& contour : contours)
    fit.corrections.push_back(
        {ContourConstraint::mostMm(parts_->rig, contour, parts_->fit.motion.poses[contour.phase]),
         ContourConstraint::mostMm(parts_->rig, contour, fit.motion.poses[contour.phase]),
         held[contour.phase] != 0});
  findEnds(parts_->rig, parts_->poses, parts_->outer, fit);
  progress.report(1);
  return fit;
}

} // namespace viscera::tracking
