#pragma once

#include <memory>
#include <optional>
#include <string>

#include "viscera/core/progress.h"
#include "viscera/document/organ.h"
#include "viscera/live/retarget.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/sequence.h"

/// Recipes of motions: JSON texts from which a session makes a motion again.
namespace viscera::live {

/// The recipe of a shipped sequence on its sample organ.
std::string sampleRecipe(const std::string& sequence, sample_organs::Resolution resolution);
/// The recipe of a shipped sequence fitted to another organ, with the landmarks that the user gave.
std::string fittedRecipe(const std::string& sequence, const Landmarks& given);

/// The shipped sequence that a recipe makes, "heartbeat"; empty for a text that is no recipe.
std::string sequenceOf(const std::string& recipe);

/// The resolution of the sample heart in a recipe of its beat; empty for any other recipe.
std::optional<sample_organs::Resolution> sampleHeartOf(const std::string& recipe);

/// Makes the motion of a recipe; a fitted one for `organ`. Throws `DataError` for an invalid recipe, and what
/// `setUpSequence` and `retargetSequence` throw. For any thread.
std::shared_ptr<const sequences::Sequence> makeMotion(const std::string& recipe, const document::Organ& organ,
                                                      const sample_organs::SampleLibrary& library,
                                                      Progress& progress);

} // namespace viscera::live
