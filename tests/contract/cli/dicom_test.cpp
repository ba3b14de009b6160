#include <algorithm>

#include <gmock/gmock.h>

#include "cli_test.h"
#include "dicom_slices.h"

namespace viscera::app::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class DicomCli : public CliTest {
protected:
  /// 16 slices of Jane Doe around the cube.
  std::string scan() const {
    tests::LabelImage image = tests::emptyLabels({32, 32, 16});
    image.indexToLps.linear() = Vec3(2, 2, 3).asDiagonal();
    image.indexToLps.translation() = Vec3(-32, -32, -24);
    std::filesystem::create_directories(path("ct"));
    for (int k = 0; k < image.size[2]; ++k) {
      tests::DicomElements slice = tests::dicomSlice(image, k, "1.2.840.4711.2");
      slice[0x0020000D] = "UI1.2.840.4711.1";
      slice[0x00100020] = "LOPID0815";
      slice[0x00200052] = "UI1.2.840.4711.9";
      put("ct/" + std::to_string(k), tests::dicomBytes(slice));
    }
    return path("ct");
  }
};

TEST_F(DicomCli, WritesEveryObjectOfAnOrganInItsScansStudy) {
  const std::string cube = put("PID0815.off", cubeOff(10));
  const json kept = runJson({"dicom", cube, "--scan", scan(), "--seg", "--sr", "--stl", "--rtstruct", "--pdf",
                             put("r.pdf", "%PDF-1.4\nthe end"), "-o", path("kept")});
  ASSERT_EQ(kept["files"].size(), 5u);
  EXPECT_EQ(kept["files"][0]["kind"], "segmentation");
  EXPECT_EQ(kept["identity"]["PatientID"], "PID0815");
  EXPECT_EQ(kept["images"], 16);
  EXPECT_FALSE(kept["identityRemoved"].get<bool>());
  const json clean = runJson({"dicom", cube, "--scan", path("ct"), "--seg", "--sr", "--stl", "--rtstruct",
                              "--without-identity", "-o", path("clean")});
  EXPECT_TRUE(clean["identity"].empty());
  for (const json& one : clean["files"]) {
    const std::string bytes = contents(one["file"].get<std::string>());
    for (const char* const value : {"PID0815", "Doe", "Jane", "1.2.840.4711."})
      EXPECT_THAT(bytes, Not(HasSubstr(value))) << one;
  }
  for (const json& result : {kept, clean})
    for (const json& one : result["files"])
      if (std::filesystem::exists("/usr/bin/dciodvfy")) {
        const test::ProcessResult found =
            test::runProcess({"/usr/bin/dciodvfy", one["file"].get<std::string>()});
        EXPECT_THAT(found.err + found.out, Not(HasSubstr("Error - "))) << one;
      }
}

TEST_F(DicomCli, SaysWhatItCannotWrite) {
  const std::string cube = put("cube.off", cubeOff(10));
  expectFailure({"dicom", cube, "-o", path("o")}, kUsage, "No DICOM object is chosen");
  expectFailure({"dicom", cube, "--rtstruct", "-o", path("o")}, kBadData, "");
  expectFailure({"dicom", cube, "--pdf", put("r.pdf", "%PDF-1.4"), "--without-identity", "-o", path("o")},
                kBadData, "identity is to be removed");
  EXPECT_FALSE(std::filesystem::exists(path("o")));
}

} // namespace
} // namespace viscera::app::cli
