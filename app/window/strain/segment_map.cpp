#include "window/strain/segment_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/presentation/strain_figure.h"
#include "window/style/language.h"

namespace viscera::app {

std::size_t strainPhaseAt(const live::StrainReading& reading, double seconds, double period) {
  const auto apart = [seconds, period](double other) {
    const double straight = std::abs(std::remainder(other - seconds, period));
    return std::min(straight, std::abs(period - straight));
  };
  const std::vector<double>& phases = reading.strain.seconds;
  const auto nearest =
      std::min_element(phases.begin(), phases.end(), [&](double a, double b) { return apart(a) < apart(b); });
  return static_cast<std::size_t>(nearest - phases.begin());
}

SegmentMovie::SegmentMovie(std::shared_ptr<const live::StrainReading> reading,
                           const presentation::StrainLook& look, presentation::SegmentsOfOrgans segments,
                           double periodSeconds)
    : reading_(std::move(reading)), look_(look), segments_(std::move(segments)), period_(periodSeconds),
      title_(inWords(std::string(presentation::titleOf(look.direction))).toStdString()) {}

presentation::SurfaceMap SegmentMovie::at(double seconds) const {
  const scene::BullsEyeFigure figure = presentation::strainBullsEye(
      *reading_, look_.direction, look_.moment, strainPhaseAt(*reading_, seconds, period_));
  return presentation::segmentMap(figure, segments_, look_.segment, title_);
}

} // namespace viscera::app
