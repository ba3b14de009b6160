#include "cine_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "fold_relief.h"
#include "nearest_place.h"
#include "viscera/geometry/normals.h"

namespace viscera::tracking {
namespace {

constexpr double kClosureMm = 3;
constexpr double kGateMm = 8, kWideGateMm = 12, kWithinGateMm = 12;
constexpr int kWideSteps = 3, kWaySteps = 8;
constexpr double kWider = 2; ///< Gates while tissue is far from the labelled pose.
constexpr double kLongestWayStep = 0.25, kStillWay = 0.003, kStillHandleMm = 0.15, kLongestStepMm = 10;
constexpr double kPoseFloor = 1e-7;
constexpr double kWithinWeight = 0.3, kRimWeight = 0.5; ///< Long-axis rows within the plane.
/// Below this det F tissue resists, more the flatter it is: the cost of a point, mm^2.
constexpr double kLeastRatio = 0.2, kRatioCost = 0.05;

/// Tukey's weight of a distance.
double tukeyWeight(double apart, double gate) {
  const double part = apart / gate;
  return std::abs(part) < 1 ? (1 - part * part) * (1 - part * part) : 0;
}

double medianOf(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

CinePose::CinePose(const MotionRig& rig, const CineSegment& segment, std::size_t at, const LabelledPose& from,
                   const LabelledPose& to, const std::vector<bool>& isLong,
                   const std::vector<CinePlane>& planes, const std::vector<std::vector<Eigen::Index>>& caps,
                   const CineStiffness& hold)
    : rig_(rig), from_(from), to_(to), isLong_(isLong), planes_(planes), hold_(hold),
      time_(segment.parts[at]) {
  for (std::size_t i = 0; i < rig.surfaces().size(); ++i) {
    isCap_.emplace_back(static_cast<std::size_t>(rig.surfaces()[i].triangles.rows()), false);
    if (i < caps.size())
      for (const Eigen::Index t : caps[i])
        isCap_[i][static_cast<std::size_t>(t)] = true;
  }
  gather(segment.ahead, time_, at);
  gather(segment.against, 1 - time_, segment.phases.size() - 1 - at);
}

void CinePose::gather(const std::vector<CineContour>& contours, double far, std::size_t step) {
  for (const CineContour& contour : contours) {
    const PlaneTracker::Followed& followed = contour.followed[step];
    if (followed.at.rows() == 0)
      continue;
    Tissue& tissue = tissue_.emplace_back();
    tissue.contour = &contour;
    tissue.at = followed.at - far * contour.drift;
    tissue.likeness = followed.likeness;
    // w = (1 - f) q l / (1 + (f c / 3 mm)^2), f how far from the label, q likeness, l length, c closure.
    tissue.weight = (1 - far) * followed.likeness.array() * contour.lengths.array() /
                    (1 + (far / kClosureMm * contour.closure.array()).square());
  }
}

Eigen::Index CinePose::acrossRows(const Points& vertices, double gateMm, Rows& rows) const {
  Eigen::Index row = 0;
  for (std::size_t surface = 0; surface < rig_.surfaces().size(); ++surface) {
    const Eigen::Index first = rig_.firstRow(surface);
    const geometry::TriangleMesh own{
        vertices.middleRows(first, rig_.rows(surface)), rig_.surfaces()[surface].triangles, {}};
    const NearestPlace nearest(own.points, own.triangles);
    const geometry::Normals normals = geometry::vertexNormals(own);
    for (const Tissue& tissue : tissue_) {
      if (tissue.contour->surface != surface)
        continue;
      for (Eigen::Index i = 0; i < tissue.at.rows(); ++i, ++row) {
        const Vec3 at = tissue.at.row(i);
        const SurfacePlace place = nearest.of(at);
        Vec3 normal = Vec3::Zero();
        rows.handles.row(row).setZero();
        for (int k = 0; k < 3; ++k) {
          const Eigen::Index vertex = own.triangles(place.triangle, k);
          normal += place.corners[k] * normals.row(vertex).cast<double>().transpose();
          rows.handles.row(row) += place.corners[k] * rig_.weights().row(first + vertex);
        }
        normal.normalize();
        rows.direction.row(row) = normal.transpose();
        rows.apart[row] = normal.dot(at - place.point);
        rows.weight[row] = isCap_[surface][static_cast<std::size_t>(place.triangle)]
                               ? 0
                               : tissue.weight[i] * tukeyWeight(place.apart, gateMm);
      }
    }
  }
  return row;
}

void CinePose::withinRows(const Points& pose, Eigen::Index first, double gateMm, Rows& rows) const {
  for (const Tissue& tissue : tissue_) {
    const CineContour& contour = *tissue.contour;
    if (!isLong_[contour.plane])
      continue;
    const Points apart = tissue.at - contour.weights * pose;
    for (const Vec3& along : {planes_[contour.plane].alongRow, planes_[contour.plane].alongColumn})
      for (Eigen::Index i = 0; i < apart.rows(); ++i, ++first) {
        rows.handles.row(first) = contour.weights.row(i);
        rows.direction.row(first) = along.transpose();
        rows.apart[first] = apart.row(i).dot(along);
        rows.weight[first] = tissue.weight[i] * (kWithinWeight + kRimWeight * contour.onRim[i]) *
                             tukeyWeight(apart.row(i).norm(), gateMm);
      }
  }
}

CinePose::Rows CinePose::rowsAt(const Points& pose, double gateMm, double withinMm) const {
  const bool within = withinMm > 0;
  Eigen::Index count = 0;
  for (const Tissue& tissue : tissue_)
    count += tissue.at.rows() * (within && isLong_[tissue.contour->plane] ? 3 : 1);
  Rows rows{Eigen::MatrixXd(count, rig_.handles()), Points(count, 3), Values(count), Values(count)};
  const Eigen::Index across = acrossRows(rig_.vertices(pose), gateMm, rows);
  if (within)
    withinRows(pose, across, withinMm, rows);
  return rows;
}

double CinePose::partOfWay() const {
  double part = (1 - std::cos(std::numbers::pi * time_)) / 2;
  const Points way = to_.pose - from_.pose;
  for (int step = 0; step < kWaySteps; ++step) {
    const Rows rows = rowsAt(between(part), step < kWideSteps ? kWideGateMm : kGateMm, 0);
    // min sum w (e - j ds)^2 with j = n . W (h_b - h_a).
    const Values along = (rows.handles * way).cwiseProduct(rows.direction).rowwise().sum();
    const double size = rows.weight.dot(along.cwiseAbs2());
    const double wanted = rows.weight.dot(along.cwiseProduct(rows.apart));
    const double change = std::clamp(wanted / (size + 1e-9), -kLongestWayStep, kLongestWayStep);
    part += change;
    if (std::abs(change) < kStillWay)
      break;
  }
  return part;
}

Points CinePose::System::solve(const Points& right) const {
  const Eigen::VectorXd stacked = right.reshaped();
  const Eigen::VectorXd found = matrix.solve(stacked);
  return found.reshaped(right.rows(), 3);
}

CinePose::System CinePose::systemAt(const Points& pose, const Points& prior, const WallStiffness& stiffness,
                                    double wider) const {
  static constexpr std::array<std::pair<int, int>, 6> kBlocks = {
      {{0, 0}, {1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}}};
  const Rows rows = rowsAt(pose, wider * kGateMm, wider * kWithinGateMm);
  std::vector<Eigen::Index> used;
  for (Eigen::Index i = 0; i < rows.weight.size(); ++i)
    if (rows.weight[i] > 0)
      used.push_back(i);
  const Eigen::MatrixXd handles = rows.handles(used, Eigen::all);
  const Points direction = rows.direction(used, Eigen::all);
  const Values weight = rows.weight(used) / (rows.weight.sum() + 1e-9), apart = rows.apart(used);
  const Eigen::MatrixXd hold = hold_.strain * stiffness.strain() + hold_.bending * stiffness.bending() +
                               hold_.handles * rig_.bending();
  const Eigen::Index n = rig_.handles();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (const auto& [row, column] : kBlocks) {
    const Values scale = weight.cwiseProduct(direction.col(row)).cwiseProduct(direction.col(column));
    Eigen::MatrixXd block = handles.transpose() * (scale.asDiagonal() * handles);
    if (row == column)
      block += hold;
    matrix.block(row * n, column * n, n, n) = block;
  }
  const Points pushed = weight.cwiseProduct(apart).asDiagonal() * direction;
  Points gradient = handles.transpose() * pushed - hold * (pose - prior);
  // Flat tissue: cost (r - det F)^2 below r, one row a point.
  const Values ratios = stiffness.ratios(pose);
  for (Eigen::Index point = 0; point < ratios.size(); ++point)
    if (ratios[point] < kLeastRatio) {
      const Points slope = stiffness.ratioGradient(pose, point);
      const Eigen::VectorXd stacked = slope.reshaped();
      matrix.selfadjointView<Eigen::Lower>().rankUpdate(stacked, kRatioCost);
      gradient += kRatioCost * (kLeastRatio - ratios[point]) * slope;
    }
  matrix.diagonal().array() += kPoseFloor;
  return {matrix.selfadjointView<Eigen::Lower>().llt(), std::move(gradient)};
}

Points CinePose::fitted(const Points& prior, const WallStiffness& stiffness, bool& heldBack) const {
  Points pose = prior;
  for (int round = 0; round < hold_.steps && !tissue_.empty(); ++round) {
    const System system = systemAt(pose, prior, stiffness, round < hold_.wideSteps ? kWider : 1);
    const Points change = system.solve(system.gradient);
    const double largest = std::sqrt(rig_.vertices(change).rowwise().squaredNorm().maxCoeff());
    pose += std::min(1.0, kLongestStepMm / std::max(largest, 1e-9)) * change;
    if (largest < kStillHandleMm && round >= hold_.wideSteps)
      break;
  }
  // No more folds than on the way between the labels themselves.
  heldBack = holdBack(prior, stiffness, pose);
  return pose;
}

bool CinePose::holdBack(const Points& safe, const WallStiffness& stiffness, Points& pose) {
  const auto folds = [&](const Points& at) { return (stiffness.ratios(at).array() <= 0).count(); };
  const auto least = folds(safe);
  const Points all = pose - safe;
  bool heldBack = false;
  for (double part = 0.75; folds(pose) > least && part >= 0; part -= 0.25) {
    heldBack = true;
    pose = safe + part * all;
  }
  return heldBack;
}

VolumeResidual CinePose::giveVolumes(const Values& wantedMl, const WallStiffness& stiffness,
                                     Points& pose) const {
  const System system = systemAt(pose, pose, stiffness);
  return solveVolumes(
      rig_, wantedMl, [&](const Points& gradient) { return system.solve(gradient); }, pose);
}

bool CinePose::unfold(const WallStiffness& stiffness, bool keepVolumes, Points& pose) const {
  if (!isFolded(stiffness, pose))
    return true;
  const System system = systemAt(pose, pose, stiffness);
  return relieveFolds(
      rig_, stiffness, [&](const Points& gradient) { return system.solve(gradient); }, keepVolumes, pose);
}

std::vector<PlaneShare> CinePose::shares(const Points& pose) const {
  std::vector<PlaneShare> shares(planes_.size());
  std::vector<double> full(planes_.size(), 0), weights(planes_.size(), 0), apart(planes_.size(), 0),
      likeness(planes_.size(), 0);
  std::vector<std::vector<double>> closures(planes_.size());
  const Points vertices = rig_.vertices(pose);
  for (const Tissue& tissue : tissue_) {
    const std::size_t plane = tissue.contour->plane;
    const Eigen::Index first = rig_.firstRow(tissue.contour->surface);
    const Points own = vertices.middleRows(first, rig_.rows(tissue.contour->surface));
    const NearestPlace nearest(own, rig_.surfaces()[tissue.contour->surface].triangles);
    for (Eigen::Index i = 0; i < tissue.at.rows(); ++i) {
      full[plane] += tissue.contour->lengths[i];
      likeness[plane] += tissue.contour->lengths[i] * tissue.likeness[i];
      weights[plane] += tissue.weight[i];
      apart[plane] += tissue.weight[i] * nearest.of(tissue.at.row(i).transpose()).apart;
      closures[plane].push_back(tissue.contour->closure[i]);
    }
    shares[plane].points += static_cast<int>(tissue.at.rows());
  }
  for (std::size_t plane = 0; plane < shares.size(); ++plane) {
    // The weights of both directions add up to 1 in a phase whose images are alike and close.
    shares[plane].weight = full[plane] > 0 ? std::min(1.0, 2 * weights[plane] / full[plane]) : 0;
    shares[plane].likeness = full[plane] > 0 ? likeness[plane] / full[plane] : 0;
    shares[plane].apartMm = weights[plane] > 0 ? apart[plane] / weights[plane] : 0;
    shares[plane].closureMm = medianOf(closures[plane]);
  }
  return shares;
}

} // namespace viscera::tracking
