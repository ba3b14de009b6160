#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/motion/patient_motion.h"

namespace viscera::app::cli {

/// `viscera track PHASES... -o M.sequence.json`: a patient's own motion out of a series.
class TrackCommand final : public Command {
public:
  std::string name() const override { return "track"; }
  std::string summary() const override { return "Find a patient's own motion in a series of phases"; }
  void addOptions(CLI::App& options) override;
  Outcome run(Surroundings& surroundings) override;

private:
  /// What is asked for, checked. Throws `UsageError`.
  motion::SeriesRequest request() const;
  motion::TrackOptions trackOptions(std::vector<std::string>& warnings) const;
  /// Writes the sequence and what else is asked for: all of it, or nothing.
  void write(const motion::PatientMotion& found) const;
  Outcome report(const motion::PatientMotion& found) const;

  std::vector<std::string> phases_;
  std::string output_;
  std::string handlesOut_;
  std::string organsOut_;
  std::string rig_;
  std::vector<std::string> surfaces_;
  int handles_ = 0;
  double periodMs_ = 0;
  double rate_ = 0;
  std::vector<double> timesMs_;
  std::vector<std::size_t> leftOut_;
  bool once_ = false;
  bool freeVolumes_ = false;
  double smoothing_ = -1;
  double robustMm_ = 0;
};

} // namespace viscera::app::cli
