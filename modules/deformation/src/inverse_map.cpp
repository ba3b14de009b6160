#include "viscera/deformation/inverse_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/LU>

#include "refine_rest.h"
#include "rest_field.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::deformation {
namespace {

/// Points that one thread solves, each from the last one's answer.
constexpr Eigen::Index kSolvedAtOnce = 1024;
constexpr int kMostSteps = 24;
constexpr double kSolved = 0.01; ///< Of the accuracy.
/// Part of the accuracy that is enough. Where cells meet, Newton's method may go to and fro.
constexpr double kFound = 0.5;
constexpr Eigen::Index kLattice = 4; ///< Samples between those that are solved first.
constexpr double kLinear = 0.25;     ///< Of the accuracy: how far samples between them may be off.
constexpr double kFirstNodes = 16;   ///< Along the hull's diagonal.
constexpr double kWorthwhile = 1.5;  ///< Times as many points are worth another binding.
constexpr double kSmallestDeterminant = 1e-3;
constexpr double kShrink = 0.5; ///< Of a step that made it worse.
constexpr int kMostShrinks = 6;

/// Solves F(x) = y from `guess`; gives x and what it is.
struct Solver {
  Solver(const RestField& fieldIn, double accuracyMm)
      : field(fieldIn), solved(kSolved * accuracyMm), found(kFound * accuracyMm) {}

  const RestField& field;
  double solved, found; ///< mm.

  RestState operator()(const Vec3& posed, const Vec3& guess, Vec3& rest) const {
    if (field.isStill(posed)) {
      rest = posed;
      return RestState::still;
    }
    rest = guess;
    RestField::Motion motion = field.motionAt(rest);
    // Newton's method for r(x) = x + u(x) - y = 0: s = -(I + grad u)^-1 r, shortened until |r| falls; where
    // space is nearly folded s = -r, the fixed point's step.
    Vec3 residual = rest + motion.displacement - posed;
    Answer best{rest, residual.norm(), motion.gradient};
    for (int step = 0; step < kMostSteps && best.off > solved; ++step) {
      const Eigen::Matrix3d derivative = Eigen::Matrix3d::Identity() + motion.gradient;
      const double determinant = derivative.determinant();
      Vec3 way =
          determinant > kSmallestDeterminant ? Vec3(-derivative.inverse() * residual) : Vec3(-residual);
      for (int shrink = 0; shrink <= kMostShrinks; ++shrink, way *= kShrink) {
        const Vec3 next = rest + way;
        const RestField::Motion there = field.motionAt(next);
        const Vec3 left = next + there.displacement - posed;
        if (left.norm() < residual.norm() || shrink == kMostShrinks) {
          rest = next;
          motion = there;
          residual = left;
          break;
        }
      }
      if (residual.norm() < best.off)
        best = {rest, residual.norm(), motion.gradient};
    }
    rest = best.rest;
    const double determinant = (Eigen::Matrix3d::Identity() + best.gradient).determinant();
    const bool folded = best.off > found || !(determinant > 0) || field.isFolded(posed);
    return folded ? RestState::folded : RestState::moved;
  }

  /// Begins at the point itself, and once more where it would have come from with the motion there.
  RestState cold(const Vec3& posed, Vec3& rest) const {
    const RestState state = (*this)(posed, posed - field.displacementAt(posed), rest);
    return state == RestState::folded ? (*this)(posed, posed, rest) : state;
  }

private:
  struct Answer {
    Vec3 rest;
    double off; ///< mm.
    Eigen::Matrix3d gradient;
  };
};

/// A plane on its way: some samples solved, the others between them.
class PlaneSolver {
public:
  PlaneSolver(const RestField& field, const SamplePlane& plane, double accuracyMm, RestPoints& result)
      : solver_(field, accuracyMm), tolerance_(kLinear * accuracyMm), plane_(plane), result_(result),
        columns_(latticeOf(plane.columns)), rows_(latticeOf(plane.rows)) {}

  void run(Threads threads) {
    parallelRanges(static_cast<Eigen::Index>(rows_.size()), 1, threads,
                   [&](Eigen::Index begin, Eigen::Index end) {
                     for (Eigen::Index row = begin; row < end; ++row)
                       solveRow(rows_[static_cast<std::size_t>(row)]);
                   });
    // A band of cells owns its first row's samples between the lattice and all rows up to the next band.
    const auto bands = std::max<Eigen::Index>(static_cast<Eigen::Index>(rows_.size()) - 1, 1);
    parallelRanges(bands, 1, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index band = begin; band < end; ++band)
        fillBand(static_cast<std::size_t>(band));
    });
  }

private:
  /// 0, 4, 8, ... and the last one.
  static std::vector<Eigen::Index> latticeOf(Eigen::Index count) {
    std::vector<Eigen::Index> list;
    for (Eigen::Index at = 0; at < count; at += kLattice)
      list.push_back(at);
    if (list.back() != count - 1)
      list.push_back(count - 1);
    return list;
  }

  Eigen::Index at(Eigen::Index column, Eigen::Index row) const { return row * plane_.columns + column; }
  RestState& state(Eigen::Index index) { return result_.states[static_cast<std::size_t>(index)]; }

  void solveRow(Eigen::Index row) {
    Vec3 offset = Vec3::Zero();
    bool warm = false;
    for (const Eigen::Index column : columns_) {
      const Vec3 posed = plane_.at(column, row);
      const Eigen::Index index = at(column, row);
      Vec3 rest;
      RestState found = warm ? solver_(posed, posed + offset, rest) : solver_.cold(posed, rest);
      if (found == RestState::folded && warm)
        found = solver_.cold(posed, rest);
      result_.points.row(index) = rest.transpose();
      state(index) = found;
      warm = found == RestState::moved;
      offset = rest - posed;
    }
  }

  void fillBand(std::size_t band) {
    const Eigen::Index top = rows_[band], bottom = rows_[std::min(band + 1, rows_.size() - 1)];
    const bool last = band + 2 >= rows_.size();
    for (std::size_t c = 0; c + 1 < columns_.size() || c == 0; ++c)
      fillCell({columns_[c], columns_[std::min(c + 1, columns_.size() - 1)], top, bottom}, last,
               c + 2 >= columns_.size());
  }

  struct Cell {
    Eigen::Index left, right, top, bottom;
  };

  Vec3 between(const Cell& cell, double u, double v) const {
    const auto corner = [&](Eigen::Index column, Eigen::Index row) {
      return Vec3(result_.points.row(at(column, row)).transpose());
    };
    return (1 - v) * ((1 - u) * corner(cell.left, cell.top) + u * corner(cell.right, cell.top)) +
           v * ((1 - u) * corner(cell.left, cell.bottom) + u * corner(cell.right, cell.bottom));
  }

  static double part(Eigen::Index at, Eigen::Index low, Eigen::Index high) {
    return high > low ? static_cast<double>(at - low) / static_cast<double>(high - low) : 0;
  }

  bool isLinear(const Cell& cell, RestState& common) {
    common = state(at(cell.left, cell.top));
    for (const Eigen::Index corner :
         {at(cell.right, cell.top), at(cell.left, cell.bottom), at(cell.right, cell.bottom)})
      if (state(corner) != common)
        return false;
    if (common != RestState::moved)
      return common == RestState::still;
    // The middle, and the samples next to the corners: motion has kinks at the grid's cells and at the hull.
    const Eigen::Index column = (cell.left + cell.right) / 2, row = (cell.top + cell.bottom) / 2;
    return isRight(cell, column, row) && isRight(cell, cell.left + 1, cell.top + 1) &&
           isRight(cell, cell.right - 1, cell.top + 1) && isRight(cell, cell.left + 1, cell.bottom - 1) &&
           isRight(cell, cell.right - 1, cell.bottom - 1);
  }

  bool isRight(const Cell& cell, Eigen::Index column, Eigen::Index row) const {
    const Vec3 rest = between(cell, part(column, cell.left, cell.right), part(row, cell.top, cell.bottom));
    return (rest + solver_.field.displacementAt(rest) - plane_.at(column, row)).norm() <= tolerance_;
  }

  /// Samples on the right and lower edges belong to the next cells.
  void fillCell(const Cell& cell, bool lastRow, bool lastColumn) {
    RestState common = RestState::still;
    const bool linear = isLinear(cell, common);
    for (Eigen::Index row = cell.top; row < cell.bottom + (lastRow ? 1 : 0); ++row)
      for (Eigen::Index column = cell.left; column < cell.right + (lastColumn ? 1 : 0); ++column) {
        if ((row == cell.top || row == cell.bottom) && (column == cell.left || column == cell.right))
          continue; // Of the lattice.
        const Vec3 guess =
            between(cell, part(column, cell.left, cell.right), part(row, cell.top, cell.bottom));
        Vec3 rest = guess;
        RestState found = common;
        if (!linear)
          found = solver_(plane_.at(column, row), guess, rest);
        result_.points.row(at(column, row)) = rest.transpose();
        state(at(column, row)) = found;
      }
  }

  Solver solver_;
  double tolerance_;
  const SamplePlane& plane_;
  RestPoints& result_;
  std::vector<Eigen::Index> columns_, rows_;
};

} // namespace

class InverseMap::Field : public RestField {
public:
  using RestField::RestField;
};

InverseMap::InverseMap(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
                       const Points& pose, const coordinates::BindOptions& options,
                       const InverseMapOptions& map, Progress& progress)
    : handles_(handles), options_(options), wanted_(map) {
  if (!(map.accuracyMm > 0))
    throw UsageError("It has to be positive", "accuracy");
  const geometry::ConvexHull hull(handles.positions);
  double spacing = hull.diagonal() / kFirstNodes;
  for (;;) {
    field_ = std::make_unique<Field>(system, handles, options, spacing, progress);
    setPose(pose);
    if (!wantsFinerGrid())
      return;
    spacing /= std::min(2.0, std::cbrt(room()));
  }
}

double InverseMap::room() const {
  return wanted_.mostWeights / static_cast<double>(handles_.positions.rows()) /
         static_cast<double>(field_->boundPoints());
}

bool InverseMap::wantsFinerGrid() const {
  return field_->errorMm() > wanted_.accuracyMm && room() >= kWorthwhile;
}

InverseMap::~InverseMap() = default;

void InverseMap::setPose(const Points& pose) {
  if (pose.rows() != handles_.positions.rows())
    throw DataError(
        misuse("It has %n {handle|handles} in place of %2", pose.rows(), handles_.positions.rows()), "pose");
  if (!pose.allFinite())
    throw DataError(misuse("It is not finite"), "pose");
  field_->setPose(pose);
}

Points InverseMap::posedPoints(const Points& rest) const {
  Points posed(rest.rows(), 3);
  parallelRanges(rest.rows(), kSolvedAtOnce, options_.threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const Vec3 point = rest.row(i).transpose();
      posed.row(i) = (point + field_->displacementAt(point)).transpose();
    }
  });
  return posed;
}

RestPoints InverseMap::restPoints(const Points& posed) const {
  RestPoints result{Points(posed.rows(), 3), std::vector<RestState>(static_cast<std::size_t>(posed.rows()))};
  const Solver solver(*field_, wanted_.accuracyMm);
  parallelRanges(posed.rows(), kSolvedAtOnce, options_.threads, [&](Eigen::Index begin, Eigen::Index end) {
    Vec3 offset = Vec3::Zero();
    bool warm = false;
    for (Eigen::Index i = begin; i < end; ++i) {
      const Vec3 point = posed.row(i).transpose();
      Vec3 rest;
      RestState found = warm ? solver(point, point + offset, rest) : solver.cold(point, rest);
      if (found == RestState::folded && warm)
        found = solver.cold(point, rest);
      result.points.row(i) = rest.transpose();
      result.states[static_cast<std::size_t>(i)] = found;
      warm = found == RestState::moved;
      offset = rest - point;
    }
  });
  return result;
}

void InverseMap::restPlane(const SamplePlane& plane, RestPoints& result) const {
  result.points.resize(plane.columns * plane.rows, 3);
  result.states.resize(static_cast<std::size_t>(plane.columns * plane.rows));
  if (plane.columns > 0 && plane.rows > 0)
    PlaneSolver(*field_, plane, wanted_.accuracyMm, result).run(options_.threads);
}

void InverseMap::refinePlane(const coordinates::CoordinateSystem& system, const SamplePlane& plane,
                             const Refinement& refinement, RestPoints& result, Progress& progress) const {
  refineRest(*field_, system, plane, refinement, result, progress);
}

double InverseMap::foldedMl() const {
  return field_->foldedMm3() / kMm3PerMl;
}

Eigen::Index InverseMap::boundPoints() const {
  return field_->boundPoints();
}

double InverseMap::errorMm() const {
  return field_->errorMm();
}

double InverseMap::residualMm(const coordinates::CoordinateSystem& system, const Points& posed,
                              const RestPoints& rest, Progress& progress) const {
  std::vector<Vec3> places, wanted;
  for (Eigen::Index i = 0; i < posed.rows(); ++i)
    if (rest.states[static_cast<std::size_t>(i)] == RestState::moved &&
        field_->isInside(rest.points.row(i).transpose())) {
      places.push_back(rest.points.row(i).transpose());
      wanted.push_back(posed.row(i).transpose());
    }
  if (places.empty())
    return 0;
  const auto binding = system.bind(handles_, pointsOf(places), options_, progress);
  Points moved;
  binding->deform(field_->pose(), moved, options_.threads);
  Values errors = (moved - pointsOf(wanted)).rowwise().norm();
  for (const int failure : binding->report().failures)
    errors[failure] = 0;
  return errors.maxCoeff();
}

double InverseMap::spacingMm() const {
  return field_->spacing();
}

Bounds InverseMap::movedBox() const {
  return field_->movedBox();
}

} // namespace viscera::deformation
