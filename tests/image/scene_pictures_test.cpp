#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkImageData.h>

#include "viscera/scene/ghost_outline.h"
#include "viscera/scene/organ_labels.h"
#include "viscera/scene/stretch_glyphs.h"
#include "viscera/scene/tissue_actor.h"
#include "viscera/scene/volume_chart.h"
#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"

#include "picture_check.h"
#include "shapes.h"
#include "tetrahedra.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

using tests::expectLooksLikeReference;
using tests::ViewInWindow;

/// Something like a kidney, darker towards its hilum.
geometry::TriangleMesh bean() {
  auto mesh = tests::sphere(5, 40);
  mesh.colors.resize(mesh.points.rows(), 3);
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i) {
    const Vec3 p = mesh.points.row(i).transpose() / 40;
    const double dent = std::exp(-3 * (p - Vec3(1, -0.3, 0)).squaredNorm());
    mesh.points.row(i) = 40 * Eigen::RowVector3d(p.x() * (0.75 - 0.5 * dent), 0.6 * p.y(), 1.25 * p.z());
    mesh.colors.row(i) << std::uint8_t(190 - 90 * dent), std::uint8_t(90 - 50 * dent),
        std::uint8_t(80 - 40 * dent);
  }
  return mesh;
}

/// Handles around the bean, some of them behind it.
Points handlesAround() {
  Points handles(8, 3);
  handles << 0, -32, 0, 38, -5, 20, -38, -5, -20, 0, -5, 58, 0, -5, -58, 0, 34, 18, 0, 34, -22, 16, -28, -30;
  return handles;
}

class ScenePicture : public testing::Test {
protected:
  explicit ScenePicture() : window(480, 320) {
    organ = window.addOrgan(bean());
    window.view.lookFrom(StandardView::anterior);
    window.view.renderer()->GetActiveCamera()->Azimuth(-25);
    window.view.renderer()->GetActiveCamera()->Elevation(12);
    window.view.frame();
  }
  vtkSmartPointer<vtkImageData> picture() { return grabPicture(window.surface.window()); }
  ViewInWindow window;
  std::shared_ptr<OrganActor> organ;
};

TEST_F(ScenePicture, OrganWithItsHandles) {
  window.view.handles()->SetPositions(handlesAround());
  window.view.handles()->SetSelection({1, 5});
  window.view.handles()->SetActiveHandle(7);
  expectLooksLikeReference(picture(), "organ_and_handles");
}

TEST_F(ScenePicture, LabelsBesideATranslucentWallAndWhatIsInIt) {
  organ->setOpacity(0.35);
  auto left = window.addOrgan(tests::sphere(4, 12, {12, 0, 12}));
  auto right = window.addOrgan(tests::sphere(4, 12, {-10, 0, -10}));
  left->setColor({0.84, 0.16, 0.14});
  right->setColor({0.2, 0.36, 0.8});
  OrganLabels labels(window.view);
  labels.setItems({{"Kidney", organ, true}, {"Upper calyx", left}, {"Lower calyx", right}});
  labels.setShown(true);
  expectLooksLikeReference(picture(), "organ_labels");
  window.view.setTheme(lightTheme());
  labels.setTheme(lightTheme());
  expectLooksLikeReference(picture(), "organ_labels_light");
}

TEST_F(ScenePicture, InfluenceMapWithLegend) {
  const Vec3 handle = handlesAround().row(0).transpose();
  auto values = std::make_shared<Values>(organ->mesh().points.rows());
  for (Eigen::Index i = 0; i < values->size(); ++i)
    (*values)[i] = std::exp(-(organ->mesh().points.row(i).transpose() - handle).squaredNorm() / 1200);
  organ->showScalars(values, viridis(), {0, 1});
  window.view.legend().show("Influence", "", viridis(), {0, 1});
  expectLooksLikeReference(picture(), "influence_map");
}

TEST_F(ScenePicture, RestShapeAndAllowedPlaneInTheLightTheme) {
  window.view.setTheme(lightTheme());
  GhostOutline ghost(std::shared_ptr<const geometry::TriangleMesh>(organ, &organ->mesh()));
  ghost.setRenderer(window.view.renderer());
  ghost.setColor(lightTheme().text);
  auto posed = std::make_shared<Points>(organ->mesh().points);
  posed->col(2) = posed->col(2).unaryExpr([](double z) { return z > 0 ? 1.35 * z : 0.85 * z; });
  organ->setPoints(posed);
  window.view.frame();
  window.view.handles()->SetPositions(handlesAround());
  window.view.handles()->SetSelection({0});
  window.view.constraint().show(handlesAround().row(0).transpose(), {0.5, -1, 0.6});
  expectLooksLikeReference(picture(), "rest_shape_and_plane");
}

TEST_F(ScenePicture, TranslucentWallShowsWhatIsInside) {
  organ->setOpacity(0.4);
  window.addOrgan(tests::sphere(4, 14, {-6, 0, 12}))->setColor({0.25, 0.45, 0.8});
  window.view.handles()->SetPositions(handlesAround());
  expectLooksLikeReference(picture(), "translucent_wall");
}

/// A ball of tetrahedra that is twisted about the vertical axis, with numbers that say how far; one place has
/// none.
class TissuePicture : public testing::Test {
protected:
  TissuePicture() : window(480, 320) {
    const tests::Solid solid = tests::solidBox(12, 40);
    auto twisted = std::make_shared<Points>(solid.points);
    auto numbers = std::make_shared<Values>(solid.points.rows());
    for (Eigen::Index i = 0; i < twisted->rows(); ++i) {
      const Vec3 p = solid.points.row(i);
      const double inBox = p.cwiseAbs().maxCoeff(), inBall = p.norm();
      const Vec3 round = inBall > 0 ? Vec3(p * (inBox / inBall)) : p;
      const double angle = 0.9 * std::sin(round.z() / 16);
      twisted->row(i) << std::cos(angle) * round.x() - std::sin(angle) * round.y(),
          std::sin(angle) * round.x() + std::cos(angle) * round.y(), 1.2 * round.z();
      (*numbers)[i] = 20 * std::abs(std::sin(round.z() / 16)) * round.head<2>().norm() / 40;
      if ((round - Vec3(24, 0, 12)).norm() < 8)
        (*numbers)[i] = std::nan("");
    }
    colors.missing = {232, 40, 200};
    tissue = std::make_unique<TissueActor>(std::make_shared<const Tetrahedra>(solid.tetrahedra), twisted);
    tissue->setValues(numbers);
    tissue->setColors(colors, {0, 20});
    tissue->setRenderer(window.view.renderer());
    window.view.lookFrom(StandardView::anterior, boundsOf(*twisted));
    window.view.renderer()->GetActiveCamera()->Azimuth(-30);
    window.view.renderer()->GetActiveCamera()->Elevation(15);
    window.view.legend().show("Rotational stress", "deg", colors, {0, 20});
    window.view.legend().setMark("folded", Vec3(232, 40, 200) / 255);
  }
  vtkSmartPointer<vtkImageData> picture() { return grabPicture(window.surface.window()); }

  ColorMap colors = viridis();
  ViewInWindow window;
  std::unique_ptr<TissueActor> tissue;
};

TEST_F(TissuePicture, InsideCutOpenWithItsPlaneAndLegend) {
  const CutPlane plane{Vec3(0, 2, 0), Vec3::UnitY()};
  tissue->setCut(plane, CutStyle::smooth);
  vtkNew<vtkVisceraCutPlaneRepresentation> gizmo;
  gizmo->SetBall(Vec3::Zero(), 44);
  gizmo->SetPlane(plane);
  gizmo->SetRenderer(window.view.renderer());
  window.view.renderer()->AddViewProp(gizmo);
  expectLooksLikeReference(picture(), "tissue_cut");
}

TEST_F(TissuePicture, WholeTetrahedraBeyondALimit) {
  tissue->setCut({Vec3(0, 2, 0), Vec3::UnitY()}, CutStyle::crinkle);
  tissue->setShownRange({8, 100});
  expectLooksLikeReference(picture(), "tissue_crinkle_limit");
}

TEST_F(TissuePicture, GlyphsOfTheStretchInAPaleShell) {
  tissue->setGhost(true);
  StretchGlyphs glyphs;
  std::vector<StretchGlyph> all;
  for (int i = 0; i < 27; ++i) {
    const Vec3 place = 17.0 * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const double more = 1 + 0.012 * (place.z() + 17);
    all.push_back({place, Eigen::Quaterniond(Eigen::AngleAxisd(0.04 * place.x(), Vec3::UnitY())),
                   Vec3(more, 1, 1 / more), 0.5 * (place.z() + 17)});
  }
  glyphs.set(all);
  glyphs.setRadius(5);
  glyphs.setColors(colors, {0, 20});
  glyphs.setVisible(true);
  glyphs.setRenderer(window.view.renderer());
  expectLooksLikeReference(picture(), "stretch_glyphs");
}

TEST(ChartPicture, CurvesBandsAndCursor) {
  SurfacelessWindow surface(480, 200);
  VolumeChart chart;
  chart.setWindow(surface.window());
  chart.setTheme(darkTheme());
  chart.setLines({{"LV", {0.88, 0.36, 0.32}, {{{109, 189}, "EDV"}, {{30, 66}, "ESV, normal"}}},
                  {"RV", {0.35, 0.6, 0.92}}});
  chart.setTimeSpan(3);
  for (int i = 0; i < 100; ++i) {
    const double squeeze = std::pow(std::max(0.0, std::sin(2 * M_PI * 0.04 * i / 0.8)), 2);
    Values values(2);
    values << 130 - 75 * squeeze, 148 - 70 * squeeze;
    chart.append(0.04 * i, values);
  }
  chart.setCursor(3.2);
  chart.update();
  expectLooksLikeReference(grabPicture(surface.window()), "chart");
}

} // namespace
} // namespace viscera::scene
