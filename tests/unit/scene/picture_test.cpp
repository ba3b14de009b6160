#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "viscera/core/error.h"
#include "viscera/scene/picture.h"

#include "shapes.h"
#include "temporary_folder.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

namespace fs = std::filesystem;

class Picture : public testing::Test {
protected:
  const tests::TemporaryFolder folder;
};

vtkSmartPointer<vtkImageData> plain(int width, int height, unsigned char value) {
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(picture->GetScalarPointer()), 3 * width * height, value);
  return picture;
}

TEST_F(Picture, OfAWindowWithoutDisplayShowsTheOrganAndComesBackFromItsFile) {
  tests::ViewInWindow window(160, 120);
  window.addOrgan(tests::sphere(4, 40))->setColor({0.9, 0.1, 0.1});
  window.view.lookFrom(StandardView::anterior);
  const auto picture = grabPicture(window.surface.window());
  const auto* middle = static_cast<const unsigned char*>(picture->GetScalarPointer(80, 60, 0));
  EXPECT_GT(middle[0], 100);
  EXPECT_LT(middle[1], 90);
  writePng(folder / "a.png", picture);
  const auto difference = comparePictures(picture, readPng(folder / "a.png"), 0);
  EXPECT_EQ(difference.mean, 0);
  EXPECT_EQ(difference.differing, 0);
}

TEST_F(Picture, SameSceneGivesTheSamePicture) {
  const auto draw = [] {
    tests::ViewInWindow window(160, 120);
    window.addOrgan(tests::sphere(4, 40));
    window.view.lookFrom(StandardView::left);
    return grabPicture(window.surface.window());
  };
  EXPECT_EQ(comparePictures(draw(), draw(), 0).differing, 0);
}

TEST_F(Picture, IsWrittenWholeOrNotAtAll) {
  EXPECT_THROW(writePng(folder / "missing" / "a.png", plain(4, 4, 9)), CannotCreateError);
  writePng(folder / "b.png", plain(4, 4, 9));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST_F(Picture, UnreadableFilesAreNamed) {
  EXPECT_THROW(readPng(folder / "none.png"), NoInputError);
  std::ofstream(folder / "text.png") << "not a picture";
  EXPECT_THROW(readPng(folder / "text.png"), DataError);
}

TEST_F(Picture, ComparisonCountsPixelsAndSizes) {
  const auto a = plain(10, 10, 100), b = plain(10, 10, 100);
  static_cast<unsigned char*>(b->GetScalarPointer(3, 4, 0))[1] = 150;
  EXPECT_DOUBLE_EQ(comparePictures(a, b, 24).differing, 0.01);
  EXPECT_DOUBLE_EQ(comparePictures(a, b, 24).mean, 50.0 / 300);
  EXPECT_EQ(comparePictures(a, b, 60).differing, 0);
  EXPECT_EQ(comparePictures(a, plain(10, 11, 100)).differing, 1);
}

TEST(SurfacelessWindow, SeveralLiveSideBySide) {
  tests::ViewInWindow first(100, 80);
  first.addOrgan(tests::sphere(3, 40));
  first.view.lookFrom(StandardView::anterior);
  const auto before = grabPicture(first.surface.window());
  {
    tests::ViewInWindow second(60, 60);
    second.addOrgan(tests::sphere(3, 40));
    second.render();
    EXPECT_EQ(comparePictures(before, grabPicture(first.surface.window()), 0).differing, 0);
    second.render();
  }
  EXPECT_EQ(comparePictures(before, grabPicture(first.surface.window()), 0).differing, 0);
}

} // namespace
} // namespace viscera::scene
