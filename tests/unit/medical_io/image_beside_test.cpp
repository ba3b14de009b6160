#include "viscera/medical_io/image_beside.h"

#include <gtest/gtest.h>

#include "dicom_segments.h"
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

/// As many voxels of the same size at another place, or turned, are of another patient.
TEST_F(ImageBeside, LiesAtTheSamePlaceInTheSameDirection) {
  tests::LabelImage moved = image(true), turned = image(true), same = image(true);
  const auto scan = put("ct.nii", false);
  moved.indexToLps.translation() = Vec3(0, 0, 30);
  folder_.put("a.nii", tests::niftiFile(moved));
  turned.indexToLps.linear() =
      Eigen::AngleAxisd(0.3, Vec3::UnitX()).toRotationMatrix() * turned.indexToLps.linear();
  folder_.put("b.nii", tests::niftiFile(turned));
  EXPECT_EQ(beside(scan, ImageContents::labels), std::nullopt);
  // The same voxels, the last slice first.
  same.indexToLps.translation() = same.indexToLps * Vec3(0, 0, 15);
  same.indexToLps.linear().col(2) *= -1;
  const auto labels = folder_.put("c.nii", tests::niftiFile(same));
  EXPECT_EQ(beside(scan, ImageContents::labels), labels);
  EXPECT_EQ(beside(labels, ImageContents::values), scan);
}

/// A study of two patients, each with its frame of reference.
class BesideSegmentation : public ImageBeside {
protected:
  /// A series of slices in a folder.
  std::filesystem::path putSeries(const std::string& name, const std::string& uid, const std::string& frame,
                                  const tests::LabelImage& scan) {
    std::filesystem::create_directories(folder_ / ("study/" + name));
    for (int k = 0; k < scan.size[2]; ++k) {
      tests::DicomElements slice = tests::dicomSlice(scan, k, uid);
      slice[0x00200052] = "UI" + frame;
      folder_.put("study/" + name + "/" + uid + "." + std::to_string(k), tests::dicomBytes(slice));
    }
    return folder_ / ("study/" + name);
  }
  std::filesystem::path putSegments(const std::string& name, const tests::SegmentWriting& writing,
                                    const tests::LabelImage& labels) {
    std::filesystem::create_directories((folder_ / ("study/" + name)).parent_path());
    return folder_.put("study/" + name, tests::dicomBytes(tests::segmentationElements(labels, writing)));
  }
  std::optional<std::filesystem::path> scanOf(const std::filesystem::path& file) {
    return beside(file, ImageContents::values);
  }
  std::optional<std::filesystem::path> segmentsOf(const std::filesystem::path& place) {
    return beside(place, ImageContents::labels);
  }
  tests::LabelImage scan_ = image(false), labels_ = image(true);
};

TEST_F(BesideSegmentation, IsTheSeriesInItsFrameOfReferenceWhereverStudiesKeepIt) {
  const auto own = putSeries("ct", "1.2.4", "1.2.9", scan_);
  putSeries("another", "1.2.5", "1.2.10", scan_);
  for (const char* name : {"seg/x.dcm", "x.dcm", "seg/deep/x.dcm"}) {
    SCOPED_TRACE(name);
    const auto file = putSegments(name, {.names = {{3, "Liver"}}}, labels_);
    if (std::string(name) != "seg/deep/x.dcm") { // Two folders away.
      EXPECT_EQ(scanOf(file), own);
      EXPECT_EQ(segmentsOf(own), file);
      EXPECT_EQ(segmentsOf(own / "1.2.4.3"), file) << "one of its files";
      EXPECT_EQ(segmentsOf(folder_ / "study/another"), std::nullopt);
    }
    std::filesystem::remove(file);
  }
}

TEST_F(BesideSegmentation, InOneFolderIsAFileOfItsSeries) {
  putSeries("all", "1.2.5", "1.2.10", image(false, {30, 30, 20}));
  putSeries("all", "1.2.4", "1.2.9", scan_);
  const auto file = putSegments("all/x.dcm", {.names = {{3, "Liver"}}}, labels_);
  const auto found = scanOf(file);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->filename().string().starts_with("1.2.4.")) << *found;
  EXPECT_EQ(segmentsOf(*found), file);
  EXPECT_EQ(segmentsOf(folder_ / "study/all/1.2.5.0"), std::nullopt) << "of the other series";
}

TEST_F(BesideSegmentation, MayBeLongerThanIt) {
  const auto own = putSeries("ct", "1.2.4", "1.2.9", scan_);
  EXPECT_EQ(scanOf(putSegments("a.dcm", {.slices = {4, 5, 6}}, labels_)), own);
  EXPECT_EQ(scanOf(putSegments("a.dcm", {.slices = {5}}, labels_)), own);
  EXPECT_EQ(scanOf(putSegments("a.dcm", {.slices = {2, 4, 8}}, labels_)), own);
}

TEST_F(BesideSegmentation, IsNoneOfAnotherGridOrFrameOfReference) {
  putSeries("ct", "1.2.4", "1.2.9", scan_);
  folder_.put("study/ct.nii", tests::niftiFile(scan_));
  EXPECT_EQ(scanOf(putSegments("a.dcm", {.frameOfReference = "1.2.11"}, labels_)), std::nullopt);
  tests::LabelImage other = labels_;
  other.indexToLps.translation() = Vec3(1, 0, 0); // Half a voxel.
  EXPECT_EQ(scanOf(putSegments("a.dcm", {}, other)), std::nullopt);
  other.indexToLps.translation() = Vec3(0, 0, 3); // Its last slice is beyond the scan.
  EXPECT_EQ(scanOf(putSegments("a.dcm", {}, other)), std::nullopt);
  other = labels_;
  other.indexToLps.linear() = Vec3(2, 2, 6).asDiagonal();
  other.voxels.resize(24 * 20 * 8);
  other.size[2] = 8;
  EXPECT_EQ(scanOf(putSegments("a.dcm", {}, other)), std::nullopt) << "slices twice as thick";
}

TEST_F(BesideSegmentation, IsTheOneThatItRefersTo) {
  const auto first = putSeries("a", "1.2.4", "1.2.9", scan_);
  const auto second = putSeries("b", "1.2.5", "1.2.9", scan_);
  const auto bySeries = putSegments("seg/x.dcm", {.referencedSeries = "1.2.5"}, labels_);
  EXPECT_EQ(scanOf(bySeries), second);
  EXPECT_EQ(segmentsOf(first), std::nullopt);
  EXPECT_EQ(segmentsOf(second), bySeries);
  const auto byImage = putSegments("seg/x.dcm", {.referencedInstance = "1.2.5.7"}, labels_);
  EXPECT_EQ(scanOf(byImage), second);
  EXPECT_EQ(segmentsOf(first), std::nullopt);
  EXPECT_EQ(scanOf(putSegments("seg/x.dcm", {.referencedSeries = "1.2.6"}, labels_)), std::nullopt);
}

/// A segmentation's size and place are its own, whatever lies beside it.
TEST_F(BesideSegmentation, DoesNotLendItsGrid) {
  putSeries("ct", "1.2.4", "1.2.9", scan_);
  const auto file = putSegments("ct/x.dcm", {.slices = {4, 5, 6}}, labels_);
  const auto series = listScans(file, progress_);
  ASSERT_EQ(series.size(), 1U);
  EXPECT_EQ(series.front().size, (std::array<int, 3>{24, 20, 3}));
  EXPECT_NEAR(series.front().indexToLps.translation().z(), 12, 1e-9);
}

} // namespace
} // namespace viscera::medical_io
