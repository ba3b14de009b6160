#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_segments.h"
#include "packed_dicom.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"

/// DICOM files whose elements are written in other ways than the standard wants them in a file.
namespace viscera::medical_io {
namespace {

using tests::DicomElements;
using tests::LabelImage;
using tests::littleEndian;

LabelImage values() {
  LabelImage image = tests::emptyLabels({9, 8, 6});
  image.indexToLps.linear() = Vec3(3, 2, 4).asDiagonal();
  image.indexToLps.translation() = Vec3(-50, -40, 100);
  for (std::size_t i = 0; i < image.voxels.size(); ++i)
    image.voxels[i] = static_cast<std::int16_t>(37 * i % 2000) - 500;
  return image;
}

/// Without types, as implicit little-endian data sets are; sequences are given by `implicitItem`.
std::string implicitElements(const DicomElements& elements) {
  std::string bytes;
  for (const auto& [tag, typed] : elements) {
    std::string value = typed.substr(2);
    if (value.size() % 2 != 0)
      value += typed.starts_with("UI") ? '\0' : ' ';
    bytes +=
        littleEndian(tag >> 16U, 2) + littleEndian(tag & 0xFFFFU, 2) + littleEndian(value.size(), 4) + value;
  }
  return bytes;
}

std::string implicitItem(const DicomElements& elements) {
  const std::string bytes = implicitElements(elements);
  return littleEndian(0xFFFE, 2) + littleEndian(0xE000, 2) + littleEndian(bytes.size(), 4) + bytes;
}

/// Group 2 without what is before it.
std::string withoutPreamble(const std::string& file) {
  return file.substr(132);
}

/// The elements, those of groups 8 to 0x20 and the rescaling with VR UN.
DicomElements withUnknownTypes(DicomElements elements) {
  for (auto& [tag, typed] : elements)
    if (tag >> 16U <= 0x20 || tag >> 16U == 0x28)
      typed = "UN" + typed.substr(2) + (typed.size() % 2 != 0 ? " " : "");
  return elements;
}

class DicomEncodings : public testing::Test {
protected:
  /// A series whose files are made by `write`.
  template <class Write>
  std::filesystem::path series(const std::string& name, const Write& write) {
    std::filesystem::create_directories(folder_ / name);
    for (int k = 0; k < image_.size[2]; ++k)
      folder_.put(name + "/IM" + std::to_string(k), write(tests::dicomSlice(image_, k)));
    return folder_ / name;
  }
  void expectScan(const std::filesystem::path& place) {
    SCOPED_TRACE(place.string());
    EXPECT_TRUE(isScan(place));
    Progress progress;
    const Scan scan = readScan(place, {}, progress);
    ASSERT_EQ(scan.size, image_.size);
    EXPECT_LT((scan.indexToLps.matrix() - image_.indexToLps.matrix()).norm(), 1e-9);
    EXPECT_EQ(scan.modality, "CT");
    EXPECT_EQ(scan.description, "Abdomen 5.0");
    std::size_t wrong = 0, at = 0;
    for (int k = 0; k < scan.size[2]; ++k)
      for (int j = 0; j < scan.size[1]; ++j)
        for (int i = 0; i < scan.size[0]; ++i)
          wrong += scan.value(i, j, k) != image_.voxels[at++] ? 1 : 0;
    EXPECT_EQ(wrong, 0U);
  }
  tests::TemporaryFolder folder_;
  LabelImage image_ = values();
};

TEST_F(DicomEncodings, WithoutPreambleOpenAsASeriesAndBySingleFile) {
  const auto implicit = series("implicit", implicitElements);
  const auto typed = series("typed", tests::dicomElements);
  const auto meta =
      series("meta", [](const DicomElements& e) { return withoutPreamble(tests::dicomBytes(e)); });
  const auto packed = series("packed", [](const DicomElements& e) {
    return withoutPreamble(tests::packedDicom(tests::dicomBytes(e), "rle"));
  });
  const auto deflated = series("deflated", [](const DicomElements& e) {
    return withoutPreamble(tests::packedDicom(tests::dicomBytes(e), "deflated"));
  });
  for (const auto& place : {implicit, typed, meta, packed, deflated}) {
    expectScan(place);
    expectScan(place / "IM2");
    EXPECT_EQ(fileKind(place / "IM2"), FileKind::scan);
  }
}

TEST_F(DicomEncodings, WithoutPreambleMayBeSegmentations) {
  LabelImage organs = tests::emptyLabels({9, 8, 6});
  organs.fill({2, 2, 1}, {5, 5, 4}, 1);
  const DicomElements e = tests::segmentationElements(organs, {.names = {{1, "Liver"}}});
  for (const std::string& bytes : {tests::dicomElements(e), withoutPreamble(tests::dicomBytes(e))}) {
    const auto file = folder_.put("segments", bytes);
    EXPECT_EQ(fileKind(file), FileKind::labelMap);
    EXPECT_TRUE(isLabelMap(file));
    Progress progress;
    EXPECT_EQ(readLabelMap(file, progress).segments.at(0).voxels, 64);
  }
}

/// The bytes of many files begin like a data set.
TEST_F(DicomEncodings, WithoutPreambleAreNotSeenInOtherFiles) {
  const auto kindOf = [&](const std::string& bytes) { return fileKind(folder_.put("file", bytes)); };
  EXPECT_EQ(kindOf(littleEndian(0x00080008, 4) + std::string(600, '\0')), FileKind::unknown);
  EXPECT_EQ(kindOf(littleEndian(8, 2) + littleEndian(5, 2) + littleEndian(1U << 30U, 4) + "ISO_IR 100"),
            FileKind::unknown);
  std::string noise;
  for (unsigned i = 0; i < 4096; ++i)
    noise += char(i * 2654435761U >> 24U);
  EXPECT_EQ(kindOf(noise), FileKind::unknown);
  EXPECT_EQ(kindOf(littleEndian(0x00000008, 4) + noise), FileKind::unknown);
  DicomElements e = tests::dicomSlice(image_, 0);
  for (const std::uint32_t identity : {0x00080016U, 0x00080018U})
    e.erase(identity);
  EXPECT_EQ(kindOf(implicitElements(e)), FileKind::unknown) << "it does not say what it is";
}

TEST_F(DicomEncodings, WithUnknownTypesOpen) {
  expectScan(
      series("unknown", [](const DicomElements& e) { return tests::dicomBytes(withUnknownTypes(e)); }));
  expectScan(
      series("bare", [](const DicomElements& e) { return tests::dicomElements(withUnknownTypes(e)); }));
  expectScan(series("pixels", [](const DicomElements& e) {
    DicomElements all = withUnknownTypes(e);
    all[0x7FE00010] = "UN" + all[0x7FE00010].substr(2);
    return tests::dicomBytes(all);
  }));
}

/// The value of a sequence of VR UN has no types in it; some programs write them.
TEST_F(DicomEncodings, WithUnknownSequencesOpen) {
  DicomElements e = tests::enhancedDicom(image_);
  std::string frames;
  for (int k = image_.size[2] - 1; k >= 0; --k) {
    const DicomElements slice = tests::dicomSlice(image_, k);
    frames += implicitItem({{0x00209113, "SQ" + implicitItem({{0x00200032, slice.at(0x00200032)}})}});
  }
  DicomElements untyped = e;
  untyped[0x52009230] = "UN" + frames;
  expectScan(folder_.put("untyped.dcm", tests::dicomBytes(untyped)));
  std::filesystem::remove(folder_ / "untyped.dcm");
  e[0x52009230] = "UN" + e[0x52009230].substr(2);
  expectScan(folder_.put("typed.dcm", tests::dicomBytes(e)));
}

TEST_F(DicomEncodings, WithUnknownTypesThatAreDamagedAreRefused) {
  DicomElements e = tests::enhancedDicom(image_);
  e[0x52009230] = "UN" + e[0x52009230].substr(2, 60);
  const auto file = folder_.put("damaged.dcm", tests::dicomBytes(e));
  Progress progress;
  EXPECT_THROW(readScan(file, {}, progress), DataError);
}

} // namespace
} // namespace viscera::medical_io
