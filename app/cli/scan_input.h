#pragma once

#include <string>

#include "cli/command.h"
#include "viscera/medical_io/scan.h"

/// What commands take as SCAN, and say of one.
namespace viscera::app::cli {

/// SCAN and which of its series and phases.
class ScanInputOptions {
public:
  void addTo(CLI::App& options);
  /// `--series` and `--phase` alone, for commands that take other files as well.
  void addChoiceTo(CLI::App& options);

  /// Throws as `medical_io::readScan`.
  medical_io::Scan read(const std::string& file, Progress& progress) const;
  medical_io::Scan read(Progress& progress) const { return read(file_, progress); }
  const std::string& file() const { return file_; }

private:
  std::string file_;
  medical_io::ScanOptions chosen_;
};

/// Adds the sentences of a scan's findings, but for those that are no reason for care (the order of files).
void appendFindings(std::vector<std::string>& warnings, const medical_io::Scan& scan);

/// What is in a scan, and which other series lie beside it.
Outcome describeScan(const std::string& file, const ScanInputOptions& options, CommandContext& context);

} // namespace viscera::app::cli
