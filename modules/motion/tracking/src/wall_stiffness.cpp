#include "wall_stiffness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/LU>

#include "tissue_witnesses.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/tracking/surface_distance.h"

namespace viscera::tracking {
namespace {

constexpr double kWitnessMm = 7, kBandMm = 8;
/// The grid does not begin at the box's own corner, where surfaces lie along its planes.
constexpr double kGridStart = 0.37;

struct WitnessGrid {
  std::vector<Vec3> points;
  std::vector<bool> tissue; ///< Where it must not fold.
  std::vector<std::pair<Eigen::Index, Eigen::Index>> neighbours;
};

/// Where witnesses lie, decided by the distances from every surface.
class WitnessChoice {
public:
  WitnessChoice(const MotionRig& rig, std::size_t outer) : outer_(outer) {
    for (const geometry::TriangleMesh& surface : rig.surfaces())
      distances_.emplace_back(std::make_shared<const geometry::TriangleMesh>(surface));
  }
  /// Whether a point is used, and whether it lies in the tissue.
  std::pair<bool, bool> at(const Vec3& point) const {
    double nearest = 1e9;
    bool tissue = true;
    for (std::size_t i = 0; i < distances_.size(); ++i) {
      Vec3 ignored;
      const double distance = distances_[i].at(point, ignored);
      nearest = std::min(nearest, std::abs(distance));
      tissue = tissue && (i == outer_ ? distance < 0 : distance > 0);
    }
    // One surface alone is a wall that is not seen, around blood that may crowd together.
    const bool band = nearest < kBandMm;
    return distances_.size() > 1 ? std::pair(band || tissue, tissue) : std::pair(band, band);
  }

private:
  std::size_t outer_;
  std::vector<MeshDistance> distances_;
};

WitnessGrid witnessGrid(const MotionRig& rig, std::size_t outer, Threads threads) {
  const WitnessChoice choice(rig, outer);
  const Bounds box = boundsOf(rig.surfaces()[outer].points);
  const Vec3 low = box.low - Vec3::Constant(kBandMm + kGridStart);
  const Eigen::Vector3i count =
      ((box.high + Vec3::Constant(kBandMm) - low) / kWitnessMm).array().ceil().cast<int>();
  const Eigen::Index all = Eigen::Index{count[0]} * count[1] * count[2];
  const auto place = [&](Eigen::Index i) {
    return Vec3(low + kWitnessMm * Vec3(static_cast<double>(i % count[0]),
                                        static_cast<double>(i / count[0] % count[1]),
                                        static_cast<double>(i / count[0] / count[1])));
  };
  std::vector<std::uint8_t> kind(static_cast<std::size_t>(all));
  parallelRanges(all, 256, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const auto [used, tissue] = choice.at(place(i));
      kind[static_cast<std::size_t>(i)] = used ? (tissue ? 2 : 1) : 0;
    }
  });
  WitnessGrid grid;
  std::vector<Eigen::Index> number(static_cast<std::size_t>(all), -1);
  const std::array<Eigen::Index, 3> back = {1, count[0], Eigen::Index{count[0]} * count[1]};
  for (Eigen::Index i = 0; i < all; ++i) {
    if (kind[static_cast<std::size_t>(i)] == 0)
      continue;
    const auto own = static_cast<Eigen::Index>(grid.points.size());
    number[static_cast<std::size_t>(i)] = own;
    grid.points.push_back(place(i));
    grid.tissue.push_back(kind[static_cast<std::size_t>(i)] == 2);
    const std::array<bool, 3> inner = {i % count[0] > 0, i / back[1] % count[1] > 0, i >= back[2]};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (inner[axis])
        if (const Eigen::Index other = number[static_cast<std::size_t>(i - back[axis])]; other >= 0)
          grid.neighbours.emplace_back(other, own);
  }
  return grid;
}

} // namespace

WallStiffness::WallStiffness(const MotionRig& rig, std::size_t outer, int witnesses, Progress& progress,
                             Threads threads) {
  const WitnessGrid grid = witnessGrid(rig, outer, threads);
  progress.throwIfCancelled();
  coordinates::BindOptions options;
  options.parameters.set("locality", rig.locality());
  options.parameters.set("softness", rig.softnessMm());
  options.threads = threads;
  coordinates::HandleSet handles;
  handles.positions = rig.rest();
  const Points points = viscera::pointsOf(grid.points);
  const auto bound =
      deformation::bindWitnesses(*coordinates::sCelestial(), handles, points, options, progress);
  const Eigen::Index n = rig.handles(), count = points.rows();
  const auto pairs = static_cast<Eigen::Index>(grid.neighbours.size());
  std::vector<Eigen::Index> tissue;
  for (Eigen::Index i = 0; i < count; ++i)
    if (grid.tissue[static_cast<std::size_t>(i)])
      tissue.push_back(i);
  strain_ = bending_ = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::MatrixXd gradients(count, n), changes(pairs, n);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index handle = 0; handle < n; ++handle)
        gradients(i, handle) = bound->gradient(i, handle)[axis];
    for (Eigen::Index i = 0; i < pairs; ++i) {
      const auto& [a, b] = grid.neighbours[static_cast<std::size_t>(i)];
      changes.row(i) = gradients.row(a) - gradients.row(b);
    }
    strain_ += gradients.transpose() * gradients / static_cast<double>(std::max<Eigen::Index>(count, 1));
    bending_ += changes.transpose() * changes / static_cast<double>(std::max<Eigen::Index>(pairs, 1));
    rows_[static_cast<std::size_t>(axis)] = gradients(tissue, Eigen::all);
  }
  strain_ = rig.bending() * strain_ * rig.bending(); // Affine motion is free.
  for (Eigen::MatrixXd& rows : witnesses_)
    rows.resize(0, n);
  if (witnesses <= 0)
    return;
  const deformation::WitnessMesh mesh = tissueWitnesses(rig, outer, witnesses, progress, threads);
  const auto fine = deformation::bindWitnesses(
      *coordinates::sCelestial(), handles, Points(mesh.points.topRows(mesh.witnesses)), options, progress);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::MatrixXd& rows = witnesses_[static_cast<std::size_t>(axis)];
    rows.resize(mesh.witnesses, n);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      for (Eigen::Index handle = 0; handle < n; ++handle)
        rows(i, handle) = fine->gradient(i, handle)[axis];
  }
}

Values WallStiffness::ratiosOf(const Rows& rows, const Points& pose) {
  const std::array<Points, 3> columns = {Points(rows[0] * pose), Points(rows[1] * pose),
                                         Points(rows[2] * pose)};
  Values ratios(rows[0].rows());
  for (Eigen::Index i = 0; i < ratios.size(); ++i)
    ratios[i] = columns[0].row(i).dot(columns[1].row(i).cross(columns[2].row(i)));
  return ratios;
}

Points WallStiffness::slopeOf(const Rows& rows, const Points& pose, Eigen::Index point) {
  // det F = f_x . (f_y x f_z) with f_a = sum_i (da w_i) h_i.
  std::array<Eigen::RowVector3d, 3> f;
  for (std::size_t axis = 0; axis < 3; ++axis)
    f[axis] = rows[axis].row(point) * pose;
  Points gradient = Points::Zero(pose.rows(), 3);
  for (std::size_t axis = 0; axis < 3; ++axis)
    gradient += rows[axis].row(point).transpose() * f[(axis + 1) % 3].cross(f[(axis + 2) % 3]);
  return gradient;
}

} // namespace viscera::tracking
