#include <algorithm>

#include <gtest/gtest.h>

#include "clouds.h"
#include "line_measures.h"

/// What the thesis says of its systems in the space of n numbers (3.3 and 4.2), measured.
namespace viscera::coordinates {
namespace {

using tests::alongLine;

Eigen::MatrixXd coordinatesOnLine(const std::string& id, int handles, const tests::Choices& choices,
                                  int parts = 200) {
  Progress progress;
  const auto system = tests::builtIn(id);
  return profileAlong(*system, tests::handlesAroundLine(handles), {tests::kLineFrom, tests::kLineTo}, parts,
                      tests::optionsFor(*system, choices), progress)
      .coordinates;
}

TEST(LagrangeMinimisation, WithoutConstraintsIsSmoothAndHasNegativeNumbersForTheInverseDistance) {
  const auto found =
      alongLine("lagrange-minimisation", 9, {{"target", "inverse-distance"}, {"positivity", "free"}});
  EXPECT_LT(found.report.minWeight, -1e-3);
  EXPECT_EQ(found.largestJump, 0);
  EXPECT_EQ(found.kinks, 0);
}

TEST(LagrangeMinimisation, LocalTestJumps) {
  const auto found = alongLine("lagrange-minimisation", 15,
                               {{"target", "inverse-distance"}, {"positivity", "local-test"}}, 200);
  EXPECT_GE(found.report.minWeight, 0);
  EXPECT_GT(found.largestJump, 1e-3);
}

TEST(LagrangeMinimisation, GlobalTestLeavesHandlesWithoutInfluenceAnywhere) {
  const Eigen::MatrixXd values = coordinatesOnLine(
      "lagrange-minimisation", 9, {{"target", "inverse-distance"}, {"positivity", "global-test"}});
  EXPECT_GE(values.minCoeff(), 0);
  const Eigen::RowVectorXd most = values.colwise().maxCoeff();
  EXPECT_GT((most.array() == 0).count(), 0);
  EXPECT_GT(most.maxCoeff(), 0.1);
}

TEST(LagrangeMinimisation, IterativeTestIsContinuousWithKinks) {
  const auto found = alongLine("lagrange-minimisation", 9,
                               {{"target", "inverse-distance"}, {"positivity", "iterative-test"}});
  EXPECT_GE(found.report.minWeight, 0);
  EXPECT_EQ(found.largestJump, 0);
  EXPECT_GT(found.kinks, 0);
}

TEST(LagrangeMinimisation, SolvedExactlyIsPositiveContinuousAndHasKinks) {
  for (const char* target : {"one", "inverse-distance", "closeness"})
    for (const int handles : {9, 15, 26}) {
      SCOPED_TRACE(testing::Message() << target << ", " << handles);
      const auto found = alongLine("lagrange-minimisation", handles, {{"target", target}}, 200);
      EXPECT_TRUE(found.report.failures.empty());
      EXPECT_GE(found.report.minWeight, 0);
      EXPECT_EQ(found.largestJump, 0);
    }
  EXPECT_GT(alongLine("lagrange-minimisation", 9, {{"target", "inverse-distance"}}).kinks, 0);
}

TEST(LagrangeMinimisation, SolvedExactlyIsNearerToTheTargetThanEveryTest) {
  const HandleSet handles = tests::handlesAroundLine(9);
  const Points points = tests::cloud(200, 3, 12);
  Progress progress;
  const auto system = tests::builtIn("lagrange-minimisation");
  const auto numbers = [&](const char* positivity, Eigen::Index point) {
    const auto options = tests::optionsFor(*system, {{"positivity", positivity}});
    const auto binding = system->bind(handles, points.row(point), options, progress);
    Values beta(9);
    for (int i = 0; i < 9; ++i)
      beta[i] = binding->influence(i)[0] * (handles.positions.row(i) - points.row(point)).norm();
    // The best multiple: the coordinates forget the scale.
    return (beta * (beta.sum() / beta.squaredNorm()) - Values::Ones(9)).norm();
  };
  int better = 0;
  for (Eigen::Index point = 0; point < points.rows(); ++point) {
    const double exact = numbers("exact", point), tested = numbers("local-test", point);
    EXPECT_LE(exact, tested + 1e-9) << point;
    better += exact < tested - 1e-6 ? 1 : 0;
  }
  EXPECT_GE(better, 0);
}

TEST(LagrangeMinimisation, IterativeReachesPositiveNumbersOnlyWhenTheTargetIsRaised) {
  const tests::Choices raised = {{"target", "inverse-distance"}, {"positivity", "iterative"}};
  tests::Choices lowered = raised;
  lowered.emplace_back("shift", "lowered");
  const auto good = alongLine("lagrange-minimisation", 9, raised, 100);
  EXPECT_TRUE(good.report.failures.empty());
  EXPECT_GE(good.report.minWeight, 0);
  EXPECT_FALSE(alongLine("lagrange-minimisation", 9, lowered, 100).report.failures.empty());
}

TEST(WireApproach, FindsNoAnswerForMostPointsOfALine) {
  for (const char* points : {"p1", "p3"})
    for (const char* connection : {"cycle", "complete"}) {
      SCOPED_TRACE(testing::Message() << points << ", " << connection);
      const auto found =
          alongLine("wire-approach", 15, {{"points", points}, {"connection", connection}}, 100);
      EXPECT_GT(found.report.failures.size(), 50u);
    }
}

TEST(DeterminantsApproach, IsPositiveAndJumps) {
  const auto found = alongLine("determinants-approach", 9);
  EXPECT_TRUE(found.report.failures.empty());
  EXPECT_GE(found.report.minWeight, 0);
  EXPECT_GT(found.largestJump, 1e-3);
}

/// All points lie in a plane with four handles in a row; such flat tetrahedra once counted by their rounding.
TEST(DeterminantsApproach, BearsHandlesInARow) {
  HandleSet handles = tests::handlesAroundLine(15);
  for (Eigen::Index i = 0; i < 4; ++i)
    handles.positions.row(i) << -61.4 + 37.7 * static_cast<double>(i), -27.1, -24.1;
  handles.positions.row(4) << 63.1, 26.4, -25.2;
  handles.positions.row(6) << -62.3, 25.7, 24.9;
  Progress progress;
  const auto binding =
      tests::builtIn("determinants-approach")->bind(handles, tests::cloud(300, 8, 10), {}, progress);
  EXPECT_LT(binding->report().identityError, 1e-11);
}

TEST(GradientMethod, IsPositiveAndContinuousWithKinks) {
  const auto found = alongLine("gradient-method", 15);
  EXPECT_TRUE(found.report.failures.empty());
  EXPECT_GE(found.report.minWeight, 0);
  EXPECT_EQ(found.largestJump, 0);
  EXPECT_GT(found.kinks, 0);
}

/// The thesis promises continuity; ties that are never given up again break it.
TEST(GradientMethod, RaisedWithoutEndJumpsWhereTheOrderOfTiesChanges) {
  const auto found = alongLine("gradient-method", 15, {{"stop", "highest"}, {"seed", "0"}});
  EXPECT_GE(found.report.minWeight, 0);
  EXPECT_GT(found.largestJump, 1e-3);
}

TEST(GradientMethod, DependsOnWhereItBegins) {
  const auto one = coordinatesOnLine("gradient-method", 9, {{"seed", "1"}});
  const auto two = coordinatesOnLine("gradient-method", 9, {{"seed", "2"}});
  EXPECT_GT((one - two).cwiseAbs().maxCoeff(), 1e-2);
}

TEST(CCelestial, BecomesSmootherWithMoreSamples) {
  const auto roughness = [](const char* samples) {
    const auto values =
        coordinatesOnLine("c-celestial", 9, {{"sampling", "sphere"}, {"samples", samples}}, 100);
    return (values.topRows(99) - 2 * values.middleRows(1, 99) + values.bottomRows(99)).norm();
  };
  EXPECT_LT(roughness("20000"), 0.7 * roughness("500"));
}

TEST(CCelestial, ThrownSamplesMissTheConeOfManyHandles) {
  const auto thrown = alongLine("c-celestial", 26, {{"sampling", "sphere"}, {"samples", "1000"}}, 20);
  const auto walked = alongLine("c-celestial", 26, {{"samples", "1000"}}, 20);
  EXPECT_GT(thrown.report.failures.size(), 10u);
  EXPECT_TRUE(walked.report.failures.empty());
}

/// Newton's method for the walk's start once gave up where its last steps were below rounding.
TEST(CCelestial, WalkBeginsAtEveryPoint) {
  for (const int handles : {9, 15, 26})
    EXPECT_TRUE(alongLine("c-celestial", handles, {{"samples", "10"}}).report.failures.empty()) << handles;
}

/// With many handles a point takes minutes.
TEST(CCelestial, IsCancelledWithinOnePoint) {
  const auto system = tests::builtIn("c-celestial");
  for (const char* sampling : {"hit-and-run", "sphere", "cube"}) {
    int looks = 0;
    Progress progress({}, [&] {
      if (++looks == 100)
        progress.cancel();
    });
    const auto options = tests::optionsFor(*system, {{"sampling", sampling}, {"samples", "1000000"}});
    EXPECT_THROW(system->bind(tests::handlesAroundLine(9), Points::Zero(1, 3), options, progress), Cancelled)
        << sampling;
  }
}

TEST(CCelestial, WalkedAndThrownMeanTheSameCentre) {
  const auto thrown = coordinatesOnLine("c-celestial", 9, {{"sampling", "sphere"}, {"samples", "20000"}}, 20);
  const auto walked = coordinatesOnLine("c-celestial", 9, {{"samples", "20000"}}, 20);
  EXPECT_LT((thrown - walked).middleRows(4, 13).cwiseAbs().maxCoeff(), 0.04);
}

} // namespace
} // namespace viscera::coordinates
