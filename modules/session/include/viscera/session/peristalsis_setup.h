#pragma once

#include "viscera/session/sequence_setup.h"

namespace viscera::session {

/// The sample stomach with its peristalsis (`sequences::Peristalsis`), whose volume stays that of the surface
/// of that resolution at rest, to rounding, in every pose. As `setUpSequence`.
SequenceSetup peristalsisSetup(const organs::SampleLibrary& library, organs::Resolution resolution,
                               Progress& progress, Threads threads = {});

} // namespace viscera::session
