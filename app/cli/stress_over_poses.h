#pragma once

#include <string>
#include <vector>

#include "cli/bound_input.h"
#include "cli/command.h"
#include "viscera/live/stress_frame.h"

namespace viscera::app::cli {

/// The options of `viscera stress` about more than one pose: the difference from another pose, and the course
/// over a sequence, with curves at the probes.
class StressOverPosesOptions {
public:
  void addTo(CLI::App& options);

  /// What these options write.
  static std::vector<OutputOption> outputs();

  /// Throws `UsageError` for a table without the poses that it is about.
  void check() const;

  /// A stress map in the pose of `--pose`, with what it was computed from.
  struct Mapped {
    const BoundInput& input;
    const WitnessedOrgan& interior;
    const Points& posed;
    const deformation::StressMap& map;
    const elasticity::StatedMaterial& material; ///< Of the pascals; unstated: there are none.
  };

  /// Computes what is asked for, writes it, and adds it to the outcome. `probes` are places at rest, mm, LPS.
  /// Throws what reading poses and sequences throws, and `Cancelled`.
  void compute(const Mapped& mapped, const std::vector<Vec3>& probes, CommandContext& context,
               Outcome& outcome) const;

private:
  void compare(const Mapped& mapped, CommandContext& context, Outcome& outcome) const;
  void follow(const Mapped& mapped, const std::vector<Vec3>& probes, CommandContext& context,
              Outcome& outcome) const;

  std::string before_;
  std::string difference_;
  std::string sequence_;
  std::string curve_;
  int instants_ = live::kCycleInstants;
};

} // namespace viscera::app::cli
