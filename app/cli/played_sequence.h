#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/deformation/deformer.h"
#include "viscera/sequences/sequence.h"
#include "viscera/session/organ.h"

namespace viscera::app::cli {

/// One surface that a sequence moves.
struct PlayedSurface {
  std::string name; ///< "outer", "lv", "rv": its column in tables.
  session::Organ organ;
  std::shared_ptr<deformation::Deformer> deformer;
  bool wall = false; ///< The outer surface of an organ with cavities, drawn translucent.
};

/// A sequence with what it moves, bound and ready.
struct PlayedSequence {
  std::shared_ptr<const sequences::Sequence> sequence;
  std::vector<PlayedSurface> surfaces; ///< The outer surface first.
  std::vector<std::string> warnings;   ///< About the files that were read.

  /// The surface with that name, or null.
  const PlayedSurface* find(const std::string& name) const;
};

/// Makes a sequence by its name ("heartbeat") with the organ it is made for, or with `organ` (ORGAN of the
/// command line) when that is not empty; `handles` may name a handle file, which has to hold the sequence's
/// own handles. Throws `UsageError` that lists the sequences for another name, and what reading and binding
/// throw.
PlayedSequence playedSequence(const std::string& name, const std::string& organ, const std::string& handles,
                              Surroundings& surroundings);

} // namespace viscera::app::cli
