#include "viscera/live/tissue_energy.h"

#include <algorithm>
#include <cmath>

#include "viscera/core/error.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/geometry/volume.h"

namespace viscera::live {
namespace {

/// Fewer say little about a small organ.
constexpr int kFewestOfAnOrgan = 100;
constexpr int kMostWitnesses = 5000, kFewestWitnesses = 500;
constexpr double kHandlesOfMost = 60;

} // namespace

int energyWitnesses(Eigen::Index handles) {
  const double part = kHandlesOfMost / static_cast<double>(std::max<Eigen::Index>(handles, 1));
  return std::clamp(static_cast<int>(kMostWitnesses * std::min(1.0, part * part)), kFewestWitnesses,
                    kMostWitnesses);
}

std::shared_ptr<const elasticity::LeastEnergy>
tissueEnergy(const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& surfaces,
             const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
             const coordinates::BindOptions& options, Progress& progress) {
  const int witnesses = energyWitnesses(handles.positions.rows());
  std::vector<double> volumes;
  double all = 0;
  for (const auto& surface : surfaces)
    all += volumes.emplace_back(
        std::abs(geometry::volume(surface->points, surface->triangles, options.threads)));
  std::vector<elasticity::WitnessedTissue> tissue;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    progress.throwIfCancelled();
    const int wanted =
        all > 0 ? std::max(kFewestOfAnOrgan, static_cast<int>(std::lround(witnesses * volumes[i] / all)))
                : witnesses;
    deformation::WitnessMesh mesh;
    try {
      mesh = deformation::gridWitnesses(*surfaces[i], wanted, progress, options.threads);
    } catch (const DataError&) { // It encloses nothing.
      continue;
    }
    tissue.push_back({deformation::bindWitnesses(system, handles, mesh.points, options, progress),
                      elasticity::witnessVolumes(mesh)});
  }
  elasticity::LeastEnergy::Options energy;
  energy.threads = options.threads;
  return std::make_shared<const elasticity::LeastEnergy>(tissue, handles.positions, energy);
}

} // namespace viscera::live
