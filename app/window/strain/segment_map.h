#pragma once

#include <memory>
#include <string>

#include "viscera/live/strain_reading.h"
#include "viscera/presentation/segment_map.h"
#include "viscera/presentation/view_state.h"

namespace viscera::app {

/// The phase that is shown at `seconds` of a cycle of `period` seconds, which leads back to its beginning.
std::size_t strainPhaseAt(const live::StrainReading& reading, double seconds, double period);

/// The colours of the segments over a cycle, for a movie: a copy of everything that it needs. Immutable; for
/// any thread.
class SegmentMovie {
public:
  SegmentMovie(std::shared_ptr<const live::StrainReading> reading, const presentation::StrainLook& look,
               presentation::SegmentsOfOrgans segments, double periodSeconds);

  /// Returns the colours that the window shows at `seconds` of the sequence.
  presentation::SurfaceMap at(double seconds) const;

private:
  std::shared_ptr<const live::StrainReading> reading_;
  presentation::StrainLook look_;
  presentation::SegmentsOfOrgans segments_;
  double period_;
  std::string title_; ///< Translated on the main thread.
};

} // namespace viscera::app
