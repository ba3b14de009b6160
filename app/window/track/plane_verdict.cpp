#include "window/track/plane_verdict.h"

#include "viscera/live/cine_reading.h"
#include "window/style/language.h"

namespace viscera::app {
SliceVerdict planeVerdict(const MeasuredMotion& measured, const Playback& playback, std::size_t slice) {
  const live::CineMotion* found = measured.images();
  if (!found || !measured.isOfStudy() || !playback.showing())
    return {};
  const auto plane = live::planeOfSlice(*found, slice);
  if (!plane)
    return {MeasuredMotion::tr("Not used for the motion"), tracking::FitLight::good};
  const live::CinePlaneUse& use = found->planes[*plane];
  const std::size_t phase = measured.phaseNow();
  const QString words = inWords(live::wordsOf(use, phase).capitalised());
  const bool estimate = found->estimate && !measured.isLabelled(phase);
  const auto light = live::lightOf(use.states[phase]);
  return {estimate ? MeasuredMotion::tr("Estimate: %1").arg(words) : words,
          estimate && light == tracking::FitLight::good ? tracking::FitLight::amber : light};
}

} // namespace viscera::app
