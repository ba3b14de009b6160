#include "viscera/live/motion_recipe.h"

#include "viscera/core/error.h"
#include "viscera/live/sequence_setup.h"

namespace viscera::live {

std::string sequenceOf(const MotionRecipe& recipe) {
  if (const auto* sample = std::get_if<SampleMotion>(&recipe))
    return sample->sequence;
  const auto* fitted = std::get_if<FittedMotion>(&recipe);
  return fitted ? fitted->sequence : std::string();
}

std::optional<sample_organs::Resolution> sampleHeartOf(const MotionRecipe& recipe) {
  const auto* sample = std::get_if<SampleMotion>(&recipe);
  return sample && sample->sequence == "heartbeat" ? std::optional(sample->resolution) : std::nullopt;
}

std::shared_ptr<const sequences::Sequence> makeMotion(const MotionRecipe& recipe,
                                                      const document::Organ& organ,
                                                      const sample_organs::SampleLibrary& library,
                                                      Progress& progress) {
  if (const auto* sample = std::get_if<SampleMotion>(&recipe))
    return setUpSequence(library, sample->sequence, sample->resolution, progress).sequence;
  if (const auto* fitted = std::get_if<FittedMotion>(&recipe))
    return retargetSequence(fitted->sequence, organ, fitted->given, progress).sequence;
  throw DataError("the motion of an organ cannot be made again: nothing is known of how it was made",
                  named(organ.name), "choose it again in Play mode");
}

} // namespace viscera::live
