#include "strain_confidence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "viscera/anatomy/norms.h"
#include "viscera/live/strain_reading.h"

namespace viscera::live {
namespace {

using strain::SegmentStrain;

constexpr double kPartPercent = 100, kPartMs = 1000;
/// A deviation over so many draws is known to a seventh of itself.
constexpr int kDraws = 24;
/// The nearest handle is looked for together for so many vertices.
constexpr Eigen::Index kVertices = 512;

/// Numbers of a normal distribution, the same on every machine (Box and Muller 1958, doi
/// 10.1214/aoms/1177706645).
class Normal {
public:
  explicit Normal(std::uint64_t seed) : engine_(seed) {}

  double operator()() {
    const double radius = std::sqrt(-2 * std::log(uniform())), angle = 2 * std::numbers::pi * uniform();
    return radius * std::cos(angle);
  }

private:
  /// Above 0, and not above 1.
  double uniform() { return (static_cast<double>(engine_() >> 11) + 1) * 0x1.0p-53; }

  std::mt19937_64 engine_;
};

/// The residual is the length of a vector: along each axis it is less by the root of 3.
Points drawnPose(const FittedPose& fitted, Normal& normal) {
  Points pose = *fitted.pose;
  for (Eigen::Index handle = 0; handle < pose.rows(); ++handle)
    for (int axis = 0; axis < 3; ++axis)
      pose(handle, axis) += fitted.residualMm[handle] / std::numbers::sqrt3 * normal();
  return pose;
}

/// The healthy range of a direction's peak; none of the thickness, whose deviation is not known.
const char* normOf(StrainDirection direction) {
  switch (direction) {
  case StrainDirection::longitudinal:
    return "lv.gls";
  case StrainDirection::circumferential:
    return "lv.gcs";
  case StrainDirection::radial:
    return "lv.grs";
  case StrainDirection::thickening:
    return nullptr;
  }
  return nullptr;
}

} // namespace

Values handleResiduals(const Points& rest, const std::vector<SurfaceResidual>& surfaces, Threads threads) {
  Values squares = Values::Zero(rest.rows()), counts = Values::Zero(rest.rows());
  for (const SurfaceResidual& surface : surfaces) {
    std::vector<Eigen::Index> nearest(static_cast<std::size_t>(surface.rest->rows()));
    parallelRanges(surface.rest->rows(), kVertices, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index row = begin; row < end; ++row)
        (rest.rowwise() - surface.rest->row(row))
            .rowwise()
            .squaredNorm()
            .minCoeff(&nearest[static_cast<std::size_t>(row)]);
    });
    for (Eigen::Index row = 0; row < surface.rest->rows(); ++row) {
      const Eigen::Index handle = nearest[static_cast<std::size_t>(row)];
      squares[handle] += (surface.measured->row(row) - surface.fitted->row(row)).squaredNorm();
      counts[handle] += 1;
    }
  }
  return (squares.array() / counts.array().max(1.0)).sqrt().matrix();
}

strain::WallMeans drawnDeviations(const strain::WallPoints& points,
                                  const deformation::WitnessGradients& gradients, const FittedPose& reference,
                                  const FittedPose& now, Progress& progress, Threads threads) {
  return strain::deviationsOfMeans(
      points,
      [&](int draw, std::vector<Eigen::Matrix3d>& before, std::vector<Eigen::Matrix3d>& after) {
        Normal normal(static_cast<std::uint64_t>(draw) + 1);
        gradients.deformationGradients(drawnPose(reference, normal), before, Threads{1});
        gradients.deformationGradients(drawnPose(now, normal), after, Threads{1});
      },
      kDraws, progress, threads);
}

const std::vector<double>& strainCurve(const SegmentStrain& segment, StrainDirection direction) {
  switch (direction) {
  case StrainDirection::longitudinal:
    return segment.longitudinal;
  case StrainDirection::circumferential:
    return segment.circumferential;
  case StrainDirection::radial:
    return segment.radial;
  case StrainDirection::thickening:
    return segment.thickening;
  }
  return segment.longitudinal;
}

std::optional<double> strainValue(const StrainReading& reading, int segment, StrainDirection direction,
                                  StrainMoment moment, std::size_t phase) {
  const SegmentStrain& each = reading.strain.segment(segment);
  const std::vector<double>& curve = strainCurve(each, direction);
  if (!each.enough || curve.empty() || !std::isfinite(curve.front()))
    return std::nullopt;
  if (moment == StrainMoment::instant)
    return phase < curve.size() ? std::optional(kPartPercent * curve[phase]) : std::nullopt;
  const bool grows = direction == StrainDirection::radial || direction == StrainDirection::thickening;
  const strain::Peak peak = grows ? strain::longestOf(curve, reading.strain.seconds)
                                  : strain::shortestOf(curve, reading.strain.seconds);
  return moment == StrainMoment::peak ? kPartPercent * peak.value : kPartMs * peak.seconds;
}

std::optional<double> strainDeviation(const StrainReading& reading, int segment, StrainDirection direction) {
  if (!reading.deviations || direction == StrainDirection::thickening)
    return std::nullopt;
  const auto& known = direction == StrainDirection::longitudinal      ? reading.deviations->longitudinal
                      : direction == StrainDirection::circumferential ? reading.deviations->circumferential
                                                                      : reading.deviations->radial;
  const double deviation = known[static_cast<std::size_t>(segment)];
  return std::isfinite(deviation) ? std::optional(kPartPercent * deviation) : std::nullopt;
}

bool reliablePeak(const StrainReading& reading, int segment, StrainDirection direction) {
  if (!reading.reliable(reading.strain.segment(segment)))
    return false;
  const std::optional<double> deviation = strainDeviation(reading, segment, direction);
  const std::optional<double> peak = strainValue(reading, segment, direction, StrainMoment::peak);
  const char* norm = normOf(direction);
  if (!deviation || !peak || !norm)
    return true;
  const anatomy::Range healthy = anatomy::rangeOf(anatomy::norm(norm));
  return *deviation <= std::min(std::abs(*peak - healthy.low), std::abs(*peak - healthy.high));
}

std::optional<WallThickness> wallThickness(const StrainReading& reading, int segment) {
  const SegmentStrain& each = reading.strain.segment(segment);
  if (each.thicknessMm.empty() || !std::isfinite(each.thicknessMm[reading.strain.reference]))
    return std::nullopt;
  return WallThickness{each.thicknessMm[reading.strain.reference],
                       kPartPercent * *std::max_element(each.thickening.begin(), each.thickening.end())};
}

std::optional<double> largestTurn(const std::vector<double>& degrees) {
  const auto most = std::max_element(degrees.begin(), degrees.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  return most == degrees.end() ? std::nullopt : std::optional(*most);
}

} // namespace viscera::live
