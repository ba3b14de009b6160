#pragma once

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::medical_io {

/// The contour of a label's voxels (closed; the axes of a voxel, mm, are the columns of `voxel`) with its
/// steps smoothed away: `smoothing` 0 leaves them, 1 is the usual, 2 the most. The points move, the triangles
/// stay.
///
/// Up to a half by a windowed sinc filter (Taubin et al. 1996, doi 10.1007/BFb0015551). Beyond it the
/// terraces of slices, many voxels long, go as well. A filter for such lengths takes the roundness of a
/// vessel away, too, and makes it a thread. A terrace goes in and out by turns, though, and a vessel in all
/// around: what the surface goes in on average around each vertex, compared with that filtered by a half, is
/// given back along the normals (volume is kept in each place). Nothing then lies farther from that than a
/// part of a voxel along the normal, so that contours stay on the borders of slices; a last gentle filter
/// follows.
///
/// Not VTK's filter, whose preparation of the neighbours takes most of its time: here two filters share one
/// pass. A constant stays what it is, exactly, so nothing is scaled. O(iterations m).
geometry::TriangleMesh smoothSteps(const geometry::TriangleMesh& contour, const Eigen::Matrix3d& voxel,
                                   double smoothing);

} // namespace viscera::medical_io
