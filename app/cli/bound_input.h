#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/inputs.h"
#include "cli/system_options.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/live/witness_sampling.h"

namespace viscera::app::cli {

/// The organ, handles, pose and coordinate system that a command was given.
struct BoundInput {
  std::shared_ptr<const coordinates::CoordinateSystem> system;
  coordinates::BindOptions options;
  document::Rig rig;
  coordinates::HandleSet handles; ///< Those of the rig.
  Points pose;                    ///< Of the handles, `n x 3` mm.
  document::Organ organ;
};

/// Defines the arguments ORGAN, `--handles`, `--pose` and those of the coordinate system, and reads them.
class BoundInputOptions {
public:
  /// Adds them; `--pose` only when the command is about one.
  void addTo(CLI::App& options, bool posed);

  /// Reads what is named; without a pose the handles are at rest. Adds to `warnings` what was odd about the
  /// handles. Throws what `SystemOptions` and the readers of inputs throw.
  BoundInput read(const CommandContext& context, std::vector<Text>& warnings) const;

  /// ORGAN as it was given, for messages.
  const std::string& organ() const { return organ_; }

private:
  std::string organ_;
  std::string handles_;
  std::string pose_;
  SystemOptions system_;
};

/// The witness points inside an organ with their coordinates, from which the stress of any pose is computed.
struct WitnessedOrgan {
  live::WitnessSample sample;
  bool ownCells = false; ///< Whether the points are corners of the organ's own cells.
  std::shared_ptr<const deformation::WitnessGradients> gradients; ///< At all points of the sample's mesh.

  const deformation::WitnessMesh& mesh() const { return *sample.mesh; }
};

/// Fills the organ with witness points and binds them to the handles. Adds to `warnings` how the points came
/// about and which points of the skin have no coordinates. Throws what sampling and binding throw, and
/// `DataError` when witness points have no coordinates: they would pass for points without stress.
///
/// `cavities` are closed surfaces in the organ: what they hold is no tissue. `cells` are the organ's own,
/// whose corners are then the witness points.
WitnessedOrgan interiorOf(const BoundInput& input, const live::WitnessOptions& witnesses,
                          std::vector<Text>& warnings, Progress& progress,
                          const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities = {},
                          std::shared_ptr<const deformation::WitnessMesh> cells = nullptr);

} // namespace viscera::app::cli
