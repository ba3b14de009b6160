#pragma once

#include <array>
#include <string>

#include "viscera/core/arrays.h"
#include "viscera/geometry/plane_cut.h"

/// Directions of slices through a scan, and the frame that maps pixels of a slice to the patient.
namespace viscera::medical_io {

/// A way to look at a patient slice by slice, by the convention of radiology: an axial slice is seen from the
/// feet, a coronal one from the front, a sagittal one from the patient's left. Letters say what lies at an
/// edge of the picture: R and L for right and left, A and P for front and back, S and I for head and feet.
struct SliceDirection {
  const char* id = "";              ///< "axial", "coronal", "sagittal".
  const char* name = "";            ///< "Axial".
  int axis = 0;                     ///< The coordinate (x, y, z as 0, 1, 2) that a slice keeps.
  Vec3 right = Vec3::UnitX();       ///< To the right in the picture, LPS.
  Vec3 up = Vec3::UnitZ();          ///< Upwards in the picture, LPS.
  std::array<const char*, 4> edges; ///< Letters of the left, right, lower and upper edge.
};

/// Axial, coronal, sagittal.
std::array<SliceDirection, 3> sliceDirections();

/// The direction of that id. Throws `UsageError` that lists them for another word.
SliceDirection sliceDirection(const std::string& id);

/// Position and axes of a slice's pixels in the patient, mm LPS.
struct SliceFrame {
  Vec3 corner = Vec3::Zero(); ///< The centre of the pixel at the lower left.
  Vec3 right = Vec3::UnitX(); ///< From a pixel to the next one in its row; not zero.
  Vec3 up = Vec3::UnitZ();    ///< From a pixel to the one above; at a right angle to `right`.
  int width = 0;              ///< Pixels in a row.
  int height = 0;             ///< Rows.

  /// The place of a pixel; whole numbers are centres.
  Vec3 at(double x, double y) const { return corner + x * right + y * up; }
  /// The pixel that lies in front of a point or behind it.
  Eigen::Vector2d pixelOf(const Vec3& point) const {
    const Vec3 from = point - corner;
    return {from.dot(right) / right.squaredNorm(), from.dot(up) / up.squaredNorm()};
  }
  /// The plane of the slice; its normal points to the reader.
  geometry::Plane plane() const { return {corner, right.cross(up).normalized()}; }
};

/// A picture of `width x height` pixels with `center` in its middle, `mmPerPixel` fine.
///
///     const SliceFrame frame = frameAround(sliceDirection("axial"), center, 0.5, 401, 301);
///     const Vec3 corner = frame.at(0, 0);
///     const Eigen::Vector2d pixel = frame.pixelOf(center); // 200, 150
SliceFrame frameAround(const SliceDirection& direction, const Vec3& center, double mmPerPixel, int width,
                       int height);

} // namespace viscera::medical_io
