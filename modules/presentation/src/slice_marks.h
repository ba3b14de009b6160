#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "viscera/document/measured_values.h"
#include "viscera/presentation/slice_presenter.h"

namespace viscera::presentation {

/// What a mouse can take hold of on a slice.
struct SliceGrips {
  /// A handle (`item`: its row), or a point of a measurement (`item`: its place among them).
  struct Grip {
    std::size_t item = 0;
    std::size_t point = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  };
  std::vector<Grip> handles;
  std::vector<Grip> measured; ///< Points that are on no organ: those stay on its surface.
};

/// The language of the texts on a slice: its words, and what it writes before decimals.
struct SliceLanguage {
  std::function<std::string(const char*)> translate;
  char decimalMark = '.';
};

/// Adds to a slice's picture what lies over grey levels and contours: the handles near its plane, as the
/// scene shows them, and what is measured in it. Regions whose values `memory` does not have are read.
SliceGrips addMarks(const SliceScene& scene, const slices::SliceDirection& direction,
                    const slices::SliceFrame& frame, document::RegionMemory& memory,
                    const SliceLanguage& language, scene::SlicePicture& picture);

/// The one of them that is nearest to a pixel and not farther away than `reach` pixels, or null.
const SliceGrips::Grip* nearestGrip(const std::vector<SliceGrips::Grip>& grips, const Eigen::Vector2d& pixel,
                                    double reach);

} // namespace viscera::presentation
