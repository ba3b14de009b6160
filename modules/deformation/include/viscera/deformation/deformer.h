#pragma once

#include <memory>
#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

struct NewPose;

/// Computes a bound surface in any pose of its handles: points, and on demand normals, volume and the
/// volume's gradient. The arrays stay at the same address from one pose to the next, so that VTK may use them
/// without a copy. For use by one thread at a time; it computes on several threads.
///
///     Deformer deformer(mesh, binding, handles.positions);
///     deformer.setPose(pose);
///     const double ml = deformer.volumeMm3() / 1000;
class Deformer {
public:
  /// `rest` is the surface that was bound, `restHandles` (`n x 3`) the handles it was bound to.
  Deformer(std::shared_ptr<const geometry::TriangleMesh> rest,
           std::shared_ptr<const coordinates::Binding> binding, Points restHandles, Threads threads = {});

  /// Poses the surface. Throws `DataError` for a pose of another size or that is not finite.
  void setPose(const Points& pose);

  /// Moves one handle to `position` and updates the points by that handle's column only.
  void moveHandle(int handle, const Vec3& position);

  /// Back to rest; exactly the rest points (no rounding from the coordinates).
  void reset();

  /// The reference is valid until the surface gets another pose.
  const Points& pose() const { return *pose_; }
  const Points& restHandles() const { return *restHandles_; }
  const Points& points() const { return points_; }
  const geometry::TriangleMesh& rest() const { return *rest_; }
  const coordinates::Binding& binding() const { return *binding_; }
  std::shared_ptr<const geometry::TriangleMesh> sharedRest() const { return rest_; }
  std::shared_ptr<const coordinates::Binding> sharedBinding() const { return binding_; }

  /// Vertex normals of the present points, computed when first asked for after a change.
  const geometry::Normals& normals();
  /// Signed volume of the present points, mm^3; computed when first asked for after a change.
  double volumeMm3();
  /// Whether `volumeMm3` costs nothing: it was asked for since the last change.
  bool volumeKnown() const { return volumeValid_; }
  double restVolumeMm3() const { return restVolume_; }
  /// Derivative of the volume with respect to every handle, `n x 3`, mm^2, at the present pose.
  const Points& volumeGradient();

  /// The largest distance of a vertex from its rest position, mm.
  double maxDisplacementMm() const;

private:
  friend void poseTogether(const std::vector<NewPose>& poses, Threads threads);
  friend std::vector<double> volumesTogether(const std::vector<Deformer*>& deformers, Threads threads);

  void requirePose(const Points& pose) const;
  PiecesOfWork poseInPieces(std::shared_ptr<const Points> pose);
  PiecesOfWork moveInPieces(std::shared_ptr<const Points> pose, const std::vector<int>& moved);
  void changed();

  std::shared_ptr<const geometry::TriangleMesh> rest_;
  std::shared_ptr<const coordinates::Binding> binding_;
  geometry::VertexTriangles around_;
  std::shared_ptr<const Points> restHandles_;
  Threads threads_;
  std::shared_ptr<const Points> pose_; ///< Shared with all organs, and with the document, in this pose.
  Points points_;
  geometry::Normals normals_;
  Points pointGradient_;
  Points handleGradient_;
  double restVolume_ = 0;
  double volume_ = 0;
  bool normalsValid_ = false;
  bool volumeValid_ = false;
  bool gradientValid_ = false;
};

} // namespace viscera::deformation
