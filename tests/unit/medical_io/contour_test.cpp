#include "viscera/medical_io/contour.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "viscera/geometry/surface_check.h"

/// Surfaces from values on a grid, with VTK's flying edges as an oracle.
namespace viscera::medical_io {
namespace {

/// Values on a grid, and where it lies.
template <class Value>
struct ContourGrid {
  std::array<int, 3> size;
  std::vector<Value> values;
  Vec3 origin = Vec3::Zero();
  double spacing = 1;

  geometry::TriangleMesh ours(double level) const { return contourOf(values, size, level, origin, spacing); }
  vtkSmartPointer<vtkPolyData> vtks(double level) const {
    vtkNew<vtkAOSDataArrayTemplate<Value>> scalars;
    scalars->SetArray(const_cast<Value*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(size.data());
    image->SetSpacing(spacing, spacing, spacing);
    image->SetOrigin(origin.data());
    image->GetPointData()->SetScalars(scalars);
    vtkNew<vtkFlyingEdges3D> filter;
    filter->SetInputData(image);
    filter->SetValue(0, level);
    filter->ComputeNormalsOff();
    filter->ComputeScalarsOff();
    filter->Update();
    return filter->GetOutput();
  }
};

/// Equal points and triangles, to the bit, in the same order.
template <class Value>
void expectContourAsVtk(const ContourGrid<Value>& grid, double level) {
  const geometry::TriangleMesh ours = grid.ours(level);
  const vtkSmartPointer<vtkPolyData> vtks = grid.vtks(level);
  ASSERT_EQ(ours.points.rows(), vtks->GetNumberOfPoints());
  ASSERT_EQ(ours.triangles.rows(), vtks->GetNumberOfPolys());
  int different = 0;
  for (Eigen::Index v = 0; v < ours.points.rows(); ++v)
    different += ours.points.row(v) != Eigen::Map<const Eigen::RowVector3d>(vtks->GetPoint(v));
  vtkNew<vtkIdList> corners;
  for (Eigen::Index t = 0; t < ours.triangles.rows(); ++t) {
    vtks->GetPolys()->GetCellAtId(t, corners);
    for (int k = 0; k < 3; ++k)
      different += ours.triangles(t, k) != corners->GetId(k);
  }
  EXPECT_EQ(different, 0);
}

TEST(Contour, OfEveryCellIsThatOfVtk) {
  for (int set = 0; set < 256; ++set) {
    SCOPED_TRACE(set);
    ContourGrid<unsigned char> cell{{2, 2, 2}, std::vector<unsigned char>(8)};
    for (int corner = 0; corner < 8; ++corner)
      cell.values[static_cast<std::size_t>(corner)] = set >> corner & 1;
    expectContourAsVtk(cell, 0.5);
  }
}

/// Rows of fewer bits than a word, of a word, of a little more and of two.
class ContourOfNoise : public testing::TestWithParam<std::array<int, 3>> {};

TEST_P(ContourOfNoise, IsThatOfVtk) {
  std::mt19937 random(11);
  std::normal_distribution<float> number;
  const std::array<int, 3> size = GetParam();
  ContourGrid<float> floats{size, {}, {1.5, -300.25, 17.3}, 0.731};
  ContourGrid<unsigned char> labels{size, {}};
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i) {
    floats.values.push_back(number(random));
    labels.values.push_back(number(random) > 0.4F);
  }
  floats.values.front() = 0; // Exactly the level: inside.
  expectContourAsVtk(floats, 0);
  expectContourAsVtk(floats, 0.3);
  expectContourAsVtk(labels, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ContourOfNoise,
                         testing::Values(std::array{3, 2, 5}, std::array{63, 7, 4}, std::array{64, 7, 9},
                                         std::array{65, 9, 7}, std::array{66, 5, 5}, std::array{129, 12, 40},
                                         std::array{64, 64, 70}));

TEST(Contour, OfABallIsClosedAndHasItsVolume) {
  constexpr int kCells = 60;
  ContourGrid<float> ball{{kCells, kCells, kCells}, {}, {-30, -30, -30}};
  for (int k = 0; k < kCells; ++k)
    for (int j = 0; j < kCells; ++j)
      for (int i = 0; i < kCells; ++i)
        ball.values.push_back(20 - std::hypot(float(i - 30), float(j - 30), float(k - 30)));
  const geometry::SurfaceReport report = geometry::checkSurface(ball.ours(0));
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(report.components, 1);
  EXPECT_NEAR(std::abs(report.volumeMm3), 4.0 / 3 * M_PI * 8000, 100);
}

TEST(Contour, OfNoiseWithAmbiguousFacesIsClosed) {
  std::mt19937 random(5);
  ContourGrid<unsigned char> labels{{40, 30, 20}, {}};
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 30; ++j)
      for (int i = 0; i < 40; ++i)
        labels.values.push_back(i > 0 && j > 0 && k > 0 && i < 39 && j < 29 && k < 19 && random() % 2 == 0);
  EXPECT_EQ(geometry::checkSurface(labels.ours(0.5)).boundaryEdges, 0);
}

TEST(Contour, IsEmptyWhereNothingCrossesTheLevel) {
  EXPECT_EQ((ContourGrid<float>{{2, 2, 2}, std::vector<float>(8, 1)}.ours(0).points.rows()), 0);
  EXPECT_EQ((ContourGrid<float>{{4, 1, 2}, {-1, 1, -1, 1, -1, 1, -1, 1}}.ours(0).points.rows()), 0);
}

} // namespace
} // namespace viscera::medical_io
