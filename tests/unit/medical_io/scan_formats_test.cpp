#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "packed_bytes.h"
#include "scan_phantom.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {
namespace {

using tests::LabelImage;

class ScanFormats : public testing::Test {
protected:
  Scan read(const std::string& name, const std::string& bytes, const ScanOptions& options = {}) {
    return readScan(folder_.put(name, bytes), options, progress_);
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

/// Every voxel, every marker at its place in the patient, and values between voxels.
void expectPhantom(const Scan& scan, const LabelImage& image, const std::string& what) {
  SCOPED_TRACE(what);
  ASSERT_EQ(scan.size, image.size);
  EXPECT_LT((scan.indexToLps.matrix() - image.indexToLps.matrix()).cwiseAbs().maxCoeff(), 1e-4);
  const Vec3 size(scan.size[0], scan.size[1], scan.size[2]);
  for (const tests::ScanMarker& marker : tests::scanMarkers()) {
    const Vec3 index = (image.indexToLps.inverse() * marker.lps).array().round();
    if (((index.array() < 0) || (index.array() >= size.array())).any())
      continue;
    const Vec3 center = image.indexToLps * index;
    ASSERT_LE((center - marker.lps).norm(), 0.5 * 4 * std::sqrt(3.0));
    ASSERT_TRUE(scan.at(center).has_value());
    EXPECT_NEAR(*scan.at(center), marker.value, 1e-2);
  }
  // Two voxels from any marker the ramp is interpolated exactly but for the rounding of values.
  for (const Vec3& lps : {Vec3(-9.5, 3.25, -14), Vec3(10.125, -20.5, -6.75)})
    EXPECT_NEAR(scan.at(lps).value_or(-1e9), tests::phantomValue(lps), 0.51);
  EXPECT_FALSE(scan.at(Vec3(0, 0, 400)).has_value());
}

TEST_F(ScanFormats, ReadThePhantomInAllOrientationsFromNiftiNrrdAndMetaImage) {
  for (const auto& [name, image] : tests::orientedPhantoms()) {
    expectPhantom(read("a.nii", tests::niftiFile(image)), image, name + " as NIfTI by the sform");
    expectPhantom(read("b.nii.gz", tests::gzipped(tests::niftiFile(image, tests::NiftiForm::qform))), image,
                  name + " as packed NIfTI by the qform");
    expectPhantom(read("c.nrrd", tests::nrrdFile(image)), image, name + " as NRRD");
    expectPhantom(read("d.nrrd", tests::nrrdFile(image, "right-anterior-superior")), image,
                  name + " as NRRD in RAS");
    expectPhantom(read("e.mha", tests::metaImageFile(image)), image, name + " as MetaImage");
  }
}

} // namespace
} // namespace viscera::medical_io
