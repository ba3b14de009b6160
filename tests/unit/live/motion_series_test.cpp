#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include <gtest/gtest.h>

#include "beating_labels.h"
#include "open_balls.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/live/motion_series.h"

namespace viscera::live {
namespace {

const std::vector<LabelledSurface> kHeart = {{"LV", {"1"}}, {"RV", {"2"}}, {"EPI", {"1", "2", "3"}}};

MotionSeries read(const SeriesRequest& request) {
  Progress progress;
  return readMotionSeries(request, progress);
}

/// What refusing a series says.
std::string refusalOf(const SeriesRequest& request) {
  try {
    read(request);
  } catch (const Error& error) {
    return error.what();
  }
  return "not refused";
}

std::string objOf(const geometry::TriangleMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  for (const auto& p : mesh.points.rowwise())
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : mesh.triangles.rowwise())
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return out.str();
}

/// A folder with a series in it.
class Series {
public:
  /// Label maps, one a phase; `change` may spoil one.
  void labels(std::size_t count, const std::function<void(std::size_t, tests::LabelImage&)>& change = {}) {
    for (std::size_t phase = 0; phase < count; ++phase) {
      tests::LabelImage image = tests::beatingLabels(double(phase) / double(count), Vec3(4, 4, 6));
      if (change)
        change(phase, image);
      folder_.put("beat_" + std::to_string(phase) + ".nrrd", tests::nrrdFile(image));
    }
  }
  /// Balls, one a phase, of these radii, about `center`.
  void balls(
      const std::string& name, const std::vector<double>& radii,
      const std::function<Vec3(std::size_t)>& center = [](std::size_t) { return Vec3(60, 40, 9); }) {
    for (std::size_t phase = 0; phase < radii.size(); ++phase)
      folder_.put(name + "_" + std::to_string(phase + 1) + ".obj",
                  objOf(tests::sphere(2, radii[phase], center(phase))));
  }
  std::filesystem::path put(const std::string& name, const std::string& contents) {
    return folder_.put(name, contents);
  }
  SeriesRequest request(const std::vector<LabelledSurface>& surfaces = {}, double period = 0.8) const {
    SeriesRequest request;
    request.inputs = {folder_.path()};
    request.surfaces = surfaces;
    if (period > 0)
      request.periodSeconds = period;
    return request;
  }

private:
  tests::TemporaryFolder folder_;
};

const std::vector<double> kBeat = {20, 19, 18, 17, 16, 15, 16, 17, 18, 19, 19.5};

TEST(SeriesName, IsWithoutItsLastNumberAndEnding) {
  EXPECT_EQ(seriesName("patient1_RV_ENDOCARDIAL_012.obj").first, "patient1_RV_ENDOCARDIAL");
  EXPECT_EQ(seriesName("patient1_RV_ENDOCARDIAL_012.obj").second, 12U);
  EXPECT_EQ(seriesName("lv-3_smooth.vtp").first, "lv_smooth");
  EXPECT_EQ(seriesName("frame10.nii.gz").second, 10U);
  EXPECT_EQ(seriesName("frame.seg.nrrd").first, "frame");
  EXPECT_FALSE(seriesName("frame.seg.nrrd").second);
  EXPECT_EQ(seriesName("cavit\xE9_3.vtp").first, "cavit\xC3\xA9") << "names become UTF-8";
}

TEST(MotionSeries, SortsFramesByTheirNumberAndSurfacesByTheirName) {
  Series series;
  series.balls("outer", kBeat);
  series.balls("cavity", {10, 9.5, 9, 8.5, 8, 7.5, 8, 8.5, 9, 9.5, 9.7});
  const MotionSeries found = read(series.request());
  EXPECT_EQ(found.names, (std::vector<std::string>{"outer", "cavity"}));
  EXPECT_EQ(found.outer, 0U);
  ASSERT_EQ(found.phases(), 11U);
  ASSERT_EQ(found.files.size(), 2U) << "where each surface came from";
  for (std::size_t surface : {0U, 1U}) {
    ASSERT_EQ(found.files[surface].size(), 11U);
    EXPECT_EQ(found.files[surface].front().filename(), found.names[surface] + "_1.obj");
    EXPECT_EQ(found.files[surface].back().filename(), found.names[surface] + "_11.obj");
  }
  ASSERT_EQ(found.corresponding.size(), 2U);
  for (std::size_t phase = 0; phase < 11; ++phase)
    EXPECT_NEAR(std::cbrt(found.volumesMl[phase][0] / found.volumesMl[0][0]), kBeat[phase] / 20, 1e-9);
  EXPECT_NEAR(found.times.seconds[10], 0.8 * 10 / 11, 1e-12);
}

TEST(MotionSeries, MakesSurfacesOfSeveralLabels) {
  Series series;
  series.labels(6);
  const MotionSeries found = read(series.request(kHeart));
  EXPECT_EQ(found.names, (std::vector<std::string>{"EPI", "LV", "RV"}));
  EXPECT_DOUBLE_EQ(found.sliceMm(), 6);
  for (const auto& files : found.files)
    EXPECT_EQ(files.size(), 6U) << "the same label maps for each surface";
  EXPECT_EQ(found.files.size(), 3U);
  for (std::size_t phase = 0; phase < 6; ++phase) {
    const tests::LabelImage image = tests::beatingLabels(double(phase) / 6, Vec3(4, 4, 6));
    const auto all = std::count_if(image.voxels.begin(), image.voxels.end(), [](auto v) { return v > 0; });
    const auto lv = std::count(image.voxels.begin(), image.voxels.end(), 1);
    EXPECT_NEAR(found.volumesMl[phase][0], 0.096 * double(all), 1e-9);
    EXPECT_NEAR(found.volumesMl[phase][1], 0.096 * double(lv), 1e-9);
    EXPECT_EQ(found.masks[phase][0].size, found.masks[0][0].size) << "all phases on one grid";
  }
}

TEST(MotionSeries, KnowsTheLabelsOfAHeart) {
  Series series;
  series.labels(5);
  series.put("labels.txt", "1 heart_ventricle_left 255 0 0 255\n2 heart_ventricle_right 0 0 255 255\n"
                           "3 heart_myocardium 200 100 0 255\n");
  const MotionSeries found = read(series.request());
  EXPECT_EQ(found.names, (std::vector<std::string>{"heart", "LV", "RV"}));
  EXPECT_GT(found.volumesMl[0][0], found.volumesMl[0][1] + found.volumesMl[0][2]);
}

TEST(MotionSeries, ReadsOneFileOfSeveralVolumesWithItsTimes) {
  Series series;
  std::vector<tests::LabelImage> phases;
  for (int phase = 0; phase < 8; ++phase)
    phases.push_back(tests::beatingLabels(phase / 8.0, Vec3(4, 4, 6)));
  SeriesRequest request = series.request(kHeart, 0);
  request.inputs = {series.put("cine.nii", tests::nifti4d(phases, 100, 16))};
  EXPECT_NEAR(read(request).times.periodSeconds, 0.8, 1e-6);
  request.periodSeconds = 1.6;
  EXPECT_NEAR(read(request).times.seconds[1], 0.2, 1e-6) << "the period that is said goes before the file's";
}

TEST(MotionSeries, DropsALastPhaseThatIsTheFirstAgain) {
  Series series;
  std::vector<double> radii = kBeat;
  radii.push_back(20);
  series.balls("outer", radii);
  const MotionSeries found = read(series.request());
  EXPECT_EQ(found.phases(), 11U);
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings.back().english().find("the last phase equals the first and is left out"),
            std::string::npos);
}

TEST(MotionSeries, LeavesPhasesOutAndTakesUnevenTimes) {
  Series series;
  series.balls("outer", kBeat);
  SeriesRequest request = series.request();
  request.leftOut = {3};
  MotionSeries found = read(request);
  EXPECT_EQ(found.phases(), 10U);
  EXPECT_NEAR(found.times.seconds[3], 0.8 * 4 / 11, 1e-12);
  request = series.request();
  request.seconds = {0, 0.1, 0.2, 0.3, 0.32, 0.34, 0.4, 0.5, 0.6, 0.7, 0.75};
  found = read(request);
  EXPECT_DOUBLE_EQ(found.times.seconds[4], 0.32);
}

TEST(MotionSeries, TakesSurfacesOfOtherTrianglesByTheirDistances) {
  Series series;
  series.balls("outer", kBeat);
  series.put("outer_3.obj", objOf(tests::sphere(3, 18, Vec3(60, 40, 9))));
  const MotionSeries found = read(series.request());
  EXPECT_TRUE(found.corresponding.empty());
  ASSERT_EQ(found.meshes.size(), 11U);
  EXPECT_NE(found.warnings.front().english().find("outer has other triangles in phase 3 than in the first"),
            std::string::npos);
}

TEST(MotionSeries, KnowsTheRimsThatSurfacesOfOtherTrianglesHaveInEveryPhase) {
  const std::vector<double> openings = {0.75, 0.77, 0.79, 0.8, 0.78, 0.76};
  Series series;
  for (std::size_t phase = 0; phase < openings.size(); ++phase) {
    const int around = 24 + static_cast<int>(phase);
    geometry::TriangleMesh ball = tests::openBall(openings[phase], 14, around).mesh;
    ball.points.conservativeResize(ball.points.rows() - 1, 3); // Without its cap.
    ball.triangles.conservativeResize(ball.triangles.rows() - around, 3);
    series.put("outer_" + std::to_string(phase) + ".obj", objOf(ball));
  }
  SeriesRequest request = series.request();
  request.leftOut = {1};
  const MotionSeries found = read(request);
  ASSERT_EQ(found.rims.size(), 5U);
  for (std::size_t phase = 0; phase < 5; ++phase) {
    ASSERT_EQ(found.rims[phase].size(), 1U);
    ASSERT_EQ(found.rims[phase][0].size(), 1U) << "its valve, in phase " << phase;
    const Points rim = tracking::pointsOf(found.rims[phase][0][0], found.meshes[phase][0]->points);
    const double height = tests::kOpenBallMm * std::cos(openings[phase < 1 ? phase : phase + 1]);
    EXPECT_LT((rim.col(2).array() - height).abs().maxCoeff(), 1e-4) << phase;
  }
}

TEST(MotionSeriesRefuses, FewerThanFourPhases) {
  Series series;
  series.balls("outer", {20, 19, 19.5});
  EXPECT_NE(refusalOf(series.request()).find("It has 3 phases; a motion needs four at least"),
            std::string::npos);
}

TEST(MotionSeriesRefuses, ALabelThatIsMissingInAPhase) {
  Series series;
  series.labels(5, [](std::size_t phase, tests::LabelImage& image) {
    if (phase == 2)
      std::replace(image.voxels.begin(), image.voxels.end(), std::int16_t{2}, std::int16_t{3});
  });
  EXPECT_NE(refusalOf(series.request(kHeart)).find("The label \"2\" is missing in phase 3"),
            std::string::npos);
}

TEST(MotionSeriesRefuses, ASurfaceThatIsMissingInAPhase) {
  Series series;
  series.balls("outer", kBeat);
  series.balls("cavity", {10, 9, 8, 9});
  EXPECT_NE(refusalOf(series.request()).find("he surface \"cavity\" is missing in phase number 5"),
            std::string::npos);
}

TEST(MotionSeriesRefuses, ACavityThatTheImageCutsInSomePhases) {
  Series series;
  series.labels(5, [](std::size_t phase, tests::LabelImage& image) {
    if (phase == 1)
      image.fill({8, 9, 0}, {10, 11, 2}, 1);
  });
  const std::string refusal = refusalOf(series.request(kHeart));
  EXPECT_NE(refusal.find("LV touches the edge of the image in phase 2 and not in others"), std::string::npos)
      << refusal;
}

TEST(MotionSeries, SaysThatTheImageCutsTheOuterSurfaceAndGoesOn) {
  Series series;
  series.labels(5, [](std::size_t phase, tests::LabelImage& image) {
    if (phase == 1)
      image.fill({8, 9, 0}, {10, 11, 2}, 3);
  });
  const MotionSeries found = read(series.request(kHeart));
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings.back().english().find("EPI touches the edge of the image in phase 2"),
            std::string::npos)
      << found.warnings.back();
}

TEST(MotionSeriesRefuses, GridsThatDiffer) {
  Series series;
  series.labels(5, [](std::size_t phase, tests::LabelImage& image) {
    if (phase == 3)
      image.indexToLps = Eigen::Translation3d(0, 0, 1) * image.indexToLps;
  });
  EXPECT_NE(refusalOf(series.request(kHeart))
                .find("The grid of phase 4 is another one than that of the first phase"),
            std::string::npos);
}

TEST(MotionSeriesRefuses, ShearedGrids) {
  Series series;
  series.labels(5, [](std::size_t, tests::LabelImage& image) { image.indexToLps.linear()(0, 2) = 1; });
  EXPECT_NE(refusalOf(series.request(kHeart)).find("Its grid is sheared"), std::string::npos);
}

TEST(MotionSeriesRefuses, TimesThatDoNotAscendWithinThePeriod) {
  Series series;
  series.balls("outer", kBeat);
  SeriesRequest request = series.request();
  request.seconds = {0, 0.1, 0.2, 0.3, 0.29, 0.34, 0.4, 0.5, 0.6, 0.7, 0.75};
  EXPECT_NE(refusalOf(request).find("do not ascend within one period of 800 ms: phase 5 is at 290.0 ms"),
            std::string::npos);
  request.seconds = {0, 0.1, 0.2, 0.3, 0.32, 0.34, 0.4, 0.5, 0.6, 0.7, 0.8};
  EXPECT_NE(refusalOf(request).find("phase 11 is at 800.0 ms"), std::string::npos);
  request.seconds = {0, 0.1};
  EXPECT_NE(refusalOf(request).find("There are 2 times for 11 phases"), std::string::npos);
}

TEST(MotionSeriesRefuses, ASeriesWithoutAPeriod) {
  Series series;
  series.balls("outer", kBeat);
  EXPECT_NE(refusalOf(series.request({}, 0)).find("The duration of one cycle is unknown"), std::string::npos);
}

TEST(MotionSeriesRefuses, ACavityOutsideTheOuterSurface) {
  Series series;
  series.balls("outer", kBeat);
  series.balls("cavity", {10, 9.5, 9, 8.5, 8, 7.5, 8, 8.5, 9, 9.5, 9.7},
               [](std::size_t) { return Vec3(90, 40, 9); });
  EXPECT_NE(refusalOf(series.request()).find("The cavity cavity is not inside the outer surface outer"),
            std::string::npos);
  Series labels;
  labels.labels(5);
  const std::string refusal = refusalOf(labels.request({{"LV", {"1"}}, {"RV", {"2"}}, {"wall", {"3"}}}));
  EXPECT_NE(refusal.find("give the outer surface the labels of its cavities too"), std::string::npos)
      << refusal;
}

TEST(MotionSeriesRefuses, AVolumeThatJumps) {
  Series series;
  series.balls("outer", {20, 19, 18, 12, 16, 15, 16, 17, 18, 19, 19.5});
  const std::string refusal = refusalOf(series.request());
  EXPECT_NE(refusal.find("The volume of outer jumps from"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("between phase 3 and phase 4"), std::string::npos) << refusal;
}

TEST(MotionSeriesRefuses, RasAgainstLps) {
  Series series;
  series.balls("outer", kBeat,
               [](std::size_t phase) { return phase == 4 ? Vec3(-60, -40, 9) : Vec3(60, 40, 9); });
  EXPECT_NE(refusalOf(series.request()).find("It seems to be in RAS where the first phase is in LPS"),
            std::string::npos);
  Series stated;
  stated.balls("outer", kBeat);
  stated.put("outer_2.obj", "# SPACE=RAS\n" + objOf(tests::sphere(2, 19, Vec3(-60, -40, 9))));
  EXPECT_NE(refusalOf(stated.request())
                .find("This file does not state its axes, but other files of the series are in RAS"),
            std::string::npos);
}

TEST(MotionSeriesRefuses, WhatDoesNotLeadBackUnlessItIsPlayedOnce) {
  Series series;
  series.balls("outer", {20, 19, 18, 17, 16, 15, 14});
  SeriesRequest request = series.request();
  const std::string refusal = refusalOf(request);
  EXPECT_NE(refusal.find("The last phase does not lead back to the first"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("--once"), std::string::npos);
  request.loop = false;
  EXPECT_FALSE(read(request).times.loop);
}

TEST(MotionSeriesRefuses, LabelsThatNobodyHasChosen) {
  Series series;
  series.labels(5);
  const std::string refusal = refusalOf(series.request());
  EXPECT_NE(refusal.find("It has several labels: label 1 (1), label 2 (2), label 3 (3)"), std::string::npos)
      << refusal;
}

TEST(MotionSeriesRefuses, AFileThatIsCutOff) {
  Series series;
  series.labels(5);
  const tests::LabelImage image = tests::beatingLabels(0.6, Vec3(4, 4, 6));
  const std::string whole = tests::nrrdFile(image);
  series.put("beat_3.nrrd", whole.substr(0, whole.size() / 2));
  const std::string refusal = refusalOf(series.request(kHeart));
  EXPECT_NE(refusal.find("beat_3.nrrd"), std::string::npos) << refusal;
  Series surfaces;
  surfaces.balls("outer", kBeat);
  const std::string ball = objOf(tests::sphere(2, 17, Vec3(60, 40, 9)));
  surfaces.put("outer_4.obj", ball.substr(0, ball.size() / 3));
  EXPECT_NE(refusalOf(surfaces.request()).find("outer_4.obj"), std::string::npos)
      << refusalOf(surfaces.request());
}

/// TotalSegmentator's folder is one image, however many files it has.
TEST(MotionSeriesRefuses, AFolderOfMasksOfOneHeart) {
  Series series;
  const tests::LabelImage whole = tests::beatingLabels(0, Vec3(4, 4, 6));
  const std::vector<std::string> names = {"heart_ventricle_left", "heart_ventricle_right",
                                          "heart_myocardium"};
  for (std::size_t label = 0; label < names.size(); ++label) {
    tests::LabelImage mask = whole;
    for (std::int16_t& voxel : mask.voxels)
      voxel = voxel == std::int16_t(label + 1) ? 1 : 0;
    series.put(names[label] + ".nii", tests::niftiFile(mask));
  }
  const std::string refusal = refusalOf(series.request());
  EXPECT_NE(refusal.find("It has 1 phase; a motion needs four at least"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("--textbook"), std::string::npos) << refusal;
  Progress progress;
  const MotionSeries image = readOnePhase(series.request(), progress);
  EXPECT_EQ(image.names, (std::vector<std::string>{"heart", "LV", "RV"}));
  EXPECT_EQ(image.masks.size(), 1U);
}

TEST(MotionSeriesRefuses, TwoVolumesInOneFile) {
  Series series;
  SeriesRequest request = series.request(kHeart);
  request.inputs = {series.put("two.nii", tests::nifti4d({tests::beatingLabels(0, Vec3(4, 4, 6)),
                                                          tests::beatingLabels(0.5, Vec3(4, 4, 6))},
                                                         400, 16))};
  EXPECT_NE(refusalOf(request).find("It has 2 phases; a motion needs four at least"), std::string::npos)
      << refusalOf(request);
}

/// A series of phases in RAS against a rest in LPS has another grid.
TEST(MotionSeriesRefuses, LabelMapsOfTheOtherSide) {
  Series series;
  series.labels(5, [](std::size_t phase, tests::LabelImage& image) {
    if (phase > 2)
      image.indexToLps = Eigen::Scaling(-1.0, -1.0, 1.0) * image.indexToLps;
  });
  EXPECT_NE(refusalOf(series.request(kHeart)).find("resample all phases to one grid, in the same axes"),
            std::string::npos)
      << refusalOf(series.request(kHeart));
}

TEST(MotionSeries, TakesFiveHundredPhases) {
  Series series;
  std::vector<double> radii;
  for (int phase = 0; phase < 500; ++phase)
    radii.push_back(18 + 2 * std::cos(2 * 3.14159265358979 * phase / 500));
  series.balls("outer", radii);
  const MotionSeries found = read(series.request());
  ASSERT_EQ(found.phases(), 500U);
  EXPECT_NEAR(found.times.seconds[499], 0.8 * 499 / 500, 1e-12);
  for (std::size_t phase = 0; phase < 500; phase += 50)
    EXPECT_NEAR(std::cbrt(found.volumesMl[phase][0] / found.volumesMl[0][0]), radii[phase] / 20, 1e-9);
}

TEST(MotionSeriesRefuses, AMixtureOfSurfacesAndLabelMaps) {
  Series series;
  series.labels(5);
  series.balls("outer", kBeat);
  EXPECT_NE(refusalOf(series.request()).find("It mixes surfaces and label maps"), std::string::npos);
}

} // namespace
} // namespace viscera::live
