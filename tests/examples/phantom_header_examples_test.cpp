#include <gtest/gtest.h>

#include "viscera/clinic/study_identity.h"
#include "viscera/elasticity/stated_material.h"
#include "viscera/elasticity/tissues.h"
#include "viscera/phantom/phantom_options.h"
#include "viscera/tracking/cine_images.h"

namespace viscera::examples {

TEST(HeaderExamples, Tissues) {
  using namespace elasticity;
  const NeoHookean liver(tissueNamed("liver").youngKpa, 0.49);
  const double kpa = vonMisesKpa(liver, Eigen::Vector3d(1.1, 1, 1).asDiagonal());
  EXPECT_GT(kpa, 0.3);
  EXPECT_LT(kpa, 0.8);
}

TEST(HeaderExamples, StatedMaterial) {
  using namespace elasticity;
  const StatedMaterial liver = materialOf("liver");
  const double kpa = vonMisesKpa(liver, {1.1, 1, 1.1});
  EXPECT_GT(kpa, 0.3);
  EXPECT_LT(kpa, 0.8);
}

TEST(HeaderExamples, StudyIdentity) {
  using namespace clinic;
  const StudyIdentity clean = withoutIdentity(newStudyIdentity(), "secret of this export");
  const std::vector<IdentifyingElement> left = identifyingElements(clean);
  ASSERT_FALSE(left.empty());
  EXPECT_EQ(left.front().value, "Anonymous");
}

TEST(HeaderExamples, PhantomOptions) {
  using namespace phantom;
  PhantomOptions options;
  options.spacing = spacingFrom("1.5,1.5,8");
  options.slices = slicesFrom({"sax:9,2", "lax"});
  setNoise("rician:15", options);
  EXPECT_EQ(options.slices.shortAxis, 9);
  EXPECT_EQ(options.deviation, 15);
}

TEST(HeaderExamples, CineImages) {
  using namespace tracking;
  CinePlane plane;
  plane.name = "four chambers";
  plane.origin = Vec3(-120, -80, 40);
  plane.alongRow = Vec3::UnitX();
  plane.alongColumn = Vec3::UnitY();
  plane.spacing = Eigen::Vector2d(1.4, 1.4);
  for (int phase = 0; phase < 20; ++phase) {
    plane.fractions.push_back(phase / 20.0);
    plane.images.push_back(CineImage::Zero(160, 192));
  }
  EXPECT_NO_THROW(requireValid({plane}));
  EXPECT_EQ(plane.imageAt(0.51, 0.02), 10);
}

} // namespace viscera::examples
