#include "viscera/deformation/rotational_stress.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "clouds.h"

namespace viscera::deformation {
namespace {

class RandomMatrices {
public:
  Eigen::Matrix3d next() {
    Eigen::Matrix3d m;
    for (int i = 0; i < 9; ++i)
      m.data()[i] = normal_(random_);
    return m;
  }
  Eigen::Vector3d direction() { return tests::drawDirection(random_); }
  Eigen::Matrix3d rotation() {
    Eigen::Quaterniond turn;
    for (double& value : turn.coeffs())
      value = normal_(random_);
    return turn.normalized().toRotationMatrix();
  }

private:
  std::mt19937 random_{5};
  std::normal_distribution<double> normal_;
};

TEST(RotationalStress, OfARigidMotionAndAUniformScalingIsZero) {
  RandomMatrices random;
  for (int i = 0; i < 200; ++i) {
    EXPECT_LT(localDistortion(random.rotation()).rotationalStress, 1e-9);
    EXPECT_LT(localDistortion(3.7 * random.rotation()).rotationalStress, 1e-9);
  }
}

TEST(RotationalStress, OfAnAnisotropicScalingIsTheTextbookValue) {
  const Eigen::Matrix3d stretch = Eigen::Vector3d(3, 2, 1).asDiagonal();
  EXPECT_NEAR(localDistortion(stretch).rotationalStress, std::numbers::pi / 6, 1e-14);
  EXPECT_NEAR(localDistortion(stretch).volumeRatio, 6, 1e-14);
}

TEST(RotationalStress, OfASimpleShearIsTheTextbookValue) {
  for (const double shear : {0.1, 0.5, 1.0, 3.0}) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
    m(0, 1) = shear;
    // The singular values of a shear are s and 1/s with s - 1/s = shear, so sin = (s^2 - 1) / (s^2 + 1).
    const double s = shear / 2 + std::sqrt(shear * shear / 4 + 1);
    EXPECT_NEAR(localDistortion(m).rotationalStress, std::asin((s * s - 1) / (s * s + 1)), 1e-13);
    EXPECT_NEAR(localDistortion(m).rotationalStress, std::atan(shear / 2), 1e-13);
  }
}

TEST(RotationalStress, SingularValuesAgreeWithJacobi) {
  RandomMatrices random;
  for (int i = 0; i < 20'000; ++i) {
    Eigen::Matrix3d m = random.next();
    if (i % 4 == 1)
      m.col(0) *= 1e-5;
    if (i % 4 == 2)
      m = Eigen::Matrix3d::Identity() + 1e-8 * m;
    if (i % 4 == 3)
      m.col(2) = m.col(1); // Singular.
    const Eigen::Vector3d exact = Eigen::JacobiSVD<Eigen::Matrix3d>(m).singularValues();
    EXPECT_LT((singularValues(m) - exact).cwiseAbs().maxCoeff(), 1e-10 * exact[0]);
  }
}

TEST(RotationalStress, IsTheLargestAngleOfManyDirections) {
  RandomMatrices random;
  for (int trial = 0; trial < 5; ++trial) {
    // A symmetric stretch, whose images are compared with the directions themselves.
    const Eigen::Matrix3d r = random.rotation();
    const Eigen::Vector3d s(1.5 + trial * 0.5, 1.2, 0.4);
    const Eigen::Matrix3d stretch = r * s.asDiagonal() * r.transpose();
    const double closed = localDistortion(stretch).rotationalStress;
    double largest = 0;
    for (int i = 0; i < 1'000'000; ++i) {
      const Eigen::Vector3d d = random.direction(), image = stretch * d;
      largest = std::max(largest, std::atan2(d.cross(image).norm(), d.dot(image)));
    }
    EXPECT_GE(closed, largest - 1e-12);
    EXPECT_LT(closed - largest, 1e-3);
  }
}

TEST(RotationalStress, FoldedTissueIsKnownByItsDeterminant) {
  const Eigen::Matrix3d mirrored = Eigen::Vector3d(1, 1, -1).asDiagonal();
  EXPECT_TRUE(localDistortion(mirrored).folded());
  EXPECT_FALSE(localDistortion(Eigen::Matrix3d::Identity()).folded());
  EXPECT_EQ(localDistortion(Eigen::Matrix3d::Zero()).rotationalStress, 0);
}

} // namespace
} // namespace viscera::deformation
