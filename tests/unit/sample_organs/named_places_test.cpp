#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "viscera/core/progress.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

/// mm. A name is written beside a vertex, not beside a place that was meant.
constexpr double kFarthestFromSurface = 8;
constexpr double kLeastApart = 5;

class NamedPlaces : public testing::TestWithParam<std::string> {};

TEST_P(NamedPlaces, LieOnTheSurfaceApartFromEachOther) {
  Progress progress;
  // Vessels of the liver are there from the middle resolution on.
  const auto resolution =
      GetParam().ends_with("liver") ? sample_organs::Resolution::medium : sample_organs::Resolution::low;
  const std::size_t slash = GetParam().find('/');
  const std::string organ = GetParam().substr(0, slash);
  const std::string name = slash == std::string::npos ? "outer" : GetParam().substr(slash + 1);
  const auto surface = sample_organs::sampleSurface(projectLibrary(), organ, name, resolution, progress);
  ASSERT_GE(surface.places.size(), 5U);
  EXPECT_EQ(surface.places, sample_organs::namedPlaces(projectLibrary(), organ, name));
  std::set<std::string> names;
  Points vertices(0, 3);
  for (const geometry::NamedPlace& place : surface.places) {
    EXPECT_TRUE(names.insert(place.name).second) << place.name << " is there twice";
    Eigen::Index nearest = 0;
    const double away = std::sqrt(
        (surface.mesh->points.rowwise() - place.at.transpose()).rowwise().squaredNorm().minCoeff(&nearest));
    EXPECT_LT(away, kFarthestFromSurface) << place.name;
    const Vec3 vertex = surface.mesh->points.row(nearest);
    if (vertices.rows() > 0) {
      EXPECT_GT((vertices.rowwise() - vertex.transpose()).rowwise().norm().minCoeff(), kLeastApart)
          << place.name << " lies on another part";
    }
    vertices.conservativeResize(vertices.rows() + 1, 3);
    vertices.row(vertices.rows() - 1) = vertex.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(OfOrgan, NamedPlaces,
                         testing::Values("heart", "stomach", "liver", "kidney_left", "kidney_right",
                                         "stomach_and_bowel", "digestive_system", "digestive_system/liver",
                                         "digestive_system/pancreas"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::erase_if(name, [](char c) { return c == '_' || c == '/'; });
                           return name;
                         });

} // namespace
} // namespace viscera::tests
