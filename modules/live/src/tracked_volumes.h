#pragma once

#include "viscera/live/patient_motion.h"

namespace viscera::live {

/// Computes ejection fractions and the volume of tissue from the volumes of the phases.
void addVolumes(const MotionSeries& series, PatientMotion& motion);

/// Takes the numbers of a right ventricle out of an estimate from one label: what its images show falls short
/// too far.
void dropUncertain(bool estimate, PatientMotion& motion);

} // namespace viscera::live
