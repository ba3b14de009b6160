#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>

#include <Eigen/Geometry>

#include "build_paths.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/geometry/volume.h"
#include "viscera/live/sequence_setup.h"

namespace viscera::tests {

/// The project's organs, kept beside the build so that each test does not make them again.
inline sample_organs::SampleLibrary cachedLibrary() {
  return {std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
          std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
}

/// Every surface of a sequence's organ, bound, in the pose of one moment: what the window shows, without it.
class SequenceScene {
public:
  explicit SequenceScene(const std::function<live::SequenceSetup(Progress&)>& make)
      : setup_(make(progress_)) {
    for (const sample_organs::SampleSurface& surface : setup_.organ.surfaces)
      add(surface);
  }
  virtual ~SequenceScene() = default;

  const live::SequenceSetup& setup() const { return setup_; }

  /// Binds another surface to the same handles.
  void add(const sample_organs::SampleSurface& surface) {
    coordinates::HandleSet handles;
    handles.positions = setup_.sequence->restHandles();
    for (const auto& system : coordinates::builtInSystems())
      if (system->id() == setup_.system.id)
        surfaces_[surface.name] = {surface.mesh,
                                   deformation::bindOrgan(*system, handles, surface.mesh->points,
                                                          {setup_.system.parameters, {}}, progress_)};
  }

  void show(double seconds, double ratePerMinute) { show(*setup_.sequence, seconds, ratePerMinute); }
  /// The same by another sequence of the same handles.
  void show(const sequences::Sequence& sequence, double seconds, double ratePerMinute) {
    sequence.poseAt(seconds, ratePerMinute, pose_);
    for (auto& [name, surface] : surfaces_)
      surface.binding->deform(pose_, surface.points);
  }

  geometry::TriangleMesh posed(const std::string& name) const {
    const Surface& surface = surfaces_.at(name);
    return {surface.points, surface.mesh->triangles, {}};
  }

  double volumeMl(const std::string& name) const {
    const Surface& surface = surfaces_.at(name);
    return geometry::volume(surface.points, surface.mesh->triangles) / kMm3PerMl;
  }

  /// The least quality that a triangle has kept: that of the posed one by that of the same at rest. Quality
  /// is 1 for an equilateral triangle and 0 for one without area.
  double worstTriangle(const std::string& name) const {
    const Surface& surface = surfaces_.at(name);
    double worst = std::numeric_limits<double>::infinity();
    for (Eigen::Index t = 0; t < surface.mesh->triangles.rows(); ++t)
      worst = std::min(worst, quality(surface.points, surface.mesh->triangles, t) /
                                  quality(surface.mesh->points, surface.mesh->triangles, t));
    return worst;
  }

private:
  struct Surface {
    std::shared_ptr<const geometry::TriangleMesh> mesh;
    std::shared_ptr<const coordinates::Binding> binding;
    Points points = {};
  };

  static double quality(const Points& points, const Triangles& triangles, Eigen::Index t) {
    const Vec3 a = points.row(triangles(t, 0));
    const Vec3 b = points.row(triangles(t, 1));
    const Vec3 c = points.row(triangles(t, 2));
    const double edges = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / edges;
  }

  Progress progress_;
  live::SequenceSetup setup_;
  std::map<std::string, Surface> surfaces_;
  Points pose_;
};

} // namespace viscera::tests
