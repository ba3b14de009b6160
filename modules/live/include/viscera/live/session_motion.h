#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "viscera/circulation/parameters.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/document.h"
#include "viscera/live/motion_recipe.h"
#include "viscera/live/motion_runner.h"

namespace viscera {
class JsonReader;
}

/// The motions of a session: which it offers, and which it plays. They stand in its view as JSON
/// (docs/session_format.md, "view"), and are read here without the rest of the view.
namespace viscera::live {

/// A sequence that can be played.
struct MotionChoice {
  document::OrganId organ;
  MotionRecipe recipe; ///< Makes it again.

  bool operator==(const MotionChoice&) const = default;
};

/// The volume that an organ is to have while the sequence moves it.
struct Prescribed {
  document::OrganId organ;
  std::string file; ///< The name of the file that it came from, for texts; UTF-8.
  /// Fraction of the cycle and volume, ml. As read from the file; they are checked when they are played.
  std::vector<std::array<double, 2>> curve;

  bool operator==(const Prescribed&) const = default;
};

/// The playing sequence, its rate and its present instant.
struct Playing {
  int motion = -1;     ///< Index in the motions; -1: the sequence that the document holds.
  double fraction = 0; ///< Of the cycle, 0 to 1.
  double ratePerMinute = 0;
  double speed = 1;
  bool loop = true;
  bool shown = false; ///< The organs are in the sequence's pose.
  std::optional<Prescribed> prescribed = std::nullopt;

  bool operator==(const Playing&) const = default;
};

/// The motions that a session offers, and the one that it plays.
struct SessionMotion {
  std::vector<MotionChoice> motions;
  std::optional<Playing> playing; ///< None: none was chosen.

  bool operator==(const SessionMotion&) const = default;

  /// The motion that is played, or else the first that is offered; null for the one that the document holds.
  const MotionChoice* chosen() const;
};

/// A circulation that moves a heart.
struct DrivingCirculation {
  Text name; ///< "Aortic stenosis"
  circulation::Parameters parameters;
};

/// Reads the motions of a session's view, of all its formats. `circulation` is the session's: a heartbeat of
/// formats 1 and 2 began at another instant, and its fractions are read as those of today's beat. Throws
/// `DataError` for motions that are damaged.
SessionMotion sessionMotion(const nlohmann::ordered_json& view,
                            const document::CirculationChoice& circulation = {});

/// A view that says only this, for a session that no window has shown.
nlohmann::ordered_json viewOf(const SessionMotion& motion);

/// One motion and what is played, as the view writes and reads them. The readers throw `JsonError`, which
/// names the place; a recipe that is damaged, or that only a newer version knows, is none.
nlohmann::ordered_json toJson(const MotionChoice& motion);
nlohmann::ordered_json toJson(const Playing& playing);
MotionChoice motionChoice(const JsonReader& json, const nlohmann::ordered_json& item,
                          const std::string& place);
Playing playing(const JsonReader& json, const nlohmann::ordered_json& item, const std::string& place);

/// The part of the cycle by which the motion that is played begins earlier than it did in formats 1 and 2:
/// there the textbook's beat began with the contraction of the atria and that of a circulation with the
/// contraction of the ventricles; now both begin `heart::kBeforeAtria` before the atria contract. 0 for a
/// motion that is no heartbeat.
double beginsEarlierBy(const SessionMotion& motion, const document::CirculationChoice& circulation);
/// A fraction of the former cycle as one of the cycle that begins earlier; what is not finite stays.
double fractionLater(double fraction, double earlier);
/// Moves the instant and the prescribed volume by that part.
void beginEarlier(Playing& playing, double earlier);

/// Makes the sequence that a session plays, else the first that it offers, else the one that it has recorded;
/// null for none. Throws what `makeMotion` and `circulatingHeart` throw.
std::shared_ptr<const sequences::Sequence> makeSequence(const document::DocumentState& state,
                                                        const SessionMotion& motion,
                                                        const sample_organs::SampleLibrary& library,
                                                        Progress& progress, Threads threads = {});

/// The circulation with which the sample heart of a session's motion beats; empty: with none.
std::optional<DrivingCirculation> drivingCirculation(const document::DocumentState& state,
                                                     const SessionMotion& motion);

/// The volume that the session prescribes while its sequence moves the organs; none where it does not, and
/// where the organ is missing. Throws `DataError` for one that is no curve of volumes.
std::optional<PrescribedVolume> prescribedVolume(const document::DocumentState& state,
                                                 const SessionMotion& motion);

/// The rate that the session plays a sequence at, cycles a minute, within what the sequence allows; its
/// standard rate where the session says none.
double rateOf(const SessionMotion& motion, const sequences::Sequence& sequence);

/// The warning that `sequence`, which the session's motion makes, is not made for the organ that it moves
/// (`unsuitedTo`), to be shown before any number of it. Empty for an organ that suits it, for a name that
/// says no organ, and for the document's own sequence. O(1); thread-safe.
Text unsuitedMotion(const document::DocumentState& state, const SessionMotion& motion,
                    const sequences::Sequence& sequence);

} // namespace viscera::live
