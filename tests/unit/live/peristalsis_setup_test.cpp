#include "viscera/live/sequence_setup.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "self_intersections.h"
#include "sequence_scene.h"
#include "viscera/sequences/peristalsis.h"

namespace viscera::live {
namespace {

using sample_organs::Resolution;
using sequences::Peristalsis;
using tests::SequenceScene;

constexpr double kWavesPerMinute = 3;

class WorkingStomach : public SequenceScene {
public:
  explicit WorkingStomach(Resolution resolution)
      : SequenceScene([&](Progress& progress) {
          return setUpSequence(tests::cachedLibrary(), "peristalsis", resolution, progress);
        }) {}

  const Peristalsis& peristalsis() const { return dynamic_cast<const Peristalsis&>(*setup().sequence); }
};

/// The mean distance of the wall from the centreline, in slices of it that are 4 mm long, for the part below
/// the middle of the body.
class WallDistance {
public:
  explicit WallDistance(const WorkingStomach& stomach)
      : line_(stomach.peristalsis().rig().anatomy.centerline),
        course_(stomach.peristalsis().rig().anatomy.course) {
    const Points& rest = stomach.setup().organ.surfaces.front().mesh->points;
    for (Eigen::Index i = 0; i < rest.rows(); ++i)
      slices_.push_back(static_cast<int>(line_.nearest(rest.row(i).transpose()) / kSlice));
    rest_ = of(rest);
  }

  /// By which part each slice of 4 mm is narrower than at rest, from the middle of the body to past the
  /// pylorus.
  std::vector<double> narrowing(const Points& points) const {
    std::vector<double> now = of(points);
    for (std::size_t i = 0; i < now.size(); ++i)
      now[i] = rest_[i] > 0 ? 1 - now[i] / rest_[i] : 0;
    return now;
  }
  static std::size_t sliceAt(double s) { return static_cast<std::size_t>(s / kSlice); }

  /// The narrowest slice as a part of what it is at rest, where it is, and what the waves say there.
  void narrowest(const Points& points, double& part, double& s) const {
    const std::vector<double> now = of(points);
    part = 2;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double at = (static_cast<double>(i) + 0.5) * kSlice;
      if (at < course_.midBody || at > course_.pylorus || rest_[i] == 0 || now[i] / rest_[i] > part)
        continue;
      part = now[i] / rest_[i];
      s = at;
    }
  }

private:
  static constexpr double kSlice = 4;

  std::vector<double> of(const Points& points) const {
    std::vector<double> sums(100, 0);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const int slice = slices_[static_cast<std::size_t>(i)];
      const Vec3 center = line_.at((slice + 0.5) * kSlice).center;
      sums[static_cast<std::size_t>(slice)] += (points.row(i).transpose() - center).norm();
    }
    return sums;
  }

  const sequences::Centerline& line_;
  sequences::GastricCourse course_;
  std::vector<int> slices_;
  std::vector<double> rest_;
};

TEST(PeristalsisSetup, volumeStaysToAMillionthOverAMinuteAtEveryRate) {
  WorkingStomach stomach(Resolution::medium);
  const double kept = stomach.peristalsis().keptMl();
  double worst = 0;
  for (const double rate : {1.0, 3.0, 6.0})
    for (int frame = 0; frame < 40; ++frame) {
      stomach.show(frame * 60 / 40.0 + 0.123, rate);
      worst = std::max(worst, std::abs(stomach.volumeMl("outer") - kept) / kept);
    }
  RecordProperty("worstRelativeVolumeError", std::to_string(worst * 1e12) + "e-12");
  EXPECT_LT(worst, 1e-6);
}

TEST(PeristalsisSetup, surfaceNarrowsAsMuchAsMeasuredInPeople) {
  WorkingStomach stomach(Resolution::medium);
  const WallDistance wall(stomach);
  double deepest = 0;
  for (int frame = 0; frame < 40; ++frame) {
    const double t = frame * 0.5;
    stomach.show(t, kWavesPerMinute);
    double part = 0;
    double s = 0;
    wall.narrowest(stomach.posed("outer").points, part, s);
    // Near the pylorus, which closes by itself, the wall is bent too sharply for that.
    if (s < stomach.peristalsis().rig().anatomy.course.pylorus - 12) {
      EXPECT_NEAR(part, 1 - stomach.peristalsis().waves().constriction(s, t, kWavesPerMinute), 0.08)
          << t << " at " << s;
    }
    deepest = std::max(deepest, 1 - part);
  }
  RecordProperty("deepestConstriction", std::to_string(deepest));
  EXPECT_NEAR(deepest, 0.58, 0.14);
}

/// When a place is narrowest, and by how much: the highest of samples at `step` seconds of a period, and the
/// parabola through it and its neighbours.
struct Passing {
  double seconds = 0;
  double narrowing = 0;
};

Passing passingOf(const std::vector<std::vector<double>>& profiles, std::size_t slice, double step) {
  const auto count = profiles.size();
  std::size_t top = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (profiles[i][slice] > profiles[top][slice])
      top = i;
  const double before = profiles[(top + count - 1) % count][slice], at = profiles[top][slice];
  const double after = profiles[(top + 1) % count][slice];
  const double shift = 0.5 * (before - after) / (before - 2 * at + after);
  return {(static_cast<double>(top) + shift) * step, at};
}

/// How many separate places of a profile between two slices are narrowed.
int wavesIn(const std::vector<double>& profile, std::size_t first, std::size_t last) {
  int waves = 0;
  for (std::size_t i = first; i < last; ++i)
    waves += profile[i] > 0.08 && profile[i] > profile[i - 1] && profile[i] >= profile[i + 1] ? 1 : 0;
  return waves;
}

TEST(PeristalsisSetup, wavesOnTheSurfaceHaveTheSpeedTheNumberAndTheDepthOfPeople) {
  WorkingStomach stomach(Resolution::medium);
  const WallDistance wall(stomach);
  const sequences::GastricCourse& course = stomach.peristalsis().rig().anatomy.course;
  const double period = 60 / kWavesPerMinute, step = period / 40;
  std::vector<std::vector<double>> profiles;
  double waves = 0;
  for (int frame = 0; frame < 40; ++frame) {
    stomach.show(frame * step, kWavesPerMinute);
    EXPECT_NEAR(stomach.volumeMl("outer"), stomach.peristalsis().keptMl(), 1e-3) << frame;
    profiles.push_back(wall.narrowing(stomach.posed("outer").points));
    waves += wavesIn(profiles.back(), WallDistance::sliceAt(course.midBody) + 1,
                     WallDistance::sliceAt(course.pylorus)) /
             40.0;
  }
  EXPECT_NEAR(waves, 3, 0.6);
  RecordProperty("wavesAtOnce", std::to_string(waves));
  const std::vector<double> places = {150, 190, 230, 258};
  std::vector<Passing> passings;
  for (const double s : places)
    passings.push_back(passingOf(profiles, WallDistance::sliceAt(s), step));
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double took = std::fmod(passings[i].seconds - passings[i - 1].seconds + period, period);
    const double speed = (places[i] - places[i - 1]) / took;
    RecordProperty("speedFrom" + std::to_string(std::lround(places[i - 1])), std::to_string(speed));
    EXPECT_NEAR(speed, 2.7, 0.6) << "mm/s from " << places[i - 1] << " to " << places[i];
    EXPECT_GT(passings[i].narrowing, passings[i - 1].narrowing) << "waves deepen on their way";
  }
  EXPECT_NEAR(passings.back().narrowing, 0.58, 0.14);
}

TEST(PeristalsisSetup, pylorusOfTheSurfaceShutsBeforeTheWaveIsThereAndOpensAfterIt) {
  WorkingStomach stomach(Resolution::medium);
  const WallDistance wall(stomach);
  const double pylorus = stomach.peristalsis().rig().anatomy.course.pylorus;
  double widest = 1, shut = 0;
  for (int frame = 0; frame < 40; ++frame) {
    stomach.show(frame * 0.5, kWavesPerMinute);
    const std::vector<double> profile = wall.narrowing(stomach.posed("outer").points);
    const double closure = stomach.peristalsis().waves().pyloricClosure(frame * 0.5, kWavesPerMinute);
    const double at = profile[WallDistance::sliceAt(pylorus)];
    widest = std::min(widest, at);
    if (closure > 0.99) {
      shut = std::max(shut, at);
      EXPECT_GT(at, 0.4) << frame;
    }
  }
  RecordProperty("pylorusShutBy", std::to_string(shut));
  EXPECT_LT(widest, 0.1);
}

TEST(PeristalsisSetup, surfaceDoesNotCrossItselfAndItsTrianglesKeepTheirShape) {
  WorkingStomach stomach(Resolution::medium);
  for (int frame = 0; frame < 24; ++frame) {
    stomach.show(frame / 24.0 * 60 / kWavesPerMinute, kWavesPerMinute);
    EXPECT_EQ(tests::selfIntersections(stomach.posed("outer")), 0) << frame;
    EXPECT_GT(stomach.worstTriangle("outer"), 0.4) << frame;
  }
}

TEST(PeristalsisSetup, oesophagusAndDuodenumHardlyMove) {
  WorkingStomach stomach(Resolution::medium);
  const Points& rest = stomach.setup().organ.surfaces.front().mesh->points;
  for (int frame = 0; frame < 20; ++frame) {
    stomach.show(frame, kWavesPerMinute);
    const Points points = stomach.posed("outer").points;
    for (Eigen::Index i = 0; i < rest.rows(); ++i) {
      const bool oesophagus = rest(i, 2) > 125;
      const bool duodenum = rest(i, 0) < -55 && rest(i, 1) > 24;
      if (oesophagus || duodenum) {
        ASSERT_LT((points.row(i) - rest.row(i)).norm(), 1.5) << "vertex " << i << " after " << frame << " s";
      }
    }
  }
}

TEST(PeristalsisSetup, isAmongTheSequencesThereAre) {
  Progress progress;
  const SequenceSetup setup = setUpSequence(tests::cachedLibrary(), "peristalsis", Resolution::low, progress);
  EXPECT_EQ(setup.organ.name, "stomach");
  EXPECT_EQ(static_cast<Eigen::Index>(setup.rig.handles.size()), setup.sequence->restHandles().rows());
  ASSERT_GE(sampleSequences().size(), 2u);
  EXPECT_EQ(sampleSequences()[1].name, setup.sequence->name().english());
}

} // namespace
} // namespace viscera::live
