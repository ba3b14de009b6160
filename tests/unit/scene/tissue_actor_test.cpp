#include "viscera/scene/tissue_actor.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"

#include "tetra_surfaces.h"
#include "tetrahedra.h"

namespace viscera::scene {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

vtkPolyData* dataOf(vtkActor* actor) {
  return vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
}

/// The triangles that an actor draws, as a mesh.
geometry::TriangleMesh drawn(vtkActor* actor) {
  auto* data = dataOf(actor);
  geometry::TriangleMesh mesh;
  mesh.points.resize(data->GetNumberOfPoints(), 3);
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    mesh.points.row(i) = Eigen::Map<const Eigen::RowVector3d>(data->GetPoint(i));
  mesh.triangles.resize(data->GetNumberOfPolys(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    data->GetPolys()->GetCellAtId(t, count, ids);
    for (int c = 0; c < 3; ++c)
      mesh.triangles(t, c) = static_cast<std::int32_t>(ids[c]);
  }
  return mesh;
}

double area(const geometry::TriangleMesh& mesh) {
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)),
               c = mesh.points.row(mesh.triangles(t, 2));
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

class Tissue : public testing::Test {
protected:
  static constexpr int kCells = 4;
  static constexpr double kHalf = 20;
  tests::Solid solid = tests::solidBox(kCells, kHalf);
  std::shared_ptr<Points> points = std::make_shared<Points>(solid.points);
  TissueActor actor{std::make_shared<const Tetrahedra>(solid.tetrahedra), points};

  std::shared_ptr<Values> heights() const { return std::make_shared<Values>(points->col(2)); }
};

TEST_F(Tissue, EveryFaceIsFoundOnceWithItsTwoTetrahedra) {
  const auto faces = tetraFaces(solid.tetrahedra, solid.points);
  const auto outside =
      std::count_if(faces.begin(), faces.end(), [](const TetraFace& face) { return face.second < 0; });
  EXPECT_EQ(outside, 6 * 2 * kCells * kCells);
  EXPECT_EQ(2 * static_cast<Eigen::Index>(faces.size()) - outside, 4 * solid.tetrahedra.rows());
}

TEST_F(Tissue, TheOutsideIsAClosedOutwardSurface) {
  actor.update();
  const auto mesh = drawn(actor.faces());
  EXPECT_EQ(mesh.triangles.rows(), 6 * 2 * kCells * kCells);
  EXPECT_NEAR(geometry::volume(mesh.points, mesh.triangles), std::pow(2 * kHalf, 3), 1e-9 * 64000);
  EXPECT_EQ(actor.shownTetrahedra(), solid.tetrahedra.rows());
  EXPECT_EQ(actor.cutTriangles(), 0);
}

TEST_F(Tissue, ASmoothCutLiesInThePlaneAndFillsIt) {
  actor.setValues(heights());
  actor.setCut({Vec3(3, 0, 0), Vec3::UnitX()}, CutStyle::smooth);
  actor.update();
  const auto mesh = drawn(actor.cut());
  EXPECT_NEAR((mesh.points.col(0).array() - 3).abs().maxCoeff(), 0, 1e-12);
  EXPECT_NEAR(area(mesh), 4 * kHalf * kHalf, 1e-9);
  // The numbers between the points are interpolated: here they are the height.
  auto* values = dataOf(actor.cut())->GetPointData()->GetArray("values");
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    EXPECT_NEAR(values->GetTuple1(i), mesh.points(i, 2), 1e-9);
  // It faces the reader on the side that is cut away.
  const Vec3 a = mesh.points.row(0), b = mesh.points.row(1), c = mesh.points.row(2);
  EXPECT_LT((b - a).cross(c - a).x(), 0);
}

TEST_F(Tissue, ASmoothCutStaysInThePlaneWhileTheTissueMoves) {
  actor.setCut({Vec3(3, 0, 0), Vec3::UnitX()}, CutStyle::smooth);
  actor.update();
  points->col(0) *= 1.3;
  points->col(1) *= 0.5;
  actor.setPoints(points);
  actor.update();
  const auto mesh = drawn(actor.cut());
  EXPECT_NEAR((mesh.points.col(0).array() - 3).abs().maxCoeff(), 0, 1e-12);
  EXPECT_NEAR(area(mesh), 0.5 * 4 * kHalf * kHalf, 1e-9);
}

TEST_F(Tissue, ACrinkleCutLeavesWholeTetrahedraAndTheSameOnesWhileTheTissueMoves) {
  actor.setCut({Vec3(3, 0, 0), Vec3::UnitX()}, CutStyle::crinkle);
  actor.update();
  EXPECT_LT(actor.shownTetrahedra(), solid.tetrahedra.rows());
  EXPECT_GT(actor.shownTetrahedra(), solid.tetrahedra.rows() / 4);
  EXPECT_EQ(actor.cutTriangles(), 0);
  const auto before = drawn(actor.faces());
  EXPECT_GT(geometry::volume(before.points, before.triangles), 17 * 40 * 40);
  auto* cells = dataOf(actor.faces())->GetPolys();
  points->col(0).array() += 30; // All of it is on the side that stays now.
  actor.setPoints(points);
  actor.update();
  EXPECT_EQ(dataOf(actor.faces())->GetPolys(), cells) << "a new pose makes no new topology";
  EXPECT_EQ(drawn(actor.faces()).triangles, before.triangles);
}

TEST_F(Tissue, ANewPoseMovesThePointsWithoutACopyOrANewTopology) {
  actor.setValues(heights());
  actor.update();
  auto* data = dataOf(actor.faces());
  auto* cells = data->GetPolys();
  EXPECT_EQ(data->GetPoints()->GetVoidPointer(0), points->data());
  *points *= 2;
  actor.setPoints(points);
  actor.setValues(heights());
  actor.update();
  EXPECT_EQ(data->GetPolys(), cells);
  EXPECT_EQ(data->GetPoints()->GetVoidPointer(0), points->data());
  EXPECT_NEAR(data->GetBounds()[1], 2 * kHalf, 1e-12);
}

TEST_F(Tissue, OnlyTetrahedraInTheRangeAreShownAndThoseWithoutANumberAlways) {
  auto values = heights();
  actor.setValues(values);
  actor.setShownRange({10.5, 100});
  actor.update();
  int expected = 0;
  for (Eigen::Index t = 0; t < solid.tetrahedra.rows(); ++t) {
    double mean = 0;
    for (int c = 0; c < 4; ++c)
      mean += (*values)[solid.tetrahedra(t, c)] / 4;
    expected += mean >= 10.5;
  }
  EXPECT_EQ(actor.shownTetrahedra(), expected);
  ASSERT_GT(expected, 0);
  ASSERT_LT(expected, solid.tetrahedra.rows());
  (*values)[0] = kNotANumber; // A corner at the bottom.
  actor.setValues(values);
  actor.update();
  EXPECT_GT(actor.shownTetrahedra(), expected);
  actor.clearShownRange();
  actor.update();
  EXPECT_EQ(actor.shownTetrahedra(), solid.tetrahedra.rows());
}

TEST_F(Tissue, ThePickFindsTheCutAndTheCornersAroundIt) {
  actor.setCut({Vec3(3, 0, 0), Vec3::UnitX()}, CutStyle::smooth);
  const Ray ray{Vec3(-100, 1, 2), Vec3::UnitX()};
  const auto pick = actor.pick(ray);
  ASSERT_TRUE(pick);
  EXPECT_NEAR((pick->position - Vec3(3, 1, 2)).norm(), 0, 1e-9);
  Vec3 combined = Vec3::Zero();
  double nearest = 1e9;
  for (int c = 0; c < 4; ++c) {
    const int corner = solid.tetrahedra(pick->tetrahedron, c);
    combined += pick->weights[std::size_t(c)] * points->row(corner).transpose();
    nearest = std::min(nearest, (points->row(corner).transpose() - pick->position).norm());
  }
  EXPECT_NEAR((combined - pick->position).norm(), 0, 1e-9);
  EXPECT_NEAR((points->row(pick->point).transpose() - pick->position).norm(), nearest, 1e-12);
  // From behind, the outside is met first.
  EXPECT_NEAR(actor.pick({Vec3(100, 1, 2), -Vec3::UnitX()})->position.x(), kHalf, 1e-9);
  actor.setVisible(false);
  EXPECT_FALSE(actor.pick(ray));
}

TEST_F(Tissue, ValuesOrCornersThatDoNotFitAreRefused) {
  EXPECT_THROW(actor.setValues(std::make_shared<Values>(3)), UsageError);
  Tetrahedra wrong = solid.tetrahedra;
  wrong(0, 0) = static_cast<std::int32_t>(points->rows());
  EXPECT_THROW(TissueActor(std::make_shared<const Tetrahedra>(wrong), points), UsageError);
}

} // namespace
} // namespace viscera::scene
