#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/document/organ_commands.h"
#include "viscera/live/motion_recipe.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/sequence.h"

namespace viscera::workbench {

/// Opacity of the wall of an organ with cavities, so that the cavities can be seen through it.
inline constexpr double kWallOpacity = 0.3;

/// A sample organ on its way into a document, with its handles and its motion.
struct LoadedSample {
  std::vector<document::NewOrgan> organs;            ///< The outer surface first, cavities in it.
  std::shared_ptr<const sequences::Sequence> motion; ///< Null for a sample without one.
  live::MotionRecipe recipe;                         ///< Makes the motion again.
  document::Rig rig;                                 ///< The motion's handles; none without one.
  document::SystemChoice system;
};

/// Makes a sample organ and the first shipped motion of it: seconds the first time. Walls are seen through,
/// and blood has its textbook colours. Throws as `live::setUpSequence`. For any thread.
LoadedSample loadSample(const sample_organs::SampleLibrary& library, const std::string& name,
                        sample_organs::Resolution resolution, Progress& progress, Threads threads = {});

} // namespace viscera::workbench
