#include <gtest/gtest.h>

#include "build_paths.h"
#include "shared_organs.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/place_handles.h"

/// The celestial coordinates on a real surface of 35,947 vertices with the handles that the program places
/// itself.
namespace viscera::coordinates {
namespace {

class BunnyTest : public testing::TestWithParam<std::shared_ptr<const CoordinateSystem>> {
protected:
  void SetUp() override {
    const auto bunny = tests::bunny(VISCERA_SHARED_ORGANS);
    if (!bunny)
      GTEST_SKIP() << "bunny.obj is not beside the project";
    organ_ = *bunny;
    handles_.positions = deformation::placeHandles(organ_);
  }

  std::shared_ptr<const Binding> bind(int threads, double locality = 0, double softness = 0) {
    BindOptions options;
    options.threads.count = threads;
    options.parameters.set("locality", locality);
    options.parameters.set("softness", softness);
    return deformation::bindOrgan(*GetParam(), handles_, organ_.points, options, progress_);
  }

  geometry::TriangleMesh organ_;
  HandleSet handles_;
  Progress progress_;
};

} // namespace

TEST_P(BunnyTest, IsReproducedExactlyByThirtyHandles) {
  ASSERT_EQ(organ_.points.rows(), 35947);
  ASSERT_EQ(handles_.positions.rows(), 30);
  const double diagonal = boundsOf(organ_.points).diagonal();
  for (const auto& [locality, softness] : {std::pair(0.0, 0.0), std::pair(3.0, 0.0), std::pair(6.0, 40.0)}) {
    SCOPED_TRACE(testing::Message() << "locality " << locality << ", softness " << softness);
    const BindingReport report = bind(2, locality, softness)->report(); // Throws when any vertex has none.
    EXPECT_LE(report.identityError, 1e-9 * diagonal);
    EXPECT_LE(report.unityError, 1e-12);
    EXPECT_GE(report.minWeight, 0);
    EXPECT_TRUE(report.failures.empty());
  }
}

TEST_P(BunnyTest, IsBoundBitwiseTheSameByAnyNumberOfThreads) {
  const auto one = bind(1, 1.5, 10), two = bind(2, 1.5, 10), three = bind(3, 1.5, 10);
  for (int handle = 0; handle < 30; ++handle) {
    EXPECT_EQ(two->influence(handle), one->influence(handle)) << handle;
    EXPECT_EQ(three->influence(handle), one->influence(handle)) << handle;
  }
}

INSTANTIATE_TEST_SUITE_P(Systems, BunnyTest, testing::Values(sCelestial(), tCelestial()),
                         [](const auto& each) { return each.param->id().substr(0, 1) + "Celestial"; });

} // namespace viscera::coordinates
