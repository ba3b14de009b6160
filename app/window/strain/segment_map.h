#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "viscera/live/strain_reading.h"
#include "viscera/presentation/presenter.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/bulls_eye.h"

namespace viscera::app {

/// The segment of each vertex of some organs, 1 to 17 or 0.
using SegmentsOfOrgans = std::map<document::OrganId, std::vector<int>>;

/// The segments of a heart's wall as colours on its organs, in the colours of the bull's eye so that both say
/// the same. With a `chosen` segment that one's alone. `title` in the language of the window. O(vertices).
presentation::SurfaceMap segmentMap(const scene::BullsEyeFigure& figure, const SegmentsOfOrgans& segments,
                                    int chosen, const std::string& title);

/// The phase that is shown at `seconds` of a cycle of `period` seconds, which leads back to its beginning.
std::size_t strainPhaseAt(const live::StrainReading& reading, double seconds, double period);

/// The colours of the segments over a cycle, for a movie: a copy of everything that it needs. Immutable; for
/// any thread.
class SegmentMovie {
public:
  SegmentMovie(std::shared_ptr<const live::StrainReading> reading, const presentation::StrainLook& look,
               SegmentsOfOrgans segments, double periodSeconds);

  /// Returns the colours that the window shows at `seconds` of the sequence.
  presentation::SurfaceMap at(double seconds) const;

private:
  std::shared_ptr<const live::StrainReading> reading_;
  presentation::StrainLook look_;
  SegmentsOfOrgans segments_;
  double period_;
  std::string title_; ///< Translated on the main thread.
};

} // namespace viscera::app
