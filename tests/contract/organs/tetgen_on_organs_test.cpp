#include <filesystem>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/geometry/volume.h"
#include "viscera/sample_organs/sample_organ.h"

/// TetGen takes every surface of every sample organ as it is.
namespace viscera::tests {
namespace {

using sample_organs::Resolution;

class TetGenOnOrgans : public testing::TestWithParam<std::tuple<std::string, Resolution>> {};

double volumeOfTetrahedra(const deformation::WitnessMesh& mesh) {
  double volume = 0;
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    const Vec3 a = mesh.points.row(mesh.tetrahedra(t, 0));
    const Vec3 b = mesh.points.row(mesh.tetrahedra(t, 1));
    const Vec3 c = mesh.points.row(mesh.tetrahedra(t, 2));
    const Vec3 d = mesh.points.row(mesh.tetrahedra(t, 3));
    volume += std::abs((b - a).cross(c - a).dot(d - a)) / 6;
  }
  return volume;
}

std::string nameOfCase(const testing::TestParamInfo<TetGenOnOrgans::ParamType>& info) {
  std::string name;
  for (const char c : std::get<0>(info.param))
    if (c != '_')
      name += c;
  return name + "_" + sample_organs::nameOf(std::get<1>(info.param));
}

TEST_P(TetGenOnOrgans, FillsEverySurfaceWithoutChangingIt) {
  const auto& [name, resolution] = GetParam();
  const sample_organs::SampleLibrary library{std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs",
                                             std::filesystem::path(VISCERA_BINARY_DIR) / "test_organs"};
  Progress progress;
  deformation::TetrahedraOptions options;
  options.radiusEdgeRatio = 0; // As `tetgen -pYQ`: any shape, the surface stays.
  options.timeLimitSeconds = 250;
  for (const sample_organs::SampleSurface& surface :
       sample_organs::sampleOrgan(library, name, resolution, progress).surfaces) {
    SCOPED_TRACE(surface.name);
    const deformation::WitnessMesh mesh = deformation::tetrahedralise(*surface.mesh, options, progress);
    const double wanted = geometry::volume(surface.mesh->points, surface.mesh->triangles);
    EXPECT_GT(mesh.tetrahedra.rows(), surface.mesh->triangles.rows() / 4);
    EXPECT_NEAR(volumeOfTetrahedra(mesh), wanted, 1e-6 * wanted);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, TetGenOnOrgans,
                         testing::Combine(testing::Values("heart", "stomach", "liver", "kidney_left",
                                                          "kidney_right", "stomach_and_bowel"),
                                          testing::Values(Resolution::low, Resolution::medium,
                                                          Resolution::high)),
                         nameOfCase);

} // namespace
} // namespace viscera::tests
