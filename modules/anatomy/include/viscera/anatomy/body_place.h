#pragma once

#include <optional>
#include <string_view>

#include "viscera/anatomy/part.h"
#include "viscera/core/arrays.h"

/// Where the organs of a body lie, for telling one direction of a body from another. Places are those of an
/// adult who lies straight, measured on the organs of public atlases and rounded; they are no model of a
/// body.
namespace viscera::anatomy {

/// The place of the middle of an organ's box.
struct BodyPlace {
  Part part;
  Vec3 center = Vec3::Zero(); ///< mm, LPS, from the middle of the first lumbar vertebra.
  /// The standard deviation of the place between persons and images, mm; infinite along an axis that the name
  /// says nothing of.
  Vec3 spread = Vec3::Zero();

  /// Whether the name itself says the side.
  bool sided() const { return part.side != Side::none && part.chamber == Chamber::none; }
};

/// The place that a name means: of `partNamed`, for vertebrae and ribs by their numbers ("vertebrae_L3", "Rib
/// 7"). None for what lies anywhere (vessels, skin), for lesions, and for pieces of organs, unless the name
/// says on which side of the body they lie ("lung_upper_lobe_left"). O(length); thread-safe.
std::optional<BodyPlace> bodyPlaceNamed(std::string_view name);

} // namespace viscera::anatomy
