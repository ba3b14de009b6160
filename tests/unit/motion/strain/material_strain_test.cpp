#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "held_value.h"
#include "thick_cylinder.h"
#include "viscera/strain/material_strain.h"

namespace viscera::strain {
namespace {

constexpr double kExact = 1e-10;

LocalAxes axesAround(const Vec3& point) {
  return localAxes(Vec3(point.x(), point.y(), 0), -Vec3::UnitZ());
}

TEST(MaterialStrain, OfAUniformStretchIsTheStretchAlongEachAxis) {
  const LocalAxes axes = localAxes(Vec3(1, 2, 0.5), Vec3(0, 0, 1));
  Eigen::Matrix3d frame;
  frame << axes.radial, axes.circumferential, axes.longitudinal;
  const Eigen::Matrix3d m = frame * Vec3(1.4, 0.8, 0.85).asDiagonal() * frame.transpose();
  const WallStrain strain = strainAlong(m, axes);
  tests::HeldValue held("uniform stretch", kExact);
  held.add(engineering(strain.radial) - 0.4);
  held.add(engineering(strain.circumferential) + 0.2);
  held.add(engineering(strain.longitudinal) + 0.15);
  held.add(strain.circumferentialLongitudinal);
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(1.1, Vec3(1, -2, 3).normalized()) * m;
  EXPECT_NEAR(strainAlong(turned, axes).radial, strain.radial, kExact) << "a rotation is no strain";
}

TEST(MaterialStrain, OfASimpleShearHasHalfTheShearAndItsSquare) {
  const LocalAxes axes = localAxes(Vec3::UnitX(), Vec3::UnitZ());
  constexpr double kShear = 0.3;
  const Eigen::Matrix3d m =
      Eigen::Matrix3d::Identity() + kShear * axes.circumferential * axes.longitudinal.transpose();
  const WallStrain strain = strainAlong(m, axes);
  tests::HeldValue held("simple shear", kExact);
  held.add(strain.circumferentialLongitudinal - kShear / 2);
  held.add(strain.longitudinal - kShear * kShear / 2);
  held.add(strain.circumferential);
  held.add(strain.radial);
}

TEST(MaterialStrain, OfACylinderThatTwistsAndInflatesIsItsClosedForm) {
  const tests::CylinderMotion motion{{}, 14, 0.85, 0.004};
  tests::HeldValue held("thick cylinder that twists and inflates, axes given", kExact);
  for (const Vec3& point : {Vec3(21, 3, 10), Vec3(-5, 26, 44), Vec3(-20, -22, 80)}) {
    const double radius = std::hypot(point.x(), point.y());
    const Eigen::Matrix3d m = motion.gradientAt(point);
    held.add(m.determinant() - 1);
    const WallStrain strain = strainAlong(m, axesAround(point));
    held.add(strain.radial - motion.radialStrain(radius));
    held.add(strain.circumferential - motion.aroundStrain(radius));
    held.add(strain.longitudinal - motion.alongStrain(radius));
    held.add(std::abs(strain.circumferentialLongitudinal) - motion.shearStrain(radius));
    held.add(strain.circumferentialRadial);
  }
}

/// Against any phase as reference: the axes go with the material.
TEST(MaterialStrain, AxesThatAreCarriedAlongAreThoseOfTheDeformedBody) {
  const tests::CylinderMotion motion{{}, 15, 0.9, 0};
  const Vec3 point(18, 15, 30);
  const LocalAxes carried = carriedAxes(axesAround(point), motion.gradientAt(point));
  const Vec3 now = motion(point);
  EXPECT_NEAR(carried.radial.dot(Vec3(now.x(), now.y(), 0).normalized()), 1, kExact);
  EXPECT_NEAR(carried.longitudinal.dot(-Vec3::UnitZ()), 1, kExact);
  EXPECT_NEAR(engineering(-0.5), -1, kExact);
  EXPECT_NEAR(engineering(-0.9), -1, kExact) << "no deformation has this strain";
}

} // namespace
} // namespace viscera::strain
