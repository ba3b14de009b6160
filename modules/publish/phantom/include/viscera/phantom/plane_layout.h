#pragma once

#include <string>
#include <vector>

#include "viscera/heart/heart_frame.h"
#include "viscera/phantom/phantom_options.h"

namespace viscera::phantom {

/// One plane of a cine study.
struct StudyPlane {
  std::string name;        ///< "sax_01", "lax_2ch"
  std::string description; ///< "cine_sax 1"
  ImageGrid grid; ///< One layer; its third column is the normal times the thickness. As the files say.
  Vec3 shift =
      Vec3::Zero(); ///< How far the body lay aside in the breath-hold of this plane, mm, in the plane.

  /// Where the voxels really are in the body's frame: `grid` less the shift.
  ImageGrid imaged() const;
};

/// The planes of a study: the stack from the base to the apex, then those along the axis. Shifts have the
/// given length and directions that the seed chooses.
std::vector<StudyPlane> studyPlanes(const heart::HeartFrame& heart, const PhantomOptions& options);

} // namespace viscera::phantom
