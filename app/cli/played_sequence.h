#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/deformation/deformer.h"
#include "viscera/document/organ.h"
#include "viscera/motion/retarget.h"
#include "viscera/sequences/sequence.h"

namespace viscera::app::cli {

/// What of a sequence is asked for on the command line.
struct PlayRequest {
  std::string sequence;              ///< "heartbeat", or a `.sequence.json` file.
  std::string organ;                 ///< ORGAN; empty: the one that the sequence is made for.
  std::string handles;               ///< A handle file that has to hold the sequence's handles; or empty.
  std::string landmarks;             ///< A handle file with landmarks of the organ; or empty.
  std::vector<std::string> landmark; ///< "apex=1,2,3"; these go before those of the file.
};

/// One surface that a sequence moves.
struct PlayedSurface {
  std::string name; ///< "outer", "lv", "rv": its column in tables.
  document::Organ organ;
  std::shared_ptr<deformation::Deformer> deformer;
  bool wall = false; ///< The outer surface of an organ with cavities, drawn translucent.
};

/// A sequence with what it moves, bound and ready.
struct PlayedSequence {
  std::shared_ptr<const sequences::Sequence> sequence;
  document::NewRig rig;                ///< The handles with their labels and groups.
  std::vector<PlayedSurface> surfaces; ///< The outer surface first.
  std::vector<std::string> warnings;   ///< About the files that were read.
  /// Of the sample heart: its chambers from outside, without vessels. Only measured.
  std::shared_ptr<deformation::Deformer> chambers;
  /// What was computed when the organ is not the sequence's own.
  std::optional<motion::RetargetedSequence> retargeted;

  /// The surface with that name, or null.
  const PlayedSurface* find(const std::string& name) const;
};

/// Makes a sequence with the organ it is made for, or fits it to the organ that is asked for: by landmarks
/// that are given or computed. A sequence file moves any organ that lies within its handles. Throws
/// `UsageError` that lists the sequences for an unknown name, and for a file without `--organ`; what reading,
/// fitting and binding throw.
PlayedSequence playedSequence(const PlayRequest& request, Surroundings& surroundings);

} // namespace viscera::app::cli
