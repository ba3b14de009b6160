#pragma once

#include <vector>

#include <vtkSmartPointer.h>

#include "view_geometry.h"

class vtkActor;

namespace viscera::scene {

/// A handle near the cursor.
struct HandleCandidate {
  int handle = -1;
  Vec3 seen = Vec3::Zero(); ///< The point of its ball that is seen there, mm.
};

/// The handles that a display position could mean, the likeliest first: those whose ball is under it by their
/// nearness to the eye, then those beside it by their distance on the display. `radii` are the balls' in
/// device pixels (0: not to be picked), `reach` says how far from its centre a handle can be picked at least.
/// Does not ask what is hidden. O(n).
std::vector<HandleCandidate> handlesNear(const ViewGeometry& view, const Points& positions,
                                         const std::vector<double>& radii, double reach, double x, double y);

/// Whether a visible and opaque actor is between the eye and a point. O(triangles).
bool isHidden(const ViewGeometry& view, const Vec3& point,
              const std::vector<vtkSmartPointer<vtkActor>>& actors);

} // namespace viscera::scene
