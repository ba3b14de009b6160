#include "viscera/live/stress_reading.h"

#include <limits>
#include <utility>

#include "degrees.h"

namespace viscera::live {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kReachPart = 0.02;
/// A corner with less weight says nothing about a point.
constexpr double kLeastWeight = 1e-9;

} // namespace

double valueOf(const StressReading& reading, const StressMeasure& measure) {
  if (!reading.inTissue)
    return kNone;
  if (measure.quantity == StressQuantity::folded)
    return reading.folded ? 1 : 0;
  if (reading.folded)
    return kNone;
  const elasticity::LocalStretch stretch{reading.stretchMax, reading.stretchMin, reading.volumeRatio};
  switch (measure.quantity) {
  case StressQuantity::rotationalStress:
    return reading.stressDegrees;
  case StressQuantity::volumeRatio:
    return reading.volumeRatio;
  case StressQuantity::stretchMax:
    return reading.stretchMax;
  case StressQuantity::vonMises:
    return reading.extremes ? elasticity::shearKpa(measure.material) * reading.extremes->vonMisesPerShear
                            : elasticity::vonMisesKpa(measure.material, stretch);
  case StressQuantity::energy:
    if (!reading.extremes)
      return elasticity::energyKpa(measure.material, stretch);
    return reading.extremes->poisson == measure.material.poisson
               ? elasticity::shearKpa(measure.material) * reading.extremes->energyPerShear
               : kNone;
  case StressQuantity::stretchMin:
  case StressQuantity::folded:
    break;
  }
  return reading.stretchMin;
}

TissuePoints::TissuePoints(std::shared_ptr<const deformation::WitnessMesh> mesh, const Points& rest,
                           double reachMm, Threads threads)
    : mesh_(std::move(mesh)), rest_(rest), reach_(reachMm), places_(*mesh_, rest, threads) {}

std::vector<StressReading> TissuePoints::read(const Points& posed, const deformation::StressMap& map) const {
  std::vector<StressReading> readings;
  for (Eigen::Index i = 0; i < rest_.rows(); ++i) {
    StressReading reading;
    reading.rest = rest_.row(i).transpose();
    reading.inTissue = distance(i) <= reach_;
    if (!reading.inTissue) {
      reading.now = Vec3::Constant(kNone);
      reading.stressDegrees = reading.volumeRatio = reading.stretchMax = reading.stretchMin = kNone;
      readings.push_back(reading);
      continue;
    }
    if (map.extremes)
      reading.extremes.emplace().poisson = map.extremes->poisson;
    places_.visitCorners(i, [&](Eigen::Index corner, double weight) {
      reading.now += weight * posed.row(corner).transpose();
      reading.folded = reading.folded || (weight > kLeastWeight && map.volumeRatio[corner] <= 0);
      reading.stressDegrees += weight * kDegrees * map.rotationalStress[corner];
      reading.volumeRatio += weight * map.volumeRatio[corner];
      reading.stretchMax += weight * map.stretchMax[corner];
      reading.stretchMin += weight * map.stretchMin[corner];
      if (map.extremes) {
        reading.extremes->vonMisesPerShear += weight * map.extremes->vonMisesPerShear[corner];
        reading.extremes->energyPerShear += weight * map.extremes->energyPerShear[corner];
      }
    });
    readings.push_back(reading);
  }
  return readings;
}

double probeReach(const deformation::WitnessMesh& mesh) {
  return kReachPart * boundsOf(mesh.points).diagonal();
}

Points placesAlong(const Vec3& from, const Vec3& to, int count) {
  Points places(count, 3);
  for (int i = 0; i < count; ++i) {
    const double part = double(i) / (count - 1);
    places.row(i) = ((1 - part) * from + part * to).transpose();
  }
  return places;
}

StressProfile profileOf(std::vector<StressReading> readings) {
  StressProfile profile;
  for (const StressReading& reading : readings)
    profile.mm.push_back((reading.rest - readings.front().rest).norm());
  profile.readings = std::move(readings);
  return profile;
}

} // namespace viscera::live
