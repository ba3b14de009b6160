#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/live/stress_mark_files.h"
#include "viscera/live/stress_reading.h"

namespace viscera::app::cli {

/// `--probe` and `--profile` of `viscera stress` and their tables, with the same numbers as the window's
/// pinned probes and profiles.
class StressMarkOptions {
public:
  void addTo(CLI::App& options);

  /// Throws `UsageError` for texts that are no points or lines, and for a table without probes or profiles.
  void check() const;

  /// The places of the probes at rest, mm, LPS.
  std::vector<Vec3> probePlaces() const;

  /// Interpolates the values in a map at the points of `mesh` and writes the tables; adds to the outcome's
  /// JSON, text and warnings.
  void read(const std::shared_ptr<const deformation::WitnessMesh>& mesh, const Points& posed,
            const deformation::StressMap& map, const elasticity::StatedMaterial& material,
            Outcome& outcome) const;

private:
  struct Line {
    Vec3 from, to;
    int count = live::kProfilePoints;
  };
  static Line lineOf(const std::string& text);
  void readProbes(const std::shared_ptr<const deformation::WitnessMesh>& mesh, const Points& posed,
                  const deformation::StressMap& map, const elasticity::StatedMaterial& material,
                  Outcome& outcome) const;
  void readProfiles(const std::shared_ptr<const deformation::WitnessMesh>& mesh, const Points& posed,
                    const deformation::StressMap& map, const elasticity::StatedMaterial& material,
                    Outcome& outcome) const;

  std::vector<std::string> probes_;
  std::vector<std::string> profiles_;
  std::string probesFile_;
  std::string profilesFile_;
};

} // namespace viscera::app::cli
