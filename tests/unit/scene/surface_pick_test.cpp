#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>

#include "viscera/scene/surface_pick.h"

#include "shapes.h"
#include "view_fixture.h"

#include "ray_mesh.h"

namespace viscera::scene {
namespace {

OrganActor ballOrgan(double radius, const Vec3& center = Vec3::Zero()) {
  return OrganActor(std::make_shared<const geometry::TriangleMesh>(tests::sphere(4, radius, center)));
}

TEST(SurfacePick, AnswersPositionNormalAndVertexOnTheNearSide) {
  OrganActor organ = ballOrgan(50);
  const Ray ray{Vec3(11, -200, 7), Vec3::UnitY()};
  const auto pick = pickSurface(ray, {&organ});
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->organ, &organ);
  EXPECT_LT((pick->position - Vec3(11, pick->position.y(), 7)).norm(), 1e-9)
      << "the position lies on the ray";
  EXPECT_LT(pick->position.y(), 0);
  EXPECT_NEAR(pick->position.norm(), 50, 0.3) << "facets lie a little inside the ball";
  EXPECT_GT(pick->normal.dot(pick->position.normalized()), 0.999);
  EXPECT_NEAR(pick->distance, (pick->position - ray.origin).norm(), 1e-9);
  EXPECT_NEAR(pick->weights[0] + pick->weights[1] + pick->weights[2], 1, 1e-12);
  const auto corners = organ.mesh().triangles.row(pick->triangle);
  double nearest = 1e9;
  for (int c = 0; c < 3; ++c)
    nearest = std::min(nearest, (organ.points().row(corners[c]).transpose() - pick->position).norm());
  EXPECT_NEAR((organ.points().row(pick->vertex).transpose() - pick->position).norm(), nearest, 0.5);
}

TEST(SurfacePick, TakesTheNearestVisibleOrgan) {
  OrganActor far = ballOrgan(20, {0, 100, 0}), near = ballOrgan(20);
  const Ray ray{Vec3(0.3, -200, 0.2), Vec3::UnitY()};
  EXPECT_EQ(pickSurface(ray, {&far, &near})->organ, &near);
  near.setVisible(false);
  EXPECT_EQ(pickSurface(ray, {&far, &near})->organ, &far);
}

TEST(SurfacePick, GoesThroughPicturesAndMeetsBodies) {
  OrganActor far = ballOrgan(20, {0, 100, 0}), near = ballOrgan(20);
  const Ray ray{Vec3(0.3, -200, 0.2), Vec3::UnitY()};
  near.setRole(SurfaceRole::picture);
  EXPECT_EQ(pickSurface(ray, {&far, &near})->organ, &far);
  near.setRole(SurfaceRole::body);
  EXPECT_EQ(pickSurface(ray, {&far, &near})->organ, &near);
}

TEST(SurfacePick, MissesAndLooksOnlyForward) {
  OrganActor organ = ballOrgan(20);
  EXPECT_FALSE(pickSurface({Vec3(30, -200, 0), Vec3::UnitY()}, {&organ}));
  EXPECT_FALSE(pickSurface({Vec3(0.1, 200, 0.1), Vec3::UnitY()}, {&organ}));
  EXPECT_FALSE(pickSurface({Vec3(0, -200, 0), Vec3::UnitY()}, {}));
}

TEST(SurfacePick, GoesThroughWhatTheClipPlaneCutsAway) {
  OrganActor organ = ballOrgan(50);
  organ.setClipPlane(Vec3::Zero(), Vec3::UnitY());
  const auto pick = pickSurface({Vec3(0.3, -200, 0.2), Vec3::UnitY()}, {&organ});
  ASSERT_TRUE(pick);
  EXPECT_GT(pick->position.y(), 49);
}

TEST(SurfacePick, SeesThePosedSurface) {
  OrganActor organ = ballOrgan(50);
  organ.setPoints(std::make_shared<Points>(0.5 * organ.mesh().points));
  EXPECT_NEAR(pickSurface({Vec3(0.1, -200, 0.1), Vec3::UnitY()}, {&organ})->position.y(), -25, 0.1);
}

TEST(SurfacePick, TellsWhichOrganHidesAnother) {
  tests::ViewInWindow window(300, 200);
  const auto inside = window.addOrgan(tests::sphere(3, 20));
  const auto wall = window.addOrgan(tests::sphere(3, 40));
  window.view.lookFrom(StandardView::anterior);
  EXPECT_EQ(window.view.coverOf(*inside), wall.get());
  EXPECT_EQ(window.view.coverOf(*wall), nullptr);
  wall->setOpacity(0.5);
  EXPECT_EQ(window.view.coverOf(*inside), nullptr) << "one looks through it";
  wall->setOpacity(1);
  wall->setClipPlane(Vec3::Zero(), Vec3::UnitY());
  EXPECT_EQ(window.view.coverOf(*inside), nullptr) << "its front is cut away";
  wall->clearClipPlane();
  inside->setVisible(false);
  EXPECT_EQ(window.view.coverOf(*inside), nullptr) << "it is hidden by nobody";
  inside->setVisible(true);
  wall->setPoints(std::make_shared<Points>(wall->mesh().points.rowwise() + Vec3(40, -60, 0).transpose()));
  EXPECT_EQ(window.view.coverOf(*inside), nullptr) << "a part of it looks out from behind";
}

TEST(SurfacePick, HitsExactlyWhatIsDrawnUnderThePixel) {
  tests::ViewInWindow window(300, 200);
  window.addOrgan(tests::sphere(4, 50));
  window.view.lookFrom(StandardView::left);
  window.view.renderer()->GetActiveCamera()->Azimuth(20);
  const auto center = window.display(Vec3::Zero());
  const auto pick = window.view.pick(center[0] + 31, center[1] - 17);
  ASSERT_TRUE(pick);
  const auto at = window.display(pick->position);
  EXPECT_NEAR(at[0], center[0] + 31, 1e-6);
  EXPECT_NEAR(at[1], center[1] - 17, 1e-6);
  EXPECT_FALSE(window.view.pick(2, 2));
}

TEST(RayMesh, AnswerDoesNotDependOnTheNumberOfThreads) {
  const auto mesh = tests::sphere(7, 50); // 131,072 triangles: several blocks
  OrganActor organ(std::make_shared<const geometry::TriangleMesh>(mesh));
  const ActorMesh view(organ.actor());
  for (const double x : {0.0, 3.7, 21.1}) {
    const Ray ray{Vec3(x, -200, 0.5 * x), Vec3::UnitY()};
    const auto one = nearestHit(ray, view.view(), 1e9, {1}), many = nearestHit(ray, view.view(), 1e9, {4});
    ASSERT_TRUE(one && many);
    EXPECT_EQ(one->triangle, many->triangle);
    EXPECT_EQ(one->distance, many->distance);
  }
}

TEST(RayMesh, ReadsVtksOwnSurfacesToo) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(30);
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->Update();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const ActorMesh mesh(actor);
  const auto hit = nearestHit({Vec3(1, -100, 2), Vec3::UnitY()}, mesh.view());
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 70, 0.5);
  vtkNew<vtkActor> empty;
  EXPECT_FALSE(nearestHit({Vec3(0, -100, 0), Vec3::UnitY()}, ActorMesh(empty).view()));
}

} // namespace
} // namespace viscera::scene
