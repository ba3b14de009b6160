#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::medical_io {

/// The value that a repair takes behind its name: "remesh=1.5", "remove-fragments=5mm", "scale=0.1".
struct RepairValue {
  double standard = 0;            ///< Without a value; 0: it is found from the surface, or has to be given.
  double low = 0;                 ///< The least.
  double high = 0;                ///< The most.
  std::vector<std::string> units; ///< Behind the number, the first by default: "%", "mm", "ml"; empty: none.
};

/// A repair of a defective surface that the user can choose. No repair is applied without the user's choice.
struct SurfaceRepair {
  std::string id; ///< As in `viscera convert`: "fill-holes", "unit-m".
  Text does;      ///< What it does, as a sentence: "fills every hole with a cap".
  /// The repaired surface, from a valid mesh. Throws `DataError` when it is not possible, `Cancelled`. A pure
  /// function; bitwise independent of the number of threads.
  std::function<geometry::TriangleMesh(const geometry::TriangleMesh&, Progress&, Threads)> apply;
  bool remakes =
      false; ///< The repair makes new triangles; `surfaceChange` measures their distance from the old ones.
  std::optional<RepairValue> value = {}; ///< None: it takes no value.
};

/// All repairs: `orient`, `fill-holes`, `remove-fragments`, `keep-largest`, `remesh`, `scale`; of the axes
/// `mirror`, `ras-to-lps`, `y-up`, `y-up-ras`, `flip-y`, `flip-z`, `flip-yz`, `flip-xz`, `flip-xyz` (of a
/// flip, the letters are the axes that change their sign); and `unit-ID` for every unit of `lengthUnits` but
/// mm.
const std::vector<SurfaceRepair>& surfaceRepairs();

/// The repair with that id, which may have a value: `remove-fragments=5mm` drops pieces smaller than that
/// (`FragmentLimit`), `remesh=1.5` resolves details of 1.5 mm, `scale=0.1` makes the surface a tenth as
/// large. Throws `UsageError` that lists the existing ones, or says what value is possible.
SurfaceRepair surfaceRepair(std::string_view id);

/// The options of `repairSurface`: fineness and number of triangles.
struct RepairOptions {
  int cells = 100;        ///< Grid cells along the longest side; details smaller than one are lost.
  int triangles = 10'000; ///< About as many as the result is to have.
};

/// A closed surface without intersections near a given one that may be open, self-intersecting or not
/// manifold: the zero level of its signed distance on a grid, by flying edges, smoothed and thinned out.
/// Pieces with less than a hundredth of the volume are left out. Expects valid indices. Throws `DataError`
/// when the surface encloses nothing, `Cancelled`. A second or two; bitwise independent of the number of
/// threads.
geometry::TriangleMesh repairSurface(const geometry::TriangleMesh& mesh, const RepairOptions& options,
                                     Progress& progress, Threads threads = {});

/// The distances between a remeshed surface and the one before.
struct SurfaceChange {
  Eigen::Index trianglesBefore = 0;
  Eigen::Index trianglesAfter = 0;
  double meanMm = 0;     ///< From the old surface's vertices to the new surface.
  double maximumMm = 0;  ///< The same; large where the new surface has lost a detail such as a thin vessel.
  double diagonalMm = 0; ///< Of the box around the old surface.
};

/// Measures the distances from every vertex of `before` that a triangle has to the surface `after`, which has
/// to be valid and not empty. O(n log m); thread-safe; bitwise independent of the number of threads.
SurfaceChange surfaceChange(const geometry::TriangleMesh& before, const geometry::TriangleMesh& after,
                            Threads threads = {});

/// The change as a sentence: "20,000 triangles instead of 61,204, 0.12 mm from ...".
Text inWords(const SurfaceChange& change);

/// Says that the new surface has lost a detail; nothing where the old one is near everywhere, to 2 % of its
/// diagonal.
std::optional<Text> doubtAbout(const SurfaceChange& change);

/// The surface with about `triangles` triangles, by quadric decimation
/// (`geometry::decimateClosedSurface`); a coarser one, one with holes and one that is not manifold are
/// returned as they are. It stays closed, but may come to intersect itself. Without colours.
geometry::TriangleMesh thinSurface(const geometry::TriangleMesh& mesh, int triangles);

/// Makes a surface anew (`repairSurface`) with about `triangles` triangles, 0: as many as it has, 20,000 at
/// most. Colours are lost.
geometry::TriangleMesh remeshed(const geometry::TriangleMesh& mesh, int triangles, Progress& progress,
                                Threads threads = {});

/// The edge of the cells by which `remeshed` makes a surface, mm: finer details are lost.
double usualResolutionMm(const geometry::TriangleMesh& mesh);
/// The finest one that `remeshedAt` takes.
double finestResolutionMm(const geometry::TriangleMesh& mesh);
/// About as many triangles as a surface of that resolution takes. O(m).
int trianglesAt(const geometry::TriangleMesh& mesh, double resolutionMm);

/// Makes a surface anew with details of `resolutionMm`, with about `triangles` triangles, 0: as many as that
/// takes. Throws as `repairSurface`, and `DataError` for a resolution finer than `finestResolutionMm`. A
/// second at the usual resolution, eight times as long at half of it.
geometry::TriangleMesh remeshedAt(const geometry::TriangleMesh& mesh, double resolutionMm, int triangles,
                                  Progress& progress, Threads threads = {});

} // namespace viscera::medical_io
