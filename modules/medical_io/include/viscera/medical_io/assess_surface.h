#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/image_cut.h"
#include "viscera/medical_io/space.h"

namespace viscera::medical_io {

/// The severity of a finding: `good` is as it should be, `note` is information, `doubt` should be checked by
/// the user, `fault` makes later steps fail.
enum class FindingSeverity { good, note, doubt, fault };

/// The subject of a finding, such as axes, size or holes. `arrangement` is the position of organs relative to
/// each other, `detail` what a repair has lost.
enum class FindingSubject { axes, size, holes, edges, facing, pieces, crossings, arrangement, detail };

/// A finding about a surface that is to become an organ: something doubtful or wrong, with possible repairs.
struct Finding {
  FindingSeverity severity = FindingSeverity::good;
  Text text;                        ///< A sentence without capital and full stop, for a user.
  std::vector<std::string> repairs; ///< Ids of `surfaceRepairs` that would help, best first.
  FindingSubject subject = FindingSubject::arrangement;

  friend bool operator==(const Finding&, const Finding&) = default;
};

/// The name of a surface, and what its file says about axes and unit.
struct SurfaceOrigin {
  std::string name;                 ///< The name of the organ in the file: "kidney_left".
  std::optional<Space> statedSpace; ///< The axes that its file states; none: LPS was assumed.
  bool unitStated = false;          ///< Its file states the unit, as label maps do, so that a small size is
                                    ///< taken as real.
  std::optional<ImageCut> cut = {}; ///< The edges of its image that cut it off.
};

/// The result of assessing a surface: all findings and its measures.
struct SurfaceAssessment {
  geometry::SurfaceReport report;
  int selfIntersections = 0;
  Vec3 sizeMm = Vec3::Zero(); ///< Of the box: right to left, front to back, foot to head.
  double volumeMl = 0;        ///< Without its sign; 0 for an open surface.
  std::vector<Finding>
      findings; ///< One for each of axes, size, holes, manifold, facing, pieces, intersections.

  FindingSeverity worst() const;
  /// Whether a user should check the surface before it is accepted.
  bool questionable() const { return worst() >= FindingSeverity::doubt; }
};

/// Checks a surface for the usual defects of patients' surfaces: wrong axes or side of the body, unit or size
/// that does not suit the named organ, holes, edges that join more than two triangles, triangles that face
/// inward, separate pieces, self-intersections. The surface is not changed. Expects valid indices. Throws
/// `Cancelled`. O(m log m), about a second for a million triangles.
SurfaceAssessment assessSurface(const geometry::TriangleMesh& mesh, const SurfaceOrigin& origin,
                                Progress& progress, Threads threads = {});
/// The same of a surface whose report, that of `geometry::checkSurface`, is known from its reading.
SurfaceAssessment assessSurface(const geometry::TriangleMesh& mesh, const geometry::SurfaceReport& report,
                                const SurfaceOrigin& origin, Progress& progress, Threads threads = {});

} // namespace viscera::medical_io
