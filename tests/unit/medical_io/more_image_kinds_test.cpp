#include <algorithm>
#include <bit>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "label_files.h"
#include "old_image_files.h"
#include "packed_bytes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/surface_file.h"

/// FreeSurfer's volumes, GIPL and Analyze 7.5, and kinds that are not read.
namespace viscera::medical_io {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tests::gzipped;
using tests::LabelImage;

class MoreImageKinds : public testing::Test {
protected:
  static LabelImage twoOrgans() {
    LabelImage image = tests::emptyLabels({12, 10, 8});
    image.indexToLps = Eigen::Translation3d(-30, 20, 7) * Eigen::Scaling(2.0, 3.0, 2.5);
    image.fill({2, 3, 1}, {6, 8, 4}, 5);
    image.fill({9, 3, 1}, {10, 4, 2}, 17);
    return image;
  }

  void expectOrgans(const std::filesystem::path& file, const Eigen::Affine3d& grid) {
    SCOPED_TRACE(file);
    EXPECT_EQ(fileKind(file), FileKind::labelMap);
    EXPECT_TRUE(isLabelMap(file));
    EXPECT_TRUE(isScan(file));
    EXPECT_EQ(imageContents(file, progress_), ImageContents::labels);
    const LabelMap map = readLabelMap(file, progress_);
    ASSERT_EQ(map.segments.size(), 2U);
    EXPECT_EQ(map.segments[0].name, "label 5");
    EXPECT_EQ(map.segments[0].voxels, 5 * 6 * 4);
    EXPECT_EQ(map.segments[0].low, (std::array<int, 3>{2, 3, 1}));
    EXPECT_EQ(map.segments[1].label, 17);
    EXPECT_NEAR(map.volumeMl(map.segments[0]), 120 * 15e-3, 1e-5);
    EXPECT_LT((map.indexToLps.matrix() - grid.matrix()).cwiseAbs().maxCoeff(), 1e-4);
    const Scan scan = readScan(file, {}, progress_);
    EXPECT_EQ(scan.value(9, 3, 1), 17);
    EXPECT_EQ(scan.value(0, 0, 0), 0);
    EXPECT_LT((scan.indexToLps.matrix() - grid.matrix()).cwiseAbs().maxCoeff(), 1e-4);
  }

  std::string problem(const std::string& name, const std::string& bytes) {
    const auto file = folder_.put(name, bytes);
    try {
      if (isLabelMap(file))
        readLabelMap(file, progress_);
      else
        readSurface(file);
    } catch (const DataError& error) {
      return error.what();
    }
    return "it was read";
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(MoreImageKinds, OfFreeSurferAreReadAtTheirPlace) {
  LabelImage image = twoOrgans();
  for (const int type : {0, 1, 3, 4, 10})
    expectOrgans(folder_.put("a.mgh", tests::mghFile(image, type)), image.indexToLps);
  expectOrgans(folder_.put("a.mgz", gzipped(tests::mghFile(image, 0))), image.indexToLps);
  expectOrgans(folder_.put("a.mgh.gz", gzipped(tests::mghFile(image, 4) + std::string(20, '\1'))),
               image.indexToLps);
  image.indexToLps = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()) * image.indexToLps;
  expectOrgans(folder_.put("b.mgz", gzipped(tests::mghFile(image, 4))), image.indexToLps);
}

TEST_F(MoreImageKinds, OfFreeSurferWithoutAPlaceSaySo) {
  std::string bytes = tests::mghFile(twoOrgans(), 0);
  bytes[29] = 0;
  const LabelMap map = readLabelMap(folder_.put("a.mgh", bytes), progress_);
  EXPECT_THAT(inEnglish(map.warnings), Contains(HasSubstr("does not say where it lies")));
  EXPECT_LT((map.spacing() - Vec3(1, 1, 1)).norm(), 1e-9);
}

TEST_F(MoreImageKinds, OfFreeSurferHaveItsNamesForAWholeBrain) {
  LabelImage brain = tests::emptyLabels();
  std::int16_t at = 0;
  for (const int label : {2, 10, 49, 11, 50, 17, 53, 16, 1001})
    brain.fill({at, 0, 0}, {at, 9, 9}, std::int16_t(label)), ++at;
  const LabelMap map = readLabelMap(folder_.put("aseg.mgz", gzipped(tests::mghFile(brain, 1))), progress_);
  const auto named = [&](const std::string& name) {
    return std::any_of(map.segments.begin(), map.segments.end(),
                       [&](const Segment& s) { return s.name == name && s.voxels == 100; });
  };
  EXPECT_TRUE(named("Left-Hippocampus"));
  EXPECT_TRUE(named("Right-Thalamus"));
  EXPECT_TRUE(named("Brain-Stem"));
  EXPECT_TRUE(named("label 1001"));
  EXPECT_THAT(inEnglish(map.warnings), Contains(HasSubstr("FreeSurfer's colour table")));
  const LabelMap nifti = readLabelMap(folder_.put("aseg.nii", tests::niftiFile(brain)), progress_);
  EXPECT_EQ(nifti.segments[0].name, "label 2") << "numbers alone say nothing elsewhere";
}

TEST_F(MoreImageKinds, OfGiplAreReadWithTheMarkInEitherPlace) {
  const LabelImage image = twoOrgans();
  for (const int type : {8, 15, 16, 31, 32, 64, 65})
    expectOrgans(folder_.put("a.gipl", tests::giplFile(image, type)), image.indexToLps);
  expectOrgans(folder_.put("a.gipl.gz", gzipped(tests::giplFile(image, 15))), image.indexToLps);
  std::string early = tests::giplFile(image, 15);
  early.replace(248, 8, early.substr(252, 4) + std::string(4, '\0'));
  expectOrgans(folder_.put("b.gipl", early), image.indexToLps);
  early.replace(248, 4, 4, '\0');
  EXPECT_THAT(problem("c.gipl", early), HasSubstr("its mark is missing"));
}

TEST_F(MoreImageKinds, OfAnalyzeAreReadByTheOrderOfTheirAxes) {
  const LabelImage image = twoOrgans();
  const std::string voxels = tests::voxelBytes(image.voxels);
  folder_.put("a.img", voxels);
  Eigen::Affine3d grid = Eigen::Affine3d::Identity();
  grid.linear() = Vec3(2, -3, 2.5).asDiagonal();
  expectOrgans(folder_.put("a.hdr", tests::analyzeHeader(image)), grid);
  expectOrgans(folder_ / "a.img", grid);
  const LabelMap map = readLabelMap(folder_ / "a.img", progress_);
  EXPECT_EQ(map.space, "LAS");
  EXPECT_THAT(inEnglish(map.warnings), Contains(HasSubstr("left and right may be exchanged")));
  std::string sagittal = tests::analyzeHeader(image);
  sagittal[252] = 2;
  grid.linear() << 0, 0, 2.5, -2, 0, 0, 0, 3, 0;
  expectOrgans(folder_.put("a.hdr", sagittal), grid);
  std::string ofSpm = tests::analyzeHeader(image);
  for (const std::size_t i : {0U, 1U, 2U})
    tests::putBytes<std::int16_t>(ofSpm, 253 + 2 * i, std::int16_t(i + 3));
  grid.linear() = Vec3(2, -3, 2.5).asDiagonal();
  grid.translation() = -(grid.linear() * Vec3(2, 3, 4));
  expectOrgans(folder_.put("a.hdr", ofSpm), grid);
  std::string swapped = tests::analyzeHeader(image, std::endian::big), bytes = voxels;
  for (std::size_t i = 0; i < bytes.size(); i += 2)
    std::swap(bytes[i], bytes[i + 1]);
  folder_.put("b.img.gz", gzipped(bytes));
  grid.translation().setZero();
  expectOrgans(folder_.put("b.hdr", swapped), grid);
}

TEST_F(MoreImageKinds, ThatAreCutOffAreRefused) {
  for (const std::string& whole : {tests::mghFile(twoOrgans(), 4), tests::giplFile(twoOrgans(), 15)}) {
    const std::string ending = whole[0] == 0 && whole[3] == 1 ? ".mgh" : ".gipl";
    for (const std::size_t length : {std::size_t{5}, std::size_t{200}, whole.size() - 1}) {
      EXPECT_THAT(problem("a" + ending, whole.substr(0, length)), testing::Not(HasSubstr("it was read")));
      EXPECT_THAT(problem("a" + ending + ".gz", gzipped(whole.substr(0, length))),
                  testing::Not(HasSubstr("it was read")));
    }
  }
  std::string strange = tests::mghFile(twoOrgans(), 4);
  strange[23] = 6;
  EXPECT_THAT(problem("a.mgh", strange), HasSubstr("no plain numbers"));
}

/// One sentence that names the kind, with a way out, and no list of endings of surfaces.
TEST_F(MoreImageKinds, ThatAreNotReadAreNamed) {
  using namespace std::string_literals;
  const std::string hdf5 = "\x89HDF\r\n\x1a\n"s + std::string(600, '\0');
  const auto names = [&](const std::string& file, const std::string& bytes, const std::string& kind) {
    SCOPED_TRACE(file);
    const std::string said = problem(file, bytes);
    EXPECT_THAT(said, HasSubstr("; it looks like " + kind + " ("));
    EXPECT_THAT(said, testing::Not(HasSubstr(".stl,")));
    EXPECT_THROW(refuse(folder_ / file), DataError);
  };
  names("a.mnc", hdf5, "MINC");
  names("b.mnc", "CDF\x01" + std::string(50, 'x'), "MINC");
  names("a.h5", hdf5, "HDF5");
  names("a.mat", hdf5, "MATLAB");
  names("b.mat", "MATLAB 5.0 MAT-file, Platform: GLNXA64" + std::string(100, ' '), "MATLAB");
  names("a.npy", "\x93NUMPY\x01" + std::string(100, ' '), "NumPy");
  names("a.tif", "II*\0"s + std::string(100, '\0'), "TIFF");
  names("b.tiff", "MM\0*"s + std::string(100, '\0'), "TIFF");
  names("a.am", "# AmiraMesh BINARY-LITTLE-ENDIAN 2.1\n", "AmiraMesh");
  names("a.nii.zst", "\x28\xb5\x2f\xfd" + std::string(50, 'x'), "an archive");
  names("a.nii.xz",
        "\xfd"
        "7zXZ\0"s +
            std::string(50, 'x'),
        "an archive");
  names("a.vti", "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\">\n",
        "a VTK XML file that holds no surface");
  names("a.mif", "mrtrix image\ndim: 4,4,4\n", "MRtrix");
  names("a.mif.gz", gzipped("mrtrix image\ndim: 4,4,4\n"), "MRtrix");
  names("a+orig.BRIK", std::string(100, '\0'), "AFNI");
  names("a.nrrd", hdf5, "HDF5");
  names("a.nii", "II*\0"s + std::string(400, '\0'), "TIFF");
}

} // namespace
} // namespace viscera::medical_io
