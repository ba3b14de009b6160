#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "cli/stage_options.h"
#include "viscera/core/phrase.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/live/session_motion.h"
#include "viscera/presentation/circulation_figure.h"
#include "viscera/presentation/heart_signs.h"
#include "viscera/sequences/sequence.h"

class vtkImageData;

namespace CLI {
class App;
}

/// The physiology of a beating heart below the pictures of a command (`--signs`), as in movies of the window.
namespace viscera::app::cli {

/// The beat that the signs tell of: one of the two, or none.
struct ToldBeat {
  std::optional<presentation::ShownCirculation> circulation;
  std::optional<heart::CardiacBeat> textbook;
};

/// The beat of a sequence at that rate: of the circulation that drives it, which is solved (some 20 ms), else
/// the textbook's; none for a sequence without a heart.
ToldBeat toldBeat(const sequences::Sequence& sequence, const std::optional<live::DrivingCirculation>& driving,
                  double ratePerMinute);

/// The option `--signs`.
class SignsOption {
public:
  void addTo(CLI::App& options);
  bool given() const { return !names_.empty(); }
  /// The user's words, for errors: "--signs ecg,sounds".
  std::string text() const;
  presentation::HeartSigns chosen() const;

private:
  std::vector<std::string> names_;
};

/// Draws signs below pictures. Qt's fonts are there as long as it lives: one at a time, on the main thread.
class SignsBelow {
public:
  /// Whole pictures have the size of `options`. Throws `UsageError` when the beat has none of the signs
  /// that are chosen, and when no room is left above them; `Error` without a font.
  SignsBelow(const SignsOption& option, ToldBeat beat, const StageOptions& options);
  ~SignsBelow();

  /// The options of the pictures above the signs.
  StageOptions above() const { return above_; }
  /// The picture with the signs at a fraction of the cycle in [0, 1] below it.
  vtkSmartPointer<vtkImageData> below(vtkImageData* picture, double fraction);
  /// What is drawn, by the words of the option.
  std::vector<std::string> drawn() const { return drawn_; }

private:
  struct Parts;
  StageOptions above_;
  std::vector<std::string> drawn_;
  std::unique_ptr<Parts> parts_;
};

} // namespace viscera::app::cli
