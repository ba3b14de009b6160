#pragma once

#include "viscera/sequences/heart_rig.h"

namespace viscera::sequences {

/// The surfaces of the sample heart that its handles need, each negative inside.
struct SampleHeartSurfaces {
  AnatomySurface ventricles;
  AnatomySurface rightCavity;
  AnatomySurface rightAtrium;
  AnatomySurface leftAtrium;
  AnatomySurface
      greatVessels; ///< Aorta, pulmonary trunk, caval and pulmonary veins: the least of their values.
};

/// The anatomy of the heart that the program ships (definition `heart`): frame, ellipsoids and vessels as
/// that definition has them.
HeartAnatomy sampleHeartAnatomy(const SampleHeartSurfaces& surfaces);

} // namespace viscera::sequences
