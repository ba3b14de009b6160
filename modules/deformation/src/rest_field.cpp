#include "rest_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include <Eigen/LU>

namespace viscera::deformation {
namespace {

constexpr Eigen::Index kPiece = 20'000; ///< Points bound at a time, between two looks at the progress.
constexpr double kWithinHull = 1e-6;    ///< Of the hull's diagonal, from its facets.
constexpr double kSlack = 1e-3;         ///< Of a cell, for nodes that are only just needed.
constexpr double kReach = 3;         ///< Times what the hull's border moves: so far out does the motion fade.
constexpr double kLeastReach = 0.02; ///< Of the hull's diagonal, where anything moves at all.
constexpr Eigen::Index kMostChecks = 4000;
constexpr double kDifference = 1e-3; ///< Of a cell: the step of differences outside of the hull.

} // namespace

RestField::RestField(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
                     const coordinates::BindOptions& options, double spacing, Progress& progress)
    : handles_(handles), options_(options), hull_(handles.positions),
      middle_(boundsOf(handles.positions).center()), pose_(handles.positions) {
  // The middle of the box may lie outside a lopsided hull; the mean of the handles never does.
  if (hull_.signedDistance(middle_) > -kWithinHull * hull_.diagonal())
    middle_ = handles.positions.colwise().mean().transpose();
  placeGrid(spacing);
  std::vector<Vec3> points;
  chooseNodes(points);
  markInnerCells();
  firstCheck_ = static_cast<Eigen::Index>(points.size());
  chooseChecks(points);
  bound_ = pointsOf(points);
  boundPoints_ = bound_.rows();
  bindAll(system, progress);
  planMending();
  displacements_.setZero(static_cast<Eigen::Index>(nodes_.size()), 3);
}

void RestField::placeGrid(double spacing) {
  const Bounds box = boundsOf(handles_.positions);
  spacing_ = spacing;
  origin_ = box.low - Vec3::Constant(0.5 * spacing);
  size_ = ((box.high - box.low) / spacing).array().ceil().cast<int>() + 3;
  nodes_.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                static_cast<std::size_t>(size_[2]));
}

Vec3 RestField::nodePosition(Eigen::Index node) const {
  const Eigen::Index x = node % size_[0], y = node / size_[0] % size_[1], z = node / size_[0] / size_[1];
  return origin_ + spacing_ * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
}

/// Nodes of cells that the hull reaches into. Those outside go on straight from where the line to the middle
/// enters the hull, so that cells on the border are as exact as those inside.
void RestField::chooseNodes(std::vector<Vec3>& points) {
  const double tiny = kWithinHull * hull_.diagonal();
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Vec3 point = nodePosition(static_cast<Eigen::Index>(n));
    const double distance = hull_.signedDistance(point);
    if (distance > (1 + kSlack) * std::sqrt(3.0) * spacing_)
      continue;
    nodes_[n].first = static_cast<std::int32_t>(points.size());
    nodes_[n].outside = distance > -tiny;
    const Vec3 entry = nodes_[n].outside ? pulledIn(point) : point;
    points.push_back(entry);
    const Vec3 mirrored = 2 * entry - point;
    if (!nodes_[n].outside || hull_.signedDistance(mirrored) > -tiny)
      continue;
    nodes_[n].second = static_cast<std::int32_t>(points.size());
    points.push_back(mirrored);
  }
}

/// A cell whose corners all lie in the hull does, too; most points need no look at the hull's planes then.
void RestField::markInnerCells() {
  inner_.assign(nodes_.size(), 0);
  const Eigen::Index strideY = size_[0], strideZ = strideY * size_[1];
  for (Eigen::Index z = 0; z + 1 < size_[2]; ++z)
    for (Eigen::Index y = 0; y + 1 < size_[1]; ++y)
      for (Eigen::Index x = 0; x + 1 < size_[0]; ++x) {
        const Eigen::Index n = x + strideY * y + strideZ * z;
        bool inside = true;
        for (const Eigen::Index corner :
             {n, n + 1, n + strideY, n + strideY + 1, n + strideZ, n + strideZ + 1, n + strideZ + strideY,
              n + strideZ + strideY + 1}) {
          const Node& node = nodes_[static_cast<std::size_t>(corner)];
          inside = inside && node.first >= 0 && !node.outside;
        }
        inner_[static_cast<std::size_t>(n)] = inside ? 1 : 0;
      }
}

/// Distance from the hull, positive outside; some negative number anywhere well inside.
double RestField::outsideBy(const Vec3& point) const {
  const Vec3 at = (point - origin_) / spacing_;
  const bool inGrid = (at.array() >= 0).all() && at.x() < size_[0] && at.y() < size_[1] && at.z() < size_[2];
  if (inGrid) {
    const auto x = static_cast<Eigen::Index>(at.x()), y = static_cast<Eigen::Index>(at.y()),
               z = static_cast<Eigen::Index>(at.z());
    if (inner_[static_cast<std::size_t>(x + size_[0] * (y + size_[1] * z))] != 0)
      return -spacing_;
  }
  return hull_.signedDistance(point);
}

void RestField::chooseChecks(std::vector<Vec3>& points) const {
  std::vector<Vec3> centres;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Vec3 centre = nodePosition(static_cast<Eigen::Index>(n)) + Vec3::Constant(0.5 * spacing_);
    if (hull_.signedDistance(centre) < -kWithinHull * hull_.diagonal())
      centres.push_back(centre);
  }
  const std::size_t step = centres.size() / static_cast<std::size_t>(kMostChecks) + 1;
  for (std::size_t i = 0; i < centres.size(); i += step)
    points.push_back(centres[i]);
}

void RestField::bindAll(const coordinates::CoordinateSystem& system, Progress& progress) {
  failed_.assign(static_cast<std::size_t>(boundPoints_), 0);
  for (Eigen::Index begin = 0; begin < boundPoints_; begin += kPiece) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(begin) / static_cast<double>(boundPoints_),
                    "Binding the space between the handles");
    Progress quiet; // The caller's listens between pieces.
    bindings_.push_back(system.bind(
        handles_, bound_.middleRows(begin, std::min(kPiece, boundPoints_ - begin)), options_, quiet));
    for (const int failure : bindings_.back()->report().failures)
      failed_[static_cast<std::size_t>(begin + failure)] = 1;
  }
  for (Node& node : nodes_)
    if (node.second >= 0 && failed_[static_cast<std::size_t>(node.second)] != 0)
      node.second = -1;
}

/// From nodes with coordinates outwards, layer by layer.
void RestField::planMending() {
  std::vector<std::uint8_t> known(nodes_.size(), 0);
  std::vector<Eigen::Index> open;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (nodes_[n].first < 0)
      continue;
    known[n] = failed_[static_cast<std::size_t>(nodes_[n].first)] == 0 ? 1 : 0;
    if (known[n] == 0)
      open.push_back(static_cast<Eigen::Index>(n));
  }
  const std::array<Eigen::Index, 3> strides = {1, size_[0], Eigen::Index(size_[0]) * size_[1]};
  while (!open.empty()) {
    const std::size_t before = mendings_.size();
    std::vector<Eigen::Index> left;
    for (const Eigen::Index node : open) {
      Mending mending{node, {}};
      for (const Eigen::Index stride : strides)
        for (const Eigen::Index neighbour : {node - stride, node + stride})
          if (neighbour >= 0 && neighbour < static_cast<Eigen::Index>(known.size()) &&
              known[static_cast<std::size_t>(neighbour)] != 0)
            mending.neighbours.push_back(neighbour);
      if (mending.neighbours.empty())
        left.push_back(node);
      else
        mendings_.push_back(std::move(mending));
    }
    if (mendings_.size() == before)
      return; // They stay where they are.
    for (std::size_t m = before; m < mendings_.size(); ++m)
      known[static_cast<std::size_t>(mendings_[m].node)] = 1;
    open = std::move(left);
  }
}

void RestField::setPose(const Points& pose) {
  pose_ = pose;
  if (pose == handles_.positions) { // Exactly, without the rounding of sums.
    displacements_.setZero();
    reach_ = largest_ = error_ = 0;
    folds_.clear();
    return;
  }
  Points moved(boundPoints_, 3);
  Points piece;
  for (std::size_t b = 0; b < bindings_.size(); ++b) {
    bindings_[b]->deform(pose, piece, options_.threads);
    moved.middleRows(static_cast<Eigen::Index>(b) * kPiece, piece.rows()) = piece;
  }
  moved -= bound_;
  for (std::size_t i = 0; i < failed_.size(); ++i)
    if (failed_[i] != 0)
      moved.row(static_cast<Eigen::Index>(i)).setZero();
  double border = 0;
  largest_ = 0;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node& node = nodes_[n];
    if (node.first < 0)
      continue;
    auto row = displacements_.row(static_cast<Eigen::Index>(n));
    row = moved.row(node.first);
    largest_ = std::max(largest_, row.norm());
    if (node.outside)
      border = std::max(border, row.norm());
    if (node.second >= 0)
      row = 2 * moved.row(node.first) - moved.row(node.second);
  }
  for (const Mending& mending : mendings_) {
    Vec3 sum = Vec3::Zero();
    for (const Eigen::Index neighbour : mending.neighbours)
      sum += displacements_.row(neighbour).transpose();
    displacements_.row(mending.node) = sum.transpose() / static_cast<double>(mending.neighbours.size());
  }
  reach_ = largest_ > 0 ? std::max(kReach * border, kLeastReach * hull_.diagonal()) : 0;
  measureError(moved);
  markFolds();
}

/// Cells of the hull whose middle is turned inside out.
std::vector<Eigen::Index> RestField::foldedCells() const {
  std::vector<Eigen::Index> folded;
  std::mutex mutex;
  parallelRanges(static_cast<Eigen::Index>(inner_.size()), kPiece, options_.threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   std::vector<Eigen::Index> own;
                   Eigen::Matrix3d gradient;
                   for (Eigen::Index cell = begin; cell < end; ++cell) {
                     if (inner_[static_cast<std::size_t>(cell)] == 0)
                       continue;
                     trilinear(nodePosition(cell) + Vec3::Constant(0.5 * spacing_), &gradient);
                     if (!((Eigen::Matrix3d::Identity() + gradient).determinant() > 0))
                       own.push_back(cell);
                   }
                   const std::lock_guard lock(mutex);
                   folded.insert(folded.end(), own.begin(), own.end());
                 });
  return folded; // In any order: only their union counts.
}

void RestField::markFolds() {
  folds_.clear();
  const std::vector<Eigen::Index> cells = foldedCells();
  if (cells.empty())
    return;
  const Eigen::Index strideY = size_[0], strideZ = strideY * size_[1];
  std::vector<Bounds> boxes;
  Bounds all{Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
  for (const Eigen::Index cell : cells) {
    Bounds box = {Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
    for (const Eigen::Index corner :
         {cell, cell + 1, cell + strideY, cell + strideY + 1, cell + strideZ, cell + strideZ + 1,
          cell + strideZ + strideY, cell + strideZ + strideY + 1}) {
      const Vec3 posed = nodePosition(corner) + Vec3(displacements_.row(corner).transpose());
      box = {box.low.cwiseMin(posed), box.high.cwiseMax(posed)};
    }
    all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
    boxes.push_back(box);
  }
  foldsOrigin_ = all.low;
  foldsSize_ = ((all.high - all.low) / spacing_).array().floor().cast<int>() + 1;
  folds_.assign(static_cast<std::size_t>(foldsSize_.cast<Eigen::Index>().prod()), 0);
  for (const Bounds& box : boxes) {
    const Eigen::Vector3i low = ((box.low - foldsOrigin_) / spacing_).array().floor().cast<int>();
    const Eigen::Vector3i high = ((box.high - foldsOrigin_) / spacing_).array().floor().cast<int>();
    for (Eigen::Index z = low[2]; z <= high[2]; ++z)
      for (Eigen::Index y = low[1]; y <= high[1]; ++y)
        for (Eigen::Index x = low[0]; x <= high[0]; ++x)
          folds_[static_cast<std::size_t>(x + foldsSize_[0] * (y + foldsSize_[1] * z))] = 1;
  }
}

bool RestField::isFolded(const Vec3& posed) const {
  if (folds_.empty())
    return false;
  const Vec3 at = (posed - foldsOrigin_) / spacing_;
  if (!((at.array() >= 0).all() && at.x() < foldsSize_[0] && at.y() < foldsSize_[1] &&
        at.z() < foldsSize_[2]))
    return false;
  const auto x = static_cast<Eigen::Index>(at.x()), y = static_cast<Eigen::Index>(at.y()),
             z = static_cast<Eigen::Index>(at.z());
  return folds_[static_cast<std::size_t>(x + foldsSize_[0] * (y + foldsSize_[1] * z))] != 0;
}

void RestField::measureError(const Points& moved) {
  error_ = 0;
  for (Eigen::Index check = firstCheck_; check < boundPoints_; ++check)
    if (failed_[static_cast<std::size_t>(check)] == 0)
      error_ = std::max(
          error_, (trilinear(bound_.row(check).transpose(), nullptr) - moved.row(check).transpose()).norm());
}

Vec3 RestField::pulledIn(const Vec3& point) const {
  const auto& planes = hull_.planes();
  const Vec3 way = point - middle_;
  double part = 1;
  for (Eigen::Index f = 0; f < planes.rows(); ++f) {
    const Vec3 normal = planes.row(f).head<3>().transpose();
    const double room = -(normal.dot(middle_) + planes(f, 3)) - 2 * kWithinHull * hull_.diagonal();
    const double wanted = normal.dot(way);
    if (wanted > room)
      part = std::min(part, std::max(room, 0.0) / wanted);
  }
  return middle_ + part * way;
}

Vec3 RestField::trilinear(const Vec3& rest, Eigen::Matrix3d* gradient) const {
  const Vec3 at = (rest - origin_) / spacing_;
  std::array<Eigen::Index, 3> low = {};
  Vec3 part;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::clamp(std::floor(at[axis]), 0.0, static_cast<double>(size_[axis] - 2));
    low[static_cast<std::size_t>(axis)] = static_cast<Eigen::Index>(cell);
    part[axis] = std::clamp(at[axis] - cell, 0.0, 1.0);
  }
  const Eigen::Index strideY = size_[0], strideZ = strideY * size_[1];
  const double* corner = displacements_.data() + 3 * (low[0] + strideY * low[1] + strideZ * low[2]);
  using Vector = Eigen::Map<const Vec3>;
  const auto node = [&](Eigen::Index x, Eigen::Index y, Eigen::Index z) {
    return Vector(corner + 3 * (x + strideY * y + strideZ * z));
  };
  const auto alongX = [&](Eigen::Index y, Eigen::Index z) -> Vec3 {
    return node(0, y, z) + part[0] * (node(1, y, z) - node(0, y, z));
  };
  const Vec3 x00 = alongX(0, 0), x10 = alongX(1, 0), x01 = alongX(0, 1), x11 = alongX(1, 1);
  const Vec3 y0 = x00 + part[1] * (x10 - x00), y1 = x01 + part[1] * (x11 - x01);
  if (gradient != nullptr) {
    const auto slope = [&](Eigen::Index y, Eigen::Index z) -> Vec3 { return node(1, y, z) - node(0, y, z); };
    const Vec3 s0 = slope(0, 0) + part[1] * (slope(1, 0) - slope(0, 0));
    const Vec3 s1 = slope(0, 1) + part[1] * (slope(1, 1) - slope(0, 1));
    gradient->col(0) = (s0 + part[2] * (s1 - s0)) / spacing_;
    gradient->col(1) = ((1 - part[2]) * (x10 - x00) + part[2] * (x11 - x01)) / spacing_;
    gradient->col(2) = (y1 - y0) / spacing_;
  }
  return y0 + part[2] * (y1 - y0);
}

/// One at the hull, zero from `reach_` on, smooth.
double RestField::fade(double outside) const {
  if (outside <= 0)
    return 1;
  if (outside >= reach_)
    return 0;
  const double part = outside / reach_;
  return 1 - part * part * (3 - 2 * part);
}

Vec3 RestField::displacementAt(const Vec3& rest) const {
  const double outside = outsideBy(rest);
  if (outside <= 0)
    return trilinear(rest, nullptr);
  return outside < reach_ ? Vec3(fade(outside) * trilinear(pulledIn(rest), nullptr)) : Vec3::Zero();
}

RestField::Motion RestField::motionAt(const Vec3& rest) const {
  Motion motion;
  const double outside = outsideBy(rest);
  if (outside <= 0) {
    motion.displacement = trilinear(rest, &motion.gradient);
    return motion;
  }
  if (outside >= reach_)
    return motion;
  motion.displacement = fade(outside) * trilinear(pulledIn(rest), nullptr);
  const double step = kDifference * spacing_;
  for (int axis = 0; axis < 3; ++axis)
    motion.gradient.col(axis) = (displacementAt(rest + step * Vec3::Unit(axis)) - motion.displacement) / step;
  return motion;
}

bool RestField::isStill(const Vec3& posed) const {
  return largest_ == 0 || outsideBy(posed) >= reach_;
}

Bounds RestField::movedBox() const {
  const Bounds box = boundsOf(handles_.positions);
  return {box.low - Vec3::Constant(reach_), box.high + Vec3::Constant(reach_)};
}

} // namespace viscera::deformation
