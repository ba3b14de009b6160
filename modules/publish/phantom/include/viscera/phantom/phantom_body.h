#pragma once

#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/named_place.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/heart/heart_frame.h"
#include "viscera/phantom/row_cover.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::phantom {

/// A closed surface of the phantom at rest.
struct BodySurface {
  std::string tissue;          ///< Of `tissues()`.
  geometry::TriangleMesh mesh; ///< mm LPS, in the frame of the sample heart.
  /// It keeps its place whatever moves: skin, inside of the chest wall, spine. Organs slide along it.
  bool still = false;
};

/// A point of tissue with a name.
struct Landmark {
  std::string name;       ///< "Apex of the left ventricle"
  Vec3 at = Vec3::Zero(); ///< mm LPS, at rest.
};

/// Thorax and upper abdomen at rest: the sample organs at their places, with lungs, chest wall and spine as
/// simple closed shapes.
struct PhantomBody {
  std::vector<BodySurface> surfaces; ///< By their tissues' labels.
  std::vector<Landmark> landmarks;
  heart::HeartFrame heart;

  /// The surface of a tissue. Throws `UsageError` when there is none.
  const BodySurface& surfaceOf(const std::string& tissue) const;
  /// The box around the skin, mm.
  Bounds bounds() const;
  /// All surfaces for `coverRows`; `points` are those of each.
  std::vector<PaintedSurface> painted(const std::vector<Points>& points) const;
};

/// Loads the organs, or makes them (seconds each). Throws what `sample_organs::sampleOrgan` throws.
PhantomBody phantomBody(const sample_organs::SampleLibrary& library, sample_organs::Resolution resolution,
                        Progress& progress, Threads threads = {});

} // namespace viscera::phantom
