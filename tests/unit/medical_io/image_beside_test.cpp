#include "viscera/medical_io/image_beside.h"

#include <gtest/gtest.h>

#include "dicom_slices.h"
#include "temporary_folder.h"

namespace viscera::medical_io {
namespace {

/// Labels, or values that no label map has, on one grid.
tests::LabelImage image(bool labels, const std::array<int, 3>& size = {24, 20, 16}) {
  tests::LabelImage image = tests::emptyLabels(size);
  image.indexToLps.linear() = Vec3(2, 2, 3).asDiagonal();
  image.fill({4, 4, 4}, {12, 12, 12}, 3);
  for (std::size_t i = 0; !labels && i < image.voxels.size(); ++i)
    image.voxels[i] = std::int16_t(i * 2654435761u >> 22) - 500;
  return image;
}

class ImageBeside : public testing::Test {
protected:
  std::optional<std::filesystem::path> beside(const std::filesystem::path& file, ImageContents wanted) {
    return imageBeside(file, wanted, progress_);
  }
  std::filesystem::path put(const char* name, bool labels, const std::array<int, 3>& size = {24, 20, 16}) {
    return folder_.put(name, tests::niftiFile(image(labels, size)));
  }
  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(ImageBeside, OfScanAndLabelMapIsTheOtherHalfOfOnePatient) {
  const auto scan = put("anna_ct.nii", false), labels = put("anna_seg.nii", true);
  put("bert_ct.nii", false);
  put("bert_seg.nii", true);
  put("anna_old.nii", false, {24, 20, 18});
  folder_.put("notes.txt", "nothing");
  EXPECT_EQ(beside(labels, ImageContents::values), scan) << "the name begins alike";
  EXPECT_EQ(beside(scan, ImageContents::labels), labels);
}

TEST_F(ImageBeside, IsNoneOfAnotherGridAndOfWhatCannotBeRead) {
  const auto labels = put("a_seg.nii", true);
  put("a_ct.nii", false, {24, 20, 18});
  folder_.put("a_broken.nii", "damaged");
  EXPECT_EQ(beside(labels, ImageContents::values), std::nullopt);
  EXPECT_EQ(beside(folder_ / "a_broken.nii", ImageContents::values), std::nullopt);
  EXPECT_EQ(beside(folder_ / "absent.nii", ImageContents::labels), std::nullopt);
}

TEST_F(ImageBeside, FindsASeriesAndAFolderOfMasks) {
  const auto labels = put("seg.nii", true);
  std::filesystem::create_directories(folder_ / "series");
  const tests::LabelImage values = image(false);
  for (int k = 0; k < values.size[2]; ++k)
    folder_.put("series/" + std::to_string(k), tests::dicomBytes(tests::dicomSlice(values, k)));
  EXPECT_EQ(beside(labels, ImageContents::values), folder_ / "series");
  EXPECT_EQ(beside(folder_ / "series", ImageContents::labels), labels);
  EXPECT_EQ(beside(folder_ / "series/3", ImageContents::labels), labels) << "one of its files";
  std::filesystem::remove(labels);
  std::filesystem::create_directories(folder_ / "masks");
  folder_.put("masks/liver.nii", tests::niftiFile(image(true)));
  EXPECT_EQ(beside(folder_ / "series", ImageContents::labels), folder_ / "masks");
}

} // namespace
} // namespace viscera::medical_io
