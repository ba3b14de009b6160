#include "window/strain/heart_segments.h"

#include "viscera/presentation/strain_figure.h"
#include "window/strain/segment_map.h"
#include "window/strain/strain_model.h"
#include "window/style/language.h"
#include "window/timeline/playback.h"
#include "window/work/workspace.h"

namespace viscera::app {

bool HeartSegments::known() const {
  return strain_.pose() || strain_.cycle();
}

/// A surface that was exchanged has no segments until they are found anew.
presentation::SegmentsOfOrgans HeartSegments::segments() const {
  presentation::SegmentsOfOrgans found;
  for (const auto& organ : strain_.workspace().document().organs())
    if (const std::vector<int>* segments = strain_.segmentsOn(organ->id);
        segments && static_cast<Eigen::Index>(segments->size()) == organ->mesh->points.rows())
      found[organ->id] = *segments;
  return found;
}

presentation::SurfaceMap HeartSegments::now(const presentation::StrainLook& look) const {
  const StrainModel::Reading pose = strain_.pose();
  const scene::BullsEyeFigure figure =
      pose ? presentation::strainBullsEye(*pose, look.direction, live::StrainMoment::instant, 1)
           : presentation::strainBullsEye(*strain_.cycle(), look.direction, look.moment, strain_.phaseNow());
  return presentation::segmentMap(figure, segments(), look.segment, inWords(figure.title).toStdString());
}

std::function<presentation::SurfaceMap(double)>
HeartSegments::overTime(const presentation::StrainLook& look) const {
  if (!known())
    return nullptr;
  if (!strain_.cycle())
    return [still = now(look)](double) { return still; };
  return [movie = SegmentMovie(strain_.cycle(), look, segments(), playback_.player().periodSeconds())](
             double seconds) { return movie.at(seconds); };
}

} // namespace viscera::app
