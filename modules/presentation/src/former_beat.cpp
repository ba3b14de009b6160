#include "former_beat.h"

#include <algorithm>
#include <cmath>

#include "viscera/circulation/curves.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/heart/cardiac_cycle.h"

namespace viscera::presentation {
namespace {

constexpr double kSameKey = 1e-9; ///< Two instants of a cycle.

/// The part of the beat by which it begins earlier than it did; 0 for a motion that is no heartbeat.
double beginsEarlierBy(const ViewState& view, const document::CirculationChoice& circulation) {
  const Playing& playing = *view.playing;
  if (playing.motion < 0 || static_cast<std::size_t>(playing.motion) >= view.motions.size())
    return 0;
  const live::MotionRecipe& recipe = view.motions[static_cast<std::size_t>(playing.motion)].recipe;
  if (live::sequenceOf(recipe) != "heartbeat")
    return 0;
  if (circulation.drives && live::sampleHeartOf(recipe))
    return circulation::drawnBefore(circulation.parameters, circulation::SolverOptions().samples,
                                    heart::kBeforeAtria);
  using heart::CardiacCycle;
  const double rate =
      playing.ratePerMinute > 0
          ? std::clamp(playing.ratePerMinute, CardiacCycle::kLowestRateBpm, CardiacCycle::kHighestRateBpm)
          : CardiacCycle::kStandardRateBpm;
  return heart::kBeforeAtria * rate / 60;
}

/// The keys of a periodic curve in their new order, without a second one at the same instant.
void sortKeys(std::vector<std::array<double, 2>>& curve) {
  std::sort(curve.begin(), curve.end());
  curve.erase(std::unique(curve.begin(), curve.end(),
                          [](const auto& a, const auto& b) { return b[0] - a[0] < kSameKey; }),
              curve.end());
}

} // namespace

void beginBeforeAtria(ViewState& view, const document::CirculationChoice& circulation) {
  if (!view.playing)
    return;
  const double earlier = beginsEarlierBy(view, circulation);
  if (earlier == 0)
    return;
  const auto later = [&](double fraction) {
    const double moved = fraction + earlier;
    return std::isfinite(moved) ? moved - std::floor(moved) : fraction;
  };
  Playing& playing = *view.playing;
  if (playing.shown || playing.fraction > 0) // Else it never left its beginning.
    playing.fraction = later(playing.fraction);
  for (Slide& slide : view.slides)
    if (slide.fraction)
      slide.fraction = later(*slide.fraction);
  if (playing.prescribed) {
    auto& curve = playing.prescribed->curve;
    // What is out of range is refused when it is played: moved, it would be accepted.
    const bool within =
        std::all_of(curve.begin(), curve.end(), [](const auto& key) { return key[0] >= 0 && key[0] <= 1; });
    if (!within)
      return;
    for (auto& key : curve)
      key[0] = later(key[0]);
    sortKeys(curve);
  }
}

} // namespace viscera::presentation
