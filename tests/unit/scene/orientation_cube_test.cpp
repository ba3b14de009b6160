#include <cmath>

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include "viscera/scene/picture.h"

#include "shapes.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

using tests::ViewInWindow;

/// Logical pixels: the middle of the cube's corner, and how far from it the letters beside the cube are.
constexpr double kMiddle = 52;
constexpr double kBeside = 38;

struct SeenFaces {
  StandardView view, right, top;
};

class CubeFromASide : public testing::TestWithParam<SeenFaces> {
protected:
  /// The side at a place in logical pixels from the middle of the cube.
  std::optional<StandardView> at(ViewInWindow& window, double ratio, double x, double y) {
    return window.view.orientationSideAt(ratio * (kMiddle + x), ratio * (kMiddle + y));
  }
};

TEST_P(CubeFromASide, NamesItsOwnSideAndThoseAround) {
  for (const double ratio : {1.0, 2.0}) {
    ViewInWindow window(static_cast<int>(300 * ratio), static_cast<int>(240 * ratio), ratio);
    window.view.lookFrom(GetParam().view, {Vec3::Constant(-50), Vec3::Constant(50)});
    window.render();
    EXPECT_EQ(at(window, ratio, 0, 0), GetParam().view) << ratio;
    EXPECT_EQ(at(window, ratio, kBeside, 0), GetParam().right) << ratio;
    EXPECT_EQ(at(window, ratio, 0, kBeside), GetParam().top) << ratio;
    EXPECT_FALSE(at(window, ratio, kBeside, kBeside)) << ratio;
    EXPECT_FALSE(at(window, ratio, 80, 0)) << ratio;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, CubeFromASide,
    testing::Values(SeenFaces{StandardView::anterior, StandardView::left, StandardView::superior},
                    SeenFaces{StandardView::posterior, StandardView::right, StandardView::superior},
                    SeenFaces{StandardView::left, StandardView::posterior, StandardView::superior},
                    SeenFaces{StandardView::right, StandardView::anterior, StandardView::superior},
                    SeenFaces{StandardView::superior, StandardView::right, StandardView::anterior},
                    SeenFaces{StandardView::inferior, StandardView::left, StandardView::anterior}),
    [](const auto& parameters) { return nameOf(parameters.param.view); });

/// How many pixels of the cube's corner differ between two pictures, as a part.
double differing(vtkImageData* one, vtkImageData* other) {
  int count = 0;
  const int side = static_cast<int>(2 * kMiddle);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto* a = static_cast<const unsigned char*>(one->GetScalarPointer(x, y, 0));
      const auto* b = static_cast<const unsigned char*>(other->GetScalarPointer(x, y, 0));
      count += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) > 24;
    }
  return double(count) / (side * side);
}

TEST(OrientationCube, ShowsWhichSideIsUnderTheMouseInBothThemes) {
  for (const Theme& theme : {darkTheme(), lightTheme()}) {
    ViewInWindow window(300, 240);
    window.view.setTheme(theme);
    window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-50), Vec3::Constant(50)});
    const auto picture = [&window] {
      window.render();
      return grabPicture(window.surface.window());
    };
    const auto plain = picture();
    EXPECT_TRUE(window.view.highlightOrientationSide(StandardView::anterior));
    EXPECT_FALSE(window.view.highlightOrientationSide(StandardView::anterior)) << "it is so already";
    EXPECT_GT(differing(plain, picture()), 0.08) << "the face is another colour";
    EXPECT_TRUE(window.view.highlightOrientationSide(StandardView::left));
    const double beside = differing(plain, picture());
    EXPECT_GT(beside, 0.0005) << "the letter beside the cube is another colour";
    EXPECT_LT(beside, 0.03);
    EXPECT_TRUE(window.view.highlightOrientationSide(std::nullopt));
    EXPECT_EQ(differing(plain, picture()), 0);
  }
}

TEST(OrientationCube, IsSmallInANarrowViewAndFoundThere) {
  for (const double ratio : {1.0, 2.0}) {
    ViewInWindow window(static_cast<int>(270 * ratio), static_cast<int>(400 * ratio), ratio);
    window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-50), Vec3::Constant(50)});
    window.render();
    const auto at = [&](double x, double y) { return window.view.orientationSideAt(ratio * x, ratio * y); };
    constexpr double kPart = 0.65;
    EXPECT_EQ(at(kPart * kMiddle, kPart * kMiddle), StandardView::anterior);
    EXPECT_EQ(at(kPart * (kMiddle + kBeside), kPart * kMiddle), StandardView::left);
    EXPECT_FALSE(at(kMiddle + kBeside, kMiddle)) << "where the letter is in a wide view";
  }
}

TEST(OrientationCube, IsNeitherSeenNorFoundWhileItIsHidden) {
  ViewInWindow window(300, 240);
  window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-50), Vec3::Constant(50)});
  window.render();
  const auto shown = grabPicture(window.surface.window());
  EXPECT_TRUE(window.view.orientationSideAt(kMiddle, kMiddle));
  window.view.setOrientationCubeShown(false);
  window.render();
  EXPECT_FALSE(window.view.orientationSideAt(kMiddle, kMiddle));
  EXPECT_GT(differing(shown, grabPicture(window.surface.window())), 0.15);
}

} // namespace
} // namespace viscera::scene
