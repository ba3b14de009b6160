#pragma once

#include "viscera/core/arrays.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/live/witness_sampling.h"
#include "viscera/scene/tissue_actor.h"
#include "window/settings.h"

namespace viscera::app {

/// Glyphs of the principal stretches.
enum class GlyphChoice { none, ellipsoids, crosses };

/// How a stress map is looked at: kept in the settings, not in the document.
struct StressLook {
  live::StressQuantity quantity = live::StressQuantity::rotationalStress;
  bool onSurface = true; ///< The map on the organ's own surface instead of on the outer tetrahedra.
  bool pinned = false;   ///< The legend's range stays as it is.
  bool cut = true;
  scene::CutStyle style = scene::CutStyle::smooth;
  Vec3 normal = Vec3::UnitY(); ///< Of the cut, towards what stays.
  double offset = 0;           ///< Of the cut from the organ's middle along `normal`, in its radius, -1 to 1.
  bool threshold = false;
  double limit = 0;   ///< In the quantity's unit.
  bool below = false; ///< Shows what is below the limit instead of what is above.
  GlyphChoice glyphs = GlyphChoice::none;
  bool handles = true;
  bool others = false; ///< The other organs stay in the picture.
  int witnesses = live::WitnessOptions().wanted;

  bool operator==(const StressLook&) const = default;
};

/// What was kept last; what is missing or out of range is as at first.
StressLook loadStressLook(const Settings& settings);
void saveStressLook(const StressLook& look, Settings& settings);

} // namespace viscera::app
