#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "viscera/core/error.h"
#include "viscera/scene/label_layout.h"
#include "viscera/scene/picture.h"

#include "shapes.h"
#include "view_fixture.h"

#include "view_furniture.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

using tests::ViewInWindow;

/// Where the patient's left, back and head are in a picture: x right, y up, and towards the reader.
struct Expected {
  StandardView view;
  Vec3 left, back, head;
};

class AnatomicalView : public testing::TestWithParam<Expected> {};

TEST_P(AnatomicalView, PutsThePatientsSidesWhereDoctorsExpectThem) {
  ViewInWindow window(300, 300);
  window.view.lookFrom(GetParam().view, {Vec3::Constant(-50), Vec3::Constant(50)});
  const auto center = window.display(Vec3::Zero());
  const auto seen = [&](const Vec3& direction) {
    const auto at = window.display(20 * direction);
    const double nearer = center[2] - at[2];
    return Vec3(at[0] - center[0], at[1] - center[1],
                std::abs(nearer) > 1e-9 ? std::copysign(50, nearer) : 0);
  };
  const auto points = [](const Vec3& seenDirection, const Vec3& wanted) {
    return seenDirection.normalized().dot(wanted) > 0.9;
  };
  EXPECT_TRUE(points(seen(Vec3::UnitX()), GetParam().left)) << seen(Vec3::UnitX()).transpose();
  EXPECT_TRUE(points(seen(Vec3::UnitY()), GetParam().back)) << seen(Vec3::UnitY()).transpose();
  EXPECT_TRUE(points(seen(Vec3::UnitZ()), GetParam().head)) << seen(Vec3::UnitZ()).transpose();
}

const Vec3 kRight = Vec3::UnitX(), kUp = Vec3::UnitY(), kNear = Vec3::UnitZ();
INSTANTIATE_TEST_SUITE_P(All, AnatomicalView,
                         testing::Values(Expected{StandardView::anterior, kRight, -kNear, kUp},
                                         Expected{StandardView::posterior, -kRight, kNear, kUp},
                                         Expected{StandardView::left, kNear, kRight, kUp},
                                         Expected{StandardView::right, -kNear, -kRight, kUp},
                                         Expected{StandardView::superior, -kRight, -kUp, kNear},
                                         Expected{StandardView::inferior, kRight, -kUp, -kNear}),
                         [](const auto& parameters) { return nameOf(parameters.param.view); });

TEST(OrganView, MarkerOnThePatientsLeftIsDrawnOnTheRightOfAnAnteriorPicture) {
  ViewInWindow window(200, 150);
  window.addOrgan(tests::sphere(3, 15, {40, 0, 0}))->setColor({1, 0, 0});
  window.addOrgan(tests::sphere(3, 15, {-40, 0, 0}))->setColor({0, 0, 1});
  window.view.lookFrom(StandardView::anterior);
  const auto picture = grabPicture(window.surface.window());
  double redX = 0, blueX = 0;
  int red = 0, blue = 0;
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 200; ++x) {
      const auto* p = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
      if (p[0] > 120 && p[2] < 60)
        ++red, redX += x;
      if (p[2] > 120 && p[0] < 60)
        ++blue, blueX += x;
    }
  ASSERT_GT(red, 100);
  ASSERT_GT(blue, 100);
  EXPECT_GT(redX / red, 130);
  EXPECT_LT(blueX / blue, 70);
}

TEST(OrganView, FramesTheWholeOrganAndFillsThePictureInAnyShapeOfWindow) {
  for (const auto& [width, height] : {std::pair{600, 200}, std::pair{200, 600}, std::pair{400, 400}})
    for (const bool parallel : {false, true}) {
      ViewInWindow window(width, height);
      window.view.renderer()->GetActiveCamera()->SetParallelProjection(parallel);
      window.addOrgan(tests::box(120, 60, 30));
      for (const auto view : {StandardView::anterior, StandardView::left, StandardView::superior}) {
        window.view.lookFrom(view);
        double most = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const auto at =
              window.display(Vec3(corner & 1 ? 120 : 0, corner & 2 ? 60 : 0, corner & 4 ? 30 : 0));
          most = std::max({most, std::abs(at[0] / width - 0.5), std::abs(at[1] / height - 0.5)});
        }
        EXPECT_LT(most, 0.5) << nameOf(view);
        EXPECT_GT(most, 0.4) << nameOf(view);
      }
    }
}

TEST(OrganView, WhatIsWhollySeenStaysSoInANarrowerViewAndTheCameraComesBack) {
  for (const bool parallel : {false, true}) {
    ViewInWindow window(400, 200);
    window.addOrgan(tests::box(120, 60, 90));
    auto* camera = window.view.renderer()->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    window.view.lookFrom(StandardView::anterior);
    window.render();
    const Vec3 eye(camera->GetPosition());
    const double scale = camera->GetParallelScale();
    window.surface.window()->SetSize(100, 200);
    window.render();
    for (int corner = 0; corner < 8; ++corner) {
      const auto at = window.display(Vec3(corner & 1 ? 120 : 0, corner & 2 ? 60 : 0, corner & 4 ? 90 : 0));
      EXPECT_TRUE(at[0] > 0 && at[0] < 100) << at[0];
      EXPECT_TRUE(at[1] > 0 && at[1] < 200) << at[1];
    }
    window.surface.window()->SetSize(400, 200);
    window.render();
    EXPECT_EQ(Vec3(camera->GetPosition()), eye);
    EXPECT_EQ(camera->GetParallelScale(), scale);
  }
}

TEST(OrganView, AnOrganLiesBesideTheLegendOfANarrowViewAndIsAsLargeAsBeforeWithoutIt) {
  for (const bool framed : {false, true}) {
    ViewInWindow window(270, 400);
    window.addOrgan(tests::box(120, 60, 160));
    auto* camera = window.view.renderer()->GetActiveCamera();
    window.view.lookFrom(StandardView::anterior);
    window.render();
    const Vec3 eye(camera->GetPosition());
    window.view.legend().show("Stress", "deg", viridis(), {0, 1});
    if (framed)
      window.view.frame();
    window.render();
    for (int corner = 0; corner < 8; ++corner) {
      const auto at = window.display(Vec3(corner & 1 ? 120 : 0, corner & 2 ? 60 : 0, corner & 4 ? 160 : 0));
      EXPECT_TRUE(at[0] > 0 && at[0] < 270) << at[0];
      EXPECT_TRUE(at[1] > kLevelLegend && at[1] < 400 - kLevelLegend) << at[1];
    }
    window.view.legend().hide();
    window.render();
    EXPECT_EQ(Vec3(camera->GetPosition()) == eye, !framed);
  }
}

/// Where the corners of a box from the origin lie in the view: device pixels.
ScreenBox cornersOf(ViewInWindow& window, const Vec3& size) {
  ScreenBox seen{1e9, 1e9, -1e9, -1e9};
  for (int corner = 0; corner < 8; ++corner) {
    const auto at =
        window.display(Vec3(corner & 1 ? size.x() : 0, corner & 2 ? size.y() : 0, corner & 4 ? size.z() : 0));
    seen = {std::min(seen.left, at[0]), std::min(seen.bottom, at[1]), std::max(seen.right, at[0]),
            std::max(seen.top, at[1])};
  }
  return seen;
}

TEST(OrganView, AnOrganLiesBesideTheUprightLegendWhetherItIsFramedBeforeOrAfter) {
  constexpr double kBar = 76; // From its left edge to the view's right one.
  for (const double ratio : {1.0, 2.0})
    for (const bool rendered : {false, true})
      for (const bool framed : {false, true}) {
        ViewInWindow window(static_cast<int>(500 * ratio), static_cast<int>(400 * ratio), ratio);
        window.addOrgan(tests::box(160, 60, 60));
        auto* camera = window.view.renderer()->GetActiveCamera();
        window.view.lookFrom(StandardView::anterior);
        const Vec3 eye(camera->GetPosition());
        if (rendered)
          window.render();
        window.view.legend().show("Stress", "deg", viridis(), {0, 1});
        if (framed)
          window.view.frame();
        window.render();
        const ScreenBox seen = cornersOf(window, {160, 60, 60});
        EXPECT_LT(seen.right, ratio * (500 - kBar)) << ratio << rendered << framed;
        EXPECT_GT(seen.width(), 0.5 * ratio * 500) << "as large as there is room";
        window.view.legend().hide();
        window.render();
        EXPECT_EQ(Vec3(camera->GetPosition()) == eye, !framed);
      }
}

TEST(OrganView, ACameraThatWasKeptWithALegendIsNotMovedWhenThatIsDrawn) {
  for (const bool kept : {true, false}) {
    ViewInWindow window(500, 400);
    window.addOrgan(tests::box(160, 60, 60));
    auto* camera = window.view.renderer()->GetActiveCamera();
    window.view.lookFrom(StandardView::anterior);
    const Vec3 eye(camera->GetPosition());
    if (kept)
      window.view.expectLegend();
    window.render();
    EXPECT_EQ(Vec3(camera->GetPosition()), eye);
    window.view.legend().show("Stress", "deg", viridis(), {0, 1});
    window.render();
    EXPECT_EQ(Vec3(camera->GetPosition()) == eye, kept);
  }
}

TEST(OrganView, TheMarkOfALegendThatComesLaterLiesBesideTheOrganToo) {
  for (const double ratio : {1.0, 2.0}) {
    ViewInWindow window(static_cast<int>(270 * ratio), static_cast<int>(400 * ratio), ratio);
    window.addOrgan(tests::box(120, 60, 160));
    auto* camera = window.view.renderer()->GetActiveCamera();
    window.view.lookFrom(StandardView::anterior);
    window.view.legend().show("Stress", "deg", viridis(), {0, 1});
    window.view.frame();
    window.render();
    const Vec3 before(camera->GetPosition());
    window.view.legend().setMark("folded", {1, 0, 1});
    window.render();
    EXPECT_LT(cornersOf(window, {120, 60, 160}).top, ratio * (400 - kLevelMarkedLegend)) << ratio;
    const Vec3 marked(camera->GetPosition());
    EXPECT_NE(marked, before);
    window.view.legend().show("Stress", "deg", viridis(), {0, 2});
    window.view.legend().setMark("", {1, 0, 1});
    window.render();
    EXPECT_EQ(Vec3(camera->GetPosition()), marked) << "what folds in a part of a cycle moves nothing in it";
    window.view.legend().hide();
    window.render();
    EXPECT_EQ(Vec3(camera->GetPosition()), before);
  }
}

TEST(OrganView, ACameraThatWasPutSomewhereStaysThereInAViewOfAnotherShape) {
  ViewInWindow window(400, 200);
  window.addOrgan(tests::box(120, 60, 90));
  auto* camera = window.view.renderer()->GetActiveCamera();
  const auto staysFrom = [&](int width, int otherWidth) {
    window.surface.window()->SetSize(width, 200);
    window.render();
    const Vec3 eye(camera->GetPosition());
    window.surface.window()->SetSize(otherWidth, 200);
    window.render();
    return eye == Vec3(camera->GetPosition());
  };
  window.view.lookFrom(StandardView::anterior);
  camera->Dolly(3);
  EXPECT_TRUE(staysFrom(400, 100)) << "it saw a part of the organ";
  window.surface.window()->SetSize(400, 200);
  window.view.lookFrom(StandardView::anterior);
  EXPECT_FALSE(staysFrom(400, 100));
  camera->Azimuth(30);
  EXPECT_TRUE(staysFrom(100, 400)) << "it was moved in the narrow view";
}

TEST(OrganView, TheCameraDependsOnTheShapeOfTheViewAndNotOnTheFramesThatWereDrawn) {
  const auto eyeAfter = [](bool drawn) {
    ViewInWindow window(400, 200);
    window.addOrgan(tests::box(120, 60, 90));
    window.view.lookFrom(StandardView::anterior);
    const auto change = [&](const auto& something) {
      something();
      for (int frame = 0; drawn && frame < 2; ++frame)
        window.render();
    };
    change([] {});
    change([&] { window.surface.window()->SetSize(100, 200); });
    change([&] { window.view.legend().show("Stress", "deg", viridis(), {0, 1}); });
    change([&] { window.surface.window()->SetSize(150, 200); });
    window.render();
    return Vec3(window.view.renderer()->GetActiveCamera()->GetPosition());
  };
  EXPECT_EQ(eyeAfter(true), eyeAfter(false));
}

TEST(OrganView, FrameKeepsTheDirectionOfSight) {
  ViewInWindow window;
  window.addOrgan(tests::sphere(2, 40));
  auto* camera = window.view.renderer()->GetActiveCamera();
  camera->Azimuth(33);
  camera->Elevation(12);
  const Vec3 before(camera->GetDirectionOfProjection());
  window.view.frame({Vec3(100, 100, 100), Vec3(130, 140, 150)});
  EXPECT_LT((Vec3(camera->GetDirectionOfProjection()) - before).norm(), 1e-12);
  EXPECT_LT((Vec3(camera->GetFocalPoint()) - Vec3(115, 120, 125)).norm(), 1e-9);
}

TEST(OrganView, OurProjectionAgreesWithVtks) {
  ViewInWindow window(640, 300);
  window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-80), Vec3::Constant(80)});
  auto* camera = window.view.renderer()->GetActiveCamera();
  camera->Azimuth(21);
  camera->Roll(17);
  for (const bool parallel : {false, true}) {
    camera->SetParallelProjection(parallel);
    const auto view = viewGeometry(window.view.renderer());
    for (const Vec3& point : {Vec3(10, -30, 44), Vec3(-60, 20, -7), Vec3(0, 0, 0)}) {
      const auto ours = view.project(point);
      const auto vtks = window.display(point);
      EXPECT_NEAR(ours.x, vtks[0], 1e-6);
      EXPECT_NEAR(ours.y, vtks[1], 1e-6);
      EXPECT_LT((view.unproject(ours.x, ours.y, ours.depth) - point).norm(), 1e-9);
    }
  }
}

TEST(OrganView, TranslucentOrgansAreDrawnAlthoughEdgesAreSmoothed) {
  ViewInWindow window(200, 150);
  const auto organ = window.addOrgan(tests::sphere(4, 40));
  window.view.lookFrom(StandardView::anterior);
  organ->setVisible(false);
  const auto empty = grabPicture(window.surface.window());
  organ->setVisible(true);
  organ->setOpacity(0.5);
  EXPECT_GT(comparePictures(empty, grabPicture(window.surface.window())).differing, 0.1);
}

TEST(OrganView, SoftwareRenderersSmoothEdgesOnlyWhenNothingMoves) {
  ViewInWindow window(200, 150);
  window.addOrgan(tests::sphere(4, 40));
  window.render();
  if (!rendersInSoftware(window.surface.window()))
    GTEST_SKIP() << "a graphics processor draws here";
  window.view.setMoving(true);
  window.render();
  EXPECT_EQ(window.surface.window()->GetMultiSamples(), 0);
  window.view.setMoving(false);
  window.render();
  EXPECT_GT(window.surface.window()->GetMultiSamples(), 1);
}

TEST(OrganView, AQuickFrameOfManyVerticesHasFewerTrianglesAndNoSmoothEdges) {
  ViewInWindow window(200, 150);
  const auto large = window.addOrgan(tests::sphere(7, 40));
  window.render();
  if (!rendersInSoftware(window.surface.window()))
    GTEST_SKIP() << "a graphics processor draws here";
  EXPECT_TRUE(window.view.isSlow());
  const auto whole = grabPicture(window.surface.window());
  window.view.setFastDrawing(true);
  window.render();
  EXPECT_EQ(window.surface.window()->GetMultiSamples(), 0);
  EXPECT_LT(large->polyData()->GetNumberOfPolys(), 2 * 16000) << "more are too small to be told apart";
  window.view.setFastDrawing(false);
  EXPECT_EQ(comparePictures(whole, grabPicture(window.surface.window()), 0).differing, 0);
  EXPECT_GT(window.surface.window()->GetMultiSamples(), 1);
  large->setVisible(false);
  EXPECT_FALSE(window.view.isSlow());
}

TEST(OrganView, AQuickFrameHasAllTrianglesWhereThatShortcutIsOff) {
  ViewInWindow window(200, 150);
  const auto large = window.addOrgan(tests::sphere(7, 40));
  window.view.setShortcuts({.fewerTriangles = false});
  window.view.setMoving(true);
  window.render();
  EXPECT_EQ(large->polyData()->GetNumberOfPolys(), large->mesh().triangles.rows());
  if (!rendersInSoftware(window.surface.window()))
    GTEST_SKIP() << "a graphics processor draws here";
  window.view.setShortcuts({});
  window.render();
  EXPECT_LT(large->polyData()->GetNumberOfPolys(), large->mesh().triangles.rows() / 2);
}

TEST(OrganView, ShowsTheTrianglesOfOrgansWhereThatIsWantedAndNoneOfThemAfterwards) {
  ViewInWindow window(240, 180);
  window.addOrgan(tests::sphere(2, 40));
  window.view.lookFrom(StandardView::anterior);
  const auto smooth = grabPicture(window.surface.window());
  window.view.setMeshLook({.edges = true});
  EXPECT_GT(comparePictures(smooth, grabPicture(window.surface.window()), 30).differing, 0.02);
  window.view.setMeshLook({.flat = true});
  EXPECT_GT(comparePictures(smooth, grabPicture(window.surface.window()), 8).differing, 0.02);
  window.view.setMeshLook({});
  EXPECT_EQ(comparePictures(smooth, grabPicture(window.surface.window()), 0).differing, 0);
}

TEST(OrganView, AQuickFrameWithFewerTrianglesHasNoEdgesOfThem) {
  ViewInWindow window(200, 150);
  const auto large = window.addOrgan(tests::sphere(7, 40));
  window.view.setMeshLook({.edges = true});
  window.render();
  EXPECT_TRUE(large->actor()->GetProperty()->GetEdgeVisibility());
  if (!rendersInSoftware(window.surface.window()))
    GTEST_SKIP() << "a graphics processor draws here";
  window.view.setFastDrawing(true);
  window.render();
  EXPECT_FALSE(large->actor()->GetProperty()->GetEdgeVisibility());
}

/// A ball in a translucent one that is added first, and a translucent one far behind that is added last.
struct BallInAGlass {
  BallInAGlass() : window(320, 240) {
    glass = window.addOrgan(tests::sphere(5, 50));
    glass->setOpacity(0.4);
    window.addOrgan(tests::sphere(4, 22))->setColor({0.1, 0.2, 0.9});
    auto behind = tests::sphere(4, 25);
    behind.points.col(0).array() += 40;
    behind.points.col(1).array() += 120;
    far = window.addOrgan(std::move(behind));
    far->setColor({0.1, 0.8, 0.2});
    far->setOpacity(0.6);
    window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-60), Vec3::Constant(60)});
    window.view.setOrientationCubeShown(false);
    window.view.setScaleBarShown(false);
  }
  vtkSmartPointer<vtkImageData> picture(bool moving) {
    window.view.setMoving(moving);
    window.render();
    return grabPicture(window.surface.window());
  }
  ViewInWindow window;
  std::shared_ptr<OrganActor> glass, far;
};

TEST(OrganView, TranslucentOrgansLookMuchTheSameWhileSomethingMoves) {
  BallInAGlass scene;
  const auto still = scene.picture(false);
  const auto difference = comparePictures(still, scene.picture(true), 40);
  EXPECT_LT(difference.mean, 4);
  EXPECT_LT(difference.differing, 0.03);
  // The glass alone, against what it is to hide: as far apart as two wrong orders are.
  scene.glass->setOpacity(1);
  EXPECT_GT(comparePictures(still, scene.picture(true), 40).differing, 0.1);
}

TEST(OrganView, ThePictureAfterAMotionIsTheOneBeforeIt) {
  BallInAGlass scene;
  const auto before = scene.picture(false);
  scene.picture(true);
  EXPECT_EQ(comparePictures(before, scene.picture(false), 0).differing, 0);
}

TEST(OrganView, AMovingGlassIsPeeledWhereThatShortcutIsOff) {
  BallInAGlass scene;
  scene.picture(true); // Only a frame tells what draws here.
  if (!rendersInSoftware(scene.window.surface.window()))
    GTEST_SKIP() << "a graphics processor draws here";
  EXPECT_TRUE(scene.glass->actor()->GetForceOpaque()) << "it is drawn among the opaque ones";
  scene.window.view.setShortcuts({.blending = false});
  scene.picture(true);
  EXPECT_FALSE(scene.glass->actor()->GetForceOpaque());
}

TEST(OrganView, LeavesOneWindowForAnother) {
  ViewInWindow first(100, 100);
  first.addOrgan(tests::sphere(2, 40));
  first.render();
  first.view.setInteractor(nullptr);
  SurfacelessWindow second(120, 90);
  first.view.setWindow(second.window());
  first.view.handles()->SetPositions(Points::Zero(3, 3));
  EXPECT_GT(grabPicture(second.window())->GetDimensions()[0], 100);
  first.view.setWindow(nullptr);
}

TEST(OrganView, WheelZoomsWithOneFrameATurnAndLettersDoNothing) {
  ViewInWindow window;
  window.addOrgan(tests::sphere(2, 40));
  window.view.lookFrom(StandardView::anterior);
  window.render();
  int frames = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&frames);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  window.view.renderer()->AddObserver(vtkCommand::EndEvent, count);
  auto* camera = window.view.renderer()->GetActiveCamera();
  const double before = camera->GetDistance();
  auto* interactor = window.surface.interactor();
  interactor->SetEventInformation(200, 150, 0, 0);
  interactor->InvokeEvent(vtkCommand::MouseWheelForwardEvent);
  EXPECT_LT(camera->GetDistance(), 0.95 * before);
  EXPECT_EQ(frames, 1);
  interactor->InvokeEvent(vtkCommand::MouseWheelBackwardEvent);
  EXPECT_NEAR(camera->GetDistance(), before, 1e-9 * before);
  for (const char letter : {'q', 'e', 'w', 's', 'p', '3', 'r', 'f'}) {
    interactor->SetKeyCode(letter);
    interactor->InvokeEvent(vtkCommand::CharEvent);
  }
  EXPECT_EQ(frames, 2);
}

TEST(OrganView, ForgetsOrgansThatAreRemoved) {
  ViewInWindow window;
  const auto organ = window.addOrgan(tests::sphere(2, 40));
  window.view.add(organ);
  EXPECT_EQ(window.view.organs().size(), 1U);
  window.view.remove(organ);
  window.view.remove(organ);
  EXPECT_TRUE(window.view.organs().empty());
  EXPECT_EQ(organ.use_count(), 1);
  window.view.handles()->SetPositions(Points::Zero(1, 3));
  EXPECT_EQ(window.view.bounds().diagonal(), 0);
}

TEST(StandardViews, NamesAreReadBackAndOthersRefused) {
  for (const auto view : {StandardView::anterior, StandardView::posterior, StandardView::left,
                          StandardView::right, StandardView::superior, StandardView::inferior})
    EXPECT_EQ(standardViewFromName(nameOf(view)), view);
  EXPECT_THROW(standardViewFromName("front"), UsageError);
}

TEST(ScaleBar, NumberHasAGroundSoThatHandlesBehindItDoNotHideIt) {
  vtkNew<vtkRenderer> renderer;
  ScaleBar bar(renderer);
  bar.setTheme(lightTheme());
  auto* props = renderer->GetViewProps();
  props->InitTraversal();
  int numbers = 0;
  while (vtkProp* prop = props->GetNextProp())
    if (auto* text = vtkTextActor::SafeDownCast(prop)) {
      ++numbers;
      const auto* ground = text->GetTextProperty()->GetBackgroundColor();
      EXPECT_GT(text->GetTextProperty()->GetBackgroundOpacity(), 0.5);
      EXPECT_EQ(Vec3(ground[0], ground[1], ground[2]), lightTheme().backgroundBottom);
    }
  EXPECT_EQ(numbers, 1);
}

/// The lowest and the highest row of pixels in which two pictures of one size differ.
std::pair<int, int> rowsThatDiffer(vtkImageData* one, vtkImageData* other) {
  const int* size = one->GetDimensions();
  std::pair<int, int> rows{size[1], -1};
  for (int y = 0; y < size[1]; ++y) {
    const auto* a = static_cast<const unsigned char*>(one->GetScalarPointer(0, y, 0));
    const auto* b = static_cast<const unsigned char*>(other->GetScalarPointer(0, y, 0));
    if (!std::equal(a, a + 3 * size[0], b))
      rows = {std::min(rows.first, y), y};
  }
  return rows;
}

TEST(ScaleBar, LiesBelowTheOrganThatFillsASmallView) {
  for (const double ratio : {1.0, 2.0}) {
    ViewInWindow window(static_cast<int>(300 * ratio), static_cast<int>(280 * ratio), ratio);
    auto flat = tests::sphere(4, 50);
    flat.points.col(1) *= 0.5;
    const auto organ = window.addOrgan(flat);
    window.view.setOrientationCubeShown(false);
    window.view.lookFrom(StandardView::anterior);
    const auto picture = [&](bool bar, bool shown) {
      window.view.setScaleBarShown(bar);
      organ->setVisible(shown);
      window.render();
      return grabPicture(window.surface.window());
    };
    const auto nothing = picture(false, false);
    const auto bar = rowsThatDiffer(picture(true, false), nothing);
    const auto seen = rowsThatDiffer(picture(false, true), nothing);
    EXPECT_GT(bar.second, 0) << ratio;
    EXPECT_LT(bar.second, seen.first) << ratio;
  }
}

TEST(ScaleBar, LengthsAreRoundAndAsLongAsPossible) {
  for (double most = 0.013; most < 4000; most *= 1.37) {
    const double length = roundLength(most);
    EXPECT_LE(length, most);
    EXPECT_GT(length, 0.4 * most - 1e-12);
    const double mantissa = length / std::pow(10, std::floor(std::log10(length) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                std::abs(mantissa - 5) < 1e-6)
        << length;
  }
}

} // namespace
} // namespace viscera::scene
