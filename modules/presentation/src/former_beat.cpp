#include "former_beat.h"

namespace viscera::presentation {

void beginBeforeAtria(ViewState& view, const document::CirculationChoice& circulation) {
  if (!view.playing)
    return;
  const double earlier = live::beginsEarlierBy(motionOf(view), circulation);
  if (earlier == 0)
    return;
  live::beginEarlier(*view.playing, earlier);
  for (Slide& slide : view.slides)
    if (slide.fraction)
      slide.fraction = live::fractionLater(*slide.fraction, earlier);
}

} // namespace viscera::presentation
