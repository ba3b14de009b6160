#pragma once

#include "viscera/live/patient_motion.h"

namespace viscera::live {

/// Computes ejection fractions and the volume of tissue from the volumes of the phases.
void addVolumes(const MotionSeries& series, PatientMotion& motion);

} // namespace viscera::live
