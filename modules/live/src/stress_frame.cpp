#include "viscera/live/stress_frame.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace viscera::live {
namespace {

/// Enough that the derivatives come from memory seldom, few enough that a cancelled search ends at once.
constexpr std::size_t kPosesATime = 8;

/// How far a volume ratio is from 1, as a factor; infinite for what is folded.
double departure(double ratio) {
  return ratio <= 0 ? std::numeric_limits<double>::infinity() : std::max(ratio, 1 / ratio);
}

void takeWorse(deformation::StressMap& worst, const deformation::StressMap& map) {
  worst.rotationalStress = worst.rotationalStress.cwiseMax(map.rotationalStress);
  worst.stretchMax = worst.stretchMax.cwiseMax(map.stretchMax);
  worst.stretchMin = worst.stretchMin.cwiseMin(map.stretchMin);
  for (Eigen::Index i = 0; i < map.volumeRatio.size(); ++i)
    if (departure(map.volumeRatio[i]) > departure(worst.volumeRatio[i]))
      worst.volumeRatio[i] = map.volumeRatio[i];
}

void takeWorse(deformation::TissueExtremes& worst, const deformation::StressMap& map) {
  for (Eigen::Index i = 0; i < map.volumeRatio.size(); ++i) {
    const elasticity::LocalStretch at{map.stretchMax[i], map.stretchMin[i], map.volumeRatio[i]};
    // Folded tissue has neither, and takes no part: std::max keeps its first where the second is no number.
    worst.vonMisesPerShear[i] = std::max(worst.vonMisesPerShear[i], elasticity::vonMisesPerShear(at));
    worst.energyPerShear[i] =
        std::max(worst.energyPerShear[i], elasticity::energyPerShear(at, worst.poisson));
  }
}

} // namespace

std::vector<StressSample> CycleStress::closed() const {
  std::vector<StressSample> closed = samples;
  if (!samples.empty())
    closed.push_back({periodSeconds, samples.front().statistics});
  return closed;
}

const StressSample* CycleStress::worst() const {
  const auto worst = std::max_element(samples.begin(), samples.end(), [](const auto& a, const auto& b) {
    return a.statistics.max < b.statistics.max;
  });
  return worst == samples.end() ? nullptr : &*worst;
}

CycleStress stressOverCycle(const deformation::WitnessGradients& gradients, Eigen::Index witnesses,
                            const PosedCycle& cycle, int instants, CycleParts parts, Threads threads,
                            Progress& progress) {
  CycleStress result;
  result.periodSeconds = cycle.periodSeconds;
  const bool withPeak = parts == CycleParts::curveAndPeak;
  const Eigen::Index points = withPeak ? gradients.witnesses() : witnesses;
  std::vector<Points> poses;
  std::vector<deformation::StressMap> maps(kPosesATime);
  auto extremes = std::make_shared<deformation::TissueExtremes>();
  if (withPeak)
    *extremes = {Values::Zero(points), Values::Zero(points), cycle.poisson};
  for (int instant = 0; instant < instants; ++instant) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(instant) / instants, "stress over the sequence");
    poses.push_back(cycle.poseAt(static_cast<double>(instant) / instants));
    if (poses.size() < kPosesATime && instant + 1 < instants)
      continue;
    const std::span found = std::span(maps).first(poses.size());
    gradients.evaluate(poses, found, points, threads);
    std::move(poses.begin(), poses.end(), std::back_inserter(result.poses));
    poses.clear();
    for (const deformation::StressMap& map : found) {
      const double fraction = static_cast<double>(result.samples.size()) / instants;
      result.samples.push_back({fraction * cycle.periodSeconds, deformation::statisticsOf(map, witnesses)});
      if (!withPeak)
        continue;
      if (!result.peak)
        result.peak = map;
      else
        takeWorse(*result.peak, map);
      takeWorse(*extremes, map);
    }
  }
  if (result.peak)
    result.peak->extremes = std::move(extremes);
  if (result.peak)
    result.peak->folded = static_cast<int>((result.peak->volumeRatio.array() <= 0).count());
  progress.report(1);
  return result;
}

std::vector<double> curveAt(const deformation::WitnessGradients& gradients, Eigen::Index point,
                            const CycleStress& cycle, const StressMeasure& measure) {
  std::vector<double> curve;
  for (const Points& pose : cycle.poses) {
    deformation::LocalDistortion found;
    if (!gradients.failed(point))
      found = deformation::localDistortion(gradients.deformationGradient(point, pose));
    deformation::StressMap map{Values::Constant(1, found.rotationalStress),
                               Values::Constant(1, found.volumeRatio), Values::Constant(1, found.stretchMax),
                               Values::Constant(1, found.stretchMin), found.folded() ? 1 : 0};
    Values value;
    quantityOf(map, measure, value);
    curve.push_back(value[0]);
  }
  return curve;
}

std::optional<Values> differenceOf(const StressFrame& a, const StressFrame& b, const StressMeasure& measure) {
  const bool ready = a.mesh && b.mesh && a.map && b.map &&
                     a.map->volumeRatio.size() == a.mesh->points.rows() &&
                     b.map->volumeRatio.size() == b.mesh->points.rows();
  if (!ready || a.mesh->points.rows() != b.mesh->points.rows() || a.mesh->points != b.mesh->points)
    return std::nullopt;
  Values ofA, ofB;
  quantityOf(*a.map, measure, ofA);
  quantityOf(*b.map, measure, ofB);
  return ofA - ofB;
}

StressCopy::StressCopy(StressFrame start, std::shared_ptr<const deformation::WitnessGradients> gradients,
                       std::shared_ptr<const coordinates::Binding> positions)
    : frame_(std::move(start)), gradients_(std::move(gradients)), positions_(std::move(positions)) {
  frame_.points = points_;
  frame_.map = map_;
}

const StressFrame& StressCopy::at(const Points& pose) {
  if (!gradients_ || pose.rows() != gradients_->handles())
    return frame_;
  gradients_->evaluate(pose, *map_);
  positions_->deform(pose, *points_);
  for (const int point : positions_->report().failures)
    points_->row(point) = frame_.mesh->points.row(point);
  frame_.stretchesAt = [gradients = gradients_, pose](Eigen::Index point) {
    return deformation::principalStretches(gradients->deformationGradient(point, pose));
  };
  ++frame_.revision;
  return frame_;
}

} // namespace viscera::live
