#include "viscera/scene/measurement_glyphs.h"

#include <cmath>

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include "shapes.h"
#include "view_fixture.h"
#include "viscera/scene/picture.h"

namespace viscera::scene {
namespace {

constexpr double kBallRadius = 40; ///< Of the ball that is measured, mm.

class Measurements : public testing::Test {
protected:
  explicit Measurements(double ratio = 1)
      : window(static_cast<int>(640 * ratio), static_cast<int>(480 * ratio), ratio), glyphs(window.view) {
    ball = window.addOrgan(tests::sphere(4, kBallRadius));
    ball->setColor({0.7, 0.3, 0.25});
    window.view.setOrientationCubeShown(false);
    window.view.setScaleBarShown(false);
    window.view.lookFrom(StandardView::anterior);
    window.render();
  }

  void show(std::vector<MeasurementGlyphs::Item> items) {
    glyphs.setItems(std::move(items));
    window.render();
  }

  /// The brightest of the pixels around a place in the picture that is drawn now: lines are thin.
  double brightnessAt(const Vec3& place) {
    return brightnessAt(place, *grabPicture(window.surface.window()));
  }

  double brightnessAt(const Vec3& place, vtkImageData& picture) {
    const auto at = window.display(place);
    double brightest = 0;
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        double sum = 0;
        for (int k = 0; k < 3; ++k)
          sum += picture.GetScalarComponentAsDouble(static_cast<int>(std::lround(at[0])) + x,
                                                    static_cast<int>(std::lround(at[1])) + y, 0, k);
        brightest = std::max(brightest, sum / (3 * 255));
      }
    return brightest;
  }

  tests::ViewInWindow window;
  MeasurementGlyphs glyphs;
  std::shared_ptr<OrganActor> ball;
};

// The reader looks along +y: what has a smaller y is nearer.

TEST_F(Measurements, LinesAreSeenInFrontAndFainterThroughTheOrgan) {
  const Vec3 middle(0, 0, 6);
  const double plain = brightnessAt(middle);
  show({{{{-30, -60, 6}, {30, -60, 6}}, "", false}});
  const double inFront = brightnessAt({0, -60, 6});
  show({{{{-30, 0, 6}, {30, 0, 6}}, "", false}});
  const double hidden = brightnessAt(middle);
  EXPECT_GT(inFront, 0.85) << "the text's colour of the dark theme";
  EXPECT_GT(hidden, plain + 0.1);
  EXPECT_LT(hidden, inFront - 0.1);
}

TEST_F(Measurements, AreHiddenWhenNotShownAndGoneWhenThereAreNone) {
  const Vec3 place(0, -60, 6);
  const double plain = brightnessAt(place);
  const std::vector<MeasurementGlyphs::Item> line = {{{{-30, -60, 6}, {30, -60, 6}}, "60 mm", false}};
  show(line);
  EXPECT_GT(brightnessAt(place), plain + 0.2);
  ASSERT_EQ(glyphs.drawn().size(), 1u);
  glyphs.setShown(false);
  window.render();
  EXPECT_NEAR(brightnessAt(place), plain, 0.03);
  EXPECT_TRUE(glyphs.drawn().empty());
  glyphs.setShown(true);
  show({});
  EXPECT_NEAR(brightnessAt(place), plain, 0.03);
}

TEST_F(Measurements, AnAngleHasAnArcAroundItsCorner) {
  const Vec3 corner(-10, -60, -10);
  const std::vector<Vec3> points = {corner + Vec3(40, 0, 0), corner, corner + Vec3(0, 0, 40)};
  // The arc is somewhere between the marks, nearer than 0.4 of the legs.
  const auto brightestBetween = [&] {
    const auto picture = grabPicture(window.surface.window());
    double brightest = 0;
    for (double radius = 6; radius < 17; radius += 0.25)
      brightest =
          std::max(brightest, brightnessAt(corner + radius * Vec3(1, 0, 1) / std::sqrt(2.0), *picture));
    return brightest;
  };
  show({{{points[0], points[1]}, "", false}, {{points[1], points[2]}, "", false}});
  EXPECT_LT(brightestBetween(), 0.7);
  show({{points, "", false}});
  EXPECT_GT(brightestBetween(), 0.85);
}

TEST_F(Measurements, LabelsStandBesideTheirLinesInTheViewAndNotOverEachOther) {
  const Vec3 a(-30, -50, 0), b(30, -50, 0);
  show({{{a, b}, "Distance 1: 60.0 mm", false},
        {{a, b}, "Distance 2: 60.0 mm", true},
        {{a, Vec3(0, -50, 20), b}, "Angle 1: 112.6 deg", false},
        {{Vec3(54, -50, 40), Vec3(56, -50, 40)}, "a label that would hang out of the view", false},
        {{a}, "", false}});
  const auto labels = glyphs.drawn();
  ASSERT_EQ(labels.size(), 4u);
  const auto middle = window.display(0.5 * (a + b));
  EXPECT_GT(labels[0].box.bottom, middle[1]) << "the line is covered";
  EXPECT_LT(labels[0].box.bottom, middle[1] + 20);
  EXPECT_NEAR(0.5 * (labels[0].box.left + labels[0].box.right), middle[0], 2);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_GE(labels[i].box.left, 0) << i;
    EXPECT_LE(labels[i].box.right, 640) << i;
    for (std::size_t k = i + 1; k < labels.size(); ++k)
      EXPECT_FALSE(labels[i].box.overlaps(labels[k].box)) << i << " and " << k;
  }
}

TEST_F(Measurements, MarksAreFoundByTheMouseAlsoBehindAnOrgan) {
  const Vec3 a(-30, -60, 0), b(20, 39, 10);
  show({{{Vec3(0, -60, 30), Vec3(10, -60, 30)}, "", false}, {{a, b}, "", false}});
  const auto at = window.display(a), behind = window.display(b);
  EXPECT_EQ(glyphs.markAt(at[0] + 4, at[1] - 4), (MeasurementGlyphs::Mark{1, 0}));
  EXPECT_EQ(glyphs.markAt(behind[0], behind[1]), (MeasurementGlyphs::Mark{1, 1}));
  EXPECT_FALSE(glyphs.markAt(at[0] + 30, at[1]));
  glyphs.setShown(false);
  EXPECT_FALSE(glyphs.markAt(at[0], at[1]));
}

TEST_F(Measurements, StayInFrontOfOrgansThatComeLater) {
  show({{{{-30, 0, 6}, {30, 0, 6}}, "", false}});
  auto other = window.addOrgan(tests::sphere(3, kBallRadius + 5));
  other->setColor({0.2, 0.2, 0.2});
  window.render();
  const double with = brightnessAt({0, 0, 6});
  show({});
  EXPECT_GT(with, brightnessAt({0, 0, 6}) + 0.1);
}

TEST_F(Measurements, WithoutExtentOrBehindTheEyeDoNoHarm) {
  const Vec3 place(0, -50, 0);
  show({{{place, place}, "0.0 mm", false},
        {{place, place, place}, "0 deg", false},
        {{Vec3(-20, -50, 0), place, Vec3(20, -50, 0)}, "180 deg", false},
        {{Vec3(0, -1e5, 0), place}, "far behind", false}});
  EXPECT_EQ(glyphs.drawn().size(), 3u) << "what is behind the eye has no label";
  for (const auto& label : glyphs.drawn())
    EXPECT_TRUE(std::isfinite(label.box.left) && std::isfinite(label.box.bottom)) << label.text;
}

class MeasurementsOnADenseScreen : public Measurements {
protected:
  MeasurementsOnADenseScreen() : Measurements(2) {}
};

TEST_F(MeasurementsOnADenseScreen, AreTwiceAsManyPixelsLarge) {
  show({{{Vec3(-30, -60, 0), Vec3(30, -60, 0)}, "60.0 mm", false}});
  const auto at = window.display({-30, -60, 0});
  EXPECT_TRUE(glyphs.markAt(at[0], at[1] + 16)) << "the mouse reaches as far as on any screen";
  const ScreenBox box = glyphs.drawn().at(0).box;
  EXPECT_GT(box.height(), 2 * 17);
}

} // namespace
} // namespace viscera::scene
