#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "viscera/document/measured_values.h"
#include "viscera/presentation/slice_presenter.h"

namespace viscera::presentation {

/// The handles and measurement points on a slice that the mouse can drag.
struct SliceGrips {
  /// A handle (`item`: its row), or a point of a measurement (`item`: its place among them).
  struct Grip {
    std::size_t item = 0;
    std::size_t point = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  };
  std::vector<Grip> handles;
  std::vector<Grip> measured; ///< Points that lie on no organ; points on an organ stay on its surface and
                              ///< cannot be dragged here.
};

/// The language of the texts on a slice: its translator and its decimal mark.
struct SliceLanguage {
  std::function<std::string(const char*)> translate;
  char decimalMark = '.';
};

/// The plane of a slice.
struct MarkedPlane {
  Vec3 normal = Vec3::UnitZ(); ///< Unit vector.
  int axis = -1;               ///< Of the patient (x, y, z as 0, 1, 2) along the normal; -1: none is.
  double stepMm = 1;           ///< To the next slice.
};

/// Adds to a slice's picture the marks over grey levels and contours: the handles near its plane, if the
/// scene shows them, and the measurements in it. Computes the values of regions that `memory` does not hold.
SliceGrips addMarks(const SliceScene& scene, const MarkedPlane& plane, const medical_io::SliceFrame& frame,
                    document::MeasuringMemory& memory, const SliceLanguage& language,
                    scene::SlicePicture& picture);

/// The grip nearest to a pixel within `reach` pixels, or null.
const SliceGrips::Grip* nearestGrip(const std::vector<SliceGrips::Grip>& grips, const Eigen::Vector2d& pixel,
                                    double reach);

} // namespace viscera::presentation
