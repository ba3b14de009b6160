#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/scan.h"

/// Reads the scan that a command names in its arguments, and describes it.
namespace viscera::app::cli {

/// Defines the argument SCAN with the options for its series and phase, and reads them.
class ScanInputOptions {
public:
  void addTo(CLI::App& options);
  /// `--series` and `--phase` alone, for commands that take other files as well.
  void addChoiceTo(CLI::App& options);

  /// Throws as `medical_io::readScan`.
  medical_io::Scan read(const std::string& file, Progress& progress) const;
  medical_io::Scan read(Progress& progress) const { return read(file_, progress); }
  const std::string& file() const { return file_; }
  /// The series and the phase that were asked for.
  const medical_io::ScanOptions& chosen() const { return chosen_; }
  /// None when no phase was asked for.
  std::optional<int> chosenPhase() const { return phase_; }

private:
  std::string file_;
  medical_io::ScanOptions chosen_;
  std::optional<int> phase_;
};

/// Adds a warning for each finding of a scan, without the harmless ones such as the order of files.
void appendFindings(std::vector<Text>& warnings, const medical_io::Scan& scan);

/// Describes the contents of a scan and lists the other series in its folder.
Outcome describeScan(const medical_io::Scan& scan, const std::string& file,
                     const medical_io::ScanOptions& chosen, CommandContext& context);

} // namespace viscera::app::cli
