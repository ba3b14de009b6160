#pragma once

#include "viscera/motion/sequence_setup.h"

namespace viscera::motion {

/// The sample liver in quiet breathing (`sequences::LiverBreathing`) with handles spread over its surface. As
/// `setUpSequence`.
SequenceSetup breathingSetup(const sample_organs::SampleLibrary& library,
                             sample_organs::Resolution resolution, Progress& progress, Threads threads = {});

} // namespace viscera::motion
