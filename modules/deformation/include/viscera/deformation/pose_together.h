#pragma once

#include <memory>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/deformation/deformer.h"

/// Poses and measures many organs at once. Each has too little work for a parallel loop of its own: with a
/// hundred small organs most of the time would pass in starting and joining the threads.
namespace viscera::deformation {

/// A pose that an organ is to take.
struct NewPose {
  Deformer* deformer = nullptr;
  std::shared_ptr<const Points> pose; ///< `n x 3`, mm; not null. The deformer keeps it, without a copy.
  std::vector<int> moved = {};        ///< The handles that are elsewhere, to be moved by their columns one
                                      ///< after the other, as by `Deformer::moveHandle`; empty: as by
                                      ///< `Deformer::setPose`.
};

/// Gives each organ, none of them twice, its pose in one parallel loop over pairs of an organ and a range of
/// its points. The points have the bits that the organ's own members give, for any number of threads. Throws
/// as those, before any organ has moved.
void poseTogether(const std::vector<NewPose>& poses, Threads threads = {});

/// The volumes of these organs, mm^3, in one parallel loop over pairs of an organ and a range of its
/// triangles: the bits of `Deformer::volumeMm3`, which then costs nothing until the next pose. O(triangles of
/// the organs that have moved).
std::vector<double> volumesTogether(const std::vector<Deformer*>& deformers, Threads threads = {});

} // namespace viscera::deformation
