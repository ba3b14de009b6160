#pragma once

#include <memory>
#include <string>

#include "viscera/core/progress.h"
#include "viscera/organs/sample_organ.h"
#include "viscera/sequences/sequence.h"
#include "viscera/session/organ.h"
#include "viscera/session/retarget.h"

/// How a motion was made, as JSON, so that a session can make it again.
namespace viscera::app {

/// A sequence that the program ships, on its sample organ.
std::string sampleRecipe(const std::string& sequence, organs::Resolution resolution);
/// The same on another organ, with the landmarks that somebody gave.
std::string fittedRecipe(const std::string& sequence, const session::Landmarks& given);

/// Makes the motion of a recipe; a fitted one for `organ`. Throws `DataError` for a recipe that is none, and
/// what `session::setUpSequence` and `session::retargetSequence` throw. For any thread.
std::shared_ptr<const sequences::Sequence> makeMotion(const std::string& recipe, const session::Organ& organ,
                                                      const organs::SampleLibrary& library,
                                                      Progress& progress);

} // namespace viscera::app
