#pragma once

#include "viscera/motion/sequence_setup.h"

namespace viscera::motion {

/// The sample stomach with its peristalsis (`sequences::Peristalsis`), whose volume stays that of the surface
/// of that resolution at rest, to rounding, in every pose. As `setUpSequence`.
SequenceSetup peristalsisSetup(const sample_organs::SampleLibrary& library,
                               sample_organs::Resolution resolution, Progress& progress,
                               Threads threads = {});

} // namespace viscera::motion
