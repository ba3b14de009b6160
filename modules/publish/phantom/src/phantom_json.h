#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "fibre_strain.h"
#include "viscera/phantom/plane_layout.h"
#include "viscera/phantom/write_phantom.h"

namespace viscera::phantom {

/// Options, period and tissues: what is true of all phases.
nlohmann::ordered_json headOf(const PhantomOptions& options, const PhantomMotion& motion);

/// One plane of a cine study, with the shift of its breath-hold.
nlohmann::ordered_json jsonOf(const StudyPlane& plane);

/// Time, volumes, landmarks and strain of a phase, at which the motion is.
nlohmann::ordered_json jsonOf(const PhantomPhase& phase, const PhantomBody& body, const PhantomMotion& motion,
                              const WallPoints& wall);

} // namespace viscera::phantom
