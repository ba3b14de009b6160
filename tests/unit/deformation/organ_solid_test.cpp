#include "viscera/deformation/organ_solid.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

using testing::HasSubstr;
using SolidReason = TetrahedraError::Reason;

std::shared_ptr<const geometry::TriangleMesh> shared(geometry::TriangleMesh mesh) {
  return std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
}

NamedWall ballWall(const std::string& name, double radius, const Vec3& center = Vec3::Zero(),
                   bool turned = false) {
  geometry::TriangleMesh mesh = tests::sphere(2, radius, center);
  if (turned)
    mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return {name, shared(std::move(mesh))};
}

double volumeOfWall(const NamedWall& wall) {
  return std::abs(geometry::volume(wall.mesh->points, wall.mesh->triangles));
}

SolidReason refusalOf(const NamedWall& outer, const std::vector<NamedWall>& cavities,
                      const std::string& says) {
  Progress progress;
  try {
    fillOrgan(outer, cavities, {}, progress);
  } catch (const TetrahedraError& error) {
    EXPECT_THAT(error.problem().english(), HasSubstr(says));
    return error.reason();
  }
  ADD_FAILURE() << "it was filled";
  return SolidReason::missing;
}

/// The area of a wall's faces.
double areaOfFaces(const OrganSolid& solid, const OrganSolid::Wall& wall) {
  double area = 0;
  for (const auto& [tetrahedron, other] : wall.faces) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 4; ++k)
      if (k != other)
        corners.emplace_back(solid.points.row(solid.tetrahedra(tetrahedron, k)).transpose());
    area += (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
  }
  return area;
}

TEST(OrganSolid, FillsTheOrganUpToItsCavities) {
  const NamedWall outer = ballWall("OUTER", 50);
  const std::vector<NamedWall> cavities = {ballWall("LV", 15, {20, 0, 0}),
                                           ballWall("RV", 10, {-20, 0, 0}, true)};
  TetrahedraOptions options;
  options.maxVolumeMm3 = 200;
  Progress progress;
  const OrganSolid solid = fillOrgan(outer, cavities, options, progress);
  const Values volumes = tetrahedronVolumes(solid.points, solid.tetrahedra);
  EXPECT_GT(volumes.minCoeff(), 0);
  EXPECT_NEAR(volumes.sum(), volumeOfWall(outer) - volumeOfWall(cavities[0]) - volumeOfWall(cavities[1]),
              0.1);
  ASSERT_EQ(solid.walls.size(), 3U);
  EXPECT_EQ(solid.walls[1].name, "LV");
  // The node sets are a partition of the boundary's nodes.
  const Triangles skin = skinOf(solid.tetrahedra);
  const std::set<std::int32_t> boundary(skin.data(), skin.data() + skin.size());
  std::set<std::int32_t> named;
  std::size_t nodes = 0, faces = 0;
  for (const OrganSolid::Wall& wall : solid.walls) {
    EXPECT_TRUE(std::is_sorted(wall.nodes.begin(), wall.nodes.end()));
    named.insert(wall.nodes.begin(), wall.nodes.end());
    nodes += wall.nodes.size();
    faces += wall.faces.size();
  }
  EXPECT_EQ(named, boundary);
  EXPECT_EQ(nodes, boundary.size());
  EXPECT_EQ(faces, static_cast<std::size_t>(skin.rows()));
  EXPECT_LT(nodes, static_cast<std::size_t>(solid.points.rows())) << "there are points inside";
  for (std::size_t i = 0; i < 3; ++i) {
    const geometry::TriangleMesh& mesh = *(i == 0 ? outer : cavities[i - 1]).mesh;
    EXPECT_EQ(solid.walls[i].nodes.size(), static_cast<std::size_t>(mesh.points.rows()));
    EXPECT_EQ(solid.walls[i].faces.size(), static_cast<std::size_t>(mesh.triangles.rows()));
    EXPECT_NEAR(areaOfFaces(solid, solid.walls[i]), geometry::area(mesh.points, mesh.triangles), 1e-6);
  }
}

TEST(OrganSolid, AnOrganWithoutCavitiesHasOneWall) {
  Progress progress;
  const NamedWall outer = ballWall("OUTER", 30, {5, 6, 7}, true);
  const OrganSolid solid = fillOrgan(outer, {}, {}, progress);
  EXPECT_NEAR(tetrahedronVolumes(solid.points, solid.tetrahedra).sum(), volumeOfWall(outer), 1e-3);
  ASSERT_EQ(solid.walls.size(), 1U);
  EXPECT_EQ(solid.walls[0].nodes.size(), static_cast<std::size_t>(outer.mesh->points.rows()));
}

TEST(OrganSolid, SurfacesThatLeaveNoTissueBetweenThemAreRefused) {
  const NamedWall outer = ballWall("OUTER", 50);
  EXPECT_EQ(refusalOf(outer, {ballWall("LV", 20, {45, 0, 0})}, ""), SolidReason::refused) << "they cross";
  EXPECT_EQ(refusalOf(outer, {ballWall("LV", 20, {100, 0, 0})}, "not wholly inside"), SolidReason::unusable);
  EXPECT_EQ(refusalOf(outer, {ballWall("LV", 20), ballWall("Stone", 5)}, "not wholly inside"),
            SolidReason::unusable);
  EXPECT_EQ(refusalOf(outer, {ballWall("LV", 50)}, "share points"), SolidReason::refused);
  geometry::TriangleMesh open = tests::sphere(1, 10);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  EXPECT_EQ(refusalOf(outer, {{"LV", shared(open)}}, "urface LV is open"), SolidReason::refused);
}

} // namespace
} // namespace viscera::deformation
