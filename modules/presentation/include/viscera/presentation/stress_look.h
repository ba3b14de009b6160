#pragma once

#include <string>

#include "viscera/core/arrays.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/live/witness_sampling.h"
#include "viscera/scene/color_map.h"
#include "viscera/scene/tissue_actor.h"

namespace viscera::presentation {

/// The glyphs that show the principal stretches of tissue.
enum class GlyphChoice { none, ellipsoids, crosses };

/// How a stress map is shown: quantity, range, cut and glyphs.
struct StressLook {
  live::StressQuantity quantity = live::StressQuantity::rotationalStress;
  elasticity::StatedMaterial material; ///< Of quantities in pascals, which are shown of a stated one only.
  bool onSurface = true; ///< The map on the organ's own surface instead of on the outer tetrahedra.
  bool pinned = false;   ///< The legend's range stays as it is.
  /// Range of the legend, in the quantity's unit; empty (high <= low) before there was a map. Kept even when
  /// it is not pinned: the steps of the range depend on the range before.
  scene::ValueRange range = {0, 0};
  bool logarithmic = false; ///< The range is logarithmic; not for quantities that are 0 or 1 (folded tissue).
  std::string amountColors =
      "viridis"; ///< The colour map of angles and of what is folded (`scene::colorMaps`).
  std::string ratioColors = "diverging"; ///< That of ratios, which lie around 1.
  bool peak = false;                     ///< The maximum over one cycle instead of this instant.
  bool cut = false;
  scene::CutStyle style = scene::CutStyle::smooth;
  Vec3 normal = Vec3::UnitY(); ///< Unit normal of the cut, towards the part that stays.
  double offset = 0;           ///< Distance of the cut from the organ's middle along `normal`, in units of
                               ///< the organ's radius, -1 to 1.
  bool threshold = false;
  double limit = 0;   ///< In the quantity's unit.
  bool below = false; ///< Shows what is below the limit instead of what is above.
  GlyphChoice glyphs = GlyphChoice::none;
  bool handles = true;
  bool others = true; ///< The other organs stay in the picture, as glass around the map.
  int witnesses = live::WitnessOptions().wanted;
  bool sameRange = true; ///< Beside another view with a stress map: one range for both.
  int probe = -1;        ///< The point of the mesh whose values are shown; -1: none.

  live::StressMeasure measure() const { return {quantity, material}; }

  bool operator==(const StressLook&) const = default;
};

/// The part of a look that is saved in the user's settings: without range, limit, probe and maximum, without
/// glyphs, which replace the tissue, and without a material, which is stated for one organ, and its pascals.
StressLook habitOf(StressLook look);

/// The look as JSON text, for settings; invalid text gives the default look.
std::string toJson(const StressLook& look);
StressLook stressLookFromJson(const std::string& text);

} // namespace viscera::presentation
