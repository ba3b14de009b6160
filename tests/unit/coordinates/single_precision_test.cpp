#include <cmath>

#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/systems.h"
#include "viscera/coordinates/weights_binding.h"

/// Coordinates that are kept in single precision, as those of large organs are.
namespace viscera::coordinates {
namespace {

constexpr double kRounding = 1.2e-7; ///< Of a number, and of the factor of its point.

/// An organ of 3,001 points within a sphere of 40 handles, of which point 1,500 lies outside.
struct LargeOrgan {
  HandleSet handles;
  Points points;
  explicit LargeOrgan(const Vec3& at = Vec3::Zero()) : points(tests::cloud(3001, 5, 50, at)) {
    handles.positions = tests::onSphere(40, 120, at);
    points.row(1500) = (at + Vec3(500, 0, 0)).transpose();
  }
  double size() const { return boundsOf(handles.positions).diagonal(); }
};

std::unique_ptr<Binding> bindIn(const CoordinateSystem& system, const LargeOrgan& scene, bool single,
                                int threads = 2) {
  BindOptions options;
  options.threads.count = threads;
  if (single)
    options.mostBytesInDoubles = 0;
  Progress progress;
  return system.bind(scene.handles, scene.points, options, progress);
}

const TiledWeights& weightsOf(const Binding& binding) {
  return dynamic_cast<const WeightsBinding&>(binding).weights();
}

Points bentPose(const Points& rest) {
  return rest + tests::cloud(static_cast<int>(rest.rows()), 8, 30);
}

void expectSameReport(const BindingReport& a, const BindingReport& b) {
  EXPECT_EQ(a.identityError, b.identityError);
  EXPECT_EQ(a.unityError, b.unityError);
  EXPECT_EQ(a.minWeight, b.minWeight);
  EXPECT_EQ(a.failures, b.failures);
  EXPECT_EQ(a.notes, b.notes);
}

} // namespace

TEST(SinglePrecision, IsChosenByTheSizeOfTheMatrix) {
  const std::size_t bytes = TiledWeights::bytesInDoubles(1000, 7);
  EXPECT_EQ(bytes, 1008u * 7u * 8u);
  EXPECT_FALSE(TiledWeights(1000, 7, bytes).single());
  EXPECT_TRUE(TiledWeights(1000, 7, bytes - 1).single());
  EXPECT_EQ(TiledWeights(1000, 7, bytes).bytes(), bytes);
  EXPECT_EQ(TiledWeights(1000, 7, 0).bytes(), bytes / 7 * 8 / 2);
  EXPECT_EQ(BindOptions().mostBytesInDoubles, std::size_t{512} << 20);
  EXPECT_FALSE(TiledWeights(1000, 7).single());
}

TEST(SinglePrecision, KeepsWeightsAndTheirSums) {
  const LargeOrgan scene;
  const auto exact = bindIn(*sCelestial(), scene, false), rounded = bindIn(*sCelestial(), scene, true);
  const TiledWeights &a = weightsOf(*exact), &b = weightsOf(*rounded);
  ASSERT_FALSE(a.single());
  ASSERT_TRUE(b.single());
  double largest = 0, sumOff = 0;
  for (Eigen::Index point = 0; point < a.points(); ++point) {
    double sum = 0, sumExact = 0;
    for (Eigen::Index handle = 0; handle < a.handles(); ++handle) {
      EXPECT_LE(std::abs(b(point, handle) - a(point, handle)), kRounding * a(point, handle));
      largest = std::max(largest, std::abs(b(point, handle) - a(point, handle)));
      sum += b(point, handle);
      sumExact += a(point, handle);
    }
    sumOff = std::max(sumOff, std::abs(sum - sumExact));
  }
  EXPECT_GT(largest, 1e-12); // It really is rounded.
  EXPECT_LT(sumOff, 5e-15);
  EXPECT_EQ(rounded->influence(3)[77], b(77, 3));
}

TEST(SinglePrecision, PosesTheSameNearAndFarFromTheOrigin) {
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(2e5, -3e5, 1e5)}) {
    const LargeOrgan scene(at);
    const auto exact = bindIn(*sCelestial(), scene, false), rounded = bindIn(*sCelestial(), scene, true);
    const Points pose = bentPose(scene.handles.positions);
    Points a, b;
    exact->deform(pose, a);
    rounded->deform(pose, b);
    EXPECT_LT((a - b).rowwise().norm().maxCoeff(), 1e-7 * scene.size());
    EXPECT_EQ(b.row(1500), scene.points.row(1500));
    exact->moveHandle(pose, 7, Vec3(5, -6, 7), a);
    rounded->moveHandle(pose, 7, Vec3(5, -6, 7), b);
    EXPECT_LT((a - b).rowwise().norm().maxCoeff(), 1e-7 * scene.size());
    EXPECT_EQ(b.row(1500), scene.points.row(1500));
    rounded->deform(scene.handles.positions, b);
    EXPECT_LT((b - scene.points).rowwise().norm().maxCoeff(), 1e-7 * scene.size());
    const Points gradient = tests::cloud(3001, 9);
    rounded->pullBack(pose, gradient, b);
    exact->pullBack(pose, gradient, a);
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), kRounding * 3001);
  }
}

/// What a pose does along a handle is what dragging that handle does, and the gradient is its transpose.
TEST(SinglePrecision, IsOneMatrixForPosesDragsAndGradients) {
  const LargeOrgan scene;
  const auto binding = bindIn(*sCelestial(), scene, true);
  const Points pose = bentPose(scene.handles.positions);
  const Vec3 delta(5, -6, 7);
  Points moved = pose;
  moved.row(7) += delta.transpose();
  Points byPose, byDrag;
  binding->deform(moved, byPose);
  binding->deform(pose, byDrag);
  binding->moveHandle(pose, 7, delta, byDrag);
  EXPECT_LT((byPose - byDrag).cwiseAbs().maxCoeff(), 1e-12);
  const Points gradient = tests::cloud(3001, 9);
  Points ofHandles, posed, transposed;
  binding->deform(pose, posed);
  posed.row(1500).setZero(); // Does not follow any handle.
  binding->pullBack(pose, gradient, transposed);
  EXPECT_NEAR(posed.cwiseProduct(gradient).sum(), pose.cwiseProduct(transposed).sum(), 1e-8);
}

TEST(SinglePrecision, GivesTheSameBitsForAnyNumberOfThreads) {
  const LargeOrgan scene(Vec3(1e4, 0, 0));
  const auto one = bindIn(*sCelestial(), scene, true, 1);
  const Points pose = bentPose(scene.handles.positions), gradient = tests::cloud(3001, 9);
  Points points, pulled;
  one->deform(pose, points, {1});
  one->pullBack(pose, gradient, pulled, {1});
  for (const int threads : {2, 3}) {
    const auto more = bindIn(*sCelestial(), scene, true, threads);
    expectSameReport(more->report(), one->report());
    Points otherPoints, otherPulled;
    more->deform(pose, otherPoints, {threads});
    more->pullBack(pose, gradient, otherPulled, {threads});
    EXPECT_EQ(otherPoints, points);
    EXPECT_EQ(otherPulled, pulled);
    for (int handle = 0; handle < 40; ++handle)
      ASSERT_EQ(more->influence(handle), one->influence(handle));
  }
}

/// The errors are those of the numbers that are kept, and measuring them while solving or afterwards is the
/// same to the bit.
TEST(SinglePrecision, ReportSaysHowExactItIs) {
  const LargeOrgan scene(Vec3(2e5, 0, 0));
  const auto exact = bindIn(*sCelestial(), scene, false), rounded = bindIn(*sCelestial(), scene, true);
  EXPECT_TRUE(exact->report().notes.empty());
  ASSERT_EQ(rounded->report().notes.size(), 1u);
  EXPECT_NE(rounded->report().notes.front().english().find("single precision"), std::string::npos);
  EXPECT_GT(rounded->report().identityError, 1e-12 * scene.size());
  EXPECT_LT(rounded->report().identityError, 1e-7 * scene.size());
  EXPECT_LT(rounded->report().unityError, 5e-15);
  EXPECT_GE(rounded->report().minWeight, 0);
  EXPECT_EQ(rounded->report().failures, std::vector<int>{1500});
  for (const Binding* binding : {exact.get(), rounded.get()})
    for (const int threads : {1, 2, 3})
      expectSameReport(
          WeightsBinding(weightsOf(*binding), scene.handles.positions, scene.points, {1500}, 0, {threads})
              .report(),
          binding->report());
}

/// Those bound point by point; differences, which would magnify the rounding, are taken in double precision.
TEST(SinglePrecision, ServesOtherSystemsAndNoDifferences) {
  LargeOrgan scene;
  scene.points = scene.points.topRows(40).eval();
  int served = 0, differentiated = 0;
  for (const auto& system : builtInSystems()) {
    if (system->id() != "mean-value" && system->id() != "wachspress")
      continue;
    SCOPED_TRACE(system->id());
    const auto exact = bindIn(*system, scene, false), rounded = bindIn(*system, scene, true);
    ASSERT_TRUE(weightsOf(*rounded).single());
    EXPECT_LT(rounded->report().identityError, 1e-7 * scene.size());
    EXPECT_LT(rounded->report().unityError, 5e-15 + exact->report().unityError);
    for (Eigen::Index point = 0; point < 40; ++point)
      for (Eigen::Index handle = 0; handle < 40; ++handle)
        EXPECT_NEAR(weightsOf(*rounded)(point, handle), weightsOf(*exact)(point, handle),
                    kRounding * std::abs(weightsOf(*exact)(point, handle)));
    ++served;
    BindOptions options;
    Progress progress;
    const Points expected =
        system->CoordinateSystem::gradients(scene.handles, scene.points, options, progress).values;
    options.mostBytesInDoubles = 0;
    EXPECT_EQ(system->CoordinateSystem::gradients(scene.handles, scene.points, options, progress).values,
              expected);
    ++differentiated;
  }
  EXPECT_GE(served, 1);
  EXPECT_EQ(differentiated, served);
}

TEST(SinglePrecision, TilesCopyAndTakeSingleNumbers) {
  TiledWeights weights(20, 3, 0);
  weights.setRow(18, Eigen::Vector3d(0.1, 0.2, 0.7));
  EXPECT_NEAR(weights(18, 0) + weights(18, 1) + weights(18, 2), 1, 1e-15);
  weights.set(18, 1, 0.3);
  EXPECT_NEAR(weights(18, 1), 0.3, 0.3 * kRounding);
  const TiledWeights copy = weights;
  EXPECT_TRUE(copy.single());
  EXPECT_EQ(copy(18, 1), weights(18, 1));
  EXPECT_EQ(copy(18, 2), weights(18, 2));
  EXPECT_EQ(copy.column(2)[18], weights(18, 2));
  EXPECT_EQ(copy(17, 2), 0);
}

} // namespace viscera::coordinates
