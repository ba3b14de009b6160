#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "viscera/core/progress.h"
#include "viscera/document/organ.h"
#include "viscera/live/retarget.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/sequence.h"

/// Recipes of motions, from which a session makes a motion again.
namespace viscera::live {

/// A shipped sequence on its sample organ.
struct SampleMotion {
  std::string sequence; ///< "heartbeat"
  sample_organs::Resolution resolution = sample_organs::Resolution::medium;

  bool operator==(const SampleMotion&) const = default;
};

/// A shipped sequence fitted to another organ.
struct FittedMotion {
  std::string sequence;
  Landmarks given; ///< By the user; the others are found.

  bool operator==(const FittedMotion&) const = default;
};

/// How a motion is made again; `std::monostate`: nothing is known of that.
using MotionRecipe = std::variant<std::monostate, SampleMotion, FittedMotion>;

/// The shipped sequence that a recipe makes, "heartbeat"; empty where nothing is known.
std::string sequenceOf(const MotionRecipe& recipe);

/// The resolution of the sample heart in a recipe of its beat; empty for any other recipe.
std::optional<sample_organs::Resolution> sampleHeartOf(const MotionRecipe& recipe);

/// Makes the motion of a recipe; a fitted one for `organ`. Throws `DataError` where nothing is known, and
/// what `setUpSequence` and `retargetSequence` throw. For any thread.
std::shared_ptr<const sequences::Sequence> makeMotion(const MotionRecipe& recipe,
                                                      const document::Organ& organ,
                                                      const sample_organs::SampleLibrary& library,
                                                      Progress& progress);

} // namespace viscera::live
