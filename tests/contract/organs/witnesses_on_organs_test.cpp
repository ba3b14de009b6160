#include <gtest/gtest.h>

#include "build_paths.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/live/witness_sampling.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::live {
namespace {

/// Fills an organ, binds the points to the handles that the program places, and measures a pose.
void expectAUsableMap(const geometry::TriangleMesh& organ, WitnessOrigin worst) {
  WitnessOptions options;
  options.wanted = 2000;
  Progress progress;
  const WitnessSample sample = sampleWitnesses(organ, options, progress);
  EXPECT_LE(sample.origin, worst);
  EXPECT_EQ(sample.remarks.empty(), sample.origin == WitnessOrigin::surface);
  deformation::requireUsable(*sample.mesh, "organ");
  EXPECT_NEAR(static_cast<double>(sample.mesh->witnesses), 2000, kWitnessCountTolerance * 2000);
  const double filled = deformation::tetrahedronVolumes(sample.mesh->points, sample.mesh->tetrahedra).sum();
  const auto report = geometry::checkSurface(organ);
  if (report.closed()) {
    EXPECT_NEAR(filled, report.volumeMm3, 0.05 * report.volumeMm3);
  }

  coordinates::HandleSet handles; // A box well outside.
  const Bounds box = boundsOf(organ.points);
  const Vec3 margin = Vec3::Constant(0.2 * box.diagonal());
  const Vec3 low = box.low - margin, high = box.high + margin;
  handles.positions.resize(8, 3);
  for (int i = 0; i < 8; ++i)
    handles.positions.row(i) << (i & 1 ? high : low)[0], (i & 2 ? high : low)[1], (i & 4 ? high : low)[2];
  const auto gradients =
      deformation::bindWitnesses(*coordinates::sCelestial(), handles, sample.mesh->points, {}, progress);
  EXPECT_TRUE(gradients->failures().empty());
  Points pose = handles.positions;
  pose.row(7) += 0.3 * (high - low).transpose();
  deformation::StressMap map;
  gradients->evaluate(pose, map);
  EXPECT_TRUE(map.rotationalStress.allFinite());
  EXPECT_GT(map.rotationalStress.maxCoeff(), 0.01);
}

class SampleOrganWitnesses : public testing::TestWithParam<const char*> {};

TEST_P(SampleOrganWitnesses, GiveAUsableMapStraightFromTheSurface) {
  Progress progress;
  expectAUsableMap(*sample_organs::sampleOrgan(sample_organs::standardLibrary(), GetParam(),
                                               sample_organs::Resolution::low, progress)
                        .surfaces.front()
                        .mesh,
                   WitnessOrigin::surface);
}

INSTANTIATE_TEST_SUITE_P(, SampleOrganWitnesses,
                         testing::Values("heart", "stomach", "liver", "kidney_left", "kidney_right",
                                         "stomach_and_bowel"));

class SharedOrganWitnesses : public testing::TestWithParam<const char*> {};

TEST_P(SharedOrganWitnesses, GiveAUsableMapOrARepairedOne) {
  const auto file = std::filesystem::path(VISCERA_SHARED_ORGANS) / GetParam();
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is absent";
  auto mesh = medical_io::readSurface(file).mesh;
  geometry::orientOutward(mesh);
  expectAUsableMap(mesh, WitnessOrigin::repairedSurface);
}

INSTANTIATE_TEST_SUITE_P(, SharedOrganWitnesses, testing::Values("liver.vtk", "kidney_left.vtk", "bunny.obj"),
                         [](const auto& organ) {
                           const std::string name = organ.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(MediumHeartWitnesses, GiveAUsableMap) {
  Progress progress;
  expectAUsableMap(*sample_organs::sampleOrgan(sample_organs::standardLibrary(), "heart",
                                               sample_organs::Resolution::medium, progress)
                        .surfaces.front()
                        .mesh,
                   WitnessOrigin::surface);
}

} // namespace
} // namespace viscera::live
