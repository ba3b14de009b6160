#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/heart_signs.h"
#include "viscera/core/phrase.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/retarget.h"
#include "viscera/sequences/sequence.h"
#include "viscera/workbench/workbench.h"

namespace viscera::app::cli {

/// The sequence, organ, rate and further options of a command that plays a sequence.
struct PlayRequest {
  std::string sequence;              ///< "heartbeat", a `.sequence.json` file, or a session.
  std::string organ;                 ///< ORGAN; empty: the one that the sequence is made for.
  std::string handles;               ///< A handle file that has to hold the sequence's handles; or empty.
  std::string landmarks;             ///< A handle file with landmarks of the organ; or empty.
  std::vector<std::string> landmark; ///< "apex=1,2,3"; these go before those of the file.
  std::string scenario;        ///< Of the circulation that the heart follows; empty: the textbook's beat.
  double ratePerMinute = 0;    ///< Of that circulation; 0: the scenario's own.
  double ejectionFraction = 0; ///< Of a heart with its chambers; 0: the textbook's.
};

/// A surface that a sequence moves, with its name.
struct PlayedSurface {
  std::string name; ///< "outer", "lv", "rv": its column in tables.
  document::OrganId organ;
};

/// A sequence with the organs that it moves, already bound to their handles.
struct PlayedSequence {
  std::shared_ptr<const sequences::Sequence> sequence;
  document::Rig rig; ///< The handles with their labels and groups; none of a session.
  /// The surfaces as organs with their looks, the rig, the system, and the motion.
  std::unique_ptr<workbench::Workbench> bench;
  std::vector<PlayedSurface> surfaces; ///< The first organs of the document, the outer surface first.
  std::vector<Text> warnings;          ///< About the files that were read.
  /// Whether two further organs of the sample heart come last, hidden, only to be measured: its chambers
  /// from outside, without vessels, and the left ventricle from outside.
  bool hasWalls = false;
  /// Whether a session is played: with its locks, at its rate, and where a volume cannot be kept the organs
  /// stay as they were, as in the window.
  bool ofSession = false;
  double ratePerMinute = 0;                         ///< Rate of the session; 0: the sequence's standard rate.
  std::optional<live::PrescribedVolume> prescribed; ///< The volume that the session prescribes.
  std::optional<live::DrivingCirculation>
      driving; ///< The circulation that moves the heart; empty: none does.
  /// What was computed when the organ is not the sequence's own.
  std::optional<live::RetargetedSequence> retargeted;

  /// The place of the surface with that name, or -1.
  int find(const std::string& name) const;
  /// Volume of a surface at rest, ml.
  double restMl(std::size_t place) const {
    return (*bench->state().organs)[place]->restVolumeMm3 / kMm3PerMl;
  }
};

/// Makes a sequence with the organ it is made for, or fits it to the organ that is asked for: by landmarks
/// that are given or computed. A heart with its chambers (of a label map or a session) beats with them, by
/// handles in them and around it. A sequence file moves any organ that lies within its handles. A session
/// moves its organs by its handles, coordinates, locks and circulation, as the window does. Throws
/// `UsageError` that lists the sequences for an unknown name, for a file that holds no organ, without
/// `--organ`, for a session without a motion, and for options that a session sets itself; also what reading,
/// fitting and binding throw.
PlayedSequence playedSequence(const PlayRequest& request, CommandContext& context);

} // namespace viscera::app::cli
