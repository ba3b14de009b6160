#pragma once

#include "viscera/motion/patient_motion.h"

namespace viscera::motion {

/// Computes ejection fractions and the volume of tissue from the volumes of the phases.
void addVolumes(const MotionSeries& series, PatientMotion& motion);

} // namespace viscera::motion
