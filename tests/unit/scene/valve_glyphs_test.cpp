#include "viscera/scene/valve_glyphs.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include "shapes.h"
#include "view_fixture.h"
#include "viscera/scene/picture.h"

namespace viscera::scene {
namespace {

/// A square sail in front of a ball, and its cord.
ValveGlyph sail() {
  ValveGlyph glyph;
  glyph.points.resize(4, 3);
  glyph.points << -10, -60, -10, 10, -60, -10, 10, -60, 10, -10, -60, 10;
  glyph.triangles.resize(2, 3);
  glyph.triangles << 0, 1, 2, 0, 2, 3;
  glyph.rims.push_back(glyph.points);
  return glyph;
}

class Valves : public testing::Test {
protected:
  Valves() : window(320, 240) {
    window.addOrgan(tests::sphere(4, 40))->setColor({0.2, 0.2, 0.6});
    window.view.setOrientationCubeShown(false);
    window.view.setScaleBarShown(false);
    window.view.lookFrom(StandardView::anterior);
    glyphs.setRenderer(window.view.renderer());
  }

  Vec3 colorAt(const Vec3& place) {
    window.render();
    const auto at = window.display(place);
    const auto picture = grabPicture(window.surface.window());
    Vec3 color;
    for (int k = 0; k < 3; ++k)
      color[k] = picture->GetScalarComponentAsDouble(static_cast<int>(at[0]), static_cast<int>(at[1]), 0, k);
    return color;
  }

  tests::ViewInWindow window;
  ValveGlyphs glyphs;
};

} // namespace

TEST_F(Valves, AreDrawnWhereTheyAreAndGoWhenTheyAreTakenBack) {
  const Vec3 middle(2, -60, 1);
  const Vec3 before = colorAt(middle);
  glyphs.set({sail()}, {});
  EXPECT_EQ(glyphs.valves(), 1);
  const Vec3 pale = colorAt(middle);
  EXPECT_GT(pale.x(), before.x() + 60); // Pale as leaflets are, in front of blue.
  glyphs.set({}, {});
  EXPECT_EQ(glyphs.valves(), 0);
  EXPECT_LT((colorAt(middle) - before).norm(), 3);
}

TEST_F(Valves, BloodFlowsFromTheTailToTheWiderTip) {
  glyphs.set({}, {{{0, -60, -20}, {0, -60, 20}, 3, {1, 0, 0}}});
  EXPECT_EQ(glyphs.arrows(), 1);
  const auto isRed = [](const Vec3& color) { return color.x() > color.z() + 40; };
  EXPECT_TRUE(isRed(colorAt({0, -60, -15})));
  EXPECT_FALSE(isRed(colorAt({4.5, -60, -15}))); // Beside the shaft;
  EXPECT_TRUE(isRed(colorAt({4.5, -60, 11.5}))); // the tip is wider.
  glyphs.set({}, {{{0, -60, 0}, {0, -60, 0}, 3, {1, 0, 0}}});
  EXPECT_EQ(glyphs.arrows(), 0);
}

TEST_F(Valves, AreNoOrganThatCouldBePicked) {
  glyphs.set({sail()}, {});
  window.render();
  const auto at = window.display({2, -60, 1});
  const auto picked = window.view.pick(at[0], at[1]);
  ASSERT_TRUE(picked);
  EXPECT_NEAR(picked->position.norm(), 40, 1); // The ball behind it.
}

} // namespace viscera::scene
