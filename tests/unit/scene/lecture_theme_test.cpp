#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "shapes.h"
#include "view_fixture.h"
#include "viscera/scene/measurement_glyphs.h"
#include "viscera/scene/organ_labels.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/slice_view.h"

namespace viscera::scene {
namespace {

/// What is written in a window, each text with its size.
std::map<std::string, int> sizesIn(vtkRenderWindow* window) {
  std::map<std::string, int> sizes;
  vtkRendererCollection* renderers = window->GetRenderers();
  renderers->InitTraversal();
  while (vtkRenderer* renderer = renderers->GetNextItem()) {
    vtkPropCollection* props = renderer->GetViewProps();
    props->InitTraversal();
    while (vtkProp* prop = props->GetNextProp())
      if (auto* text = vtkTextActor::SafeDownCast(prop); text && text->GetVisibility() && text->GetInput())
        sizes[text->GetInput()] = text->GetTextProperty()->GetFontSize();
  }
  return sizes;
}

/// A view with everything that is written in one.
class LectureTheme : public testing::Test {
protected:
  LectureTheme() : window(900, 700), labels(window.view), measured(window.view) {
    const auto ball = window.addOrgan(tests::sphere(3, 40));
    window.view.lookFrom(StandardView::anterior);
    window.view.legend().show("Stress", "%", viridis(), {0, 1});
    window.view.legend().setMark("folded", Vec3::Ones());
    labels.setItems({{"Ball", ball}});
    labels.setShown(true);
    measured.setItems({{{{-30, -60, 6}, {30, -60, 6}}, "60.0 mm", false}});
    wear(darkTheme());
  }

  void wear(const Theme& theme) {
    window.view.setTheme(theme);
    labels.setTheme(theme);
    measured.setTheme(theme);
    window.render();
  }

  tests::ViewInWindow window;
  OrganLabels labels;
  MeasurementGlyphs measured;
};

TEST_F(LectureTheme, MakesAllTypeOfTheViewLargerAndTheOldThemeMakesItAsItWas) {
  const auto usual = sizesIn(window.surface.window());
  for (const char* text : {"Ball", "60.0 mm", "Stress (%)", "folded", "0.2", "A"})
    EXPECT_TRUE(usual.count(text)) << text;
  for (const bool dark : {true, false}) {
    wear(lectureTheme(dark));
    auto large = sizesIn(window.surface.window());
    // A longer scale bar has another length, of which there is one in either picture.
    EXPECT_EQ(large.size(), usual.size());
    for (const auto& [text, size] : usual)
      if (large.count(text)) {
        EXPECT_EQ(large[text], std::lround(kLectureTypeScale * size)) << text;
      }
    for (const auto& [text, size] : large)
      EXPECT_GE(size, kLectureTypeScale * 12 - 0.5) << text;
  }
  wear(darkTheme());
  EXPECT_EQ(sizesIn(window.surface.window()), usual);
}

TEST_F(LectureTheme, LeavesRoomForWhatGrows) {
  wear(lectureTheme(true));
  const auto drawn = labels.drawn();
  ASSERT_EQ(drawn.size(), 1u);
  const double corner = 104 * kLectureTypeScale;
  EXPECT_FALSE(drawn[0].box.overlaps({0, 0, corner, corner})) << "the orientation cube is there";
  EXPECT_EQ(window.view.orientationSideAt(corner / 2, corner / 2), StandardView::anterior);
  EXPECT_FALSE(window.view.orientationSideAt(1.2 * corner, corner / 2));
}

TEST_F(LectureTheme, HasTheStrongestContrastThatThereIs) {
  for (const bool dark : {true, false}) {
    const Theme theme = lectureTheme(dark);
    EXPECT_EQ(theme.dark, dark);
    for (const Vec3& ground : {theme.backgroundTop, theme.backgroundBottom, theme.panel})
      EXPECT_NEAR((theme.text - ground).cwiseAbs().minCoeff(), 1, 1e-12);
    wear(theme);
    EXPECT_EQ(Vec3(window.view.renderer()->GetBackground()), theme.backgroundBottom);
    const auto drawn = grabPicture(window.surface.window());
    EXPECT_EQ(drawn->GetScalarComponentAsDouble(450, 690, 0, 0), dark ? 0 : 255) << "the ground at the top";
  }
}

/// The contrast of two colours after WCAG 2, from 1 to 21.
double contrastBetween(const Vec3& a, const Vec3& b) {
  constexpr double kDark = 0.04045, kOver = 0.05;
  const auto luminance = [](const Vec3& color) {
    const auto linear = [](double x) { return x <= kDark ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.x()) + 0.7152 * linear(color.y()) + 0.0722 * linear(color.z());
  };
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + kOver) / (darker + kOver);
}

/// Names of organs and parts stand beside all organs, on the background from its upper to its lower end.
TEST(ColorsOfNames, CanBeReadInEveryTheme) {
  constexpr double kReadable = 4.5;
  EXPECT_NEAR(contrastBetween(Vec3::Zero(), Vec3::Ones()), 21, 1e-9);
  for (const Theme& theme : {darkTheme(), lightTheme(), lectureTheme(true), lectureTheme(false)})
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 ground = (1 - part) * theme.backgroundBottom + part * theme.backgroundTop;
      EXPECT_GE(contrastBetween(theme.text, ground), kReadable) << theme.dark << ", " << part;
    }
}

TEST(LectureThemeOfSlices, MakesTheirTypeLarger) {
  SurfacelessWindow window(400, 300);
  SliceView slice;
  slice.setWindow(window.window());
  SlicePicture picture;
  picture.width = 400;
  picture.height = 300;
  picture.edges = {"R", "L", "P", "A"};
  picture.title = "Axial";
  slice.show(picture);
  window.window()->Render();
  auto usual = sizesIn(window.window());
  slice.setTheme(lectureTheme(true));
  slice.show(picture);
  window.window()->Render();
  auto large = sizesIn(window.window());
  for (const char* text : {"R", "L", "P", "A", "Axial"}) {
    ASSERT_GT(usual[text], 0) << text;
    EXPECT_EQ(large[text], std::lround(kLectureTypeScale * usual[text])) << text;
  }
}

} // namespace
} // namespace viscera::scene
