#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_files.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {
namespace {

using tests::LabelImage;
using tests::TemporaryFolder;

/// Two organs with empty slices between them, in an oblique grid.
LabelImage twoOrgans() {
  LabelImage image = tests::emptyLabels({21, 18, 14}); // 378 pixels: frames do not end at a byte.
  image.indexToLps.linear() = (Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized())).toRotationMatrix() *
                              Vec3(0.8, 1.1, 2.5).asDiagonal();
  image.indexToLps.translation() = Vec3(-100, 50, 700);
  image.fill({2, 3, 1}, {6, 8, 4}, 1);
  image.fill({12, 3, 9}, {14, 15, 12}, 2);
  return image;
}

LabelMap read(const std::filesystem::path& file) {
  Progress progress;
  return readLabelMap(file, progress);
}

/// All labelled voxels lie at the same places in both.
void expectSameVoxels(const LabelMap& map, const LabelImage& image) {
  std::size_t wrong = 0;
  std::int64_t labelled = 0;
  const Eigen::Affine3d toMap = map.indexToLps.inverse() * image.indexToLps;
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i) {
        const std::int16_t label = image.voxels[std::size_t((k * image.size[1] + j) * image.size[0] + i)];
        if (label == 0)
          continue;
        ++labelled;
        const Eigen::Vector3i at = (toMap * Vec3(i, j, k)).array().round().cast<int>();
        const auto number = map.layers.at(0).at(map.indexOf(at.x(), at.y(), at.z()));
        wrong += number == 0 || map.segments.at(number - 1U).label != label ? 1 : 0;
        EXPECT_LT((toMap * Vec3(i, j, k) - at.cast<double>()).norm(), 1e-4);
      }
  EXPECT_EQ(wrong, 0U);
  std::int64_t there = 0;
  for (const Segment& segment : map.segments)
    there += segment.voxels;
  EXPECT_EQ(there, labelled);
}

class DicomSegmentation : public testing::TestWithParam<bool> {
protected:
  std::filesystem::path put(const LabelImage& image, bool withoutEmptyFrames) {
    return folder_.put("a.dcm", tests::dicomFile(image, {.fractional = GetParam(),
                                                         .withoutEmptyFrames = withoutEmptyFrames,
                                                         .names = {"liver", "left kidney"}}));
  }
  TemporaryFolder folder_;
};

TEST_P(DicomSegmentation, KeepsPlaceNamesAndColours) {
  const LabelImage image = twoOrgans();
  for (const bool withoutEmptyFrames : {false, true}) {
    const LabelMap map = read(put(image, withoutEmptyFrames));
    ASSERT_EQ(map.segments.size(), 2U);
    expectSameVoxels(map, image);
    EXPECT_EQ(map.size[2], withoutEmptyFrames ? 12 : 14);
    EXPECT_EQ(map.segments[0].name, "liver");
    EXPECT_EQ(map.segments[1].name, "left kidney");
    EXPECT_LT((map.segments[0].color - Vec3(1, 1, 1)).norm(), 0.02);
    EXPECT_LT((map.segments[1].color - Vec3(1, 0, 0)).norm(), 0.05);
  }
}

/// Archives store files under numbers.
TEST_P(DicomSegmentation, IsReadUnderAnyName) {
  const LabelImage image = twoOrgans();
  const auto file = put(image, true);
  std::filesystem::rename(file, folder_ / "SEG.1.2.840.10008");
  expectSameVoxels(read(folder_ / "SEG.1.2.840.10008"), image);
}

INSTANTIATE_TEST_SUITE_P(, DicomSegmentation, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "Fractional" : "Binary"; });

TEST(DicomFile, HasItsNamesInTheCharactersThatItSays) {
  const TemporaryFolder folder;
  const auto nameIn = [&](const std::string& set, const std::string& name) {
    const std::string placeholder(name.size(), '#'); // DCMTK would refuse the name itself.
    std::string bytes =
        tests::dicomFile(twoOrgans(), {.names = {placeholder, "spleen"}, .characterSet = set});
    bytes.replace(bytes.find(placeholder), name.size(), name);
    return read(folder.put("a.dcm", bytes)).segments.at(0).name;
  };
  EXPECT_EQ(nameIn("ISO_IR 100", "h\xEDgado"), "h\xC3\xADgado");
  EXPECT_EQ(nameIn("ISO_IR 192", "h\xC3\xADgado"), "h\xC3\xADgado");
  EXPECT_EQ(nameIn("ISO_IR 144", "\xD9\xD5\xE2\xDE"), "\xD0\xB9\xD0\xB5\xD1\x82\xD0\xBE") << "Cyrillic";
  EXPECT_EQ(nameIn("", "h\xEDgado"), "h?gado") << "it does not say which letter that is";
}

TEST(DicomFile, ThatIsCutOffIsRefused) {
  const TemporaryFolder folder;
  const std::string bytes = tests::dicomFile(twoOrgans(), {.names = {"liver", "left kidney"}});
  for (const std::size_t length : {bytes.size() / 4, bytes.size() / 2, bytes.size() - 100, bytes.size() - 2})
    EXPECT_THROW(read(folder.put("a.dcm", bytes.substr(0, length))), DataError) << length;
}

TEST(DicomFile, WithUnevenSlicesIsRefusedAndSaysWhatToDo) {
  const TemporaryFolder folder;
  LabelImage image = twoOrgans();
  image.fill({2, 3, 0}, {6, 8, image.size[2] - 1}, 1);
  const auto put = [&](double off) {
    return folder.put("a.dcm",
                      tests::dicomFile(image, {.names = {"liver", "left kidney"}, .lastSliceOffMm = off}));
  };
  EXPECT_NO_THROW(read(put(0)));
  try {
    read(put(1.2));
    ADD_FAILURE() << "not refused";
  } catch (const DataError& error) {
    EXPECT_THAT(error.problem().english(),
                ::testing::HasSubstr("Its slices are not equally far from each other"));
    EXPECT_THAT(error.tryThis().english(), ::testing::HasSubstr("resample the segmentation"));
  }
}

} // namespace
} // namespace viscera::medical_io
