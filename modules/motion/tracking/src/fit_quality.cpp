#include "viscera/tracking/fit_quality.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "tissue_witnesses.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_mesh.h"

namespace viscera::tracking {
namespace {

constexpr double kAmberMeanMm = 1.5, kAmberP95Mm = 4, kAmberVolume = 0.1;
constexpr double kAmberDice = 0.95, kAmberDiceOfThickSlices = 0.93, kThickSliceMm = 3;
constexpr double kRedMeanMm = 2.5, kRedDice = 0.9;

Vec3 normalOf(const Points& points, const Triangles& triangles, Eigen::Index t) {
  const Vec3 a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
             c = points.row(triangles(t, 2));
  return (b - a).cross(c - a);
}

/// Collects the verdict on a phase.
class Judge {
public:
  void say(FitLight light, Text reason) {
    verdict_.light = std::max(verdict_.light, light);
    verdict_.reasons.push_back(std::move(reason));
  }
  FitVerdict take() { return std::move(verdict_); }

private:
  FitVerdict verdict_;
};

void judgeSurface(const SurfaceQuality& surface, const Text& name, double sliceMm, Judge& judge) {
  if (surface.meanMm > kAmberMeanMm)
    judge.say(surface.meanMm > kRedMeanMm ? FitLight::red : FitLight::amber,
              phrase("%1 is %2 mm away on average", name, inFixed(surface.meanMm, 1)));
  if (surface.p95Mm > kAmberP95Mm)
    judge.say(FitLight::amber,
              phrase("a twentieth of %1 is more than %2 mm away", name, inFixed(surface.p95Mm, 1)));
  if (std::abs(surface.freeMl - surface.measuredMl) > kAmberVolume * surface.measuredMl)
    judge.say(FitLight::amber, phrase("%1 had to be changed by %2 % to get its volume", name,
                                      inFixed(100 * std::abs(surface.freeMl / surface.measuredMl - 1), 0)));
  if (surface.dice) {
    const double least = sliceMm > kThickSliceMm ? kAmberDiceOfThickSlices : kAmberDice;
    if (*surface.dice < least)
      judge.say(*surface.dice < kRedDice ? FitLight::red : FitLight::amber,
                phrase("%1 agrees with its voxels by a Dice of %2 only", name, inFixed(*surface.dice, 2)));
  } else if (surface.flipped > 0) {
    judge.say(FitLight::amber,
              phrase("%n {triangle|triangles} of %2 {is|are} turned over", surface.flipped, name));
  }
}

} // namespace

Spread spreadOf(const Values& values, const Values& weights) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return values[a] < values[b]; });
  Spread spread;
  const double all = weights.sum();
  spread.mean = values.dot(weights) / all;
  spread.max = values.maxCoeff();
  // The smallest x with sum of w_i over x_i <= x at least 0.95 sum w_i.
  double below = 0;
  for (const Eigen::Index i : order) {
    below += weights[i];
    spread.p95 = values[i];
    if (below >= 0.95 * all)
      break;
  }
  return spread;
}

int opposedTriangles(const Triangles& triangles, const Points& fitted, const Points& measured) {
  int count = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    count += normalOf(fitted, triangles, t).dot(normalOf(measured, triangles, t)) < 0;
  return count;
}

int opposedTriangles(const Triangles& triangles, const Points& fitted, const SurfaceDistance& distance) {
  int count = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Vec3 middle =
        (fitted.row(triangles(t, 0)) + fitted.row(triangles(t, 1)) + fitted.row(triangles(t, 2)))
            .transpose() /
        3;
    Vec3 outward;
    distance.at(middle, outward);
    count += normalOf(fitted, triangles, t).dot(outward) < 0;
  }
  return count;
}

deformation::WitnessMesh tissueWitnesses(const MotionRig& rig, std::size_t outer, int wanted,
                                         Progress& progress, Threads threads) {
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> cavities;
  for (std::size_t i = 0; i < rig.surfaces().size(); ++i)
    if (i != outer)
      cavities.push_back(std::make_shared<const geometry::TriangleMesh>(rig.surfaces()[i]));
  deformation::WitnessMesh mesh =
      deformation::gridWitnesses(rig.surfaces()[outer], wanted, progress, threads);
  if (!cavities.empty())
    mesh = deformation::withoutCavities(mesh, cavities, threads);
  return mesh;
}

TissueWitnesses::TissueWitnesses(const MotionRig& rig, std::size_t outer, int wanted, Progress& progress,
                                 Threads threads) {
  const deformation::WitnessMesh mesh = tissueWitnesses(rig, outer, wanted, progress, threads);
  coordinates::BindOptions options;
  options.parameters.set("locality", rig.locality());
  options.parameters.set("softness", rig.softnessMm());
  options.threads = threads;
  coordinates::HandleSet handles;
  handles.positions = rig.rest();
  const Points witnesses = mesh.points.topRows(mesh.witnesses);
  gradients_ = deformation::bindWitnesses(*coordinates::sCelestial(), handles, witnesses, options, progress);
  count_ = mesh.witnesses;
}

int TissueWitnesses::foldedAt(const Points& pose, Threads threads) const {
  deformation::StressMap map;
  gradients_->evaluate(pose, map, threads);
  return map.folded;
}

FitVerdict verdictOf(const PhaseQuality& phase, const std::vector<std::string>& names, double sliceMm) {
  Judge judge;
  for (std::size_t i = 0; i < phase.surfaces.size(); ++i)
    judgeSurface(phase.surfaces[i], named(names[i]), sliceMm, judge);
  if (phase.folded > 0)
    judge.say(FitLight::amber, phrase("the tissue is folded at %n {place|places}", phase.folded));
  if (!phase.volumesMet)
    judge.say(FitLight::red, "the measured volumes cannot be met");
  return judge.take();
}

} // namespace viscera::tracking
