#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cage/coplanar_groups.h"
#include "clouds.h"
#include "line_measures.h"
#include "shapes.h"

/// Points on the faces, edges and corners of a cage, and next to them: rounding decides there on which side
/// of a plane a point is, and must decide nothing else.
namespace viscera::coordinates {
namespace {

/// A cage, the edges between its flat faces, and what lies in it.
struct Shape {
  HandleSet handles;
  std::vector<std::pair<int, int>> edges;
  std::function<bool(const Vec3&)> holds;
};

Shape plate(double thickness) {
  const auto box = tests::box(100, 100, thickness);
  Shape shape;
  shape.handles.positions = box.points;
  shape.handles.cage = box.triangles;
  for (int corner = 0; corner < 8; ++corner)
    for (const int axis : {1, 2, 4})
      if ((corner & axis) == 0)
        shape.edges.emplace_back(corner, corner + axis);
  shape.holds = [=](const Vec3& p) {
    return p.minCoeff() >= 0 && p[0] <= 100 && p[1] <= 100 && p[2] <= thickness;
  };
  return shape;
}

/// The letter L, 80 mm high: two faces of six corners, and an edge that is pushed in.
Shape letterL() {
  Shape shape;
  Points& corners = shape.handles.positions;
  corners.resize(12, 3);
  corners.leftCols<2>() << 0, 0, 100, 0, 100, 40, 40, 40, 40, 100, 0, 100, 0, 0, 100, 0, 100, 40, 40, 40, 40,
      100, 0, 100;
  corners.col(2) << Values::Zero(6), Values::Constant(6, 80);
  shape.handles.cage.resize(20, 3);
  shape.handles.cage.topRows(8) << 0, 3, 1, 1, 3, 2, 0, 4, 3, 0, 5, 4, 6, 7, 9, 7, 8, 9, 6, 9, 10, 6, 10, 11;
  for (int i = 0; i < 6; ++i) {
    const int next = (i + 1) % 6;
    shape.handles.cage.row(8 + 2 * i) << i, next, next + 6;
    shape.handles.cage.row(9 + 2 * i) << i, next + 6, i + 6;
    shape.edges.insert(shape.edges.end(), {{i, next}, {i + 6, next + 6}, {i, i + 6}});
  }
  shape.holds = [](const Vec3& p) {
    return p.minCoeff() >= 0 && p[2] <= 80 && ((p[0] <= 100 && p[1] <= 40) || (p[0] <= 40 && p[1] <= 100));
  };
  return shape;
}

/// What is asked of a cage system.
struct Asked {
  const char* id;
  double identity; ///< mm.
  bool concave;    ///< Takes such a cage.
  bool outside;    ///< Defined outside the cage.
  bool linear;     ///< Along edges between flat faces.
};

std::ostream& operator<<(std::ostream& stream, const Asked& asked) {
  return stream << asked.id;
}

class OnTheCage : public testing::TestWithParam<Asked> {
protected:
  std::vector<Shape> shapes() const {
    std::vector<Shape> all = {plate(100), plate(1)};
    if (GetParam().concave)
      all.push_back(letterL());
    return all;
  }

  /// Binds the points to the shape turned in several ways, somewhere in a body. Expects identity, and with
  /// `expected` (`points x handles`) those weights.
  void expectExact(const Shape& shape, const std::vector<Vec3>& points,
                   const Eigen::MatrixXd& expected = {}) const {
    const Points plain = pointsOf(points);
    for (int turn = 0; turn < 6; ++turn) {
      const Eigen::Matrix3d rotation = tests::turn(0.7 + turn).transpose();
      const Eigen::RowVector3d shift(turn * 6.1, -22.3 * turn, 52.7 * turn);
      HandleSet handles = shape.handles;
      handles.positions = (handles.positions * rotation).rowwise() + shift;
      const Points turned = (plain * rotation).rowwise() + shift;
      Progress progress;
      const auto bound = tests::builtIn(GetParam().id)->bind(handles, turned, {}, progress);
      ASSERT_TRUE(bound->report().failures.empty())
          << bound->report().failures.size() << " of " << points.size();
      EXPECT_LT(bound->report().identityError, GetParam().identity) << "turn " << turn;
      for (int handle = 0; handle < expected.cols(); ++handle)
        EXPECT_LT((bound->influence(handle) - expected.col(handle)).cwiseAbs().maxCoeff(), 1e-10)
            << "handle " << handle << ", turn " << turn;
    }
  }

  Points random_ = tests::cloud(200, 21); ///< Ways off the cage.
};

TEST_P(OnTheCage, EdgesAndCornersAreLinearInTheirTwoEnds) {
  for (const Shape& shape : shapes()) {
    std::vector<Vec3> points;
    std::vector<Eigen::RowVectorXd> rows;
    for (const auto& [from, to] : shape.edges)
      for (const double share : {0.0, 1e-9, 1e-5, 0.01, 0.137, 0.29, 0.5, 0.771, 0.9999, 1.0}) {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(shape.handles.positions.rows());
        row[from] = 1 - share;
        row[to] = share;
        points.emplace_back((row * shape.handles.positions).transpose());
        rows.push_back(row);
      }
    Eigen::MatrixXd expected(GetParam().linear ? rows.size() : 0, GetParam().linear ? rows[0].size() : 0);
    for (Eigen::Index i = 0; i < expected.rows(); ++i)
      expected.row(i) = rows[static_cast<std::size_t>(i)];
    expectExact(shape, points, expected);
  }
}

TEST_P(OnTheCage, NothingHappensNextToEdgesAndCorners) {
  for (const Shape& shape : shapes()) {
    std::vector<Vec3> points;
    Eigen::Index next = 0;
    for (const auto& [from, to] : shape.edges)
      for (const double share : {0.0, 1e-6, 0.21, 0.5, 0.83})
        for (int digits = 3; digits <= 12; ++digits) {
          const Eigen::RowVector3d on =
              (1 - share) * shape.handles.positions.row(from) + share * shape.handles.positions.row(to);
          const Vec3 point =
              (on + std::pow(10.0, -digits) * random_.row(next++ % random_.rows())).transpose();
          if (GetParam().outside || shape.holds(point))
            points.push_back(point);
        }
    ASSERT_GT(points.size(), 100U);
    expectExact(shape, points);
  }
}

TEST_P(OnTheCage, NothingHappensOnFacesAndNextToThem) {
  for (const Shape& shape : shapes()) {
    std::vector<Vec3> points;
    for (Eigen::Index t = 0; t < shape.handles.cage.rows(); ++t) {
      const auto [a, b, c] = geometry::cornersOf(shape.handles.positions, shape.handles.cage, t);
      const Vec3 normal = (b - a).cross(c - a).normalized();
      for (const Vec3& shares : {Vec3(0.2, 0.5, 0.3), Vec3(0.01, 0.98, 0.01), Vec3(1e-6, 0.4, 0.599999)}) {
        const Vec3 on = shares[0] * a + shares[1] * b + shares[2] * c;
        points.push_back(on);
        for (int digits = 3; digits <= 12; ++digits)
          for (const double side : {-1.0, 1.0})
            if (const Vec3 point = on + side * std::pow(10.0, -digits) * normal;
                GetParam().outside || shape.holds(point))
              points.push_back(point);
      }
    }
    expectExact(shape, points);
  }
}

// The rays of positive mean value lose digits in the plate of 1 mm: it is asked for 1e-10 of the plate's
// size.
INSTANTIATE_TEST_SUITE_P(Systems, OnTheCage,
                         testing::Values(Asked{"mean-value", 1e-9, true, true, true},
                                         Asked{"spherical-mean-value", 1e-9, true, true, true},
                                         Asked{"positive-mean-value", 1.5e-8, true, false, true},
                                         Asked{"wachspress", 1e-9, false, false, true},
                                         Asked{"green", 1e-9, true, false, false}),
                         [](const auto& each) {
                           std::string name = each.param.id;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// The faces' corners only: a corner of triangles that all lie in one face is none of the face's.
TEST(Wachspress, GiveAHandleInTheMiddleOfAFlatFaceNoInfluence) {
  HandleSet handles = plate(100).handles;
  handles.positions.conservativeResize(9, 3);
  handles.positions.row(8) << 31, 47, 0;
  Triangles cage(14, 3);
  cage << handles.cage.bottomRows(10), 0, 2, 8, 2, 3, 8, 3, 1, 8, 1, 0, 8;
  handles.cage = cage;
  handles.positions *= tests::turn(1.3);
  Points points(3, 3);
  points << 31, 47, 0, 60, 47, 0, 31, 47, 20;
  points *= tests::turn(1.3);
  Progress progress;
  const auto bound = tests::builtIn("wachspress")->bind(handles, points, {}, progress);
  EXPECT_TRUE(bound->report().failures.empty());
  EXPECT_LT(bound->report().identityError, 1e-9);
  EXPECT_EQ(bound->influence(8), Values::Zero(3));
}

TEST(PositiveMeanValue, GiveAHandleThatIsNoCornerOfTheCageNoInfluence) {
  HandleSet handles = plate(100).handles;
  handles.positions.conservativeResize(9, 3);
  handles.positions.row(8) << 31, 47, 52;
  const Points there = handles.positions.bottomRows(1);
  Progress progress;
  const auto bound = tests::builtIn("positive-mean-value")->bind(handles, there, {}, progress);
  EXPECT_TRUE(bound->report().failures.empty());
  EXPECT_LT(bound->report().identityError, 1e-9);
  EXPECT_EQ(bound->influence(8)[0], 0);
}

/// Where a corner lies on an edge, the triangle between them has no area, and lies in both faces' planes.
TEST(CoplanarGroups, LetATriangleWithoutWidthJoinOneFaceOnly) {
  HandleSet handles = plate(100).handles;
  handles.positions.conservativeResize(9, 3);
  handles.positions.row(8) = (handles.positions.row(0) + handles.positions.row(1)) / 2;
  // The edge from 0 to 1 is between the triangles 1 (0, 3, 1) and 4 (0, 1, 5).
  Triangles cage(14, 3);
  cage << handles.cage, 0, 1, 8, 8, 1, 5;
  cage.row(4) << 0, 8, 5;
  const std::vector<int> groups = coplanarGroups(handles.positions * tests::turn(0.9), cage);
  EXPECT_EQ(std::set<int>(groups.begin(), groups.end()).size(), 6U);
  EXPECT_EQ(groups[12], groups[1]);
  EXPECT_EQ(groups[13], groups[4]);
}

/// As near as this, nothing would be left of r1 r2 + v1 . v2 by subtraction.
TEST(Green, KeepTheirDerivativesNextToAnEdge) {
  const Shape shape = letterL();
  HandleSet handles = shape.handles;
  handles.positions *= tests::turn(0.4);
  const auto system = tests::builtIn("green");
  Progress progress;
  for (const double away : {1e-2, 1e-4, 1e-5, 1e-6, 1e-7}) {
    Points point(1, 3);
    point << 37.0, away, 0.6 * away;
    point *= tests::turn(0.4);
    const auto gradients = system->gradients(handles, point, {}, progress);
    ASSERT_TRUE(gradients.failures.empty());
    const Eigen::Index rows = gradients.values.rows();
    const double step = away / 100;
    for (int axis = 0; axis < 3; ++axis) {
      Points around(4, 3);
      const Eigen::RowVector3d unit = step * Eigen::RowVector3d::Unit(axis);
      around << point + unit, point - unit, point + 2 * unit, point - 2 * unit;
      const auto bound = system->bind(handles, around, {}, progress);
      Values slopes(12);
      for (int handle = 0; handle < 12; ++handle) {
        const Values w = bound->influence(handle);
        slopes[handle] = (8 * (w[0] - w[1]) - (w[2] - w[3])) / (12 * step);
      }
      ASSERT_GE(rows, 12);
      EXPECT_LT((gradients.values.col(axis).head(12) - slopes).cwiseAbs().maxCoeff(), 1e-12 / away)
          << away << ", axis " << axis;
    }
  }
}

} // namespace
} // namespace viscera::coordinates
