#include "viscera/medical_io/slice_frame.h"

#include <algorithm>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

std::array<SliceDirection, 3> sliceDirections() {
  return {SliceDirection{"axial", "Axial", 2, Vec3::UnitX(), -Vec3::UnitY(), {"R", "L", "P", "A"}},
          SliceDirection{"coronal", "Coronal", 1, Vec3::UnitX(), Vec3::UnitZ(), {"R", "L", "I", "S"}},
          SliceDirection{"sagittal", "Sagittal", 0, Vec3::UnitY(), Vec3::UnitZ(), {"A", "P", "I", "S"}}};
}

SliceDirection sliceDirection(const std::string& id) {
  const auto all = sliceDirections();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&id](const SliceDirection& direction) { return direction.id == id; });
  if (found == all.end())
    throw UsageError(misuse("There is no such slice"), "\"" + id + "\"",
                     misuse("take axial, coronal or sagittal"));
  return *found;
}

SliceFrame frameAround(const SliceDirection& direction, const Vec3& center, double mmPerPixel, int width,
                       int height) {
  SliceFrame frame;
  frame.right = mmPerPixel * direction.right;
  frame.up = mmPerPixel * direction.up;
  frame.width = width;
  frame.height = height;
  frame.corner = center - 0.5 * (width - 1) * frame.right - 0.5 * (height - 1) * frame.up;
  return frame;
}

} // namespace viscera::medical_io
