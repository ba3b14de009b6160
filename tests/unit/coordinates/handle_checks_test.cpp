#include "viscera/coordinates/handle_checks.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

/// The text of the error for `handles`; empty when they are accepted.
template <int Dim>
std::string fault(const PointsOf<Dim>& handles) {
  try {
    requireUsableHandles<Dim>(handles);
  } catch (const DataError& error) {
    return error.what();
  }
  return {};
}

/// Random handles pressed to `thickness` of their size along a skew direction.
Points pressed(double thickness) {
  Points handles = tests::cloud(12, 5, 50);
  handles.col(2) *= thickness;
  return (handles * tests::turn(0.7).transpose()).rowwise() + Eigen::RowVector3d(300, -200, 900);
}

} // namespace

TEST(UsableHandles, AreFourOrMoreAtDifferentPlaces) {
  EXPECT_EQ(fault<3>(tests::cloud(4, 1)), "");
  EXPECT_THAT(fault<3>(tests::cloud(3, 1)), testing::HasSubstr("Only 3 handles"));
  EXPECT_THAT(fault<3>(Points(0, 3)), testing::HasSubstr("Only 0 handles"));
}

TEST(UsableHandles, DoNotLieInOnePlane) {
  EXPECT_THAT(fault<3>(pressed(0)), testing::HasSubstr("one plane"));
  EXPECT_THAT(fault<3>(pressed(1e-11)), testing::HasSubstr("one plane"));
  EXPECT_EQ(fault<3>(pressed(1e-6)), "");
  EXPECT_THAT(fault<3>(Points(Vec3::LinSpaced(3, 0, 1).transpose().replicate(5, 1))),
              testing::HasSubstr("at one place"));
}

TEST(UsableHandles, NameTheTwoAtOnePlace) {
  Points handles = tests::cloud(12, 2, 100);
  handles.row(9) = handles.row(4);
  EXPECT_THAT(fault<3>(handles), testing::HasSubstr("handles 4 and 9"));
  handles(9, 0) += 1e-8; // Of 300 mm.
  EXPECT_THAT(fault<3>(handles), testing::HasSubstr("handles 4 and 9"));
  handles(9, 0) += 1e-3;
  EXPECT_EQ(fault<3>(handles), "");
}

TEST(UsableHandles, AreFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Points handles = tests::cloud(12, 2);
    handles(7, 1) = bad;
    EXPECT_THAT(fault<3>(handles), testing::HasSubstr("handle 7"));
  }
}

TEST(UsableHandles, InThePlaneAreThreeOrMoreNotOnOneLine) {
  PointsOf<2> handles(3, 2);
  handles << 0, 0, 1, 0, 0, 1;
  EXPECT_EQ(fault<2>(handles), "");
  EXPECT_THAT(fault<2>(handles.topRows(2)), testing::HasSubstr("Only 2 handles"));
  handles.row(2) << 2, 0;
  EXPECT_THAT(fault<2>(handles), testing::HasSubstr("one line"));
}

} // namespace viscera::coordinates
