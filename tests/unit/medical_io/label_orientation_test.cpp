#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bzipped.h"
#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"

/// Where a label map is in the patient, whatever its axes: an asymmetric phantom whose corners are known.
namespace viscera::medical_io {
namespace {

using tests::LabelImage;
using tests::NiftiForm;
using tests::TemporaryFolder;

const Vec3 kSpacing(0.8, 1.3, 2.1);
const Vec3 kOrigin(-31, 17, 240);
/// Single precision, in which NIfTI keeps its matrices, for numbers of this size.
constexpr double kGridTolerance = 1e-4;
constexpr double kHalfVoxel = 0.5;

struct Orientation {
  std::string name;
  Eigen::Matrix3d linear;
};

/// All eight directions of the axes, one with its axes exchanged, and an oblique one of each handedness.
std::vector<Orientation> orientations() {
  std::vector<Orientation> list;
  for (int signs = 0; signs < 8; ++signs) {
    const Vec3 sign((signs & 1) != 0 ? -1 : 1, (signs & 2) != 0 ? -1 : 1, (signs & 4) != 0 ? -1 : 1);
    const std::string name = {sign[0] < 0 ? 'R' : 'L', sign[1] < 0 ? 'A' : 'P', sign[2] < 0 ? 'I' : 'S'};
    list.push_back({name, sign.cwiseProduct(kSpacing).asDiagonal()});
  }
  Eigen::Matrix3d sagittal;
  sagittal << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  list.push_back({"sagittal", sagittal * kSpacing.asDiagonal()});
  const Eigen::Matrix3d oblique =
      (Eigen::AngleAxisd(0.5, Vec3(1, 2, -1).normalized()) * Eigen::AngleAxisd(-0.3, Vec3::UnitX()))
          .toRotationMatrix();
  list.push_back({"oblique", oblique * kSpacing.asDiagonal()});
  list.push_back({"oblique left-handed", oblique * Vec3(0.8, -1.3, 2.1).asDiagonal()});
  return list;
}

/// Three arms of different lengths that meet in one corner: no turn or mirror image looks the same.
LabelImage phantom(const Eigen::Matrix3d& linear) {
  LabelImage image = tests::emptyLabels();
  image.indexToLps.linear() = linear;
  image.indexToLps.translation() = kOrigin;
  image.fill({4, 5, 3}, {19, 9, 7}, 7);
  image.fill({4, 5, 3}, {8, 16, 7}, 7);
  image.fill({4, 5, 3}, {8, 9, 13}, 7);
  return image;
}

const std::vector<Vec3> kCorners = {{4, 5, 3},  {19, 5, 3}, {19, 9, 3}, {19, 9, 7}, {4, 16, 3}, {8, 16, 3},
                                    {8, 16, 7}, {4, 5, 13}, {8, 5, 13}, {8, 9, 13}, {4, 9, 13}};

/// Reads the file, makes the surface, and looks for the phantom where `image` has it.
void expectPhantomInPlace(const std::filesystem::path& file, const LabelImage& image) {
  Progress progress;
  const LabelMap map = readLabelMap(file, progress);
  EXPECT_EQ(map.size, image.size);
  EXPECT_TRUE(map.indexToLps.matrix().isApprox(image.indexToLps.matrix(), kGridTolerance))
      << map.indexToLps.matrix() << "\ninstead of\n"
      << image.indexToLps.matrix();
  ASSERT_EQ(map.segments.size(), 1U);
  EXPECT_EQ(map.segments[0].label, 7);

  // Gentle, so that corners of the arms stay near.
  const auto surfaces = labelSurfaces(map, {.segments = {}, .smoothing = 0.5}, progress);
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(surfaces.at(0).mesh);
  EXPECT_TRUE(geometry::checkSurface(*mesh).outward());
  const geometry::SignedDistance distance(mesh);
  const Eigen::Affine3d toIndex = image.indexToLps.inverse();
  for (const Vec3& corner : kCorners) {
    const Vec3 nearest = distance.nearest(image.indexToLps * corner);
    EXPECT_LT((toIndex * nearest - corner).norm(), kHalfVoxel) << "corner " << corner.transpose();
  }
  Points indices = mesh->points;
  for (Eigen::Index v = 0; v < indices.rows(); ++v)
    indices.row(v) = (toIndex * Vec3(mesh->points.row(v).transpose())).transpose();
  const Bounds box = boundsOf(indices);
  EXPECT_LT((box.low - Vec3(3.5, 4.5, 2.5)).cwiseAbs().maxCoeff(), kHalfVoxel) << box.low.transpose();
  EXPECT_LT((box.high - Vec3(19.5, 16.5, 13.5)).cwiseAbs().maxCoeff(), kHalfVoxel) << box.high.transpose();
}

class LabelOrientation : public testing::Test {
protected:
  /// Writes the phantom in every orientation by `write` and expects each in its place.
  template <typename Write>
  void expectInPlace(const std::string& name, const Write& write) {
    for (const Orientation& orientation : orientations()) {
      SCOPED_TRACE(orientation.name);
      const LabelImage image = phantom(orientation.linear);
      expectPhantomInPlace(folder_.put(name, write(image)), image);
    }
  }
  TemporaryFolder folder_;
};

TEST_F(LabelOrientation, OfNiftiWithASformAloneIsKept) {
  expectInPlace("a.nii", [](const LabelImage& image) { return tests::niftiFile(image, NiftiForm::sform); });
}

TEST_F(LabelOrientation, OfNiftiWithAQformAloneIsKept) {
  expectInPlace("a.nii", [](const LabelImage& image) { return tests::niftiFile(image, NiftiForm::qform); });
}

TEST_F(LabelOrientation, OfNiftiWithBothFormsIsKept) {
  expectInPlace("a.nii", [](const LabelImage& image) { return tests::niftiFile(image, NiftiForm::both); });
}

TEST_F(LabelOrientation, OfNiftiInTwoFilesIsKept) {
  for (const NiftiForm form : {NiftiForm::sform, NiftiForm::qform})
    expectInPlace("a.hdr", [&](const LabelImage& image) {
      const tests::NiftiHalves halves = tests::niftiHalves(image, form);
      folder_.put("a.img", halves.voxels);
      return halves.header;
    });
}

TEST_F(LabelOrientation, OfNrrdPackedByBzip2IsKept) {
  expectInPlace("a.nrrd", [](const LabelImage& image) {
    const std::string voxels = tests::voxelBytes(image.voxels);
    std::string nrrd = tests::nrrdFile(image, "right-anterior-superior");
    nrrd.resize(nrrd.size() - voxels.size());
    return nrrd.replace(nrrd.find("encoding: raw"), 13, "encoding: bzip2") + tests::bzipped(voxels);
  });
}

TEST_F(LabelOrientation, OfNrrdInLpsIsKept) {
  expectInPlace("a.nrrd",
                [](const LabelImage& image) { return tests::nrrdFile(image, "left-posterior-superior"); });
}

TEST_F(LabelOrientation, OfNrrdInRasIsKept) {
  expectInPlace("a.nrrd",
                [](const LabelImage& image) { return tests::nrrdFile(image, "right-anterior-superior"); });
}

TEST_F(LabelOrientation, OfNrrdInLasIsKept) {
  expectInPlace("a.nrrd",
                [](const LabelImage& image) { return tests::nrrdFile(image, "left-anterior-superior"); });
}

TEST_F(LabelOrientation, OfMetaImageIsKept) {
  expectInPlace("a.mha", [](const LabelImage& image) { return tests::metaImageFile(image); });
}

/// Other readers make such a grid orthogonal, which moves the far corner by centimetres.
TEST_F(LabelOrientation, OfAShearedSformIsKept) {
  Eigen::Matrix3d sheared;
  sheared << 0.8, 0.1, 0.5, 0, 1.3, -0.4, 0, 0, 2.1;
  const LabelImage image = phantom(sheared);
  expectPhantomInPlace(folder_.put("a.nii", tests::niftiFile(image)), image);
  expectPhantomInPlace(folder_.put("a.nrrd", tests::nrrdFile(image)), image);
}

TEST_F(LabelOrientation, OfTwoNiftiFormsThatDisagreeIsTheSforms) {
  const LabelImage image = phantom(kSpacing.asDiagonal());
  std::string bytes = tests::niftiFile(image, NiftiForm::both);
  tests::putBytes<float>(bytes, 268, 500.0F); // The origin of the qform.
  const auto file = folder_.put("a.nii", bytes);
  expectPhantomInPlace(file, image);
  Progress progress;
  const LabelMap map = readLabelMap(file, progress);
  ASSERT_EQ(map.warnings.size(), 1U);
  EXPECT_NE(map.warnings[0].english().find("sform and qform"), std::string::npos) << map.warnings[0];
}

TEST_F(LabelOrientation, OfASingularSformIsTheQforms) {
  const LabelImage image = phantom(orientations().back().linear);
  std::string bytes = tests::niftiFile(image, NiftiForm::both);
  for (std::size_t i = 0; i < 12; ++i)
    tests::putBytes<float>(bytes, 280 + 4 * i, 0.0F);
  expectPhantomInPlace(folder_.put("a.nii", bytes), image);
}

TEST_F(LabelOrientation, OfNiftiWithoutFormsIsItsSpacingAndSaysSo) {
  LabelImage image = phantom(Vec3(-0.8, -1.3, 2.1).asDiagonal());
  image.indexToLps.translation().setZero();
  const auto file = folder_.put("a.nii", tests::niftiFile(image, NiftiForm::none));
  expectPhantomInPlace(file, image);
  Progress progress;
  EXPECT_EQ(readLabelMap(file, progress).warnings.size(), 1U);
}

TEST_F(LabelOrientation, OfAVolumeInMetresIsConverted) {
  const LabelImage image = phantom(kSpacing.asDiagonal());
  LabelImage inMetres = image;
  inMetres.indexToLps = Eigen::Scaling(1e-3) * image.indexToLps;
  std::string bytes = tests::niftiFile(inMetres);
  bytes[123] = 1;
  expectPhantomInPlace(folder_.put("a.nii", bytes), image);
}

} // namespace
} // namespace viscera::medical_io
