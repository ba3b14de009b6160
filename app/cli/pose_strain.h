#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/inputs.h"
#include "cli/still_organs.h"
#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/progress.h"
#include "viscera/presentation/presenter.h"

namespace viscera::app::cli {

/// The directions that `--strain` takes: longitudinal, circumferential, radial, thickening.
std::vector<std::string> strainDirectionNames();

/// The strain of a heart's wall in one pose.
struct PoseStrain {
  presentation::SurfaceMap map; ///< The 17 segments in the colours of the bull's eye.
  nlohmann::ordered_json json; ///< `direction`; `segments[]`: `number`, `percent` (null where it is unknown).
  std::vector<Text> warnings;
};

/// Measures the wall of the left ventricle among `organs` in `pose` against rest, in one of
/// `strainDirectionNames`. Throws `DataError` without a left ventricle, what `live::StrainGauge` throws, and
/// `Cancelled`. Seconds.
PoseStrain strainOfPose(const StillOrgans& organs, const document::Rig& rig, const Points& pose,
                        const std::shared_ptr<const coordinates::CoordinateSystem>& system,
                        const coordinates::BindOptions& options, const std::string& direction,
                        Progress& progress);

} // namespace viscera::app::cli
