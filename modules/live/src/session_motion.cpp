#include "viscera/live/session_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "viscera/circulation/curves.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/document/key_sequence.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/live/circulating_heart.h"
#include "viscera/live/unsuited_motion.h"
#include "viscera/sequences/volume_curve.h"

namespace viscera::live {
namespace {

constexpr double kSameKey = 1e-9; ///< Two instants of a cycle.

/// The organ that the chosen motion moves; null for the document's own motion, and where it is missing.
std::shared_ptr<const document::Organ> movedOrgan(const document::DocumentState& state,
                                                  const SessionMotion& motion) {
  const MotionChoice* chosen = motion.chosen();
  return chosen ? state.organ(chosen->organ) : nullptr;
}

/// The keys of a periodic curve in their new order, without a second one at the same instant.
void sortKeys(std::vector<std::array<double, 2>>& curve) {
  std::sort(curve.begin(), curve.end());
  curve.erase(std::unique(curve.begin(), curve.end(),
                          [](const auto& a, const auto& b) { return b[0] - a[0] < kSameKey; }),
              curve.end());
}

} // namespace

const MotionChoice* SessionMotion::chosen() const {
  const int index = playing ? playing->motion : motions.empty() ? -1 : 0;
  return index >= 0 && static_cast<std::size_t>(index) < motions.size()
             ? &motions[static_cast<std::size_t>(index)]
             : nullptr;
}

double beginsEarlierBy(const SessionMotion& motion, const document::CirculationChoice& circulation) {
  const MotionChoice* chosen = motion.chosen();
  if (!motion.playing || !chosen || sequenceOf(chosen->recipe) != "heartbeat")
    return 0;
  if (circulation.drives && sampleHeartOf(chosen->recipe))
    return circulation::drawnBefore(circulation.parameters, circulation::SolverOptions().samples,
                                    heart::kBeforeAtria);
  using heart::CardiacCycle;
  const double said = motion.playing->ratePerMinute;
  const double rate = said > 0 ? std::clamp(said, CardiacCycle::kLowestRateBpm, CardiacCycle::kHighestRateBpm)
                               : CardiacCycle::kStandardRateBpm;
  return heart::kBeforeAtria * rate / 60;
}

double fractionLater(double fraction, double earlier) {
  const double moved = fraction + earlier;
  return std::isfinite(moved) ? moved - std::floor(moved) : fraction;
}

void beginEarlier(Playing& playing, double earlier) {
  if (earlier == 0)
    return;
  if (playing.shown || playing.fraction > 0) // Else it never left its beginning.
    playing.fraction = fractionLater(playing.fraction, earlier);
  if (!playing.prescribed)
    return;
  auto& curve = playing.prescribed->curve;
  // What is out of range is refused when it is played: moved, it would be accepted.
  if (!std::all_of(curve.begin(), curve.end(), [](const auto& key) { return key[0] >= 0 && key[0] <= 1; }))
    return;
  for (auto& key : curve)
    key[0] = fractionLater(key[0], earlier);
  sortKeys(curve);
}

std::shared_ptr<const sequences::Sequence> makeSequence(const document::DocumentState& state,
                                                        const SessionMotion& motion,
                                                        const sample_organs::SampleLibrary& library,
                                                        Progress& progress, Threads threads) {
  const auto organ = movedOrgan(state, motion);
  if (!organ)
    return document::sequenceOf(*state.keySequence, *state.rig);
  const MotionRecipe& recipe = motion.chosen()->recipe;
  if (const std::optional<DrivingCirculation> driving = drivingCirculation(state, motion))
    return circulatingHeart(library, driving->name, driving->parameters, *sampleHeartOf(recipe), progress,
                            threads)
        .sequence;
  return makeMotion(recipe, *organ, library, progress);
}

std::optional<DrivingCirculation> drivingCirculation(const document::DocumentState& state,
                                                     const SessionMotion& motion) {
  const document::CirculationChoice& circulation = *state.circulation;
  if (!movedOrgan(state, motion) || !circulation.drives || !sampleHeartOf(motion.chosen()->recipe))
    return std::nullopt;
  return DrivingCirculation{document::nameOf(circulation), circulation.parameters};
}

std::optional<PrescribedVolume> prescribedVolume(const document::DocumentState& state,
                                                 const SessionMotion& motion) {
  if (!motion.playing || !motion.playing->prescribed || !state.organ(motion.playing->prescribed->organ))
    return std::nullopt;
  const Prescribed& prescribed = *motion.playing->prescribed;
  return PrescribedVolume{prescribed.organ, sequences::volumeCurve(prescribed.curve), prescribed.file};
}

double rateOf(const SessionMotion& motion, const sequences::Sequence& sequence) {
  if (!motion.playing || !(motion.playing->ratePerMinute > 0))
    return sequence.standardRatePerMinute();
  return std::clamp(motion.playing->ratePerMinute, sequence.lowestRatePerMinute(),
                    sequence.highestRatePerMinute());
}

Text unsuitedMotion(const document::DocumentState& state, const SessionMotion& motion,
                    const sequences::Sequence& sequence) {
  const auto organ = movedOrgan(state, motion);
  return organ ? unsuitedTo(sequence.id(), organ->name) : Text();
}

} // namespace viscera::live
