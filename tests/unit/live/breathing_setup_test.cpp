#include "viscera/live/sequence_setup.h"

#include <cmath>

#include <gtest/gtest.h>

#include "self_intersections.h"
#include "sequence_scene.h"

namespace viscera::live {
namespace {

class BreathingLiver : public tests::SequenceScene {
public:
  BreathingLiver()
      : SequenceScene([](Progress& progress) {
          return setUpSequence(tests::cachedLibrary(), "breathing", sample_organs::Resolution::low, progress);
        }) {}
};

TEST(BreathingSetup, liverKeepsItsVolumeAndShapeThroughABreath) {
  BreathingLiver liver;
  const double rate = liver.setup().sequence->standardRatePerMinute();
  liver.show(0, rate);
  const double kept = liver.volumeMl("outer");
  for (int frame = 0; frame < 24; ++frame) {
    liver.show(frame / 24.0 * 60 / rate, rate);
    EXPECT_NEAR(liver.volumeMl("outer"), kept, 1e-6 * kept) << frame;
    EXPECT_GT(liver.worstTriangle("outer"), 0.8) << frame;
  }
  liver.show(0.5 * 60 / rate, rate);
  EXPECT_EQ(tests::selfIntersections(liver.posed("outer")), 0);
}

TEST(BreathingSetup, liverDescendsByOneToTwoAndAHalfCentimetres) {
  BreathingLiver liver;
  liver.show(2, 15);
  const Points& rest = liver.setup().organ.surfaces.front().mesh->points;
  const double down = (rest - liver.posed("outer").points).col(2).mean();
  EXPECT_GT(down, 10);
  EXPECT_LT(down, 25);
}

TEST(BreathingSetup, isAmongTheSequencesThereAre) {
  Progress progress;
  const SequenceSetup setup =
      setUpSequence(tests::cachedLibrary(), "breathing", sample_organs::Resolution::low, progress);
  EXPECT_EQ(setup.organ.name, "liver");
  ASSERT_EQ(setup.rig.groups.size(), 2u);
  EXPECT_EQ(setup.rig.groups[0].handles.size(), 8u);
}

} // namespace
} // namespace viscera::live
