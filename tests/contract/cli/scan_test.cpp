#include <cmath>
#include <filesystem>

#include "build_paths.h"
#include "cine_pictures.h"
#include "cli_test.h"
#include "dicom_slices.h"
#include "phantom_scan.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"

namespace viscera::app::cli {

/// Scans on the command line: `info`, `probe` and `warp`.
class CliScan : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    image_ = tests::orientedPhantomGrid(2, {0, 1, 2});
    tests::fillPhantom(image_);
    scan_ = put("ct.nii", tests::niftiFile(image_));
    rest_ = put("rest.mrk.json", markups(corners(30)));
  }

  /// A folder with the phantom as DICOM, without the layers of `left`.
  std::string dicomFolder(int left = -1) const {
    std::filesystem::create_directories(path("dicom"));
    for (int k = 0; k < image_.size[2]; ++k)
      if (k != left)
        put("dicom/" + std::to_string(k), tests::dicomBytes(tests::dicomSlice(image_, k)));
    return path("dicom");
  }

  tests::LabelImage image_;
  std::string scan_, rest_;
};

TEST_F(CliScan, InfoSaysWhatIsInIt) {
  const json info = runJson({"info", scan_});
  EXPECT_EQ(info["kind"], "scan");
  EXPECT_EQ(info["size"], json::array({21, 23, 17}));
  EXPECT_NEAR(info["spacingMm"][1].get<double>(), 4, 1e-6);
  EXPECT_NEAR(info["originMm"][0].get<double>(), -21, 1e-4);
  EXPECT_NEAR(info["directions"][1][1].get<double>(), -1, 1e-6) << "flipped";
  EXPECT_EQ(info["maximum"], 2004);
  EXPECT_TRUE(info["minimum"].is_number());
  EXPECT_EQ(info["phases"], 1);
  EXPECT_TRUE(info["findings"].is_array());
  for (const char* key : {"modality", "unit", "transferSyntax", "space", "description"})
    EXPECT_TRUE(info[key].is_string()) << key;
}

TEST_F(CliScan, InfoOfADicomFolderNamesWhatIsOdd) {
  const json info = runJson({"info", dicomFolder(12)});
  EXPECT_EQ(info["modality"], "CT");
  EXPECT_EQ(info["unit"], "HU");
  EXPECT_EQ(info["transferSyntax"], "Little Endian Explicit");
  ASSERT_EQ(info["series"].size(), 3U) << "the longest even part, the other one, all resampled";
  EXPECT_EQ(info["series"][0]["files"], 16);
  EXPECT_EQ(info["series"][0]["slices"],
            json({{"first", 5}, {"last", 16}, {"all", 16}, {"resampled", false}}));
  EXPECT_TRUE(info["series"][2]["slices"]["resampled"].get<bool>());
  ASSERT_EQ(info["findings"].size(), 2U);
  EXPECT_EQ(info["findings"][0]["kind"], "part-read");
  EXPECT_EQ(info["findings"][1]["kind"], "missing-slice");
  EXPECT_EQ(info["size"][2], 12);
  EXPECT_EQ(info["warnings"].size(), 2U);
  expectFailure({"info", path("dicom"), "--series", "9.9"}, kUsage, "It has no series 9.9");
}

TEST_F(CliScan, InfoListsACineStudyAsOnePatient) {
  std::filesystem::create_directories(path("cine"));
  std::string cut;
  for (tests::CinePicture picture :
       {tests::shortAxisPicture(1, 0, 860), tests::shortAxisPicture(2, 17.7, 776),
        tests::longAxisPicture(6, 121, 900)})
    for (picture.phase = 0; picture.phase < picture.phases; ++picture.phase) {
      std::string bytes = tests::dicomBytes(tests::cineElements(picture));
      if (picture.series == 2 && picture.phase == 4) {
        bytes.resize(bytes.size() - 10);
        cut = tests::cineFileName(picture);
      }
      put("cine/" + tests::cineFileName(picture), bytes);
    }
  const json info = runJson({"info", path("cine")});
  EXPECT_EQ(info["kind"], "cine study");
  EXPECT_EQ(info["date"], "20240301");
  ASSERT_EQ(info["series"].size(), 3U);
  EXPECT_EQ(info["series"][1]["number"], 2);
  EXPECT_EQ(info["series"][1]["description"], "cine");
  EXPECT_EQ(info["series"][1]["spacingMm"], json::array({2.0, 2.0}));
  EXPECT_EQ(info["series"][1]["thicknessMm"], 6);
  const json slice = info["series"][1]["slices"][0];
  EXPECT_EQ(slice["plane"], "short axis");
  EXPECT_EQ(slice["phases"], 11);
  ASSERT_EQ(slice["missingFractions"].size(), 1U);
  EXPECT_NEAR(slice["missingFractions"][0].get<double>(), 1.0 / 3, 1e-6);
  EXPECT_NEAR(slice["intervalMs"].get<double>(), 776, 1e-9);
  EXPECT_EQ(info["series"][2]["slices"][0]["plane"], "4-chamber");
  ASSERT_EQ(info["stacks"].size(), 1U);
  EXPECT_EQ(info["stacks"][0]["series"], json::array({1, 2}));
  EXPECT_NEAR(info["stacks"][0]["gapsMm"][0].get<double>(), 11.7, 1e-6);
  const std::string warnings = info["warnings"].dump();
  EXPECT_NE(warnings.find(cut), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("phase 4 of series 2"), std::string::npos) << warnings;
  EXPECT_EQ(runJson({"info", path("cine"), "--phase", "1"})["kind"], "scan");
}

TEST_F(CliScan, InfoNamesTheOtherHalfOfThePatientBesideIt) {
  EXPECT_TRUE(runJson({"info", scan_})["beside"].is_null());
  tests::LabelImage labels = image_;
  labels.voxels.assign(labels.voxels.size(), 0);
  labels.fill({2, 2, 2}, {8, 9, 9}, 1);
  const std::string file = put("ct_labels.nii", tests::niftiFile(labels));
  EXPECT_EQ(runJson({"info", scan_})["beside"], file);
  EXPECT_EQ(runJson({"info", file})["beside"], scan_);
}

TEST_F(CliScan, ALabelMapStaysOne) {
  tests::LabelImage labels = tests::emptyLabels();
  labels.fill({2, 2, 2}, {8, 9, 9}, 1);
  EXPECT_EQ(runJson({"info", put("labels.nii", tests::niftiFile(labels))})["kind"], "label map");
}

TEST_F(CliScan, ProbeReadsEveryMarkerAtItsPlace) {
  std::vector<std::string> arguments = {"probe", scan_};
  for (const tests::ScanMarker& marker : tests::scanMarkers()) {
    const Vec3 index = (image_.indexToLps.inverse() * marker.lps).array().round();
    const Vec3 center = image_.indexToLps * index;
    arguments.push_back("--at");
    arguments.push_back(tests::decimal(center.x()) + "," + tests::decimal(center.y()) + "," +
                        tests::decimal(center.z()));
  }
  arguments.insert(arguments.end(), {"--at", "-500,0,0"});
  const json values = runJson(arguments)["values"];
  ASSERT_EQ(values.size(), 5U);
  for (std::size_t m = 0; m < 4; ++m) {
    EXPECT_NEAR(values[m]["value"].get<double>(), tests::scanMarkers()[m].value, 0.1);
    EXPECT_EQ(values[m]["inside"], true);
    EXPECT_TRUE(values[m]["positionMm"].is_array());
  }
  EXPECT_EQ(values[4]["inside"], false);
  EXPECT_TRUE(values[4]["value"].is_null());
  expectFailure({"probe", scan_, "--at", "1,2"}, kUsage, "It is not a position X,Y,Z");
  expectFailure({"probe", path("none.nii"), "--at", "1,2,3"}, kNoInput, "There is no such file");
}

TEST_F(CliScan, WarpMovesAScanAlongWithTheHandles) {
  std::vector<std::array<double, 3>> moved = corners(30);
  for (auto& corner : moved)
    corner[2] += 8;
  const std::string pose = put("pose.mrk.json", markups(moved));
  const json warp =
      runJson({"warp", dicomFolder(), "--handles", rest_, "--pose", pose, "-o", path("out.nii.gz")});
  EXPECT_EQ(warp["file"], path("out.nii.gz"));
  EXPECT_EQ(warp["size"], json::array({21, 23, 17}));
  EXPECT_LT(warp["largestErrorVoxel"].get<double>(), 0.05);
  EXPECT_EQ(warp["folded"], 0);
  EXPECT_TRUE(warp["seconds"].is_number());
  // Markers within the handles went up by 8 mm.
  const json values = runJson({"probe", path("out.nii.gz"), "--at", "0,0,8", "--at", "18,16,-16"})["values"];
  EXPECT_NEAR(values[0]["value"].get<double>(), 2001, 1);
  EXPECT_NEAR(values[1]["value"].get<double>(), 2004, 1);
  expectFailure({"warp", scan_, "--handles", rest_, "--pose", pose, "-o", path("out.png")}, kCannotCreate,
                "cannot be written as \".png\"");
}

TEST_F(CliScan, WarpMovesALabelMap) {
  tests::LabelImage labels = tests::emptyLabels({30, 30, 30});
  labels.indexToLps.linear() *= 2;
  labels.indexToLps.translation().setConstant(-30);
  labels.fill({10, 10, 10}, {18, 18, 18}, 4);
  std::vector<std::array<double, 3>> moved = corners(30);
  for (auto& corner : moved)
    corner[0] -= 6;
  const json warp = runJson({"warp", put("labels.nrrd", tests::nrrdFile(labels)), "--handles", rest_,
                             "--pose", put("pose.mrk.json", markups(moved)), "-o", path("out.seg.nrrd")});
  EXPECT_EQ(warp["kind"], "label map");
  const json info = runJson({"info", path("out.seg.nrrd")});
  ASSERT_EQ(info["labels"].size(), 1U);
  EXPECT_EQ(info["labels"][0]["label"], 4);
  EXPECT_EQ(info["labels"][0]["voxels"], 9 * 9 * 9);
}

TEST_F(CliScan, WarpBendsNoBone) {
  tests::LabelImage labels = tests::emptyLabels({30, 30, 30});
  labels.indexToLps.linear() *= 2;
  labels.indexToLps.translation().setConstant(-30);
  labels.fill({12, 12, 8}, {17, 17, 21}, 4);
  std::vector<std::array<double, 3>> longer = corners(30);
  for (auto& corner : longer)
    corner[2] *= 1.5;
  const auto file = [&](const std::string& name) {
    return put(name + ".seg.nrrd",
               tests::nrrdFile(labels, "left-posterior-superior",
                               "Segment0_ID:=s\nSegment0_Name:=" + name + "\nSegment0_LabelValue:=4\n"));
  };
  const auto heightOf = [&](const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {
        "warp", file(name),          "--handles", rest_, "--pose", put("longer.mrk.json", markups(longer)),
        "-o",   path("out.seg.nrrd")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const json warp = runJson(arguments);
    const json info = runJson({"info", path("out.seg.nrrd")});
    return std::pair(info["labels"][0]["voxels"].get<double>(), warp["rigid"]);
  };
  const double voxels = 6 * 6 * 14;
  EXPECT_EQ(heightOf("left femur"), std::pair(voxels, json::array({"left femur"})));
  EXPECT_EQ(heightOf("spleen").second, json::array());
  EXPECT_GT(heightOf("spleen").first, 1.3 * voxels);
  EXPECT_GT(heightOf("left femur", {"--bend-bones"}).first, 1.3 * voxels);
  const auto [kept, rigid] = heightOf("spleen", {"--rigid", file("spleen")});
  EXPECT_EQ(kept, voxels) << "what is told not to bend";
  EXPECT_EQ(rigid, json::array({"spleen"}));
}

/// A CT of a patient with its segmentation, 3 mm fine, and a box of handles around it.
class CliWarpOfACt : public CliTest {
protected:
  void SetUp() override {
    CliTest::SetUp();
    if (!std::filesystem::exists(kCt / "example_ct_sm.nii.gz"))
      GTEST_SKIP() << "../shared/organs/ct is not there";
    rest_ = put("rest.mrk.json", markups(posed([](const Vec3& p) { return p; })));
    scan_ = readScan((kCt / "example_ct_sm.nii.gz").string());
  }
  template <typename Motion>
  static std::vector<std::array<double, 3>> posed(Motion motion) {
    std::vector<std::array<double, 3>> list;
    for (int c = 0; c < 8; ++c) {
      const Vec3 p = motion(Vec3(c & 1 ? 300 : -300, c & 2 ? 130 : -450, c & 4 ? 360 : -80));
      list.push_back({p.x(), p.y(), p.z()});
    }
    return list;
  }
  static medical_io::Scan readScan(const std::string& file) {
    Progress progress;
    return medical_io::readScan(file, {}, progress);
  }
  json warp(const std::string& image, const std::string& rest, const std::string& pose,
            const std::string& out) {
    return runJson({"warp", image, "--handles", rest, "--pose", pose, "-o", out});
  }
  /// Of the differences of two scans at voxels away from their borders, as a root of the mean square.
  template <typename Value>
  double difference(Value value) const {
    double sum = 0;
    int count = 0;
    for (int k = 8; k < scan_.size[2] - 8; ++k)
      for (int j = 15; j < scan_.size[1] - 15; ++j)
        for (int i = 15; i < scan_.size[0] - 15; ++i, ++count)
          sum += std::pow(value(i, j, k) - scan_.value(i, j, k), 2);
    return std::sqrt(sum / count);
  }

  inline static const std::filesystem::path kCt = std::filesystem::path(VISCERA_SHARED_ORGANS) / "ct";
  std::string rest_;
  medical_io::Scan scan_;
};

TEST_F(CliWarpOfACt, APoseAndItsReverseBringItBackButForInterpolation) {
  const Eigen::Affine3d turn =
      Eigen::Translation3d(4, -5, 6) * Eigen::AngleAxisd(0.06, Vec3(1, 2, 8).normalized());
  const std::string pose = put("pose.mrk.json", markups(posed([&](const Vec3& p) { return turn * p; })));
  const std::string there = path("there.nii.gz"), back = path("back.nii.gz");
  const json first = warp((kCt / "example_ct_sm.nii.gz").string(), rest_, pose, there);
  EXPECT_LT(first["largestErrorVoxel"].get<double>(), 0.05);
  EXPECT_EQ(first["folded"], 0);
  warp(there, pose, rest_, back);
  const medical_io::Scan moved = readScan(there), again = readScan(back);
  // What interpolating twice does at most: a shift by half a voxel along each axis, and back.
  const auto halfShift = [this](int i, int j, int k) {
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner)
      sum += scan_
                 .at(scan_.indexToLps *
                     Vec3(i + 0.5 - (corner & 1), j + 0.5 - (corner >> 1 & 1), k + 0.5 - (corner >> 2)))
                 .value_or(0);
    return sum / 8;
  };
  const double returned = difference([&](int i, int j, int k) { return again.value(i, j, k); });
  EXPECT_LT(returned, difference(halfShift));
  EXPECT_GT(difference([&](int i, int j, int k) { return moved.value(i, j, k); }), 3 * returned)
      << "else nothing is proved";
}

TEST_F(CliWarpOfACt, ScanAndLabelMapBendAlike) {
  const std::string pose = put("pose.mrk.json", markups(posed([](const Vec3& p) {
                                 return Vec3(p.z() > 0 && p.y() < 0 ? Vec3(p + Vec3(40, 60, -30)) : p);
                               })));
  const json warped = warp((kCt / "example_ct_sm.nii.gz").string(), rest_, pose, path("ct.nii.gz"));
  EXPECT_LT(warped["largestErrorVoxel"].get<double>(), 0.05);
  EXPECT_EQ(warped["folded"], 0);
  EXPECT_GT(warped["moved"].get<int>(), 300000);
  warp((kCt / "example_seg.nii.gz").string(), rest_, pose, path("seg.nii.gz"));
  Progress progress;
  const auto meanOfLargest = [&](const std::filesystem::path& labels, const medical_io::Scan& scan) {
    const medical_io::LabelMap map = medical_io::readLabelMap(labels, progress);
    std::size_t largest = 0;
    for (std::size_t s = 0; s < map.segments.size(); ++s)
      largest = map.segments[s].voxels > map.segments[largest].voxels ? s : largest;
    double sum = 0;
    for (std::size_t v = 0; v < map.voxelCount(); ++v)
      if (map.layers[0][v] == largest + 1)
        sum += std::visit([&](const auto& s) { return scan.slope * double(s[v]) + scan.intercept; },
                          scan.samples);
    return sum / double(map.segments[largest].voxels);
  };
  EXPECT_NEAR(meanOfLargest(path("seg.nii.gz"), readScan(path("ct.nii.gz"))),
              meanOfLargest(kCt / "example_seg.nii.gz", scan_), 6)
      << "Hounsfield units within the largest organ";
}

} // namespace viscera::app::cli
