#include <cmath>

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include "viscera/core/error.h"
#include "viscera/geometry/normals.h"
#include "viscera/scene/ghost_outline.h"
#include "viscera/scene/picture.h"

#include "shapes.h"
#include "view_fixture.h"

#include "silhouette.h"

namespace viscera::scene {
namespace {

TEST(Silhouette, OfABallSeenFromFarAwayIsItsGreatCircle) {
  const auto mesh = tests::sphere(5, 10);
  ViewGeometry view;
  view.parallel = true;
  std::vector<float> segments;
  silhouette(mesh, geometry::vertexNormals(mesh), view, segments);
  ASSERT_GT(segments.size(), 6U * 50);
  double length = 0;
  for (std::size_t i = 0; i < segments.size(); i += 6) {
    const Eigen::Map<const Eigen::Vector3f> a(&segments[i]), b(&segments[i + 3]);
    EXPECT_NEAR(a.y(), 0, 0.05);
    EXPECT_NEAR(a.norm(), 10, 0.05);
    length += (a - b).norm();
  }
  EXPECT_NEAR(length, 2 * M_PI * 10, 0.1);
}

TEST(Silhouette, SeenFromNearbyIsTheCircleOfTouchingRays) {
  const auto mesh = tests::sphere(5, 10);
  ViewGeometry view;
  view.eye = Vec3(0, -20, 0);
  std::vector<float> segments;
  silhouette(mesh, geometry::vertexNormals(mesh), view, segments);
  ASSERT_FALSE(segments.empty());
  for (std::size_t i = 0; i < segments.size(); i += 3)
    EXPECT_NEAR(segments[i + 1], -5, 0.1) << "the tangent circle is at r^2 / d from the centre";
}

TEST(DepthGrid, HidesWhatIsBehindTheSurfaceAndNotItsOwnEdge) {
  const auto mesh = tests::sphere(5, 10);
  ViewGeometry view;
  view.eye = Vec3(0, -100, 0);
  view.halfHeight = 0.2;
  view.centerX = view.centerY = 500;
  view.pixelHeight = 1000;
  const DepthGrid grid(mesh, view, 200);
  EXPECT_FALSE(grid.sees({0, 10, 0}, 0.2));
  EXPECT_FALSE(grid.sees({5, 30, 4}, 0.2));
  EXPECT_TRUE(grid.sees({0, -10, 0}, 0.2));
  EXPECT_TRUE(grid.sees({9.95, -1, 0}, 0.2)) << "its edge";
  EXPECT_TRUE(grid.sees({30, 30, 0}, 0.2)) << "beside it";
  EXPECT_FALSE(grid.sees({0, -200, 0}, 0.2)) << "behind the eye";
}

TEST(GhostOutline, IsDrawnAroundTheRestShapeAndGoesWhenHidden) {
  tests::ViewInWindow window(200, 150);
  window.addOrgan(tests::sphere(4, 25));
  const auto rest = std::make_shared<const geometry::TriangleMesh>(tests::sphere(4, 40));
  const auto ghost = std::make_shared<GhostOutline>(rest);
  window.view.lookFrom(StandardView::anterior, boundsOf(rest->points));
  const auto without = grabPicture(window.surface.window());
  ghost->setRenderer(window.view.renderer());
  const auto with = grabPicture(window.surface.window());
  const double part = comparePictures(without, with).differing;
  EXPECT_GT(part, 0.005);
  EXPECT_LT(part, 0.1) << "a thin line";
  ghost->setVisible(false);
  EXPECT_EQ(comparePictures(without, grabPicture(window.surface.window())).differing, 0);
  ghost->setRenderer(nullptr);
}

/// The mark of the selected organ.
TEST(GhostOutline, IsHiddenByOpaqueOrgansInFrontUnlessItIsSeenThrough) {
  const auto differing = [](double radius, bool through) {
    tests::ViewInWindow window(200, 150);
    window.addOrgan(tests::sphere(4, 40, Vec3(0, -60, 0)));
    const auto marked = std::make_shared<const geometry::TriangleMesh>(tests::sphere(4, radius));
    GhostOutline outline(marked);
    outline.setColor(Vec3(1, 1, 1));
    outline.setOpacity(1);
    outline.setSeenThrough(through);
    window.view.lookFrom(StandardView::anterior, boundsOf(tests::sphere(2, 70).points));
    const auto without = grabPicture(window.surface.window());
    outline.setRenderer(window.view.renderer());
    const double part = comparePictures(without, grabPicture(window.surface.window())).differing;
    outline.setRenderer(nullptr);
    return part;
  };
  EXPECT_EQ(differing(20, false), 0) << "it is wholly behind the other organ";
  EXPECT_GT(differing(20, true), 0) << "as the rest shape behind a pose is";
  EXPECT_GT(differing(65, false), 0.002) << "around the other organ";
}

TEST(GhostOutline, GoesWhereItsPointsGo) {
  tests::ViewInWindow window(200, 150);
  const auto rest = std::make_shared<const geometry::TriangleMesh>(tests::sphere(4, 20));
  const auto posed = std::make_shared<const geometry::TriangleMesh>(tests::sphere(4, 40));
  const auto drawn = [&](const auto& mesh, bool pose) {
    GhostOutline outline(mesh);
    if (pose)
      outline.setPoints(posed->points, geometry::vertexNormals(*posed));
    outline.setRenderer(window.view.renderer());
    window.view.lookFrom(StandardView::anterior, boundsOf(posed->points));
    return grabPicture(window.surface.window());
  };
  EXPECT_EQ(comparePictures(drawn(rest, true), drawn(posed, false)).differing, 0);
  EXPECT_GT(comparePictures(drawn(rest, false), drawn(posed, false)).differing, 0.002);
  GhostOutline outline(rest);
  EXPECT_THROW(outline.setPoints(Points::Zero(3, 3), geometry::Normals::Zero(3, 3)), UsageError);
}

} // namespace
} // namespace viscera::scene
