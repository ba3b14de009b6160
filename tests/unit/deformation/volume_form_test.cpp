#include "viscera/deformation/volume_form.h"

#include <random>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

/// An egg of 2,562 vertices, 300 mm from the origin, bound to 24 handles.
class VolumeFormTest : public testing::Test {
protected:
  void SetUp() override {
    auto mesh = tests::sphere(4);
    mesh.points = mesh.points * Vec3(60, 45, 35).asDiagonal();
    mesh.points.rowwise() += Eigen::RowVector3d(300, -120, 80);
    rest_ = std::make_shared<geometry::TriangleMesh>(std::move(mesh));
    handles_ = placeHandles(*rest_, {24, true, 0.05, 0.15});
    coordinates::HandleSet set;
    set.positions = handles_;
    Progress progress;
    binding_ = coordinates::builtInSystems().front()->bind(set, rest_->points, {}, progress);
  }

  double onSurface(const Points& pose) const {
    Points points;
    binding_->deform(pose, points);
    return geometry::volume(points, rest_->triangles);
  }

  Points shaken(double byMm) {
    std::normal_distribution<double> normal(0, byMm);
    Points pose = handles_;
    for (Eigen::Index i = 0; i < pose.size(); ++i)
      pose.data()[i] += normal(random_);
    return pose;
  }

  std::shared_ptr<const geometry::TriangleMesh> rest_;
  std::shared_ptr<const coordinates::Binding> binding_;
  Points handles_;
  std::mt19937 random_{7};
};

TEST_F(VolumeFormTest, IsTheVolumeOfTheSurfaceInAnyPose) {
  const auto form = VolumeForm::of(*rest_, *binding_);
  ASSERT_TRUE(form);
  for (int i = 0; i < 50; ++i) {
    const Points pose = shaken(i);
    EXPECT_NEAR(form->volume(pose) / onSurface(pose), 1, 1e-12) << "handles moved by about " << i << " mm";
  }
}

TEST_F(VolumeFormTest, PaysWhereItsNumbersAreFewerThanTheCoordinates) {
  EXPECT_TRUE(VolumeForm::pays(172974, 30)) << "the heart of the thesis";
  EXPECT_FALSE(VolumeForm::pays(2958, 222)) << "a ventricle among all handles of the heart";
  EXPECT_FALSE(VolumeForm::pays(1000000, 60)) << "it would be made for many seconds";
}

TEST_F(VolumeFormTest, ItsGradientIsThatOfTheSurface) {
  const auto form = VolumeForm::of(*rest_, *binding_);
  ASSERT_TRUE(form);
  const auto around = geometry::vertexTriangles(rest_->points.rows(), rest_->triangles);
  for (int i = 0; i < 10; ++i) {
    const Points pose = shaken(15);
    Points points, ofPoints, expected, found;
    binding_->deform(pose, points);
    geometry::volumeGradient(points, rest_->triangles, around, ofPoints);
    binding_->pullBack(pose, ofPoints, expected);
    form->gradient(pose, found);
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_F(VolumeFormTest, AlongADirectionItIsTheCubicOfTheSurface) {
  const auto form = VolumeForm::of(*rest_, *binding_);
  ASSERT_TRUE(form);
  const Points pose = shaken(10), direction = shaken(10) - handles_;
  const auto cubic = form->along(pose, direction);
  for (const double s : {-2.0, -0.5, 0.0, 0.25, 1.0, 3.0}) {
    const double value = cubic[0] + s * (cubic[1] + s * (cubic[2] + s * cubic[3]));
    EXPECT_NEAR(value / onSurface(pose + s * direction), 1, 1e-12) << "s = " << s;
  }
}

TEST_F(VolumeFormTest, HasTheSameBitsForAnyNumberOfThreads) {
  const auto one = VolumeForm::of(*rest_, *binding_, {1});
  const auto three = VolumeForm::of(*rest_, *binding_, {3});
  ASSERT_TRUE(one && three);
  const Points pose = shaken(20);
  EXPECT_EQ(one->volume(pose), three->volume(pose));
}

/// A binding whose points are no linear function of the handles.
class CurvedBinding final : public coordinates::Binding {
public:
  explicit CurvedBinding(const coordinates::Binding& inner) : inner_(inner) {}
  Eigen::Index handleCount() const override { return inner_.handleCount(); }
  Eigen::Index pointCount() const override { return inner_.pointCount(); }
  const coordinates::BindingReport& report() const override { return inner_.report(); }
  void deform(const Points& pose, Points& points, Threads threads) const override {
    inner_.deform(pose, points, threads);
    points *= 1 + 0.001 * (pose.row(0) - pose.row(1)).norm();
  }
  void moveHandle(const Points&, int, const Vec3&, Points&, Threads) const override {}
  void pullBack(const Points& pose, const Points& pointGradient, Points& handleGradient,
                Threads threads) const override {
    inner_.pullBack(pose, pointGradient, handleGradient, threads);
  }
  Values influence(int handle) const override { return inner_.influence(handle); }

private:
  const coordinates::Binding& inner_;
};

TEST_F(VolumeFormTest, DoesNotExistWhereThePointsAreNotLinearInTheHandles) {
  const CurvedBinding curved(*binding_);
  EXPECT_FALSE(VolumeForm::of(*rest_, curved));
}

} // namespace
} // namespace viscera::deformation
