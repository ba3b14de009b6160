#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::deformation {

/// The options of `tetrahedralise`: tetrahedron size, and limits of time and memory.
struct TetrahedraOptions {
  double maxVolumeMm3 = 0;        ///< Of nearly all tetrahedra; 0: no limit.
  double radiusEdgeRatio = 1.414; ///< Largest circumradius by shortest edge; 0: any shape.
  double timeLimitSeconds = 60;
  std::uint64_t memoryLimitBytes = std::uint64_t{2} << 30;
  std::filesystem::path worker; ///< Empty: `installedTetgenWorker()`.
};

/// Thrown when a surface cannot be filled with tetrahedra; holds the reason.
class TetrahedraError : public Error {
public:
  enum class Reason {
    missing,     ///< The worker program does not exist or cannot be started.
    refused,     ///< TetGen cannot mesh this surface: it ended, or crashed, as it does on bad surfaces.
    unusable,    ///< The result is not a mesh of this surface.
    timeLimit,   ///< It took too long and was ended.
    memoryLimit, ///< It exceeded the memory limit.
  };
  TetrahedraError(Reason reason, Text what, Text tryThis = {});
  Reason reason() const { return reason_; }

private:
  Reason reason_;
};

/// The path of the program that runs TetGen, which is installed beside this library: `viscera_tetgen_worker`
/// in the installation's libexec folder or in the build's bin folder, or the path in the environment variable
/// VISCERA_TETGEN_WORKER. The path may not exist.
std::filesystem::path installedTetgenWorker();

/// Fills a closed surface (mm, LPS; any number of nested or separate pieces) with tetrahedra by TetGen
/// (Si 2015, doi:10.1145/2629697). The triangles of the surface are kept as they are; points are added inside
/// only. Those are the witness points of the result; the vertices of the surface, bit for bit, are the points
/// behind them. Cavities, by the winding number, stay empty.
///
/// TetGen runs in a process of its own with the limits given; it may abort, loop or exhaust memory without
/// harm, and is killed when `progress` is cancelled. Throws `TetrahedraError`, `Cancelled`, and `DataError`
/// for an invalid mesh. Thread-safe. The same input gives the same mesh.
WitnessMesh tetrahedralise(const geometry::TriangleMesh& surface, const TetrahedraOptions& options,
                           Progress& progress);

/// `options` with TetGen as the mesher where no mesher is set, limited to 60 s and 2 GB.
coordinates::BindOptions withTetgen(coordinates::BindOptions options);

} // namespace viscera::deformation
