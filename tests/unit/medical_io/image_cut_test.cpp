#include "viscera/medical_io/image_cut.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viscera/medical_io/assess_surface.h"
#include "viscera/medical_io/label_surfaces.h"

namespace viscera::medical_io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kSide = 30;

/// A map of voxels of 3 mm with a ball in each segment; the images of RAS files have negative x and y.
class Cuts : public testing::Test {
protected:
  Cuts() {
    map_.size = {kSide, kSide, kSide};
    map_.indexToLps.linear() = Vec3(-3, -3, 3).asDiagonal();
    map_.layers.emplace_back(map_.voxelCount());
  }

  /// What is within `radius` of the middle; returns the segment's index.
  std::size_t addBall(const std::string& name, const Vec3& middle, double radius) {
    return add(name, [&](const Vec3& voxel) { return (voxel - middle).norm() <= radius; });
  }

  template <class Inside>
  std::size_t add(const std::string& name, const Inside& inside) {
    const std::size_t index = map_.segments.size();
    Segment segment;
    segment.name = name;
    segment.named = true;
    segment.label = static_cast<std::int64_t>(index + 1);
    segment.low = {kSide, kSide, kSide};
    for (int k = 0; k < kSide; ++k)
      for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i)
          if (inside(Vec3(i, j, k))) {
            map_.layers[0].set(map_.indexOf(i, j, k), static_cast<std::uint16_t>(index + 1));
            ++segment.voxels;
            const std::array<int, 3> here = {i, j, k};
            for (std::size_t axis = 0; axis < 3; ++axis) {
              segment.low[axis] = std::min(segment.low[axis], here[axis]);
              segment.high[axis] = std::max(segment.high[axis], here[axis]);
            }
          }
    map_.segments.push_back(segment);
    return index;
  }

  std::string said(std::size_t segment) const {
    const auto cut = imageCut(map_, segment);
    return cut ? cut->text().english() : "";
  }

  LabelMap map_;
};

TEST_F(Cuts, AnOrganThatGoesOnBeyondTheImageIsNamedWithTheEdge) {
  EXPECT_EQ(said(addBall("liver", {10, 15, 2}, 8)),
            "is cut by the lower edge of the image: its volume is too small");
  EXPECT_EQ(said(addBall("spleen", {27, 15, 26}, 6)),
            "is cut by 2 edges (right, upper) of the image: its volume is too small")
      << "the axis i of this image leads to the right";
}

TEST_F(Cuts, TheEdgesAreThoseOfThePatientInAnImageThatLiesOtherwise) {
  Eigen::Matrix3d sagittal; // i to the back, j to the feet, k to the left.
  sagittal << 0, 0, 2, 1, 0, 0, 0, -1, 0;
  map_.indexToLps.linear() = sagittal;
  EXPECT_THAT(imageCut(map_, addBall("liver", {2, 15, 15}, 8))->edges, ElementsAre("front"));
  EXPECT_THAT(imageCut(map_, addBall("spleen", {15, 27, 5}, 5))->edges, ElementsAre("lower"));
  EXPECT_THAT(imageCut(map_, addBall("stomach", {20, 10, 27}, 6))->edges, ElementsAre("left"));
}

TEST_F(Cuts, AnOrganThatEndsAtTheEdgeOfACroppedImageMayBeWhole) {
  const std::size_t liver = addBall("liver", {15, 15, 9}, 9.2);
  const auto cut = imageCut(map_, liver);
  ASSERT_TRUE(cut);
  EXPECT_FALSE(cut->sure);
  EXPECT_EQ(said(liver), "reaches the lower edge of the image, which may cut it off");
}

TEST_F(Cuts, NothingIsSaidOfWhatIsWhole) {
  EXPECT_EQ(said(addBall("liver", {15, 15, 15}, 8)), "");
  map_.size[2] = 1; // A single slice has no first and last one.
  map_.layers[0] = LabelLayer(map_.voxelCount());
  Segment flat;
  flat.name = "heart";
  flat.low = {5, 5, 0};
  flat.high = {9, 9, 0};
  flat.voxels = 25;
  map_.segments = {flat};
  EXPECT_EQ(said(0), "");
}

TEST_F(Cuts, NothingIsSaidOfWhatNoImageHoldsAsAWhole) {
  const auto column = [](const Vec3& voxel) { return (voxel - Vec3(15, 20, voxel.z())).norm() < 3; };
  for (const char* name : {"aorta", "spinal_cord", "vertebrae_L3", "skin", "body", "femur_left", "Muskel",
                           "inferior_vena_cava", "esophagus", "fat", "Model_1_skin"})
    EXPECT_EQ(said(add(name, column)), "") << name;
  EXPECT_NE(said(add("colon", column)), "") << "whose volume is of interest";
  EXPECT_EQ(said(add("label 9", [](const Vec3& voxel) { return voxel.x() < 28; })), "")
      << "what goes through the image and has no name is a body or a background";
  EXPECT_NE(said(addBall("label 10", {2, 15, 15}, 6)), "");
}

TEST_F(Cuts, SurfacesAndChecksSayIt) {
  addBall("liver", {15, 15, 3}, 9);
  Progress progress;
  const auto surfaces = labelSurfaces(map_, {}, progress);
  ASSERT_TRUE(surfaces.at(0).cut);
  EXPECT_THAT(inEnglish(surfaces[0].warnings), testing::Contains(HasSubstr("cut by the lower edge")));
  const SurfaceAssessment checked =
      assessSurface(surfaces[0].mesh, {"liver", Space::lps, true, surfaces[0].cut}, progress);
  EXPECT_TRUE(checked.questionable());
  EXPECT_TRUE(std::any_of(checked.findings.begin(), checked.findings.end(), [](const Finding& finding) {
    return finding.subject == FindingSubject::size && finding.severity == FindingSeverity::doubt &&
           finding.text == ImageCut{{"lower"}, true}.text();
  }));
}

} // namespace
} // namespace viscera::medical_io
