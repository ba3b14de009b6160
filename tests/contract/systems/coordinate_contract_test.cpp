#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "promises.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/geometry/convex_hull.h"
#include "viscera/localised_scc/localised_s_celestial.h"

/// What every coordinate system promises by its interface and its traits, whatever it is. A new system is
/// tried by being in `builtInSystems`.
namespace viscera::coordinates {
namespace {

using System = std::shared_ptr<const CoordinateSystem>;

std::vector<System> systems() {
  std::vector<System> all = builtInSystems(), inner;
  for (const System& system : all)
    if (const Traits traits = system->traits();
        traits.positive && traits.everywhere && traits.continuous && traits.affine && !traits.needsCage)
      inner.push_back(system);
  all.push_back(localised_scc::localisedSCelestial(inner));
  return all;
}

std::string testName(const testing::TestParamInfo<System>& each) {
  std::string name = each.param->id();
  name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }),
             name.end());
  return name;
}

constexpr double kRadius = 50;
constexpr double kSize = 2 * kRadius; ///< For tolerances, mm.
const Vec3 kCenter(30, -110, 260);    ///< Somewhere in a body.

/// Handles and the triangles between them, for systems that want a cage.
HandleSet withCage(const Points& positions) {
  HandleSet handles;
  handles.positions = positions;
  handles.cage = geometry::ConvexHull(positions).triangles();
  return handles;
}

HandleSet sphereOfHandles(int count = 18) {
  return withCage(tests::onSphere(count, kRadius, kCenter));
}

/// Points well inside the hull of `sphereOfHandles`.
Points pointsInside(int count, unsigned seed) {
  return tests::cloud(count, seed, 0.4 * kRadius, kCenter);
}

HandleSet tetrahedron() {
  Points corners(4, 3);
  corners << 0, 0, 0, 40, 5, -3, -6, 35, 4, 8, 9, 50;
  return withCage(corners.rowwise() + kCenter.transpose());
}

class CoordinateContract : public testing::TestWithParam<System> {
protected:
  const CoordinateSystem& system() const { return *GetParam(); }
  Traits traits() const { return GetParam()->traits(); }

  std::unique_ptr<Binding> bind(const HandleSet& handles, const Points& points,
                                const BindOptions& options = {}) {
    return system().bind(handles, points, deformation::withTetgen(options), progress_);
  }

  /// The message of the `DataError` that binding to `positions` gives. The cage may be any that fits the
  /// count.
  std::string refusal(const Points& positions) {
    HandleSet handles = sphereOfHandles(std::max<int>(4, static_cast<int>(positions.rows())));
    handles.positions = positions;
    try {
      bind(handles, pointsInside(5, 1));
    } catch (const DataError& error) {
      return error.what();
    }
    return {};
  }

  static Points randomPose(const HandleSet& handles, unsigned seed) {
    return handles.positions + tests::cloud(static_cast<int>(handles.positions.rows()), seed, 12);
  }

  /// All coordinates, `points x handles`.
  static Eigen::MatrixXd influences(const Binding& binding) {
    Eigen::MatrixXd values(binding.pointCount(), binding.handleCount());
    for (int handle = 0; handle < static_cast<int>(binding.handleCount()); ++handle)
      values.col(handle) = binding.influence(handle);
    return values;
  }

  /// Identity and unity, and positivity if the system promises it.
  void expectExact(const BindingReport& report) {
    EXPECT_LE(report.identityError, 1e-9 * kSize);
    EXPECT_LE(report.unityError, 1e-12);
    if (traits().positive) {
      EXPECT_GE(report.minWeight, 0);
    }
  }

  /// No point inside may fail, unless the system says that some do.
  void expectAnswers(const BindingReport& report) {
    if (traits().everywhere) {
      EXPECT_TRUE(report.failures.empty());
    }
  }

  /// The rows of `values` whose points have coordinates.
  static Points answered(const BindingReport& report, const Points& values) {
    Points rows(values.rows() - static_cast<Eigen::Index>(report.failures.size()), 3);
    Eigen::Index next = 0;
    for (int point = 0; point < static_cast<int>(values.rows()); ++point)
      if (!std::binary_search(report.failures.begin(), report.failures.end(), point))
        rows.row(next++) = values.row(point);
    return rows;
  }

  Progress progress_;
};

} // namespace

TEST_P(CoordinateContract, NamesItself) {
  EXPECT_THAT(system().id(), testing::MatchesRegex("[a-z0-9-]+"));
  EXPECT_FALSE(system().name().empty());
  EXPECT_FALSE(system().summary().empty());
  EXPECT_EQ(system().summary().find('\n'), std::string::npos);
}

TEST_P(CoordinateContract, OffersParametersThatExplainThemselves) {
  std::set<std::string> names;
  for (const Parameter& parameter : system().parameters()) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name << " is offered twice";
    EXPECT_FALSE(parameter.help.empty()) << parameter.name;
    ParameterValues values;
    values.set(parameter.name, parameter.standard);
    EXPECT_NO_THROW(values.requireWithin(system().parameters())) << parameter.name;
  }
}

TEST_P(CoordinateContract, OnASimplexIsBarycentric) {
  if (!traits().affine)
    GTEST_SKIP() << system().name() << " are no sums of the handles alone";
  const HandleSet handles = tetrahedron();
  Eigen::Matrix4d corners;
  corners << handles.positions, Eigen::Vector4d::Ones();
  Points points(40, 3);
  const Points random = tests::cloud(40, 3, 0.5, Vec3::Constant(0.5));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::RowVector4d shares(random(i, 0) + 0.05, random(i, 1) + 0.05, random(i, 2) + 0.05, 0.3);
    shares /= shares.sum();
    points.row(i) = shares * handles.positions;
  }
  const auto binding = bind(handles, points);
  ASSERT_TRUE(binding->report().failures.empty());
  const Eigen::MatrixXd coordinates = influences(*binding);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (int handle = 0; handle < 4; ++handle)
      EXPECT_EQ(binding->weight(i, handle), coordinates(i, handle));
    const Eigen::RowVector4d expected =
        Eigen::RowVector4d(points(i, 0), points(i, 1), points(i, 2), 1) * corners.inverse();
    EXPECT_LT((coordinates.row(i) - expected).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST_P(CoordinateContract, ReproducesRandomPoints) {
  for (const int count : {5, 18, 60}) {
    SCOPED_TRACE(count);
    const HandleSet handles = sphereOfHandles(count);
    const geometry::ConvexHull hull(handles.positions);
    Points points = tests::cloud(500, 7, kRadius, kCenter);
    Eigen::Index inside = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      if (hull.signedDistance(points.row(i).transpose()) < -0.01 * kSize)
        points.row(inside++) = points.row(i);
    ASSERT_GT(inside, 20);
    const auto binding = bind(handles, points.topRows(inside));
    expectAnswers(binding->report());
    expectExact(binding->report());

    Points rest;
    binding->deform(handles.positions, rest);
    EXPECT_LT((rest - points.topRows(inside)).rowwise().norm().maxCoeff(), 1e-9 * kSize);
  }
}

/// All that are no sums of the handles alone follow a shift.
TEST_P(CoordinateContract, FollowsAnyAffineMotion) {
  const HandleSet handles = sphereOfHandles();
  const Points points = pointsInside(100, 2);
  Eigen::Matrix3d shear;
  shear << 1.2, 0.3, -0.1, 0, 0.8, 0.25, 0.1, -0.2, 1.1;
  if (!traits().affine)
    shear.setIdentity();
  const Eigen::RowVector3d shift(4, -60, 25);
  Points moved;
  const auto binding = bind(handles, points);
  binding->deform((handles.positions * shear).rowwise() + shift, moved);
  const Points difference = answered(binding->report(), moved - ((points * shear).rowwise() + shift));
  EXPECT_LT(difference.rows() == 0 ? 0 : difference.rowwise().norm().maxCoeff(), 1e-8 * kSize);
}

TEST_P(CoordinateContract, IsExactAtTheEndsOfEveryParameter) {
  const HandleSet handles = sphereOfHandles();
  const Points points = pointsInside(24, 3);
  for (const Parameter& parameter : system().parameters()) {
    std::vector<double> ends = {parameter.minimum, parameter.maximum};
    if (!parameter.choices.empty())
      for (std::size_t choice = 0; choice < parameter.choices.size(); ++choice)
        ends.push_back(static_cast<double>(choice));
    for (const double value : ends) {
      SCOPED_TRACE(parameter.name + " = " + std::to_string(value));
      if (!parameter.choices.empty() && value >= static_cast<double>(parameter.choices.size()))
        continue;
      BindOptions options;
      options.parameters.set(parameter.name, value);
      const auto binding = bind(handles, points, options);
      expectAnswers(binding->report());
      expectExact(binding->report());
    }
  }
}

TEST_P(CoordinateContract, RefusesParametersItDoesNotHave) {
  BindOptions unknown;
  unknown.parameters.set("no-such-parameter", 1);
  EXPECT_THROW(bind(sphereOfHandles(), pointsInside(3, 1), unknown), UsageError);
  for (const Parameter& parameter : system().parameters()) {
    BindOptions beyond;
    beyond.parameters.set(parameter.name, std::max(parameter.maximum, 1e3) * 10);
    EXPECT_THROW(bind(sphereOfHandles(), pointsInside(3, 1), beyond), UsageError) << parameter.name;
  }
}

TEST_P(CoordinateContract, GivesTheSameBitsForAnyNumberOfThreads) {
  const HandleSet handles = sphereOfHandles();
  const Points points = pointsInside(1500, 4), pose = randomPose(handles, 5);
  const Points pointGradient = tests::cloud(1500, 6);
  BindOptions options;
  options.threads.count = 1;
  const auto one = bind(handles, points, options);
  Points deformed, pulled;
  one->deform(pose, deformed, {1});
  one->pullBack(pose, pointGradient, pulled, {1});
  for (const int threads : {2, 3}) {
    SCOPED_TRACE(threads);
    options.threads.count = threads;
    const auto more = bind(handles, points, options);
    EXPECT_EQ(influences(*more), influences(*one));
    Points again, pulledAgain;
    more->deform(pose, again, {threads});
    more->pullBack(pose, pointGradient, pulledAgain, {threads});
    EXPECT_EQ(again, deformed);
    EXPECT_EQ(pulledAgain, pulled);
    EXPECT_EQ(more->report().identityError, one->report().identityError);
  }
}

TEST_P(CoordinateContract, StopsWhenCancelled) {
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(
      system().bind(sphereOfHandles(), pointsInside(5000, 1), deformation::withTetgen({}), cancelled),
      Cancelled);
}

TEST_P(CoordinateContract, RefusesHandlesThatNoPointCanUse) {
  const Points handles = sphereOfHandles(14).positions;
  EXPECT_NE(refusal(handles.topRows(3)), "");
  EXPECT_NE(refusal(Points(0, 3)), "");

  Points flat = handles;
  flat.col(1).setConstant(-110);
  EXPECT_NE(refusal(flat), "");

  Points doubled = handles;
  doubled.row(11) = doubled.row(2);
  EXPECT_THAT(refusal(doubled), testing::AllOf(testing::HasSubstr("2"), testing::HasSubstr("11")));

  Points broken = handles;
  broken(7, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(broken), testing::HasSubstr("7"));
  broken(7, 2) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(broken), testing::HasSubstr("7"));
}

TEST_P(CoordinateContract, NeverGivesGarbageForPointsOutside) {
  const HandleSet handles = sphereOfHandles();
  Points points = pointsInside(60, 8);
  std::vector<int> outside;
  for (int i = 0; i < 60; i += 7) {
    const Vec3 way = (points.row(i).transpose() - kCenter).normalized();
    points.row(i) = (kCenter + (kRadius * (1.001 + 0.4 * i)) * way).transpose();
    outside.push_back(i);
  }
  const auto binding = bind(handles, points);
  const std::vector<int>& failures = binding->report().failures;
  EXPECT_TRUE(std::is_sorted(failures.begin(), failures.end()));
  if (traits().everywhere) {
    EXPECT_TRUE(std::includes(outside.begin(), outside.end(), failures.begin(), failures.end()))
        << "a point inside failed";
  }
  if (traits().positive && traits().affine) {
    EXPECT_TRUE(std::includes(failures.begin(), failures.end(), outside.begin(), outside.end()))
        << "no positive coordinates exist outside the hull";
  }

  Points moved;
  binding->deform(randomPose(handles, 9), moved);
  EXPECT_TRUE(moved.allFinite());
  for (const int failed : failures)
    EXPECT_EQ(moved.row(failed), points.row(failed)) << "a failed point does not move";
  EXPECT_LE(binding->report().identityError, 1e-9 * kSize * 30);
}

TEST_P(CoordinateContract, TurnsWithHandlesAndPoints) {
  if (!traits().rotationInvariant)
    GTEST_SKIP() << system().name() << " does not promise it";
  const HandleSet handles = sphereOfHandles();
  const Points points = pointsInside(200, 10);
  const Eigen::MatrixXd plain = influences(*bind(handles, points));
  for (const double angle : {0.3, 1.7, 3.0}) {
    HandleSet turned = handles;
    turned.positions = handles.positions * tests::turn(angle).transpose();
    const Points turnedPoints = points * tests::turn(angle).transpose();
    EXPECT_LT((influences(*bind(turned, turnedPoints)) - plain).cwiseAbs().maxCoeff(), 1e-10) << angle;
  }
}

TEST_P(CoordinateContract, InterpolatesItsHandles) {
  if (!traits().interpolates)
    GTEST_SKIP() << system().name() << " does not promise it";
  const HandleSet handles = sphereOfHandles();
  const Points pose = randomPose(handles, 11);
  Points moved;
  const auto binding = bind(handles, handles.positions);
  EXPECT_TRUE(binding->report().failures.empty());
  binding->deform(pose, moved);
  EXPECT_LT((moved - pose).rowwise().norm().maxCoeff(), 1e-9 * kSize);
}

TEST_P(CoordinateContract, GradientsAreTheDerivatives) {
  if (!traits().smooth)
    GTEST_SKIP() << system().name() << " does not promise any";
  const HandleSet handles = sphereOfHandles();
  const Points points = pointsInside(30, 12);
  const auto gradients = system().gradients(handles, points, deformation::withTetgen({}), progress_);
  EXPECT_EQ(gradients.closedForm, traits().closedFormGradient);
  ASSERT_TRUE(gradients.failures.empty());
  const Eigen::Index count = handles.positions.rows();
  const Eigen::Index rows = gradients.lift ? gradients.lift->rowCount() : count;
  ASSERT_EQ(gradients.values.rows(), points.rows() * rows);

  const double step = 1e-4 * kSize;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::RowVector3d offset = step * Eigen::RowVector3d::Unit(axis);
    const Eigen::MatrixXd difference = influences(*bind(handles, points.rowwise() + offset)) -
                                       influences(*bind(handles, points.rowwise() - offset));
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        EXPECT_NEAR(gradients.values(i * rows + j, axis), difference(i, j) / (2 * step), 1e-6);
  }
}

/// What the stress map is made from: the derivative of the posed points by the points at rest.
TEST_P(CoordinateContract, WitnessGradientsAreTheDerivativesOfDeforming) {
  if (!traits().smooth)
    GTEST_SKIP() << system().name() << " does not promise any";
  const HandleSet handles = sphereOfHandles();
  const Points points = pointsInside(12, 19), pose = randomPose(handles, 20);
  const auto witnesses = deformation::bindWitnesses(system(), handles, points, {}, progress_);
  const double step = 1e-4 * kSize;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::RowVector3d offset = step * Eigen::RowVector3d::Unit(axis);
    Points forward, backward;
    bind(handles, points.rowwise() + offset)->deform(pose, forward);
    bind(handles, points.rowwise() - offset)->deform(pose, backward);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Vec3 difference = (forward.row(i) - backward.row(i)).transpose() / (2 * step);
      EXPECT_LT((witnesses->deformationGradient(i, pose).col(axis) - difference).norm(), 1e-5);
    }
  }
}

TEST_P(CoordinateContract, SaysSoWhereNobodyMakesTheTetrahedraThatItNeedsAndElseDoesWithout) {
  try {
    system().bind(sphereOfHandles(), pointsInside(5, 1), {}, progress_);
    EXPECT_FALSE(traits().needsTetrahedra) << "it was bound without tetrahedra";
  } catch (const UsageError& error) {
    EXPECT_TRUE(traits().needsTetrahedra) << error.what();
    EXPECT_THAT(error.what(), testing::HasSubstr("tetrahedra"));
  }
}

TEST_P(CoordinateContract, MovesOneHandleAsItDeforms) {
  const HandleSet handles = sphereOfHandles();
  const auto binding = bind(handles, pointsInside(300, 13));
  Points pose = randomPose(handles, 14), dragged, posed;
  binding->deform(pose, dragged);
  for (const int handle : {0, 9, 17}) {
    const Vec3 delta(3, -8, 5 + handle);
    binding->moveHandle(pose, handle, delta, dragged);
    pose.row(handle) += delta.transpose();
  }
  binding->deform(pose, posed);
  EXPECT_LT((dragged - posed).rowwise().norm().maxCoeff(), 1e-10 * kSize);
}

TEST_P(CoordinateContract, PullsGradientsBackAsTheAdjointOfDeforming) {
  const HandleSet handles = sphereOfHandles();
  const auto binding = bind(handles, pointsInside(300, 15));
  const Points pose = randomPose(handles, 16), pointGradient = tests::cloud(300, 17);
  const Points way = tests::cloud(static_cast<int>(handles.positions.rows()), 18);
  Points forward, backward, pulled;
  const double step = 1e-2;
  binding->deform(pose + step * way, forward);
  binding->deform(pose - step * way, backward);
  binding->pullBack(pose, pointGradient, pulled);
  const double change = ((forward - backward).array() * pointGradient.array()).sum() / (2 * step);
  EXPECT_NEAR((pulled.array() * way.array()).sum(), change, 1e-6 * pointGradient.norm());
}

TEST_P(CoordinateContract, PromisesWhatTheCommittedTableSays) {
  const auto table = tests::promises();
  ASSERT_TRUE(table.count(system().id())) << "a new system gets a row in tests/contract/systems/promises.csv";
  std::map<std::string, bool> row = table.at(system().id());
  row.erase("localisable"); // The plugin's choice, seen through the program.
  const Traits said = traits();
  const std::map<std::string, bool> own = {{"needsCage", said.needsCage},
                                           {"needsTetrahedra", said.needsTetrahedra},
                                           {"positive", said.positive},
                                           {"interpolates", said.interpolates},
                                           {"closedFormGradient", said.closedFormGradient},
                                           {"usesGroups", said.usesGroups},
                                           {"rotationInvariant", said.rotationInvariant},
                                           {"everywhere", said.everywhere},
                                           {"continuous", said.continuous},
                                           {"smooth", said.smooth},
                                           {"affine", said.affine}};
  EXPECT_EQ(own, row);
}

TEST(Promises, AreThoseOfSystemsThatThereAre) {
  std::set<std::string> known, listed;
  for (const System& system : systems())
    known.insert(system->id());
  for (const auto& [id, row] : tests::promises())
    listed.insert(id);
  EXPECT_EQ(listed, known);
}

TEST_P(CoordinateContract, BindsNoPoints) {
  const HandleSet handles = sphereOfHandles();
  const auto binding = bind(handles, Points(0, 3));
  Points moved;
  binding->deform(handles.positions, moved);
  EXPECT_EQ(moved.rows(), 0);
  EXPECT_EQ(binding->report().identityError, 0);
}

INSTANTIATE_TEST_SUITE_P(Systems, CoordinateContract, testing::ValuesIn(systems()), testName);

} // namespace viscera::coordinates
