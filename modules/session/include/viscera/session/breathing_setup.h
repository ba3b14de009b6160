#pragma once

#include "viscera/session/sequence_setup.h"

namespace viscera::session {

/// The sample liver in quiet breathing (`sequences::LiverBreathing`) with handles spread over its surface. As
/// `setUpSequence`.
SequenceSetup breathingSetup(const organs::SampleLibrary& library, organs::Resolution resolution,
                             Progress& progress, Threads threads = {});

} // namespace viscera::session
