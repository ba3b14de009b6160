#include "viscera/live/witness_sampling.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/split_edges.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_repairs.h"

namespace viscera::live {
namespace {

using deformation::TetrahedraError;
using deformation::WitnessMesh;
using geometry::TriangleMesh;

/// TetGen places about one witness for so many tetrahedra of the largest volume allowed.
constexpr double kTetrahedraPerWitness = 4.7;
constexpr int kMostRuns = 5;
/// The volume limit changes by at most this factor from one run to the next.
constexpr double kMostChange = 8;
/// A surface with more triangles than this for each wanted witness, and than the second number, is thinned
/// out at once; TetGen would place more points along it than are wanted.
constexpr double kTrianglesPerWitness = 20;
constexpr int kFineTriangles = 60'000;
/// Thinning out more than these takes longer than a repair, which does not look at single triangles.
constexpr Eigen::Index kTooFineTriangles = 500'000;
constexpr int kFewestTriangles = 300;
/// The grids of the repair, finest first.
constexpr int kRepairCells[] = {100, 80, 60};
constexpr int kRepairTriangles = 10'000;
/// The surface of `n` points spread evenly over a compact organ has about `14 n^(2/3)` triangles.
constexpr double kSkinTriangles = 14;
/// Edges longer than this many distances of witnesses are halved, up to so many times those triangles.
constexpr double kLongEdge = 2.5, kMostSplit = 4;
constexpr double kMuchFiner = 4; ///< Times that many triangles.

void requireInRange(const WitnessOptions& options) {
  if (options.wanted < WitnessOptions::kFewest || options.wanted > WitnessOptions::kMost)
    throw UsageError(phrase("cannot place %1 witness points", options.wanted), "witnesses",
                     phrase("choose %1 to %2", WitnessOptions::kFewest, WitnessOptions::kMost));
  if (!(options.radiusEdgeRatio >= 1.1 && options.radiusEdgeRatio <= 10))
    throw UsageError(misuse("the quality of tetrahedra is a ratio from 1.1 (best) to 10"), "quality");
  if (!(options.timeLimitSeconds > 0) || options.memoryLimitBytes == 0)
    throw UsageError(misuse("the limits of time and memory must be above 0"), "witnesses");
}

/// Fills one surface after another until there are witness points.
class Sampler {
public:
  Sampler(const WitnessOptions& options, Progress& progress) : options_(options), progress_(progress) {}

  WitnessSample sample(const TriangleMesh& surface) {
    const TriangleMesh cleaned = clean(surface);
    std::optional<TetrahedraError> failure;
    WitnessSample result;
    if (auto mesh = tryToFill(cleaned, failure)) {
      result.mesh = std::move(mesh);
    } else if (failure->reason() != TetrahedraError::Reason::missing &&
               (mesh = tryRepaired(cleaned, *failure))) {
      result.mesh = std::move(mesh);
      result.origin = WitnessOrigin::repairedSurface;
    } else {
      remarks_.push_back(
          phrase("The witness points lie on a regular grid inside the surface. %1.", failure->problem()));
      result.mesh = std::make_shared<const WitnessMesh>(
          deformation::gridWitnesses(cleaned, options_.wanted, progress_, options_.threads));
      result.origin = WitnessOrigin::grid;
    }
    if (relativeMiss(*result.mesh) > kWitnessCountTolerance)
      remarks_.push_back(
          phrase("There are %1 witness points; %2 do not fit this shape or the limits of time and memory.",
                 result.mesh->witnesses, options_.wanted));
    result.remarks = std::move(remarks_);
    return result;
  }

private:
  TriangleMesh clean(const TriangleMesh& surface) {
    geometry::requireValid(surface, "surface");
    geometry::CleanedSurface cleaned = geometry::cleanSurface(surface);
    if (cleaned.mesh.triangles.rows() < 4)
      throw DataError(phrase("the surface has %1 usable triangles, so it encloses nothing",
                             cleaned.mesh.triangles.rows()),
                      "surface", "choose a closed surface");
    if (cleaned.removedTriangles > 0)
      remarks_.push_back(phrase("%n {triangle without area or that came twice is|triangles without area or "
                                "that came twice are} left out.",
                                cleaned.removedTriangles));
    if (cleaned.turnedTriangles > 0)
      remarks_.push_back(
          phrase("%n {triangle was|triangles were} turned around to face outward.", cleaned.turnedTriangles));
    return std::move(cleaned.mesh);
  }

  using Filled = std::shared_ptr<const WitnessMesh>;

  Filled tryToFill(const TriangleMesh& surface, std::optional<TetrahedraError>& failure) {
    const double most = std::max<double>(kTrianglesPerWitness * options_.wanted, kFineTriangles);
    try {
      const auto triangles = static_cast<double>(surface.triangles.rows());
      if (surface.triangles.rows() > kTooFineTriangles)
        throw TetrahedraError(TetrahedraError::Reason::refused,
                              phrase("it has %1 triangles", surface.triangles.rows()));
      if (triangles > most && geometry::checkSurface(surface).closed()) {
        progress_.report(0.1, "simplifying the surface");
        return std::make_shared<const WitnessMesh>(fill(thinned(surface, most / triangles)));
      }
      return std::make_shared<const WitnessMesh>(fill(surface));
    } catch (const TetrahedraError& error) {
      failure = error;
      return nullptr;
    }
  }

  Filled tryRepaired(const TriangleMesh& surface, const TetrahedraError& why) {
    for (const int cells : kRepairCells) {
      try {
        progress_.report(0.3, "repairing the surface");
        const TriangleMesh repaired = medical_io::repairSurface(
            surface,
            {.cells = cells,
             .triangles = std::clamp(static_cast<int>(skinTriangles()), kFewestTriangles, kRepairTriangles)},
            progress_, options_.threads);
        auto mesh = std::make_shared<const WitnessMesh>(fill(repaired));
        const Bounds box = boundsOf(surface.points);
        const double cell = (box.high - box.low).maxCoeff() / cells;
        remarks_.push_back(
            phrase("The surface was repaired before it was filled. %1. Details smaller than %2 mm are lost.",
                   why.problem(), inDigits(cell, 2)));
        return mesh;
      } catch (const TetrahedraError& error) {
        if (error.reason() != TetrahedraError::Reason::refused &&
            error.reason() != TetrahedraError::Reason::unusable)
          return nullptr;          // It would run into its limits once more.
      } catch (const DataError&) { // Encloses nothing at this resolution.
      }
    }
    return nullptr;
  }

  TriangleMesh thinned(const TriangleMesh& surface, double part) {
    const auto triangles = static_cast<int>(part * static_cast<double>(surface.triangles.rows()));
    TriangleMesh thin = medical_io::thinSurface(surface, std::max(triangles, kFewestTriangles));
    progress_.throwIfCancelled();
    return thin;
  }

  /// Runs TetGen with one volume limit after another until the number of witnesses is met. Where the surface
  /// alone calls for more points than are wanted, it is thinned out.
  WitnessMesh fill(const TriangleMesh& whole) {
    TriangleMesh surface = withRoomForWitnesses(whole);
    double divisor = kTetrahedraPerWitness * options_.wanted, part = 1;
    bool tooManyBefore = false;
    std::optional<WitnessMesh> best;
    std::optional<TetrahedraError> failure;
    for (int run = 0; run < kMostRuns; ++run) {
      progress_.report(0.2 + 0.6 * run / kMostRuns, "filling the organ with tetrahedra");
      double count = 0;
      try {
        WitnessMesh mesh = filled(surface, divisor);
        count = static_cast<double>(mesh.witnesses);
        if (count > 0 && (!best || relativeMiss(mesh) < relativeMiss(*best)))
          best = std::move(mesh);
      } catch (const TetrahedraError& error) {
        if (part == 1 && !best)
          throw;
        failure = error; // The thinned surface may intersect itself, or the limits do not allow more.
        if (part == 1 || error.reason() != TetrahedraError::Reason::refused)
          break;
      }
      if (best && relativeMiss(*best) <= kWitnessCountTolerance)
        break;
      const bool tooMany = count > (1 + kWitnessCountTolerance) * options_.wanted;
      // Larger tetrahedra help first, unless the surface is much finer than points so far apart need.
      const bool surfaceDecides = tooMany && (tooManyBefore || muchTooFine(surface));
      tooManyBefore = tooMany;
      if (count > 0 && !surfaceDecides) {
        divisor *= std::clamp(options_.wanted / count, 1 / kMostChange, kMostChange);
      } else {
        part *= count > 0 ? std::clamp(0.9 * options_.wanted / count, 0.1, 0.8) : 0.85;
        surface = thinned(whole, part);
      }
    }
    if (best)
      return *std::move(best);
    if (failure)
      throw *failure;
    throw TetrahedraError(TetrahedraError::Reason::unusable, "TetGen placed no point inside the surface");
  }

  WitnessMesh filled(const TriangleMesh& surface, double divisor) {
    deformation::TetrahedraOptions options;
    options.maxVolumeMm3 = std::abs(geometry::checkSurface(surface).volumeMm3) / divisor;
    options.radiusEdgeRatio = options_.radiusEdgeRatio;
    options.timeLimitSeconds = options_.timeLimitSeconds;
    options.memoryLimitBytes = options_.memoryLimitBytes;
    options.worker = options_.worker;
    return deformation::tetrahedralise(surface, options, progress_);
  }

  /// TetGen places no point near a triangle that is much larger than the points' distance.
  TriangleMesh withRoomForWitnesses(const TriangleMesh& surface) const {
    const double volume = std::abs(geometry::checkSurface(surface).volumeMm3);
    const double distance = std::cbrt(volume / options_.wanted);
    return geometry::splitLongEdges(surface, kLongEdge * distance,
                                    static_cast<int>(kMostSplit * skinTriangles()));
  }

  bool muchTooFine(const TriangleMesh& surface) const {
    return static_cast<double>(surface.triangles.rows()) >
           std::max<double>(kFewestTriangles, kMuchFiner * skinTriangles());
  }

  double skinTriangles() const { return kSkinTriangles * std::pow(options_.wanted, 2.0 / 3); }
  double relativeMiss(const WitnessMesh& mesh) const {
    return std::abs(static_cast<double>(mesh.witnesses) - options_.wanted) / options_.wanted;
  }

  const WitnessOptions& options_;
  Progress& progress_;
  std::vector<Text> remarks_;
};

} // namespace

WitnessSample sampleWitnesses(const geometry::TriangleMesh& surface, const WitnessOptions& options,
                              Progress& progress) {
  requireInRange(options);
  progress.report(0, "witness points");
  WitnessSample sample = Sampler(options, progress).sample(surface);
  progress.report(1);
  return sample;
}

WitnessSample withoutCavities(WitnessSample sample,
                              const std::vector<std::shared_ptr<const TriangleMesh>>& cavities,
                              const WitnessOptions& options) {
  if (cavities.empty())
    return sample;
  sample.mesh = std::make_shared<const WitnessMesh>(
      deformation::withoutCavities(*sample.mesh, cavities, options.threads));
  if (static_cast<double>(sample.mesh->witnesses) < (1 - kWitnessCountTolerance) * options.wanted)
    sample.remarks.push_back(
        phrase("There are %1 witness points of %2: the others would lie in cavities, which hold no tissue.",
               sample.mesh->witnesses, options.wanted));
  return sample;
}

} // namespace viscera::live
