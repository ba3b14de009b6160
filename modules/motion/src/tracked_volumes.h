#pragma once

#include "viscera/motion/patient_motion.h"

namespace viscera::motion {

/// Fills in ejection fractions, and what is left for the tissue, from the volumes of the phases.
void addVolumes(const MotionSeries& series, PatientMotion& motion);

} // namespace viscera::motion
