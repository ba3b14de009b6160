#include "viscera/scene/slice_view.h"

#include <array>

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>

#include "view_fixture.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/standing_slices.h"

namespace viscera::scene {
namespace {

using Rgb = std::array<int, 3>;

Rgb pixel(vtkImageData* picture, int x, int y) {
  const auto* at = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
  return {at[0], at[1], at[2]};
}

/// A ramp of grey levels to the right, darker by 100 in the lower half.
SlicePicture ramp(int width, int height) {
  SlicePicture picture;
  picture.width = width;
  picture.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture.grey.push_back(static_cast<std::uint8_t>(x % 156 + (y < height / 2 ? 0 : 100)));
  return picture;
}

TEST(SliceView, DrawsEveryGreyLevelInItsPixel) {
  SurfacelessWindow window(150, 90);
  SliceView view;
  view.setWindow(window.window());
  const SlicePicture picture = ramp(150, 90);
  view.show(picture);
  const auto drawn = grabPicture(window.window());
  int wrong = 0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 150; ++x) {
      const int grey = picture.grey[std::size_t(y * 150 + x)];
      wrong += pixel(drawn, x, y) == Rgb{grey, grey, grey} ? 0 : 1;
    }
  EXPECT_EQ(wrong, 0);
}

TEST(SliceView, DrawsContoursInTheirColoursAndTheCrosshairWithAGap) {
  SurfacelessWindow window(160, 120);
  SliceView view;
  view.setWindow(window.window());
  SlicePicture picture = ramp(160, 120);
  std::fill(picture.grey.begin(), picture.grey.end(), std::uint8_t(0));
  picture.lines.push_back({{{30, 30}, {130, 30}, {130, 90}, {30, 90}}, true, Vec3(1, 0.5, 0), false});
  picture.cross = Eigen::Vector2d(80, 60);
  view.show(picture);
  const auto drawn = grabPicture(window.window());
  for (const auto& [x, y] : {std::pair{80, 30}, {80, 90}, {30, 45}, {130, 45}}) {
    const Rgb color = pixel(drawn, x, y);
    EXPECT_GT(color[0], 150) << x << " " << y;
    EXPECT_LT(color[2], 40) << x << " " << y;
  }
  EXPECT_EQ(pixel(drawn, 60, 45), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel(drawn, 80, 60), (Rgb{0, 0, 0})) << "what the crosshair points at is seen";
  EXPECT_GT(pixel(drawn, 50, 60)[2], 60);
  EXPECT_GT(pixel(drawn, 80, 100)[2], 60);
  picture.cross.reset();
  picture.lines.clear();
  view.show(picture);
  EXPECT_EQ(pixel(grabPicture(window.window()), 50, 60), (Rgb{0, 0, 0}));
}

TEST(SliceView, WritesOverNeitherLettersNorWhatIsMeasured) {
  SurfacelessWindow window(300, 200);
  SliceView view;
  view.setWindow(window.window());
  SlicePicture picture = ramp(300, 200);
  picture.edges = {"R", "L", "I", "S"};
  const auto drawn = [&] {
    view.show(picture);
    return grabPicture(window.window());
  };
  const auto before = drawn();
  picture.note = "L 40  W 400  Bent, folded where it is hatched";
  picture.title = "A title that is as long as that of a narrow slice";
  const Eigen::AlignedBox2d region(Eigen::Vector2d(200, 60), Eigen::Vector2d(285, 130));
  for (int i = 0; i < 2; ++i) // The second one does not cover the first.
    picture.texts.push_back({{285, 100}, "Liver: 45.3\n24 ml, 897 voxels", Vec3(1, 0.9, 0.3), region});
  const auto after = drawn();
  int changed = 0, near = 0;
  const auto compare = [&](int left, int right, int low, int high, int& count) {
    for (int y = low; y < high; ++y)
      for (int x = left; x < right; ++x)
        count += pixel(before, x, y) == pixel(after, x, y) ? 0 : 1;
  };
  compare(200, 286, 60, 130, changed);
  compare(142, 158, 8, 24, changed);    // The letter below,
  compare(142, 158, 177, 193, changed); // and the one above.
  EXPECT_EQ(changed, 0);
  compare(0, 300, 0, 200, near);
  EXPECT_GT(near, 500) << "all of it is written";
}

TEST(SliceView, TakesPicturesOfAnotherSize) {
  SurfacelessWindow window(150, 90);
  SliceView view;
  view.setWindow(window.window());
  view.show(ramp(150, 90));
  window.window()->Render();
  window.window()->SetSize(100, 60);
  view.show(ramp(100, 60));
  EXPECT_EQ(pixel(grabPicture(window.window()), 70, 50), (Rgb{170, 170, 170}));
}

TEST(StandingSlices, StandAmongTheOrgansAndGoAgain) {
  tests::ViewInWindow window(200, 200);
  StandingSlices slices(window.view);
  window.view.setOrientationCubeShown(false);
  window.view.setScaleBarShown(false);
  StandingSlices::Slice slice;
  slice.corner = Vec3(-50, 0, -50);
  slice.right = Vec3(100, 0, 0);
  slice.up = Vec3(0, 0, 100);
  slice.width = slice.height = 2;
  slice.grey = {10, 90, 170, 250};
  slices.show({slice});
  window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-50), Vec3::Constant(50)});
  const auto at = [&](vtkImageData* drawn, const Vec3& place) {
    const auto display = window.display(place);
    return pixel(drawn, int(display[0]), int(display[1]))[0];
  };
  const auto drawn = grabPicture(window.surface.window());
  EXPECT_NEAR(at(drawn, Vec3(-40, 0, -40)), 10, 6);
  EXPECT_NEAR(at(drawn, Vec3(40, 0, -40)), 90, 6);
  EXPECT_NEAR(at(drawn, Vec3(40, 0, 40)), 250, 6);
  EXPECT_EQ(slices.count(), 1u);
  slices.show({});
  EXPECT_LT(at(grabPicture(window.surface.window()), Vec3(40, 0, 40)), 120);
}

} // namespace
} // namespace viscera::scene
