#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/image_cut.h"
#include "viscera/medical_io/label_map.h"

/// Converts label maps to organ surfaces.
namespace viscera::medical_io {

/// The options of the conversion: which labels, smoothing and number of triangles.
struct LabelSurfaceOptions {
  std::vector<std::size_t> segments; ///< Indices into `LabelMap::segments`, each once; empty: all.
  int triangles = 20'000;            ///< The approximate maximum for each surface; 0: no limit.
  double smoothing = 1; ///< 0: the voxels' steps stay; 0.5: the terraces of slices stay; 1: none; up to 2.
  bool largestPieceOnly = false; ///< Drops the voxels that do not touch the largest piece by a face.
};

/// The surface of one label, with its volume and remarks.
struct LabelSurface {
  std::size_t segment = 0;        ///< Index into `LabelMap::segments`: its name and colour.
  geometry::TriangleMesh mesh;    ///< mm LPS; closed, manifold, outward.
  geometry::SurfaceReport report; ///< Of `mesh`.
  double volumeMm3 = 0;           ///< That the mesh encloses.
  double voxelVolumeMm3 = 0;      ///< Of the voxels that were kept.
  int pieces = 1;                 ///< Voxels that touch by faces; those that were kept.
  std::optional<ImageCut> cut;    ///< The edges of the image that cut it off; none: it is whole.
  std::vector<Text> warnings;     ///< Pieces that were left out, that cut, and other remarks for the user.
};

/// Called with every surface as soon as it is made: on the thread that made it, never on two at a time.
using SurfaceListener = std::function<void(const LabelSurface&)>;

/// A closed surface around every label, in the order of `options.segments`: flying edges through the label's
/// voxels with a margin, so that organs that the image cuts off are closed as well; windowed-sinc smoothing
/// (Taubin et al. 1996, doi 10.1007/BFb0015551) that keeps the volume around each vertex;
/// `geometry::decimateClosedSurface`; then all vertices move along their normals, by a voxel at most, until
/// the volume is the voxels' within `kVolumeTolerance`. A label that would lose its shape (thinner than a
/// voxel) is smoothed less.
///
/// Throws `UsageError` for a segment that the map does not have, `Cancelled`. In parallel over labels;
/// results do not depend on the number of threads. O(v + m log m) for a box of v voxels and m triangles.
std::vector<LabelSurface> labelSurfaces(const LabelMap& map, const LabelSurfaceOptions& options,
                                        Progress& progress, Threads threads = {},
                                        const SurfaceListener& made = {});

/// Largest relative difference between the volumes of a surface and of its voxels.
inline constexpr double kVolumeTolerance = 0.01;

} // namespace viscera::medical_io
