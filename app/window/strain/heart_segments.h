#pragma once

#include <functional>

#include "viscera/presentation/segment_map.h"
#include "viscera/presentation/view_state.h"

namespace viscera::app {

class Playback;
class StrainModel;

/// The segments of one view's heart as colours on its organs: now, and over the cycle. Everything has to live
/// longer; for the main thread.
class HeartSegments {
public:
  HeartSegments(const StrainModel& strain, const Playback& playback) : strain_(strain), playback_(playback) {}

  /// Whether there is a reading whose colours can be shown.
  bool known() const;
  /// The colours of the instant that is shown, or of the pose while handles move it. Expects `known`.
  presentation::SurfaceMap now(const presentation::StrainLook& look) const;
  /// Returns the colours that the view shows at the seconds of its sequence, for a movie: a copy of
  /// everything that it needs, for any thread. Null unless `known`.
  std::function<presentation::SurfaceMap(double seconds)>
  overTime(const presentation::StrainLook& look) const;

private:
  presentation::SegmentsOfOrgans segments() const;

  const StrainModel& strain_;
  const Playback& playback_;
};

} // namespace viscera::app
