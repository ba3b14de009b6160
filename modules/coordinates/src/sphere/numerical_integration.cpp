#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "choice_parameter.h"
#include "nspace/direction_solver.h"
#include "sphere/sphere_samples.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

const Parameter kDirectionSamples =
    countParameter("samples", "Divisions of the icosahedron: 20 * 4^samples directions", 0, 5, 3);
const Parameter kDirectionSeed =
    countParameter("seed", "Turns the directions at random; 0 leaves the icosahedron upright", 0, 1000, 0);

/// Unit vectors whose determinant is smaller lie in one plane with the point: they span nothing.
constexpr double kFlatWithPoint = 1e-14;
/// A direction through an edge belongs to both sides.
constexpr double kDirectionOnEdge = 1e-12;

/// Every face of the tetrahedra once, sorted.
Triangles facesOf(const geometry::Tetrahedra& tetrahedra) {
  std::vector<std::array<int, 3>> faces;
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
    for (int left = 0; left < 4; ++left) {
      std::array<int, 3> face{};
      for (int corner = 0, next = 0; corner < 4; ++corner)
        if (corner != left)
          face[static_cast<std::size_t>(next++)] = tetrahedra(t, corner);
      std::sort(face.begin(), face.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  Triangles triangles(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t i = 0; i < faces.size(); ++i)
    triangles.row(static_cast<Eigen::Index>(i)) << faces[i][0], faces[i][1], faces[i][2];
  return triangles;
}

/// A turn that is as likely as any other; none for seed 0.
Eigen::Matrix3d randomTurn(int seed) {
  if (seed == 0)
    return Eigen::Matrix3d::Identity();
  std::mt19937 random(static_cast<unsigned>(seed));
  std::normal_distribution<double> normal;
  Eigen::Quaterniond turn;
  for (double& value : turn.coeffs())
    value = normal(random);
  return turn.normalized().toRotationMatrix();
}

/// A face's part of the directions' numbers, before its samples are shared with other faces.
struct SeenFace {
  Eigen::Index face, sample;
  Vec3 shares;
  double weight;
};

struct Integral {
  Triangles faces;
  SphereSamples samples;

  bool operator()(const HandleDirections& sight, Values& beta) const {
    const Eigen::Index count = samples.areas.size();
    Values total = Values::Zero(count);
    std::vector<SeenFace> seen;
    Eigen::Matrix3Xd shares(3, count);
    for (Eigen::Index face = 0; face < faces.rows(); ++face) {
      Eigen::Matrix3d frame;
      for (int i = 0; i < 3; ++i)
        frame.col(i) = sight.units.row(faces(face, i)).transpose();
      const double volume = frame.determinant();
      if (std::abs(volume) < kFlatWithPoint)
        continue;
      // Each direction w = sum_i shares_i u_i by the three corners of a face; it is seen where no share is
      // negative, and counts by the squared determinant.
      shares.noalias() = frame.inverse() * samples.directions;
      for (Eigen::Index sample = 0; sample < count; ++sample)
        if (shares.col(sample).minCoeff() >= -kDirectionOnEdge) {
          seen.push_back({face, sample, shares.col(sample).cwiseMax(0), volume * volume});
          total[sample] += volume * volume;
        }
    }
    if (!(total.minCoeff() > 0))
      return false;
    // beta_i += area_w (det_f^2 / sum of det^2 over the faces that w sees) shares_i.
    for (const SeenFace& one : seen)
      for (int i = 0; i < 3; ++i)
        beta[faces(one.face, i)] +=
            samples.areas[one.sample] * one.weight / total[one.sample] * one.shares[i];
    return true;
  }
};

} // namespace

/// The thesis's numerical integration approach (3.2.1): the faces of the handles' Delaunay tetrahedra, seen
/// from a point, cover the sphere around it more than once; mean value coordinates are integrated over it at
/// the centres of a divided icosahedron. A sample is shared between all triangles that hold it, as the square
/// of the volume that each spans with the point.
///
/// Each sample is reproduced by every triangle that holds it, and the samples add up to zero, so identity and
/// unity are exact for any number of samples. The integral is continuous; its sum jumps where a sample passes
/// an edge, by less the more samples there are. `samples` is the number of divisions of the icosahedron,
/// `seed` turns it at random; 0 leaves it as it is. O(samples x tetrahedra) a point.
std::shared_ptr<const CoordinateSystem> numericalIntegration() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{.id = "numerical-integration",
                        .name = "Numerical integration approach",
                        .summary = "Mean value over all tetrahedra of the handles at once, by directions; "
                                   "positive, with many maxima",
                        .traits = {.positive = true,
                                   .interpolates = true,
                                   .rotationInvariant = false,
                                   .continuous = false,
                                   .smooth = false},
                        .parameters = {kDirectionSamples, kDirectionSeed}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        SphereSamples samples = sphereSamples(static_cast<int>(parameters.get(kDirectionSamples)));
        samples.directions =
            (randomTurn(static_cast<int>(parameters.get(kDirectionSeed))) * samples.directions).eval();
        return std::make_unique<DirectionSolver>(
            handles.positions,
            Integral{facesOf(geometry::delaunayTetrahedra(handles.positions)), std::move(samples)});
      });
}

} // namespace viscera::coordinates
