#include "viscera/live/cycle_curves.h"

#include <algorithm>

#include "viscera/live/heart_walls.h"

namespace viscera::live {
namespace {

constexpr int kEvenInstants = 96;
/// Instants nearer than this part of the cycle are one.
constexpr double kSameCycleInstant = 1e-9;

std::vector<double> instantsOf(const sequences::Sequence& sequence, double ratePerMinute) {
  std::vector<double> fractions;
  for (int i = 0; i <= kEvenInstants; ++i)
    fractions.push_back(static_cast<double>(i) / kEvenInstants);
  for (const sequences::Phase& phase : sequence.phases(ratePerMinute))
    if (phase.begin > 0 && phase.begin < 1)
      fractions.push_back(phase.begin);
  std::sort(fractions.begin(), fractions.end());
  const auto same = [](double a, double b) { return b - a < kSameCycleInstant; };
  fractions.erase(std::unique(fractions.begin(), fractions.end(), same), fractions.end());
  return fractions;
}

} // namespace

CycleCurves measureCycle(MotionRunner& runner, Progress& progress) {
  runner.requireMovable();
  CycleCurves curves;
  const HeartWalls walls(runner);
  std::vector<heart::WallPlaces> places;
  curves.fractions = instantsOf(*runner.sequence(), runner.ratePerMinute());
  for (std::size_t instant = 0; instant < curves.fractions.size(); ++instant) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(instant) / static_cast<double>(curves.fractions.size()));
    runner.show(curves.fractions[instant] * runner.periodSeconds());
    const std::vector<double> volumes = runner.volumesMl();
    curves.milliliters.resize(volumes.size());
    for (std::size_t organ = 0; organ < volumes.size(); ++organ)
      curves.milliliters[organ].push_back(volumes[organ]);
    if (const auto now = walls.now())
      places.push_back(*now);
    if (curves.obstacle.empty())
      curves.obstacle = runner.obstacle();
  }
  if (!places.empty())
    curves.wall = heart::wallMotion(places);
  return curves;
}

} // namespace viscera::live
