#include "rest_field.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <Eigen/LU>

namespace viscera::deformation {
namespace {

/// Points bound at a time, between two looks at the progress.
constexpr Eigen::Index kPointsBoundAtOnce = 20'000;
constexpr Eigen::Index kNodesAtOnce = 4096; ///< Nodes or cells that a thread takes at a time.
constexpr double kSlack = 1e-3;             ///< Of a cell, for nodes that are only just needed.
constexpr int kCoarser = 4;                 ///< Cells of the inner grid along one of the outer, or more.
/// Nodes of the outer grid, 96 bytes each: for a handle that is dragged far away its cells become larger.
constexpr double kMostOuterNodes = 400'000;
constexpr double kMostFoldCells = 4'000'000; ///< A byte each; they become larger likewise.
constexpr double kReach = 3;         ///< Times what the hull's border moves: so far out the motion fades.
constexpr double kLeastReach = 0.02; ///< Of the hull's diagonal, where anything moves at all.
constexpr double kRoomToGrow = 1.5;  ///< Times the reach: how far the outer grid goes, for poses to come.
constexpr Eigen::Index kMostChecks = 2000;
constexpr double kExactCells = 2; ///< Outside of the hull, until the exact motion is the grid's.
constexpr double kCounted = 0.99; ///< Of the checks; next to a handle the motion has a kink at any spacing.

} // namespace

Vec3 VectorGrid::position(Eigen::Index node) const {
  const Eigen::Index x = node % size[0], y = node / size[0] % size[1], z = node / size[0] / size[1];
  return origin + spacing * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
}

bool VectorGrid::contains(const Vec3& point) const {
  const Vec3 at = (point - origin) / spacing;
  return (at.array() >= 0).all() && at.x() <= size[0] - 1 && at.y() <= size[1] - 1 && at.z() <= size[2] - 1;
}

namespace {

/// The cell that a point is in, and where in it.
struct InCell {
  Eigen::Index corner = 0;
  Vec3 part = Vec3::Zero();
};

InCell cellAt(const VectorGrid& grid, const Vec3& point) {
  const Vec3 at = (point - grid.origin) / grid.spacing;
  InCell result;
  Eigen::Index stride = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double inside = std::clamp(at[axis], 0.0, static_cast<double>(grid.size[axis] - 1));
    const auto cell =
        std::min(static_cast<Eigen::Index>(inside), static_cast<Eigen::Index>(grid.size[axis] - 2));
    result.part[axis] = inside - static_cast<double>(cell);
    result.corner += stride * cell;
    stride *= grid.size[axis];
  }
  return result;
}

/// The eight nodes of a cell, x first, from its first one on.
std::array<Eigen::Index, 8> cornersOf(const VectorGrid& grid, Eigen::Index first) {
  const Eigen::Index y = grid.size[0], z = y * grid.size[1];
  return {first,     first + 1,     first + y,     first + y + 1,
          first + z, first + z + 1, first + z + y, first + z + y + 1};
}

} // namespace

Vec3 VectorGrid::at(const Vec3& point, Eigen::Matrix3d* gradient) const {
  const auto [corner, part] = cellAt(*this, point);
  const Eigen::Index strideY = size[0], strideZ = strideY * size[1];
  const double* first = vectors.data() + 3 * corner;
  const auto node = [&](Eigen::Index offset) { return Eigen::Map<const Vec3>(first + 3 * offset); };
  const auto alongX = [&, p = part[0]](Eigen::Index offset) -> Vec3 {
    return node(offset) + p * (node(offset + 1) - node(offset));
  };
  // Trilinear: u = sum of the corners' u_c with the products of part or 1 - part. The column of the gradient
  // for an axis has the difference of its two sides in place of their mix, over the spacing.
  const Vec3 x00 = alongX(0), x10 = alongX(strideY), x01 = alongX(strideZ), x11 = alongX(strideZ + strideY);
  const Vec3 y0 = x00 + part[1] * (x10 - x00), y1 = x01 + part[1] * (x11 - x01);
  if (gradient != nullptr) {
    const auto slope = [&](Eigen::Index offset) -> Vec3 { return node(offset + 1) - node(offset); };
    const Vec3 s0 = slope(0) + part[1] * (slope(strideY) - slope(0));
    const Vec3 s1 = slope(strideZ) + part[1] * (slope(strideZ + strideY) - slope(strideZ));
    gradient->col(0) = (s0 + part[2] * (s1 - s0)) / spacing;
    gradient->col(1) = ((1 - part[2]) * (x10 - x00) + part[2] * (x11 - x01)) / spacing;
    gradient->col(2) = (y1 - y0) / spacing;
  }
  return y0 + part[2] * (y1 - y0);
}

VectorGrid::Corners VectorGrid::cornersAt(const Vec3& point) const {
  const auto [first, part] = cellAt(*this, point);
  const std::array<Eigen::Index, 8> nodes = cornersOf(*this, first);
  Corners corners;
  for (std::size_t c = 0; c < 8; ++c) {
    corners.nodes[c] = static_cast<std::int32_t>(nodes[c]);
    corners.weights[c] =
        static_cast<float>(((c & 1U) != 0 ? part[0] : 1 - part[0]) * ((c & 2U) != 0 ? part[1] : 1 - part[1]) *
                           ((c & 4U) != 0 ? part[2] : 1 - part[2]));
  }
  return corners;
}

Vec3 VectorGrid::sum(const Corners& corners) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < 8; ++c)
    sum += static_cast<double>(corners.weights[c]) * vectors.row(corners.nodes[c]).transpose();
  return sum;
}

RestField::RestField(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
                     const coordinates::BindOptions& options, double spacing, Progress& progress)
    : handles_(handles), options_(options), hull_(handles.positions),
      middle_(boundsOf(handles.positions).center()), pose_(handles.positions) {
  // The middle of the box may lie outside a lopsided hull; the mean of the handles never does.
  if (hull_.signedDistance(middle_) > -kWithinHull * hull_.diagonal())
    middle_ = handles.positions.colwise().mean().transpose();
  placeInner(spacing);
  std::vector<Vec3> points;
  chooseNodes(points);
  firstCheck_ = static_cast<Eigen::Index>(points.size());
  chooseChecks(points);
  bindAll(system, points, progress);
  markWholeCells();
  planMending();
}

/// One cell of the outer grid more than the hull on each side, so that the border of the inner grid is
/// outside of the hull, and nodes of the outer grid lie on it.
void RestField::placeInner(double spacing) {
  const Bounds box = boundsOf(handles_.positions);
  const double coarse = kCoarser * spacing;
  const Eigen::Vector3i cells = ((box.high - box.low) / coarse).array().ceil().cast<int>() + 2;
  inner_.spacing = spacing;
  inner_.size = kCoarser * cells.array() + 1;
  inner_.origin = box.center() - 0.5 * coarse * cells.cast<double>();
  inner_.vectors.setZero(inner_.count(), 3);
}

void RestField::chooseNodes(std::vector<Vec3>& points) {
  const double tiny = kWithinHull * hull_.diagonal();
  for (Eigen::Index node = 0; node < inner_.count(); ++node) {
    const Vec3 point = inner_.position(node);
    const double distance = hull_.signedDistance(point);
    if (distance > (1 + kSlack) * std::sqrt(3.0) * inner_.spacing) {
      innerFaded_.push_back(extrapolatedNode(node, point));
      continue;
    }
    BoundNode bound{static_cast<std::int32_t>(node), static_cast<std::int32_t>(points.size()), -1,
                    distance > -tiny};
    const Vec3 entry = bound.outside ? pulledIn(point) : point;
    points.push_back(entry);
    const Vec3 mirrored = 2 * entry - point;
    if (bound.outside && hull_.signedDistance(mirrored) <= -tiny) {
      bound.second = static_cast<std::int32_t>(points.size());
      points.push_back(mirrored);
    }
    boundNodes_.push_back(bound);
  }
}

/// Fading begins behind the bound nodes, so that it does not begin with a step.
RestField::ExtrapolatedNode RestField::extrapolatedNode(Eigen::Index node, const Vec3& position) const {
  const double distance = hull_.signedDistance(position) - std::sqrt(3.0) * inner_.spacing;
  return {static_cast<std::int32_t>(node), static_cast<float>(std::max(distance, 0.0)),
          inner_.cornersAt(pulledIn(position))};
}

void RestField::chooseChecks(std::vector<Vec3>& points) const {
  std::vector<Vec3> centres;
  for (const BoundNode& node : boundNodes_) {
    const Vec3 centre = inner_.position(node.node) + Vec3::Constant(0.5 * inner_.spacing);
    if (hull_.signedDistance(centre) < -kWithinHull * hull_.diagonal())
      centres.push_back(centre);
  }
  const std::size_t step = centres.size() / static_cast<std::size_t>(kMostChecks) + 1;
  for (std::size_t i = 0; i < centres.size(); i += step)
    points.push_back(centres[i]);
}

void RestField::bindAll(const coordinates::CoordinateSystem& system, const std::vector<Vec3>& points,
                        Progress& progress) {
  bound_ = pointsOf(points);
  failed_.assign(points.size(), 0);
  for (Eigen::Index begin = 0; begin < bound_.rows(); begin += kPointsBoundAtOnce) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(begin) / static_cast<double>(bound_.rows()),
                    "Binding the space between the handles");
    Progress quiet; // The caller's listens between pieces.
    bindings_.push_back(
        system.bind(handles_, bound_.middleRows(begin, std::min(kPointsBoundAtOnce, bound_.rows() - begin)),
                    options_, quiet));
    for (const int failure : bindings_.back()->report().failures)
      failed_[static_cast<std::size_t>(begin + failure)] = 1;
  }
  for (BoundNode& node : boundNodes_)
    if (node.second >= 0 && failed_[static_cast<std::size_t>(node.second)] != 0)
      node.second = -1;
}

void RestField::markWholeCells() {
  std::vector<std::uint8_t> isBound(static_cast<std::size_t>(inner_.count()), 0);
  for (const BoundNode& node : boundNodes_)
    isBound[static_cast<std::size_t>(node.node)] = 1;
  wholeCells_.assign(isBound.size(), 0);
  for (const BoundNode& node : boundNodes_) {
    // Nodes on the grid's border are not bound, so that the corners exist.
    const auto corners = cornersOf(inner_, node.node);
    wholeCells_[static_cast<std::size_t>(node.node)] =
        std::all_of(corners.begin(), corners.end(),
                    [&](Eigen::Index c) { return isBound[static_cast<std::size_t>(c)] != 0; })
            ? 1
            : 0;
  }
}

/// Mends from nodes with coordinates outwards, layer by layer.
void RestField::planMending() {
  std::vector<std::uint8_t> known(static_cast<std::size_t>(inner_.count()), 0);
  std::vector<Eigen::Index> open;
  for (const BoundNode& node : boundNodes_) {
    const bool failed = failed_[static_cast<std::size_t>(node.first)] != 0;
    known[static_cast<std::size_t>(node.node)] = failed ? 0 : 1;
    if (failed)
      open.push_back(node.node);
  }
  const std::array<Eigen::Index, 3> strides = {1, inner_.size[0],
                                               Eigen::Index(inner_.size[0]) * inner_.size[1]};
  while (!open.empty()) {
    const std::size_t before = neighbourMeans_.size();
    std::vector<Eigen::Index> left;
    for (const Eigen::Index node : open) {
      NeighbourMeanNode mean{node, {}};
      for (const Eigen::Index stride : strides)
        for (const Eigen::Index neighbour : {node - stride, node + stride})
          if (known[static_cast<std::size_t>(neighbour)] != 0)
            mean.neighbours.push_back(neighbour);
      if (mean.neighbours.empty())
        left.push_back(node);
      else
        neighbourMeans_.push_back(std::move(mean));
    }
    if (neighbourMeans_.size() == before)
      return; // They stay where they are.
    for (std::size_t m = before; m < neighbourMeans_.size(); ++m)
      known[static_cast<std::size_t>(neighbourMeans_[m].node)] = 1;
    open = std::move(left);
  }
}

/// Around the inner grid, each of its nodes there on one of that one's, so that both are the same on the
/// inner grid's border. Its size follows the motion, its spacing the room for it.
void RestField::placeOuter(double reach) {
  reachBuilt_ = kRoomToGrow * reach + std::sqrt(3.0) * inner_.spacing;
  double more = 0; // In floating point: what is too much need not fit into an integer.
  Eigen::Array3d nodes;
  for (double coarser = kCoarser; coarser == kCoarser || nodes.prod() > kMostOuterNodes; coarser *= 2) {
    outer_.spacing = coarser * inner_.spacing;
    more = std::ceil(reachBuilt_ / outer_.spacing) + 1;
    nodes = ((inner_.size.cast<double>().array() - 1) / coarser).ceil() + 1 + 2 * more;
  }
  outer_.size = nodes.cast<int>();
  outer_.origin = inner_.origin - Vec3::Constant(more * outer_.spacing);
  outer_.vectors.setZero(outer_.count(), 3);
  outerFaded_.clear();
  for (Eigen::Index node = 0; node < outer_.count(); ++node) {
    const Vec3 position = outer_.position(node);
    if (hull_.signedDistance(position) < reachBuilt_)
      outerFaded_.push_back(extrapolatedNode(node, position)); // In the hull what the inner grid has there.
  }
}

Points RestField::boundDisplacements() const {
  Points moved(bound_.rows(), 3);
  Points piece;
  for (std::size_t b = 0; b < bindings_.size(); ++b) {
    bindings_[b]->deform(pose_, piece, options_.threads);
    const Eigen::Index begin = static_cast<Eigen::Index>(b) * kPointsBoundAtOnce;
    moved.middleRows(begin, piece.rows()) = piece - bound_.middleRows(begin, piece.rows());
  }
  for (std::size_t i = 0; i < failed_.size(); ++i)
    if (failed_[i] != 0)
      moved.row(static_cast<Eigen::Index>(i)).setZero();
  return moved;
}

/// Gives how far the hull's border moves, mm.
double RestField::setBoundNodes(const Points& moved) {
  double border = 0;
  for (const BoundNode& node : boundNodes_) {
    auto row = inner_.vectors.row(node.node);
    row = moved.row(node.first);
    if (node.outside)
      border = std::max(border, row.squaredNorm());
    if (node.second >= 0)
      // Linear beyond the hull: u(p) = 2 u(e) - u(2 e - p), e where the hull is entered.
      row = 2 * moved.row(node.first) - moved.row(node.second);
  }
  for (const NeighbourMeanNode& mean : neighbourMeans_) {
    Vec3 sum = Vec3::Zero();
    for (const Eigen::Index neighbour : mean.neighbours)
      sum += inner_.vectors.row(neighbour).transpose();
    inner_.vectors.row(mean.node) = sum.transpose() / static_cast<double>(mean.neighbours.size());
  }
  return std::sqrt(border);
}

/// One at the hull, zero from `reach_` on, smooth between.
void RestField::extrapolateNodes(VectorGrid& grid, const std::vector<ExtrapolatedNode>& nodes) const {
  parallelRanges(static_cast<Eigen::Index>(nodes.size()), kNodesAtOnce, options_.threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (Eigen::Index n = begin; n < end; ++n) {
                     const ExtrapolatedNode& node = nodes[static_cast<std::size_t>(n)];
                     const double part = static_cast<double>(node.distance) / reach_;
                     if (part < 1)
                       grid.vectors.row(node.node) =
                           (1 - part * part * (3 - 2 * part)) * inner_.sum(node.entry).transpose();
                     else
                       grid.vectors.row(node.node).setZero();
                   }
                 });
}

/// The inner grid's border gets what the outer grid has there.
void RestField::joinGrids() {
  const Eigen::Vector3i last = inner_.size.array() - 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int side : {0, last[axis]})
      for (int a = 0; a <= last[u]; ++a)
        for (int b = 0; b <= last[v]; ++b) {
          Eigen::Vector3i at;
          at[axis] = side;
          at[u] = a;
          at[v] = b;
          const Eigen::Index node =
              at[0] + Eigen::Index(inner_.size[0]) * (at[1] + Eigen::Index(inner_.size[1]) * at[2]);
          inner_.vectors.row(node) = outer_.at(inner_.position(node), nullptr).transpose();
        }
  }
}

void RestField::setPose(const Points& pose) {
  pose_ = pose;
  foldCells_.clear();
  foldedCount_ = 0;
  error_ = 0;
  roughness_.clear();
  if (pose == handles_.positions) { // Exactly, without the rounding of sums.
    inner_.vectors.setZero();
    outer_.vectors.setZero();
    reach_ = 0;
    return;
  }
  const Points moved = boundDisplacements();
  const double border = setBoundNodes(moved);
  reach_ = std::max(kReach * border, kLeastReach * hull_.diagonal());
  if (reach_ + std::sqrt(3.0) * inner_.spacing > reachBuilt_)
    placeOuter(reach_);
  extrapolateNodes(inner_, innerFaded_);
  extrapolateNodes(outer_, outerFaded_);
  joinGrids();
  measureError(moved);
  measureRoughness();
  markFolds();
}

void RestField::measureError(const Points& moved) {
  std::vector<double> errors;
  for (Eigen::Index check = firstCheck_; check < bound_.rows(); ++check)
    if (failed_[static_cast<std::size_t>(check)] == 0)
      errors.push_back(
          (inner_.at(bound_.row(check).transpose(), nullptr) - moved.row(check).transpose()).norm());
  if (errors.empty())
    return;
  const auto counted =
      errors.begin() + static_cast<std::ptrdiff_t>(kCounted * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), counted, errors.end());
  error_ = *counted;
}

/// Between nodes a linear motion is off by an eighth of the second difference along each axis.
void RestField::measureRoughness() {
  roughness_.assign(static_cast<std::size_t>(inner_.count()), 0);
  const std::array<Eigen::Index, 3> strides = {1, inner_.size[0],
                                               Eigen::Index(inner_.size[0]) * inner_.size[1]};
  parallelRanges(static_cast<Eigen::Index>(boundNodes_.size()), kNodesAtOnce, options_.threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (Eigen::Index n = begin; n < end; ++n) {
                     const BoundNode& bound = boundNodes_[static_cast<std::size_t>(n)];
                     if (bound.outside) // Next to motions that no system says.
                       continue;
                     double sum = 0;
                     for (const Eigen::Index stride : strides)
                       sum += (inner_.vectors.row(bound.node - stride) - 2 * inner_.vectors.row(bound.node) +
                               inner_.vectors.row(bound.node + stride))
                                  .norm();
                     roughness_[static_cast<std::size_t>(bound.node)] = static_cast<float>(sum / 8);
                   }
                 });
  spreadRoughness(strides);
}

/// Outside of the hull, where no system says how nodes move, cells are as rough as those next to them: the
/// hull may end in a corner between nodes, at a handle.
void RestField::spreadRoughness(const std::array<Eigen::Index, 3>& strides) {
  for (int layer = 0; layer < 2; ++layer)
    for (const BoundNode& bound : boundNodes_) {
      if (!bound.outside)
        continue;
      float& own = roughness_[static_cast<std::size_t>(bound.node)];
      for (const Eigen::Index stride : strides)
        own = std::max({own, roughness_[static_cast<std::size_t>(bound.node - stride)],
                        roughness_[static_cast<std::size_t>(bound.node + stride)]});
    }
}

double RestField::roughnessAt(const Vec3& rest) const {
  if (roughness_.empty() || !inner_.contains(rest))
    return 0;
  float largest = 0;
  for (const Eigen::Index corner : cornersOf(inner_, cellAt(inner_, rest).corner))
    largest = std::max(largest, roughness_[static_cast<std::size_t>(corner)]);
  return largest;
}

double RestField::exactPart(const Vec3& rest) const {
  const double distance = hull_.signedDistance(rest);
  return std::clamp(1 - distance / (kExactCells * inner_.spacing), 0.0, 1.0);
}

double RestField::foldedMm3() const {
  return static_cast<double>(foldedCount_) * inner_.spacing * inner_.spacing * inner_.spacing;
}

/// Cells of the hull whose middle is turned inside out.
std::vector<Eigen::Index> RestField::findFoldedCells() const {
  std::vector<Eigen::Index> folded;
  std::mutex mutex;
  parallelRanges(static_cast<Eigen::Index>(boundNodes_.size()), kNodesAtOnce, options_.threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   std::vector<Eigen::Index> own;
                   for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n) {
                     const Eigen::Index cell = boundNodes_[n].node;
                     if (wholeCells_[static_cast<std::size_t>(cell)] == 0)
                       continue;
                     // det(I + grad u) in the middle of the cell, times (4 h)^3.
                     Eigen::Matrix3d edges; // Four of each direction, summed.
                     edges.setZero();
                     const auto corners = cornersOf(inner_, cell);
                     for (std::size_t c = 0; c < 8; ++c)
                       for (int axis = 0; axis < 3; ++axis)
                         edges.col(axis) +=
                             ((c >> axis & 1U) != 0 ? 1 : -1) * inner_.vectors.row(corners[c]).transpose();
                     edges.diagonal().array() += 4 * inner_.spacing;
                     if (!(edges.determinant() > 0))
                       own.push_back(cell);
                   }
                   const std::lock_guard lock(mutex);
                   folded.insert(folded.end(), own.begin(), own.end());
                 });
  return folded; // In any order: only their union counts.
}

void RestField::markFolds() {
  const std::vector<Eigen::Index> cells = findFoldedCells();
  const Vec3 toMiddle = Vec3::Constant(0.5 * inner_.spacing);
  foldedCount_ = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [&](Eigen::Index cell) {
    return isInside(inner_.position(cell) + toMiddle);
  }));
  if (cells.empty())
    return;
  std::vector<Bounds> boxes;
  Bounds all{Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
  for (const Eigen::Index cell : cells) {
    Bounds box{Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
    for (const Eigen::Index corner : cornersOf(inner_, cell)) {
      const Vec3 posed = inner_.position(corner) + Vec3(inner_.vectors.row(corner).transpose());
      box = {box.low.cwiseMin(posed), box.high.cwiseMax(posed)};
    }
    all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
    boxes.push_back(box);
  }
  folds_.origin = all.low;
  folds_.spacing = inner_.spacing;
  const auto nodes = [&]() -> Eigen::Array3d {
    return ((all.high - all.low) / folds_.spacing).array().floor() + 2;
  };
  while (nodes().prod() > kMostFoldCells)
    folds_.spacing *= 2;
  folds_.size = nodes().cast<int>();
  foldCells_.assign(static_cast<std::size_t>(folds_.count()), 0);
  for (const Bounds& box : boxes) {
    const Eigen::Vector3i low = ((box.low - folds_.origin) / folds_.spacing).array().floor().cast<int>();
    const Eigen::Vector3i high = ((box.high - folds_.origin) / folds_.spacing).array().floor().cast<int>();
    for (Eigen::Index z = low[2]; z <= high[2]; ++z)
      for (Eigen::Index y = low[1]; y <= high[1]; ++y)
        for (Eigen::Index x = low[0]; x <= high[0]; ++x)
          foldCells_[static_cast<std::size_t>(x + folds_.size[0] * (y + folds_.size[1] * z))] = 1;
  }
}

bool RestField::isFolded(const Vec3& posed) const {
  return !foldCells_.empty() && folds_.contains(posed) &&
         foldCells_[static_cast<std::size_t>(cellAt(folds_, posed).corner)] != 0;
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

Vec3 RestField::displacementAt(const Vec3& rest) const {
  if (inner_.contains(rest))
    return inner_.at(rest, nullptr);
  return reach_ > 0 && outer_.contains(rest) ? outer_.at(rest, nullptr) : Vec3::Zero();
}

RestField::Motion RestField::motionAt(const Vec3& rest) const {
  Motion motion;
  if (inner_.contains(rest))
    motion.displacement = inner_.at(rest, &motion.gradient);
  else if (reach_ > 0 && outer_.contains(rest))
    motion.displacement = outer_.at(rest, &motion.gradient);
  return motion;
}

Bounds RestField::movedBox() const {
  const Bounds box = boundsOf(handles_.positions);
  const Vec3 room = Vec3::Constant(reach_ > 0 ? reachBuilt_ + outer_.spacing : 0);
  return {box.low - room, box.high + room};
}

} // namespace viscera::deformation
