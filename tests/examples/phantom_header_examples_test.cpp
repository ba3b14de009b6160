#include <gtest/gtest.h>

#include "viscera/elasticity/tissues.h"
#include "viscera/phantom/phantom_options.h"

namespace viscera::examples {

TEST(HeaderExamples, Tissues) {
  using namespace elasticity;
  const NeoHookean liver(tissueNamed("liver").youngKpa, 0.49);
  const double kpa = vonMisesKpa(liver, Eigen::Vector3d(1.1, 1, 1).asDiagonal());
  EXPECT_GT(kpa, 0.3);
  EXPECT_LT(kpa, 0.8);
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

} // namespace viscera::examples
