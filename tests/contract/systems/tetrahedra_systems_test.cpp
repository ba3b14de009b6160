#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "concave_cage.h"
#include "line_measures.h"
#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/deformation/bind_organ.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_gradients.h"

/// Harmonic coordinates and bounded biharmonic weights on TetGen's meshes.
namespace viscera::coordinates {
namespace {

std::shared_ptr<const Binding> boundTo(const std::string& id, const HandleSet& handles, const Points& points,
                                       const tests::Choices& choices = {}) {
  Progress progress;
  const auto system = tests::builtIn(id);
  return deformation::bindOrgan(*system, handles, points, tests::optionsFor(*system, choices), progress);
}

/// The letter U, 40 mm deep: the ends of its arms do not see each other.
HandleSet letterU() {
  Eigen::Matrix<double, 8, 2> outline;
  outline << 0, 0, 60, 0, 60, 60, 40, 60, 40, 20, 20, 20, 20, 60, 0, 60;
  HandleSet handles;
  handles.positions.resize(16, 3);
  handles.cage.resize(28, 3);
  Eigen::Index row = 0;
  for (int i = 0; i < 8; ++i) {
    const int next = (i + 1) % 8;
    handles.positions.row(i) << outline.row(i), 0;
    handles.positions.row(8 + i) << outline.row(i), 40;
    handles.cage.row(row++) << i, next, 8 + next;
    handles.cage.row(row++) << i, 8 + next, 8 + i;
  }
  const int cap[6][3] = {{0, 5, 6}, {0, 6, 7}, {0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
  for (const auto& t : cap) {
    handles.cage.row(row++) << 8 + t[0], 8 + t[1], 8 + t[2];
    handles.cage.row(row++) << t[0], t[2], t[1];
  }
  return handles;
}

TEST(Harmonic, ArePositiveInAConcaveCageWhereMeanValueIsNot) {
  const Points points = tests::cloud(300, 9, 8, Vec3(10, 48, 20));
  const auto harmonic = boundTo("harmonic", letterU(), points);
  EXPECT_LT(boundTo("mean-value", letterU(), points)->report().minWeight, -1e-3);
  EXPECT_GT(harmonic->report().minWeight, -1e-6);
  EXPECT_LT(harmonic->report().identityError, 1e-9 * 80);
  // What the other arm does is hardly felt.
  EXPECT_LT(coordinatesOf(*harmonic).col(2).maxCoeff(), 0.01);
}

/// Two ways to tell the inside of a cage: solid angles and tetrahedra.
TEST(Harmonic, AnswerWhereGreenCoordinatesDo) {
  const Points points = tests::cloud(1000, 3, 40, Vec3::Constant(40));
  Progress progress;
  const auto failures = [&](const std::string& id) {
    return tests::builtIn(id)
        ->bind(tests::concaveCage(), points, deformation::withTetgen({}), progress)
        ->report()
        .failures;
  };
  EXPECT_EQ(failures("harmonic"), failures("green"));
  EXPECT_GT(failures("green").size(), 300u);
}

/// Twice as many elements across bring the coordinates closer to those of a much finer mesh.
TEST(Harmonic, ConvergeAsTheTetrahedraShrink) {
  HandleSet handles;
  handles.positions = tests::onSphere(18, 50);
  const Points points = tests::cloud(200, 3, 15);
  const Eigen::MatrixXd fine = coordinatesOf(*boundTo("harmonic", handles, points, {{"resolution", "32"}}));
  const auto error = [&](const char* resolution) {
    const auto coarse = boundTo("harmonic", handles, points, {{"resolution", resolution}});
    return (coordinatesOf(*coarse) - fine).cwiseAbs().mean();
  };
  const double at8 = error("8"), at16 = error("16");
  RecordProperty("at8", std::to_string(at8));
  RecordProperty("at16", std::to_string(at16));
  EXPECT_LT(at16, 0.5 * at8);
  EXPECT_LT(at16, 5e-3);
}

TEST(Harmonic, PointsOutsideAConcaveCageAreNamed) {
  Points points(2, 3);
  points << 50, 6, 6, 70, 70, 70; // The second one is in the dent.
  EXPECT_THROW(boundTo("harmonic", tests::concaveCage(), points), deformation::UnboundVertices);
}

TEST(Harmonic, DerivativesAreThoseOfTheElements) {
  const HandleSet handles = tests::concaveCage();
  const Points points = tests::cloud(40, 5, 4, Vec3(6, 6, 50));
  Progress progress;
  const auto system = tests::builtIn("harmonic");
  const auto witnesses = deformation::bindWitnesses(*system, handles, points, {}, progress);
  EXPECT_TRUE(witnesses->closedForm());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    EXPECT_LT((witnesses->deformationGradient(i, handles.positions) - Eigen::Matrix3d::Identity()).norm(),
              1e-9);
}

TEST(Harmonic, SayWhichProgramIsMissing) {
  Progress progress;
  BindOptions options;
  options.tetrahedralise = [](const geometry::TriangleMesh& surface, double, Progress& watched) {
    deformation::TetrahedraOptions tetgen;
    tetgen.worker = "/nowhere/tetgen_worker";
    deformation::tetrahedralise(surface, tetgen, watched);
    return SolidMesh{};
  };
  try {
    tests::builtIn("harmonic")->bind(tests::concaveCage(), tests::cloud(3, 1), options, progress);
    ADD_FAILURE() << "it was bound without TetGen";
  } catch (const deformation::TetrahedraError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("tetgen_worker"));
  }
}

/// As the organs of one document, and the witness points inside one.
TEST(SystemsOnTetrahedra, SolveOnceForPointsThatAreBoundToTheSameHandles) {
  for (const char* id : {"harmonic", "bounded-biharmonic"}) {
    Progress progress;
    const auto system = tests::builtIn(id);
    BindOptions options = deformation::withTetgen(tests::optionsFor(*system, {{"resolution", "6"}}));
    int meshed = 0;
    options.tetrahedralise = [&meshed, tetgen = options.tetrahedralise](auto&&... arguments) {
      ++meshed;
      return tetgen(arguments...);
    };
    HandleSet handles = tests::concaveCage();
    const Points first = tests::cloud(20, 5, 4, Vec3(6, 6, 50)),
                 second = tests::cloud(30, 6, 4, Vec3(6, 6, 50));
    system->bind(handles, first, options, progress);
    const auto shared = system->bind(handles, second, options, progress);
    system->gradients(handles, first, options, progress);
    EXPECT_EQ(meshed, 1) << id;
    const auto alone = tests::builtIn(id)->bind(handles, second, options, progress);
    EXPECT_EQ(meshed, 2) << id;
    EXPECT_EQ(coordinatesOf(*shared), coordinatesOf(*alone)) << id;

    options.parameters.setFromText(system->parameters(), "resolution", "7");
    system->bind(handles, second, options, progress);
    EXPECT_EQ(meshed, 3) << id << ": another resolution";
    handles.positions *= 1.1;
    system->bind(handles, second, options, progress);
    EXPECT_EQ(meshed, 4) << id << ": other handles";
    EXPECT_THROW(system->bind(handles, second, {}, progress), UsageError) << "without a mesher";
  }
}

TEST(BoundedBiharmonic, AreBoundedLocalAndConverge) {
  HandleSet handles;
  handles.positions = tests::onSphere(20, 50);
  const Points points = tests::cloud(400, 4, 24);
  const auto bound = boundTo("bounded-biharmonic", handles, points);
  EXPECT_TRUE(bound->report().notes.empty());
  const Eigen::MatrixXd weights = coordinatesOf(*bound);
  EXPECT_GE(weights.minCoeff(), 0);
  EXPECT_LE(weights.maxCoeff(), 1);
  EXPECT_LE(bound->report().unityError, 1e-12);
  EXPECT_LE(bound->report().identityError, 1e-9 * 100);
  // More handles than with S-Celestial have next to no weight.
  const Eigen::MatrixXd others = coordinatesOf(*boundTo("s-celestial", handles, points));
  EXPECT_GT((weights.array() < 0.01).count(), 1.5 * (others.array() < 0.01).count());
}

TEST(BoundedBiharmonic, FollowShiftsButNoTurn) {
  HandleSet handles;
  handles.positions = tests::onSphere(14, 50);
  const Points points = tests::cloud(100, 5, 20);
  const auto bound = boundTo("bounded-biharmonic", handles, points, {{"resolution", "10"}});
  Points moved;
  bound->deform(handles.positions.rowwise() + Eigen::RowVector3d(3, -4, 5), moved);
  EXPECT_LT((moved - (points.rowwise() + Eigen::RowVector3d(3, -4, 5))).norm(), 1e-9);
  bound->deform(handles.positions * tests::turn(0.5).transpose(), moved);
  EXPECT_GT((moved - points * tests::turn(0.5).transpose()).rowwise().norm().maxCoeff(), 0.5);
}

TEST(BoundedBiharmonic, TheirStressAtRestIsNone) {
  HandleSet handles;
  handles.positions = tests::onSphere(14, 50);
  const Points points = tests::cloud(60, 6, 20);
  Progress progress;
  const auto witnesses =
      deformation::bindWitnesses(*tests::builtIn("bounded-biharmonic"), handles, points, {}, progress);
  deformation::StressMap map;
  witnesses->evaluate(handles.positions, map);
  EXPECT_LT(map.rotationalStress.maxCoeff(), 1e-6);
  EXPECT_LT((map.volumeRatio.array() - 1).abs().maxCoeff(), 1e-9);
}

} // namespace
} // namespace viscera::coordinates
