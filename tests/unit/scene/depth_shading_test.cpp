#include "viscera/scene/depth_shading.h"

#include <optional>

#include <gtest/gtest.h>

#include "viscera/scene/picture.h"

#include "shapes.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

class ShadedView : public testing::Test {
protected:
  ShadedView() {
    window_.addOrgan(tests::sphere(3, 15));
    window_.view.lookFrom(StandardView::anterior);
    shading_.emplace(window_.view);
    shading_->setWanted(true);
  }

  void draw(const Theme& theme) {
    window_.view.setTheme(theme);
    grabPicture(window_.surface.window());
  }

  tests::ViewInWindow window_{120, 90};
  std::optional<DepthShading> shading_;
};

TEST_F(ShadedView, IsDrawnOnlyWhileItIsWanted) {
  draw(darkTheme());
  EXPECT_TRUE(shading_->drawn());
  shading_->setWanted(false);
  draw(darkTheme());
  EXPECT_FALSE(shading_->drawn());
}

/// VTK prints an error for each buffer that is left.
TEST_F(ShadedView, ReleasesItsBuffersAfterAChangeOfTheBackground) {
  for (const Theme& theme : {darkTheme(), lightTheme()})
    draw(theme);
  EXPECT_TRUE(shading_->drawn());
  testing::internal::CaptureStderr();
  shading_.reset();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace viscera::scene
