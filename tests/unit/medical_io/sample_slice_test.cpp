#include "viscera/medical_io/sample_slice.h"

#include <cmath>

#include <gtest/gtest.h>

#include "phantom_scan.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

float valueAt(const ValueImage& image, int x, int y) {
  return image.values[std::size_t(y) * std::size_t(image.width) + std::size_t(x)];
}

ValueImage sampled(const Scan& scan, const SliceFrame& frame, const SampleOptions& options = {},
                   const Points* rest = nullptr) {
  ValueImage image;
  sampleSlice(scan, frame, options, image, rest);
  return image;
}

TEST(SliceDirection, HasTheSidesThatRadiologistsExpect) {
  for (const SliceDirection& direction : sliceDirections()) {
    const auto side = [](const Vec3& towards) {
      const char* letters[] = {"L", "R", "P", "A", "S", "I"};
      Eigen::Index axis = 0;
      towards.cwiseAbs().maxCoeff(&axis);
      return std::string(letters[2 * axis + (towards[axis] < 0 ? 1 : 0)]);
    };
    EXPECT_EQ(direction.edges[0], side(-direction.right)) << direction.id;
    EXPECT_EQ(direction.edges[1], side(direction.right)) << direction.id;
    EXPECT_EQ(direction.edges[2], side(-direction.up)) << direction.id;
    EXPECT_EQ(direction.edges[3], side(direction.up)) << direction.id;
    EXPECT_EQ(direction.right[direction.axis], 0);
    EXPECT_EQ(direction.up[direction.axis], 0);
  }
  // Axial from the feet with the patient's right on the left; sagittal from the left: the front on the left.
  EXPECT_STREQ(sliceDirection("axial").edges[0], "R");
  EXPECT_EQ(frameAround(sliceDirection("axial"), Vec3::Zero(), 1, 2, 2).plane().normal, Vec3(0, 0, -1));
  EXPECT_EQ(frameAround(sliceDirection("coronal"), Vec3::Zero(), 1, 2, 2).plane().normal, Vec3(0, -1, 0));
  EXPECT_EQ(frameAround(sliceDirection("sagittal"), Vec3::Zero(), 1, 2, 2).plane().normal, Vec3(1, 0, 0));
  EXPECT_THROW(sliceDirection("transverse"), UsageError);
}

TEST(SliceFrame, LeadsFromPixelsToPlacesAndBack) {
  const SliceFrame frame = frameAround(sliceDirection("sagittal"), Vec3(10, 20, 30), 0.5, 101, 61);
  EXPECT_LT((frame.at(50, 30) - Vec3(10, 20, 30)).norm(), 1e-12);
  const Eigen::Vector2d pixel = frame.pixelOf(Vec3(99, 25, 32)); // x does not count here.
  EXPECT_NEAR(pixel.x(), 60, 1e-12);
  EXPECT_NEAR(pixel.y(), 34, 1e-12);
}

TEST(SampleSlice, GivesTheValueOfThePlaceInAnyScanAndAnyPlane) {
  Eigen::Matrix3d mirrored = Eigen::Matrix3d::Zero(); // i to the feet, j to the right, k to the front.
  mirrored(2, 0) = mirrored(0, 1) = mirrored(1, 2) = -1;
  Eigen::Matrix3d sheared = Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  sheared.col(2) = (sheared.col(2) + 0.3 * sheared.col(1)).eval();
  for (const Eigen::Matrix3d& axes : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), mirrored, sheared}) {
    const Vec3 spacing(1, 1.5, 2), middle(7, -12, 40);
    const Vec3 origin = middle - axes * spacing.asDiagonal() * Vec3(20, 20, 20);
    const Scan scan = tests::phantomScan({41, 41, 41}, spacing, origin, tests::slope, axes);
    for (const SliceDirection& direction : sliceDirections()) {
      const SliceFrame frame = frameAround(direction, middle, 0.7, 12, 16);
      const ValueImage image = sampled(scan, frame);
      for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x)
          EXPECT_NEAR(valueAt(image, x, y), tests::slope(frame.at(x, y)), 0.51) << direction.id;
    }
  }
}

TEST(SampleSlice, EndsHalfAVoxelBeyondTheOuterCentres) {
  const Scan scan =
      tests::phantomScan({4, 4, 1}, Vec3(2, 2, 2), Vec3::Zero(), [](const Vec3&) { return 7.0; });
  SliceFrame frame = frameAround(sliceDirection("axial"), Vec3(3, 3, 0.9), 0.25, 64, 64);
  const ValueImage image = sampled(scan, frame);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const Vec3 place = frame.at(x, y);
      const bool inside = place.x() >= -1 && place.x() <= 7 && place.y() >= -1 && place.y() <= 7;
      EXPECT_EQ(!std::isnan(valueAt(image, x, y)), inside) << place.transpose();
    }
  frame.corner.z() = 1.1;
  for (const float value : sampled(scan, frame).values)
    EXPECT_TRUE(std::isnan(value));
}

TEST(SampleSlice, MixesNoPaddingIntoValues) {
  Scan scan = tests::phantomScan({8, 8, 8}, Vec3::Ones(), Vec3::Zero(),
                                 [](const Vec3& p) { return p.x() < 3.5 ? 50.0 : -3024.0; });
  scan.padding = -2000;
  const SliceFrame frame = frameAround(sliceDirection("axial"), Vec3(3.5, 3.5, 3.5), 0.1, 40, 3);
  const ValueImage image = sampled(scan, frame);
  for (int x = 0; x < 40; ++x) {
    if (frame.at(x, 1).x() < 3.49) {
      EXPECT_FLOAT_EQ(valueAt(image, x, 1), 50);
    } else if (frame.at(x, 1).x() > 3.51) {
      EXPECT_TRUE(std::isnan(valueAt(image, x, 1)));
    }
  }
}

TEST(SampleSlice, TakesTheNearestVoxelWhenAsked) {
  const Scan scan = tests::phantomScan({5, 5, 5}, Vec3::Ones(), Vec3::Zero(), tests::slope);
  SampleOptions options;
  options.nearest = true;
  const ValueImage image =
      sampled(scan, frameAround(sliceDirection("axial"), Vec3(2.4, 2.4, 2.4), 1, 1, 1), options);
  EXPECT_FLOAT_EQ(image.values[0], static_cast<float>(tests::slope(Vec3(2, 2, 2))));
}

TEST(SampleSlice, TakesMeanOrMaximumOfASlab) {
  const Scan scan = tests::phantomScan({5, 5, 21}, Vec3::Ones(), Vec3::Zero(),
                                       [](const Vec3& p) { return p.z() == 12 ? 900.0 : 0.0; });
  const SliceFrame frame = frameAround(sliceDirection("axial"), Vec3(2, 2, 10), 1, 3, 3);
  SampleOptions options;
  options.slabMm = 9;
  EXPECT_NEAR(sampled(scan, frame, options).values[4], 100, 1e-3);
  options.maximum = true;
  EXPECT_FLOAT_EQ(sampled(scan, frame, options).values[4], 900);
  options.slabMm = 3;
  EXPECT_FLOAT_EQ(sampled(scan, frame, options).values[4], 0);
  // Layers outside of the scan do not count.
  options = {};
  options.slabMm = 8;
  const SliceFrame end = frameAround(sliceDirection("axial"), Vec3(2, 2, 22), 1, 3, 3);
  EXPECT_FLOAT_EQ(sampled(scan, end, options).values[4], 0);
}

/// The places of a frame's pixels.
Points placesOf(const SliceFrame& frame) {
  Points places(Eigen::Index(frame.width) * frame.height, 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    places.row(i) = frame.at(double(i % frame.width), double(i / frame.width)).transpose();
  return places;
}

TEST(SampleSlice, ShowsWhatWasAtThePlacesAtRest) {
  const Scan scan = tests::phantomScan({60, 60, 60}, Vec3::Ones(), Vec3::Zero(), tests::slope);
  const SliceFrame frame = frameAround(sliceDirection("coronal"), Vec3(30, 30, 30), 0.5, 41, 29);
  Points rest = placesOf(frame);
  const ValueImage straight = sampled(scan, frame), same = sampled(scan, frame, {}, &rest);
  for (std::size_t i = 0; i < same.values.size(); ++i)
    EXPECT_NEAR(same.values[i], straight.values[i], 1e-3);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.2, Vec3(3, 1, 2).normalized()).toRotationMatrix();
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    rest.row(i) = (turn * (rest.row(i).transpose() - Vec3(30, 30, 30)) + Vec3(29, 31, 33)).transpose();
  const ValueImage image = sampled(scan, frame, {}, &rest);
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    EXPECT_NEAR(image.values[std::size_t(i)], tests::slope(rest.row(i).transpose()), 0.51);
  rest.row(7).setConstant(std::nan(""));
  EXPECT_TRUE(std::isnan(sampled(scan, frame, {}, &rest).values[7]));
}

TEST(SampleSlice, IsTheSameAlongTheVoxelsAsAcrossThem) {
  // Whatever way rows of pixels run, with what padding: pixel by pixel by places, and row by row.
  Scan scan = tests::phantomScan({30, 34, 26}, Vec3(1, 1.2, 1.5), Vec3(-3, 2, 1), tests::slope);
  auto& samples = std::get<std::vector<std::int16_t>>(scan.samples);
  for (std::size_t i = 0; i < samples.size(); i += 97)
    samples[i] = -2000;
  for (const bool padded : {false, true}) {
    if (padded)
      scan.padding = -2000;
    for (const SliceDirection& direction : sliceDirections())
      for (const double mm : {0.4, 2.7}) {
        const SliceFrame frame = frameAround(direction, Vec3(11.3, 21.7, 18.9), mm, 64, 48);
        const Points places = placesOf(frame);
        for (const SampleOptions& options :
             {SampleOptions{}, SampleOptions{.slabMm = 5}, SampleOptions{.slabMm = 5, .maximum = true}}) {
          const ValueImage rows = sampled(scan, frame, options),
                           points = sampled(scan, frame, options, &places);
          for (std::size_t i = 0; i < rows.values.size(); ++i) {
            ASSERT_EQ(std::isnan(rows.values[i]), std::isnan(points.values[i])) << direction.id << i;
            if (!std::isnan(rows.values[i])) {
              ASSERT_NEAR(rows.values[i], points.values[i], 2e-3) << direction.id << i;
            }
          }
        }
      }
  }
}

TEST(SampleSlice, IsTheSameWithOneThreadAndWithFour) {
  const Scan scan = tests::phantomScan({30, 30, 30}, Vec3::Ones(), Vec3::Zero(), tests::slope);
  const SliceFrame frame = frameAround(sliceDirection("axial"), Vec3(15, 15, 15), 0.4, 50, 64);
  SampleOptions one, four;
  one.threads = {1};
  four.threads = {4};
  EXPECT_EQ(sampled(scan, frame, one).values, sampled(scan, frame, four).values);
}

TEST(GreyOf, IsBlackBelowWhiteAboveAndBackgroundWhereNothingIs) {
  ValueImage image{5, 1, {-1000, 40, 240, 5000, std::nanf("")}};
  std::vector<std::uint8_t> grey;
  greyOf(image, {40, 400}, 17, grey);
  EXPECT_EQ(grey, (std::vector<std::uint8_t>{0, 128, 255, 255, 17}));
}

} // namespace
} // namespace viscera::medical_io
