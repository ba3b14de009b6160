#pragma once

#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/geometry/triangle_mesh.h"

/// Computes the volume that a closed triangle surface encloses, by the divergence theorem (thesis 5.1.1). The
/// thesis integrates each triangle by a quadrature of four points; the closed form `1/6 p1.(p2 x p3)` is
/// equal to it up to rounding.
namespace viscera::geometry {

/// Signed volume in mm^3: positive for an outward surface. Meaningless for an open one. Sums fixed blocks of
/// triangles in a fixed order, relative to the first point: bitwise independent of the number of threads.
/// O(m).
double volume(const Points& points, const Triangles& triangles, Threads threads = {});

/// The sum of `volume` in pieces, for measuring several surfaces in one parallel loop. `points` and
/// `triangles` must live longer, and must not change until all pieces are done.
class VolumeSum {
public:
  VolumeSum(const Points& points, const Triangles& triangles);

  /// A piece for each block of triangles. This object must not be moved until they are done.
  PiecesOfWork pieces();
  /// mm^3, once all pieces are done: the bits of `volume`.
  double volume() const;

private:
  const Points& points_;
  const Triangles& triangles_;
  Vec3 origin_ = Vec3::Zero();
  std::vector<double> blocks_;
};

/// Derivative of `volume` with respect to every vertex: fills `gradient` (resized to `n x 3`, mm^2) with
/// `1/6 sum p2 x p3` over the triangles around each vertex. Exact for closed surfaces, whose gradient does
/// not depend on the origin. Bitwise independent of the number of threads. O(m).
void volumeGradient(const Points& points, const Triangles& triangles, const VertexTriangles& around,
                    Points& gradient, Threads threads = {});

/// Area of triangle `t`, mm^2.
double areaOf(const Points& points, const Triangles& triangles, Eigen::Index t);

/// Area of the surface in mm^2. O(m).
double area(const Points& points, const Triangles& triangles);

} // namespace viscera::geometry
