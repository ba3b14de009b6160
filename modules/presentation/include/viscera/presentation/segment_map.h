#pragma once

#include <map>
#include <string>
#include <vector>

#include "viscera/presentation/presenter.h"
#include "viscera/scene/bulls_eye.h"

namespace viscera::presentation {

/// The segment of each vertex of some organs, 1 to 17 or 0 (`live::StrainGauge::segmentsOn`).
using SegmentsOfOrgans = std::map<document::OrganId, std::vector<int>>;

/// The segments of a heart's wall as colours on its organs, in the colours of the bull's eye so that both say
/// the same. With a `chosen` segment that one's alone. `title` in the language of the reader. O(vertices).
SurfaceMap segmentMap(const scene::BullsEyeFigure& figure, const SegmentsOfOrgans& segments, int chosen,
                      const std::string& title);

} // namespace viscera::presentation
