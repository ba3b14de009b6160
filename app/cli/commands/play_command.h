#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/listing.h"
#include "cli/played_sequence.h"
#include "cli/stage_options.h"
#include "viscera/motion/motion_runner.h"
#include "viscera/motion/volume_record.h"

namespace viscera::app::cli {

/// `viscera play`: plays a sequence, measures it, and records it.
class PlayCommand final : public Command {
public:
  std::string name() const override { return "play"; }
  std::string summary() const override { return "Play a sequence, measure it and record it"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  /// What playing has shown.
  struct Measured {
    motion::VolumeRecord volumes;
    std::vector<double> wallMl;  ///< Of the sample heart: chambers from outside less both cavities.
    motion::VolumeRecord atKeys; ///< Of a recorded sequence: at its keys, which frames may miss.
  };

  /// The rate to play at. Throws `UsageError` outside what the sequence allows.
  double rateOf(const sequences::Sequence& sequence) const;
  /// Writes the handles and landmarks that are asked for.
  void writeRig(const PlayedSequence& played) const;
  motion::MotionRunner runnerOf(PlayedSequence& played, double rate, Threads threads) const;
  /// Plays every frame, and records those that are asked for.
  Measured play(PlayedSequence& played, double rate, int frames, Surroundings& surroundings) const;
  /// Adds the ejection fraction and what belongs to it, as far as the surfaces are closed.
  void addIndices(const PlayedSequence& played, const Measured& measured, double rate, Outcome& outcome,
                  Listing& listing) const;
  Outcome report(const PlayedSequence& played, const Measured& measured, double rate) const;

  PlayRequest request_;
  std::string handlesOut_;
  std::string landmarksOut_;
  std::string volumeCurve_;
  double rate_ = 0; ///< 0: the sequence's own.
  int cycles_ = 1;
  double framesPerSecond_ = 25;
  std::string frames_;
  std::string movie_;
  std::string csv_;
  std::string sheet_;
  int columns_ = 6;
  std::string size_ = "1280x800";
  StageOptions stage_;
};

} // namespace viscera::app::cli
