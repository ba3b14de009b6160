#include <memory>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include "viscera/core/error.h"
#include "viscera/geometry/coarse_triangles.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/scene/organ_actor.h"

#include "shapes.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

std::shared_ptr<geometry::TriangleMesh> ball(int levels = 3) {
  return std::make_shared<geometry::TriangleMesh>(tests::sphere(levels, 40));
}

const void* pointsSeen(const OrganActor& actor) {
  return actor.polyData()->GetPoints()->GetVoidPointer(0);
}

geometry::Normals normalsSeen(const OrganActor& actor) {
  auto* seen = actor.polyData()->GetPointData()->GetNormals();
  return Eigen::Map<const geometry::Normals>(static_cast<const float*>(seen->GetVoidPointer(0)),
                                             seen->GetNumberOfTuples(), 3);
}

TEST(OrganActor, VtkLooksAtTheMeshItself) {
  auto mesh = ball();
  mesh->colors = Colors::Constant(mesh->points.rows(), 3, 90);
  const OrganActor actor(mesh);
  auto* data = actor.polyData();
  EXPECT_EQ(pointsSeen(actor), mesh->points.data());
  EXPECT_EQ(data->GetPolys()->GetConnectivityArray()->GetVoidPointer(0), mesh->triangles.data());
  EXPECT_EQ(data->GetPointData()->GetNormals()->GetVoidPointer(0), actor.normals().data());
  EXPECT_EQ(data->GetPointData()->GetArray("colors")->GetVoidPointer(0), mesh->colors.data());
  EXPECT_EQ(data->GetNumberOfPoints(), mesh->points.rows());
  EXPECT_EQ(data->GetNumberOfPolys(), mesh->triangles.rows());
}

TEST(OrganActor, VtkLooksAtTheNumbersThatColourIt) {
  OrganActor actor(ball());
  const auto values = std::make_shared<Values>(Values::LinSpaced(actor.mesh().points.rows(), 0, 1));
  actor.showScalars(values, viridis(), {0, 1});
  EXPECT_EQ(actor.polyData()->GetPointData()->GetArray("values")->GetVoidPointer(0), values->data());
  EXPECT_TRUE(actor.scalarsShown());
  actor.hideScalars();
  EXPECT_EQ(actor.polyData()->GetPointData()->GetArray("values"), nullptr);
}

TEST(OrganActor, IsDrawnWithFewerTrianglesOnTheSamePointsAndWholeAgain) {
  const auto mesh = ball(5);
  OrganActor actor(mesh);
  actor.setCoarse(8);
  const vtkIdType few = actor.polyData()->GetNumberOfPolys();
  EXPECT_LT(few, mesh->triangles.rows() / 4);
  EXPECT_GT(few, mesh->triangles.rows() / 16);
  EXPECT_EQ(pointsSeen(actor), mesh->points.data());
  actor.setCoarse(1);
  EXPECT_EQ(actor.polyData()->GetNumberOfPolys(), mesh->triangles.rows());
}

TEST(OrganActor, CanBeThePictureOfAnotherOneWhichThenIsMetWithoutBeingDrawn) {
  tests::ViewInWindow window(200, 200);
  const auto body = window.addOrgan(tests::sphere(3, 40)), picture = window.addOrgan(tests::sphere(3, 50));
  body->setColor({1, 0, 0});
  picture->setColor({0, 1, 0});
  picture->setRole(SurfaceRole::picture);
  body->setRole(SurfaceRole::body);
  EXPECT_TRUE(body->met() && !body->drawn() && !picture->met() && picture->drawn());
  window.view.lookFrom(StandardView::anterior);
  window.render();
  const auto hit = window.view.pick(100, 100);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->organ, body.get());
  body->setOpacity(0.3);
  picture->setVisible(false);
  EXPECT_FALSE(window.view.isSlow()) << "what is not drawn is not peeled";
  body->setRole(SurfaceRole::whole);
  EXPECT_TRUE(body->met() && body->drawn());
}

/// A heart that beats is drawn with half of its triangles for as long as a class looks at it.
TEST(OrganActor, HalfOfItsTrianglesAreAClosedSurfaceNearItsOwn) {
  const auto mesh = ball(4);
  OrganActor actor(mesh);
  actor.setCoarse(2);
  Triangles half(actor.polyData()->GetNumberOfPolys(), 3);
  for (vtkIdType t = 0; t < half.rows(); ++t) {
    const vtkIdType* corners = nullptr;
    vtkIdType count = 0;
    actor.polyData()->GetPolys()->GetCellAtId(t, count, corners);
    ASSERT_EQ(count, 3);
    half.row(t) << std::int32_t(corners[0]), std::int32_t(corners[1]), std::int32_t(corners[2]);
  }
  EXPECT_NEAR(double(half.rows()), 0.5 * double(mesh->triangles.rows()), 2);
  const geometry::SurfaceReport report = geometry::checkSurface({mesh->points, half, {}});
  EXPECT_TRUE(report.manifold() && report.outward());
  const double whole = geometry::checkSurface(*mesh).volumeMm3;
  EXPECT_NEAR(report.volumeMm3, whole, 0.01 * whole);
}

TEST(OrganActor, ItsFewTrianglesAreLitByTheirOwnNormalsWhereItFolds) {
  const auto mesh = ball(5);
  OrganActor actor(mesh);
  actor.setCoarse(8);
  auto posed = std::make_shared<Points>(mesh->points);
  actor.setPoints(posed);
  const Triangles few = geometry::coarseTriangles(*mesh, mesh->points.rows() / 8);
  for (const double fold : {10.0, 30.0}) {
    posed->col(0) =
        (mesh->points.col(0).array() + fold * (0.25 * mesh->points.col(2).array()).sin()).matrix();
    actor.pointsChanged();
    const geometry::Normals whole = geometry::vertexNormals({*posed, mesh->triangles, {}});
    const geometry::Normals own = geometry::vertexNormals({*posed, few, {}});
    EXPECT_TRUE(normalsSeen(actor) == own);
    EXPECT_TRUE(actor.normals() == whole) << "who asks for places on the organ is told of all of it";
    EXPECT_TRUE(normalsSeen(actor) == own) << "and the picture stays";
    actor.setCoarse(1);
    EXPECT_TRUE(normalsSeen(actor) == whole);
    actor.setCoarse(8);
    EXPECT_TRUE(normalsSeen(actor) == own);
  }
}

TEST(OrganActor, FollowsThePosedPointsWithoutCopyEvenWhenTheyMoveInMemory) {
  const auto mesh = ball();
  OrganActor actor(mesh);
  auto posed = std::make_shared<Points>(2.0 * mesh->points);
  actor.setPoints(posed);
  EXPECT_EQ(pointsSeen(actor), posed->data());
  EXPECT_NEAR(actor.polyData()->GetBounds()[1], 80, 1e-12);

  *posed = Points(3.0 * mesh->points);
  Points elsewhere = *posed;
  posed->swap(elsewhere);
  actor.pointsChanged();
  EXPECT_EQ(pointsSeen(actor), posed->data());
  EXPECT_NEAR(actor.polyData()->GetBounds()[1], 120, 1e-12);

  actor.setPoints(nullptr);
  EXPECT_EQ(pointsSeen(actor), mesh->points.data());
}

TEST(OrganActor, NormalsAreThoseOfThePointsAsTheyAreNow) {
  const auto mesh = ball();
  OrganActor actor(mesh);
  auto posed = std::make_shared<Points>(mesh->points);
  actor.setPoints(posed);
  posed->col(2) *= 0.25;
  actor.pointsChanged();
  EXPECT_EQ(actor.normals(), geometry::vertexNormals({*posed, mesh->triangles, {}}));
}

TEST(OrganActor, KeepsWhatItDrawsAlive) {
  auto mesh = ball();
  const double x = mesh->points(5, 0);
  const OrganActor actor(std::move(mesh));
  EXPECT_EQ(static_cast<const double*>(pointsSeen(actor))[15], x);
}

TEST(OrganActor, RefusesPointsAndNumbersOfAnotherCount) {
  OrganActor actor(ball());
  EXPECT_THROW(actor.setPoints(std::make_shared<Points>(3, 3)), UsageError);
  EXPECT_THROW(actor.showScalars(std::make_shared<Values>(7), viridis(), {0, 1}), UsageError);
}

TEST(OrganActor, LeavesOutTheInsideOnlyWhenItCannotBeSeen) {
  OrganActor actor(ball());
  const Vec3 outside(0, -300, 0), inside(0, 0, 0);
  const auto culls = [&](const Vec3& eye) {
    actor.cullBackFaces(eye);
    return actor.actor()->GetProperty()->GetBackfaceCulling() != 0;
  };
  EXPECT_TRUE(culls(outside));
  EXPECT_FALSE(culls(inside));
  actor.setOpacity(0.5);
  EXPECT_FALSE(culls(outside));
  actor.setOpacity(1);
  actor.setClipPlane(Vec3::Zero(), Vec3::UnitX());
  EXPECT_FALSE(culls(outside));
  actor.clearClipPlane();
  EXPECT_TRUE(culls(outside));

  auto open = ball();
  open->triangles.conservativeResize(open->triangles.rows() - 1, 3);
  OrganActor hole(open);
  hole.cullBackFaces(outside);
  EXPECT_FALSE(hole.actor()->GetProperty()->GetBackfaceCulling());

  auto inward = ball();
  inward->triangles.col(0).swap(inward->triangles.col(1));
  OrganActor turned(inward);
  turned.cullBackFaces(outside);
  EXPECT_FALSE(turned.actor()->GetProperty()->GetBackfaceCulling());
}

} // namespace
} // namespace viscera::scene
