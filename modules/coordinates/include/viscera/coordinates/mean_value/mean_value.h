#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Mean value coordinates of a triangulated cage (thesis 3.1 and annex B.3; Floater, Kos, Reimers 2005, doi
/// 10.1016/j.cagd.2005.06.004; Ju, Schaefer, Warren 2005, doi 10.1145/1073204.1073229). The cage is
/// `HandleSet::cage`, else the convex hull of the handles. Positive inside a convex cage, negative here and
/// there in others; defined outside as well; smooth but on the cage itself. O(points x triangles).
///
/// Per triangle (i, j, k), with p at the origin and `m = sum of angle x unit normal` over the three planes
/// through p and an edge, the weight of v_i is `m . (v_j x v_k) / (2 det(v_i, v_j, v_k))`. This is the
/// thesis's (3.8) with its denominators made one, which makes its derivatives short.
class MeanValue final : public PointwiseSystem {
public:
  MeanValue();
};

/// Mean value coordinates of one closed, outward surface over some of the handles.
std::unique_ptr<const PointSolver> meanValueSolver(Points handles, Triangles cage);

} // namespace viscera::coordinates
