#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/document/rig_commands.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/sequence.h"

namespace viscera::live {

/// A sequence with its sample organ, handles and coordinates, ready to be played.
struct SequenceSetup {
  std::shared_ptr<const sequences::Sequence> sequence; ///< Never null.
  sample_organs::SampleOrgan organ;                    ///< On whose surfaces it was calibrated.
  document::Rig rig;             ///< The sequence's rest handles, in its order, with labels and groups.
  document::SystemChoice system; ///< The coordinates and parameters with which it was calibrated.
};

/// Id, name and sample organ of a sequence that the program ships.
struct SampleSequence {
  std::string id;    ///< As on the command line: "heartbeat".
  std::string name;  ///< As in the window: "Heartbeat".
  std::string organ; ///< The sample organ that it moves: "heart".
};

/// All shipped sequences, in the order in which a list shows them.
const std::vector<SampleSequence>& sampleSequences();

/// Whether an organ is of the kind that a sequence moves.
enum class SequenceMatch { yes, unknown, no };

/// Judges by its name whether an organ suits a sequence: yes for "liver_2" and breathing, no for "spleen" and
/// a heartbeat, unknown for "mesh 1".
SequenceMatch matchesOrgan(const SampleSequence& sequence, const std::string& organName);

/// Makes the sample organ of a sequence, its handles and the sequence itself, calibrated on that organ at
/// that resolution: at any time and rate the volume of the heart's left ventricle follows its curve within
/// 0.5 ml, the right one within 1 ml. Slow results are stored in the library's cache. Throws `UsageError` for
/// an unknown sequence (it lists the existing ones), what `sample_organs::sampleOrgan` throws, `Cancelled`.
/// For any thread.
SequenceSetup setUpSequence(const sample_organs::SampleLibrary& library, const std::string& id,
                            sample_organs::Resolution resolution, Progress& progress, Threads threads = {});

} // namespace viscera::live
