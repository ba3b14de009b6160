#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "clouds.h"
#include "concave_cage.h"
#include "line_measures.h"
#include "shapes.h"
#include "sphere/plane_neighbours.h"
#include "sphere/sphere_samples.h"
#include "viscera/core/error.h"

/// What the thesis says of its systems that connect the handles (3.1 and 3.2), and of those it compares with
/// (2.3), measured.
namespace viscera::coordinates {
namespace {

using tests::alongLine;

Eigen::MatrixXd coordinatesOf(const std::string& id, const HandleSet& handles, const Points& points,
                              const tests::Choices& choices = {}) {
  Progress progress;
  const auto system = tests::builtIn(id);
  const auto binding = system->bind(handles, points, tests::optionsFor(*system, choices), progress);
  Eigen::MatrixXd values(points.rows(), handles.positions.rows());
  for (int handle = 0; handle < static_cast<int>(values.cols()); ++handle)
    values.col(handle) = binding->influence(handle);
  return values;
}

TEST(DelaunayApproach, JumpsAtAFlip) {
  const auto found = alongLine("delaunay-approach", 11);
  EXPECT_TRUE(found.report.failures.empty());
  EXPECT_GE(found.report.minWeight, 0);
  EXPECT_GT(found.largestJump, 1e-3);
}

/// Where three edges are near a flip at once a little of the jump is left.
TEST(DelaunayApproach, BlendedJumpsMuchLess) {
  const auto plain = alongLine("delaunay-approach", 11),
             blended = alongLine("delaunay-approach", 11, {{"blend", "5"}});
  EXPECT_GE(blended.report.minWeight, 0);
  EXPECT_LT(blended.largestJump, 0.05 * plain.largestJump);
}

TEST(VoronoiRegions, JumpAtFlipsWithTheSphericalBarycentricTransfer) {
  EXPECT_GT(alongLine("voronoi-regions", 11, {{"transfer", "spherical-barycentric"}}).largestJump, 1e-3);
}

/// Handles 8 and 9 are in line with the middle of a short way across; everything else is far away.
HandleSet sword() {
  HandleSet handles = tests::handlesAroundLine(10);
  handles.positions.row(8) << 0, 6, 0;
  handles.positions.row(9) << 0, 12, 0;
  return handles;
}

LineProperties throughTheSword(const char* transfer) {
  Progress progress;
  const auto system = tests::builtIn("voronoi-regions");
  return measureAlong(*system, sword(), {Vec3(-7.3, 0, 0), Vec3(7.1, 0, 0)}, 100,
                      tests::optionsFor(*system, {{"transfer", transfer}}), progress);
}

TEST(VoronoiRegions, JumpAtASwordWithTheNaturalNeighbourTransfer) {
  EXPECT_GT(throughTheSword("natural-neighbour").largestJump, 1e-3);
}

TEST(VoronoiRegions, WeightedByDistanceAreContinuousAtASword) {
  const auto found = throughTheSword("laguerre");
  EXPECT_TRUE(found.report.failures.empty());
  EXPECT_EQ(found.largestJump, 0);
}

TEST(IncrementalApproach, IsPositiveWithFewInnerHandles) {
  EXPECT_GE(alongLine("incremental-approach", 9).report.minWeight, 0);
}

/// The remedy that the thesis only proposes.
TEST(IncrementalApproach, WithTheNormAsLiftIsNeverNegative) {
  for (const int handles : {9, 11, 26}) {
    const auto found = alongLine("incremental-approach", handles, {{"k", "norm"}}, 200);
    EXPECT_GE(found.report.minWeight, 0) << handles;
  }
}

TEST(SphereSamples, CoverTheSphereEvenly) {
  for (const int level : {0, 2}) {
    const SphereSamples samples = sphereSamples(level);
    EXPECT_EQ(samples.areas.size(), 20 << (2 * level));
    EXPECT_NEAR(samples.areas.sum(), 4 * M_PI, 1e-12);
    EXPECT_LT((samples.directions * samples.areas).norm(), 1e-12);
  }
}

/// The thesis (3.2.1) calls them continuous, which the integral is: what the sum over samples jumps by goes
/// to zero with the samples.
TEST(NumericalIntegration, IsPositiveAndTheMoreContinuousTheMoreSamples) {
  const auto few = alongLine("numerical-integration", 10, {{"samples", "1"}}, 100);
  const auto many = alongLine("numerical-integration", 10, {{"samples", "3"}}, 100);
  EXPECT_TRUE(many.report.failures.empty());
  EXPECT_GE(many.report.minWeight, 0);
  EXPECT_LT(many.report.identityError, 1e-12 * 100);
  EXPECT_LT(many.largestJump, 1e-3);
  EXPECT_LT(many.largestJump, 0.3 * few.largestJump);
}

TEST(NumericalIntegration, HasMoreMaximaThanCelestialCoordinates) {
  EXPECT_GT(alongLine("numerical-integration", 10, {{"samples", "3"}}, 100).localMaxima,
            alongLine("s-celestial", 10, {}, 100).localMaxima);
}

TEST(NumericalIntegration, WithAnotherSeedAreTheSameToTheSizeOfItsSamples) {
  const HandleSet handles = tests::handlesAroundLine(10);
  const Points points = tests::cloud(30, 12, 8);
  const auto with = [&](const char* seed) {
    return coordinatesOf("numerical-integration", handles, points, {{"samples", "4"}, {"seed", seed}});
  };
  const double apart = (with("1") - with("2")).cwiseAbs().maxCoeff();
  EXPECT_GT(apart, 0);
  EXPECT_LT(apart, 2e-3);
  EXPECT_EQ(with("1"), with("1"));
}

TEST(CatalogueOfLayers, IsPositiveAndContinuousWithKinksAtInnerFaces) {
  for (const char* partitions : {"nested", "independent"})
    for (const char* polyhedra : {"tetrahedra", "convex"}) {
      SCOPED_TRACE(testing::Message() << partitions << ", " << polyhedra);
      const auto found =
          alongLine("catalogue-of-layers", 10, {{"partitions", partitions}, {"polyhedra", polyhedra}}, 200);
      EXPECT_TRUE(found.report.failures.empty());
      EXPECT_GE(found.report.minWeight, 0);
      EXPECT_EQ(found.largestJump, 0);
      EXPECT_GT(found.kinks, 0);
    }
}

TEST(Wachspress, IsPositiveInsideAConvexCageAndRefusesAnother) {
  HandleSet handles;
  handles.positions = tests::onSphere(20, 50);
  EXPECT_GT(coordinatesOf("wachspress", handles, tests::cloud(200, 5, 25)).minCoeff(), 0);
  const auto box = tests::box(80, 80, 80);
  handles.positions = box.points;
  handles.cage = box.triangles;
  handles.positions.row(7) << 20, 20, 20; // Pushed in beyond the middle.
  Progress progress;
  EXPECT_THROW(tests::builtIn("wachspress")->bind(handles, tests::cloud(1, 1, 1), {}, progress), DataError);
}

TEST(NaturalNeighbours, ArePositiveLocalAndSmooth) {
  const auto found = alongLine("natural-neighbours", 15, {}, 200);
  EXPECT_TRUE(found.report.failures.empty());
  EXPECT_GE(found.report.minWeight, 0);
  EXPECT_EQ(found.largestJump, 0);
  Eigen::MatrixXd values =
      coordinatesOf("natural-neighbours", tests::handlesAroundLine(26), tests::cloud(50, 6, 10));
  EXPECT_GT((values.array() == 0).rowwise().count().minCoeff(), 4);
}

TEST(NaturalNeighbours, BearHandlesOnOneSphereAndOnALattice) {
  HandleSet handles;
  handles.positions = tests::box(60, 60, 60).points;
  const Points points = tests::cloud(100, 7, 20, Vec3::Constant(30));
  const Eigen::MatrixXd values = coordinatesOf("natural-neighbours", handles, points);
  EXPECT_LT((values * handles.positions - points).cwiseAbs().maxCoeff(), 1e-9);
  const Eigen::MatrixXd middle = coordinatesOf("natural-neighbours", handles, Points::Constant(1, 3, 30));
  EXPECT_LT((middle.array() - 0.125).abs().maxCoeff(), 1e-12);
}

TEST(PlaneNeighbours, OfASquareAreItsBilinearMiddle) {
  PlanePoints sites(4, 2);
  sites << -1, -1, 1, -1, 1, 1, -1, 1;
  Eigen::VectorXd shares;
  ASSERT_TRUE(planeNeighbours(sites, Eigen::VectorXd::Zero(4), shares));
  EXPECT_LT((shares.array() - 0.25).abs().maxCoeff(), 1e-14);
  EXPECT_FALSE(planeNeighbours(sites.bottomRows(2), Eigen::VectorXd::Zero(2), shares));
}

TEST(PlaneNeighbours, OfAPowerDiagramReproduceTheOrigin) {
  const Points random = tests::cloud(12, 8, 3);
  const PlanePoints sites = random.leftCols<2>();
  const Eigen::VectorXd powers = -random.col(2).cwiseAbs();
  Eigen::VectorXd shares;
  ASSERT_TRUE(planeNeighbours(sites, powers, shares));
  EXPECT_LT((shares.transpose() * sites).norm(), 1e-9);
}

TEST(PositiveMeanValue, IsPositiveWhereMeanValueIsNot) {
  const HandleSet handles = tests::concaveCage();
  const Points points = tests::cloud(300, 9, 10, Vec3(12, 12, 60));
  const Eigen::MatrixXd plain = coordinatesOf("mean-value", handles, points);
  const Eigen::MatrixXd seen = coordinatesOf("positive-mean-value", handles, points, {{"level", "2"}});
  EXPECT_LT(plain.minCoeff(), -1e-4);
  EXPECT_GE(seen.minCoeff(), 0);
}

TEST(PositiveMeanValue, InAConvexCageComesCloserToMeanValueWithMoreRays) {
  HandleSet handles;
  handles.positions = tests::onSphere(14, 50);
  const Points points = tests::cloud(20, 10, 15);
  const Eigen::MatrixXd exact = coordinatesOf("mean-value", handles, points);
  const auto error = [&](const char* level) {
    return (coordinatesOf("positive-mean-value", handles, points, {{"level", level}}) - exact)
        .cwiseAbs()
        .maxCoeff();
  };
  EXPECT_LT(error("4"), 0.3 * error("1"));
  EXPECT_LT(error("4"), 5e-3);
}

TEST(SphericalMeanValue, OverTrianglesIsMeanValue) {
  HandleSet handles;
  handles.positions = tests::onSphere(17, 50);
  const Points points = tests::cloud(100, 11, 25);
  EXPECT_LT(
      (coordinatesOf("spherical-mean-value", handles, points) - coordinatesOf("mean-value", handles, points))
          .cwiseAbs()
          .maxCoeff(),
      1e-10);
}

/// The middle of a box sees all corners alike; over triangles the diagonals make a difference.
TEST(SphericalMeanValue, DoesNotSeeTheDiagonalsOfABox) {
  HandleSet handles;
  const auto box = tests::box(60, 60, 60);
  handles.positions = box.points;
  handles.cage = box.triangles;
  const Points middle = Points::Constant(1, 3, 30);
  EXPECT_LT((coordinatesOf("spherical-mean-value", handles, middle).array() - 0.125).abs().maxCoeff(), 1e-12);
  EXPECT_GT((coordinatesOf("mean-value", handles, middle).array() - 0.125).abs().maxCoeff(), 1e-3);
}

TEST(SphericalMeanValue, OnAFaceAreThatFacesCoordinates) {
  HandleSet handles;
  const auto box = tests::box(60, 60, 60);
  handles.positions = box.points;
  handles.cage = box.triangles;
  Points onTop(1, 3);
  onTop << 20, 25, 60;
  const Eigen::MatrixXd values = coordinatesOf("spherical-mean-value", handles, onTop);
  EXPECT_LT((values * handles.positions - onTop).norm(), 1e-10);
  EXPECT_LT(values.leftCols(4).cwiseAbs().maxCoeff(), 1e-12); // The corners of the bottom.
}

} // namespace
} // namespace viscera::coordinates
