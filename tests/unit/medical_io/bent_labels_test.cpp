#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/label_map.h"

/// Labels that programs kept as fractions, or as whole numbers behind a slope.
namespace viscera::medical_io {
namespace {

using testing::HasSubstr;
using tests::LabelImage;
using tests::putBytes;

/// A NIfTI file whose voxels are what `valueOf` makes of their labels, as T of the given type.
template <typename T>
std::string storedNifti(const LabelImage& image, std::int16_t type, float slope, float intercept,
                        const std::function<T(int label)>& storedOf) {
  std::string bytes = tests::niftiFile(image);
  bytes.resize(bytes.size() - image.voxels.size() * sizeof(std::int16_t));
  putBytes<std::int16_t>(bytes, 70, type);
  putBytes<float>(bytes, 112, slope);
  putBytes<float>(bytes, 116, intercept);
  for (const std::int16_t label : image.voxels) {
    const T value = storedOf(label);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return bytes;
}

/// As nibabel keeps fractions from 0 to `largest` behind an integer header: the whole range of the type.
template <typename T>
std::string asNibabelKeeps(const LabelImage& image, std::int16_t type, double largest) {
  const double low = double(std::numeric_limits<T>::min()), high = double(std::numeric_limits<T>::max());
  const auto slope = static_cast<float>(largest / (high - low));
  const auto intercept = static_cast<float>(-low * double(slope));
  return storedNifti<T>(image, type, slope, intercept, [&](int label) {
    return static_cast<T>(std::clamp(std::round((label - double(intercept)) / double(slope)), low, high));
  });
}

class BentLabels : public testing::Test {
protected:
  static LabelImage twoOrgans(std::int16_t first, std::int16_t second) {
    LabelImage image = tests::emptyLabels();
    image.fill({2, 3, 4}, {9, 8, 9}, first);
    image.fill({12, 3, 4}, {14, 5, 6}, second);
    return image;
  }

  void expectOrgans(const std::string& what, const std::string& bytes, std::int64_t first,
                    std::int64_t second) {
    SCOPED_TRACE(what);
    const auto file = folder_.put("a.nii", bytes);
    EXPECT_EQ(imageContents(file, progress_), ImageContents::labels);
    const LabelMap map = readLabelMap(file, progress_);
    ASSERT_EQ(map.segments.size(), 2U);
    EXPECT_EQ(map.segments[0].label, first);
    EXPECT_EQ(map.segments[0].voxels, 8 * 6 * 6);
    EXPECT_EQ(map.segments[1].label, second);
    EXPECT_EQ(map.segments[1].voxels, 27);
    EXPECT_TRUE(std::any_of(map.warnings.begin(), map.warnings.end(), [](const Text& warning) {
      return warning.english().find("rounded to labels, by at most") != std::string::npos;
    })) << "a note";
    EXPECT_TRUE(std::holds_alternative<LabelMap>(readScanOrLabels(file, {}, progress_)));
  }

  void expectNone(const std::string& what, const std::string& bytes) {
    SCOPED_TRACE(what);
    const auto file = folder_.put("b.nii", bytes);
    EXPECT_EQ(imageContents(file, progress_), ImageContents::values);
    EXPECT_THROW(readLabelMap(file, progress_), DataError);
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(BentLabels, BehindASlopeAreRounded) {
  expectOrgans("8 bits", asNibabelKeeps<std::uint8_t>(twoOrgans(2, 7), 2, 7), 2, 7);
  expectOrgans("8 bits of many labels", asNibabelKeeps<std::uint8_t>(twoOrgans(5, 104), 2, 117), 5, 104);
  expectOrgans("16 bits", asNibabelKeeps<std::int16_t>(twoOrgans(2, 10), 4, 10), 2, 10);
  expectOrgans("16 bits without sign", asNibabelKeeps<std::uint16_t>(twoOrgans(1, 300), 512, 300), 1, 300);
  expectOrgans("32 bits", asNibabelKeeps<std::int32_t>(twoOrgans(1, 2), 8, 2), 1, 2);
  expectOrgans("a third",
               storedNifti<std::int16_t>(twoOrgans(1, 3), 4, 1.0F / 3, 0,
                                         [](int label) { return std::int16_t(3 * label); }),
               1, 3);
  expectOrgans("an intercept",
               storedNifti<std::int16_t>(twoOrgans(1, 2), 4, 0.1F, 0.7F,
                                         [](int label) { return std::int16_t(10 * label - 7); }),
               1, 2);
}

TEST_F(BentLabels, AsFractionsAreRounded) {
  const auto bent = [](double by) { return [by](int label) { return float(label * (1 + by)); }; };
  expectOrgans("2.00007", storedNifti<float>(twoOrgans(1, 2), 16, 1, 0, bent(3.5e-5)), 1, 2);
  expectOrgans("0.9999999", storedNifti<float>(twoOrgans(1, 3), 16, 1, 0, bent(-1e-7)), 1, 3);
  expectOrgans("doubles",
               storedNifti<double>(twoOrgans(4, 50), 64, 1, 0, [](int label) { return label + 1e-9; }), 4,
               50);
  expectOrgans("below 0",
               storedNifti<double>(twoOrgans(1, 2), 64, 1, 0, [](int label) { return label - 1e-8; }), 1, 2);
}

TEST_F(BentLabels, SayByHowMuchTheyAreOff) {
  const LabelMap map = readLabelMap(
      folder_.put("a.nii", storedNifti<double>(twoOrgans(1, 2), 64, 1, 0,
                                               [](int label) { return label == 2 ? 2.00007 : label; })),
      progress_);
  ASSERT_FALSE(map.warnings.empty());
  EXPECT_THAT(map.warnings.back().english(), HasSubstr("0.00007"));
}

TEST_F(BentLabels, WholeNumbersNeedNoNote) {
  const LabelMap map =
      readLabelMap(folder_.put("a.nii", storedNifti<float>(twoOrgans(1, 2), 16, 1, 0,
                                                           [](int label) { return float(label); })),
                   progress_);
  EXPECT_TRUE(map.warnings.empty());
}

TEST_F(BentLabels, AreNoFractionsOfAnotherMeaning) {
  expectNone("a probability",
             storedNifti<float>(twoOrgans(1, 2), 16, 1, 0, [](int label) { return 0.5F * float(label); }));
  expectNone("a probability behind a slope",
             storedNifti<std::uint8_t>(twoOrgans(100, 200), 2, 1.0F / 255, 0,
                                       [](int label) { return std::uint8_t(label); }));
  expectNone("thirds", storedNifti<std::int16_t>(twoOrgans(1, 2), 4, 1.0F / 3, 0,
                                                 [](int label) { return std::int16_t(label); }));
  expectNone("a dark mask", storedNifti<std::uint8_t>(twoOrgans(1, 1), 2, 0.3F, 0,
                                                      [](int label) { return std::uint8_t(label); }));
  expectNone("small measurements",
             storedNifti<float>(twoOrgans(1, 2), 16, 1, 0, [](int label) { return 2e-5F * float(label); }));
  LabelImage ramp = tests::emptyLabels();
  for (std::size_t v = 0; v < ramp.voxels.size(); ++v)
    ramp.voxels[v] = std::int16_t(v % 400);
  expectNone("a CT that was resampled",
             storedNifti<float>(ramp, 16, 1, 0, [](int value) { return 0.37F * float(value); }));
  EXPECT_EQ(imageContents(folder_.put("c.nii", asNibabelKeeps<std::uint16_t>(ramp, 512, 399)), progress_),
            ImageContents::values)
      << "an MR behind a slope whose values are near whole numbers";
}

} // namespace
} // namespace viscera::medical_io
