#include "viscera/scene/text_font.h"

#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

namespace viscera::scene {
namespace {

constexpr int kDpi = 72;

/// What VTK writes for this style, as bytes.
std::vector<unsigned char> written(vtkTextProperty* style) {
  vtkNew<vtkImageData> picture;
  int size[2] = {0, 0};
  EXPECT_TRUE(vtkTextRenderer::GetInstance()->RenderString(style, vtkStdString("Heart 17.5 ml"), picture,
                                                           size, kDpi));
  const auto bytes = static_cast<std::size_t>(picture->GetNumberOfPoints()) *
                     static_cast<std::size_t>(picture->GetNumberOfScalarComponents());
  const auto* first = static_cast<const unsigned char*>(picture->GetScalarPointer());
  return {first, first + bytes};
}

std::vector<unsigned char> writtenInFile(const std::string& file) {
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(18);
  style->SetFontFamily(VTK_FONT_FILE);
  style->SetFontFile(file.c_str());
  return written(style);
}

class TextFont : public testing::Test {
protected:
  void TearDown() override { setTextFont(kDefaultFontFamily); }
};

TEST_F(TextFont, TextsAreWrittenInAFontOfTheSystem) {
  const std::string file = textFontFile();
  ASSERT_TRUE(std::filesystem::is_regular_file(file)) << file;
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(18);
  EXPECT_EQ(written(style), writtenInFile(file));
  style->BoldOn();
  EXPECT_NE(written(style), writtenInFile(file)) << "bold letters have a file of their own";
}

TEST_F(TextFont, AnotherFamilyIsUsedFromThenOn) {
  const std::string before = textFontFile();
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(18);
  const std::vector<unsigned char> first = written(style);
  setTextFont("monospace");
  EXPECT_NE(textFontFile(), before);
  EXPECT_NE(written(style), first);
  EXPECT_EQ(written(style), writtenInFile(textFontFile()));
}

TEST_F(TextFont, AFamilyThatIsNotInstalledBecomesTheNearest) {
  setTextFont("No Such Family 4711");
  EXPECT_TRUE(std::filesystem::is_regular_file(textFontFile())) << textFontFile();
}

TEST_F(TextFont, ASizeThatFitsIsFoundInThatFont) {
  vtkNew<vtkTextProperty> style;
  const int size = vtkTextRenderer::GetInstance()->GetConstrainedFontSize(vtkStdString("Left ventricle"),
                                                                          style, 200, 40, kDpi);
  EXPECT_GT(size, 0);
  EXPECT_EQ(style->GetFontSize(), size) << "the style has the size, as VTK promises";
  int box[4] = {0, 0, 0, 0};
  ASSERT_TRUE(
      vtkTextRenderer::GetInstance()->GetBoundingBox(style, vtkStdString("Left ventricle"), box, kDpi));
  EXPECT_LE(box[1] - box[0], 200);
}

} // namespace
} // namespace viscera::scene
