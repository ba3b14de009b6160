#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "choice_parameter.h"
#include "mean_value/mean_value_solver.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

enum class Partitions { nested, independent };
enum class Polyhedra { tetrahedra, convex };

const Parameter kPartitions =
    choiceParameter("partitions", "Inner handles of each layer", {"nested", "independent"});
const Parameter kPolyhedra = choiceParameter("polyhedra", "Pieces of the hull", {"tetrahedra", "convex"});

/// Part of the handles' size: what lies in a plane, and what is outside.
constexpr double kInLayer = 1e-9;

using Face = std::array<int, 3>;

/// A convex polyhedron over some of the handles: outward triangles.
using Polyhedron = std::vector<Face>;

/// Divides the hull of the handles.
class Divider {
public:
  Divider(const Points& handles, Polyhedra kind)
      : handles_(handles), kind_(kind), tolerance_(kInLayer * boundsOf(handles).diagonal()) {}

  double height(const Face& face, const Vec3& point) const {
    const Vec3 a = at(face[0]), area = (at(face[1]) - a).cross(at(face[2]) - a);
    return area.normalized().dot(point - a);
  }

  /// How far a point is outside, or (negative) inside.
  double distance(const Polyhedron& polyhedron, const Vec3& point) const {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Face& face : polyhedron)
      farthest = std::max(farthest, height(face, point));
    return farthest;
  }

  /// Replaces the polyhedron around `handle` by its partition.
  void insert(std::vector<Polyhedron>& layer, int handle) const {
    const auto around = std::min_element(layer.begin(), layer.end(), [&](const auto& a, const auto& b) {
      return distance(a, at(handle)) < distance(b, at(handle));
    });
    // The cones from the handle over the faces of a convex polyhedron around it fill it without overlap; the
    // face a, b, c with the handle h has the outward faces abc, bah, cbh and ach.
    std::vector<Polyhedron> parts;
    for (const auto& [a, b, c] : *around)
      if (height({a, b, c}, at(handle)) < -tolerance_) // Not flat.
        parts.push_back({{a, b, c}, {b, a, handle}, {c, b, handle}, {a, c, handle}});
    if (kind_ == Polyhedra::convex)
      join(parts);
    layer.erase(around);
    layer.insert(layer.end(), parts.begin(), parts.end());
  }

private:
  Vec3 at(int handle) const { return handles_.row(handle).transpose(); }

  /// Joins neighbours as long as the union is convex.
  void join(std::vector<Polyhedron>& parts) const {
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = i + 1; j < parts.size();) {
        Polyhedron both;
        if (!joined(parts[i], parts[j], both)) {
          ++j;
          continue;
        }
        parts[i] = std::move(both);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1; // The larger one may now fit to what did not fit before.
      }
  }

  bool joined(const Polyhedron& one, const Polyhedron& two, Polyhedron& both) const {
    both = one;
    both.insert(both.end(), two.begin(), two.end());
    const auto inside = [&](const Face& face) { // Shared: it is there in both directions.
      return std::any_of(both.begin(), both.end(), [&](Face other) {
        std::swap(other[0], other[1]);
        for (int turn = 0; turn < 3; ++turn, std::rotate(other.begin(), other.begin() + 1, other.end()))
          if (other == face)
            return true;
        return false;
      });
    };
    Polyhedron outer;
    for (const Face& face : both)
      if (!inside(face))
        outer.push_back(face);
    if (outer.size() == both.size())
      return false;
    // Convex where no corner is above any face: n_f . (v - v_f) <= 0 for all f and v, to the tolerance.
    both = std::move(outer);
    for (const Face& face : both)
      for (const Face& other : both)
        for (const int corner : other)
          if (height(face, at(corner)) > tolerance_)
            return false;
    return true;
  }

  const Points& handles_;
  Polyhedra kind_;
  double tolerance_;
};

struct Cell {
  Polyhedron faces;
  std::unique_ptr<const PointSolver> solver;
};

class LayeredSolver final : public PointSolver {
public:
  LayeredSolver(const Points& handles, Partitions partitions, Polyhedra polyhedra)
      : handles_(handles), divider_(handles_, polyhedra), size_(boundsOf(handles).diagonal()) {
    const Triangles triangles = geometry::ConvexHull(handles).triangles();
    Polyhedron hull;
    std::vector<bool> outer(static_cast<std::size_t>(handles.rows()), false);
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
      hull.push_back({triangles(t, 0), triangles(t, 1), triangles(t, 2)});
      for (const int corner : hull.back())
        outer[static_cast<std::size_t>(corner)] = true;
    }
    addLayer({hull});
    std::vector<Polyhedron> nested = {hull};
    for (int handle = 0; handle < static_cast<int>(handles.rows()); ++handle) {
      if (outer[static_cast<std::size_t>(handle)])
        continue;
      std::vector<Polyhedron> own = {hull};
      divider_.insert(partitions == Partitions::nested ? nested : own, handle);
      if (partitions == Partitions::independent)
        addLayer(own);
    }
    if (nested.size() > 1)
      addLayer(nested);
  }

  bool solve(const Vec3& point, Values& weights) const override {
    // a_i = 1/L sum_l a_i^l (thesis 3.2.2), with the mean value coordinates a^l of the cell of layer l that
    // the point is in. Every layer reproduces the point with unity, and so does their mean; cells are convex,
    // so nothing is negative but by rounding.
    Values part(weights.size());
    for (const auto& layer : layers_) {
      const Cell* around = nullptr;
      double nearest = kInLayer * size_;
      for (const Cell& cell : layer)
        if (const double distance = divider_.distance(cell.faces, point); distance <= nearest) {
          nearest = distance;
          around = &cell;
        }
      part.setZero();
      if (!around || !around->solver->solve(point, part))
        return false;
      weights += part / static_cast<double>(layers_.size());
    }
    weights = weights.cwiseMax(0);
    return true;
  }

private:
  void addLayer(const std::vector<Polyhedron>& polyhedra) {
    auto& layer = layers_.emplace_back();
    for (const Polyhedron& polyhedron : polyhedra) {
      Triangles cage(static_cast<Eigen::Index>(polyhedron.size()), 3);
      for (std::size_t t = 0; t < polyhedron.size(); ++t)
        cage.row(static_cast<Eigen::Index>(t)) << polyhedron[t][0], polyhedron[t][1], polyhedron[t][2];
      layer.push_back({polyhedron, meanValueSolver(handles_, std::move(cage))});
    }
  }

  Points handles_;
  Divider divider_;
  double size_;
  std::vector<std::vector<Cell>> layers_;
};

} // namespace

/// The mean of mean value coordinates over several layers (thesis 3.2.2): the convex hull of the handles, and
/// partitions of it by the inner handles. `partitions`: `nested`, one partition by all inner handles one
/// after another; or `independent`, one for each. `polyhedra`: `tetrahedra`, or `convex`, where neighbours
/// are joined as long as their union is convex. Kinks at the faces inside. The thesis's other inner system,
/// harmonic coordinates, is not offered. O(polyhedra + triangles) a point.
std::shared_ptr<const CoordinateSystem> catalogueOfLayers() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "catalogue-of-layers",
          .name = "Catalogue of layers",
          .summary = "The mean over the hull and partitions of it by the inner handles; kinks at their faces",
          // Four handles in one plane are split along one diagonal or the other.
          .traits = {.positive = true, .rotationInvariant = false, .smooth = false},
          .parameters = {kPartitions, kPolyhedra}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        return std::make_unique<LayeredSolver>(handles.positions, chosen<Partitions>(parameters, kPartitions),
                                               chosen<Polyhedra>(parameters, kPolyhedra));
      });
}

} // namespace viscera::coordinates
