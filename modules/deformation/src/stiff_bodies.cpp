#include "viscera/deformation/stiff_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "broyden_search.h"
#include "viscera/core/parallel.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/winding_number.h"

namespace viscera::deformation {
namespace {

constexpr int kCellsAlong = 40;       ///< Of a grid of distances, along its longest side.
constexpr double kLeastCellMm = 0.5;  ///< No grid of distances is finer.
constexpr double kRoomAround = 0.35;  ///< Of a body's diagonal: how far its grid goes, and the widest band.
constexpr double kBandOfMotion = 3;   ///< Times what both motions differ, so that nothing folds between them.
constexpr double kLeastBandCells = 3; ///< Of the grid of distances.
constexpr Eigen::Index kMostCompared = 400;        ///< Vertices at which both motions are compared.
constexpr Eigen::Index kStiffSamplesAtOnce = 4096; ///< Samples that a thread takes at a time.
constexpr double kReverseMm = 0.01;                ///< The accuracy of the reverse.
constexpr int kMostReverseSteps = 30;

/// 1 up to `from`, 0 from `to` on, and smooth between.
double smoothFall(double at, double from, double to) {
  const double part = std::clamp((at - from) / std::max(to - from, 1e-9), 0.0, 1.0);
  return 1 - part * part * (3 - 2 * part);
}

} // namespace

StiffBodies::StiffBodies(std::vector<std::shared_ptr<const geometry::TriangleMesh>> rest, Threads threads,
                         Progress& progress)
    : threads_(threads) {
  for (auto& mesh : rest) {
    progress.throwIfCancelled();
    bodies_.push_back(bodyOf(std::move(mesh), threads, progress));
  }
}

StiffBodies::Body StiffBodies::bodyOf(std::shared_ptr<const geometry::TriangleMesh> rest, Threads threads,
                                      Progress& progress) {
  Body body;
  const Bounds box = boundsOf(rest->points);
  const Vec3 room = Vec3::Constant(kRoomAround * box.diagonal());
  const Vec3 extent = box.high - box.low + 2 * room;
  body.spacing = std::max(extent.maxCoeff() / kCellsAlong, kLeastCellMm);
  body.origin = box.low - room;
  body.size = (extent / body.spacing).array().ceil().cast<int>() + 2;
  body.rest = std::move(rest);
  const geometry::SignedDistance surface(body.rest);
  const geometry::WindingNumber winding(*body.rest);
  const Eigen::Index layer = Eigen::Index(body.size[0]) * body.size[1];
  body.distances.resize(static_cast<std::size_t>(layer * body.size[2]));
  parallelRanges(body.size[2], 1, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index z = begin; z < end; ++z) {
      if (progress.cancelled())
        return;
      for (Eigen::Index y = 0; y < body.size[1]; ++y)
        for (Eigen::Index x = 0; x < body.size[0]; ++x) {
          const Vec3 node = body.origin + body.spacing * Vec3(static_cast<double>(x), static_cast<double>(y),
                                                              static_cast<double>(z));
          // The side is that of the winding number: surfaces of bones have holes.
          const double away = (surface.nearest(node) - node).norm();
          body.distances[static_cast<std::size_t>(x + body.size[0] * y + layer * z)] =
              static_cast<float>(winding.inside(node) ? -away : away);
        }
    }
  });
  progress.throwIfCancelled();
  return body;
}

/// Trilinear; as far away as may be outside of the grid.
double StiffBodies::Body::distanceAt(const Vec3& restPlace) const {
  const Vec3 at = (restPlace - origin) / spacing;
  if (!((at.array() >= 0).all() && at.x() < size[0] - 1 && at.y() < size[1] - 1 && at.z() < size[2] - 1))
    return HUGE_VAL;
  const Eigen::Vector3i cell = at.array().floor().cast<int>();
  const Vec3 part = at - cell.cast<double>();
  const Eigen::Index y = size[0], z = y * size[1];
  const float* first = distances.data() + cell[0] + y * cell[1] + z * cell[2];
  const auto alongX = [&](Eigen::Index offset) {
    return (1 - part.x()) * static_cast<double>(first[offset]) +
           part.x() * static_cast<double>(first[offset + 1]);
  };
  const double low = (1 - part.y()) * alongX(0) + part.y() * alongX(y);
  const double high = (1 - part.y()) * alongX(z) + part.y() * alongX(z + y);
  return (1 - part.z()) * low + part.z() * high;
}

/// 1 in the body and up to one cell outside of it: what is trilinear of distances is too large by less than
/// half of a cell's diagonal.
double StiffBodies::Body::weightAt(const Vec3& restPlace) const {
  return smoothFall(distanceAt(restPlace), spacing, spacing + band);
}

void StiffBodies::setPose(const std::vector<const Points*>& posed, const InverseMap& soft) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    const Points& rest = body.rest->points;
    // Least squares over the vertices (Umeyama 1991, doi 10.1109/34.88573, without scale).
    body.toPose.matrix() = Eigen::umeyama(rest.transpose().eval(), posed.at(b)->transpose().eval(), false);
    body.toRest = body.toPose.inverse();
    const Eigen::Index step = rest.rows() / kMostCompared + 1;
    Points some((rest.rows() + step - 1) / step, 3);
    for (Eigen::Index i = 0; i < some.rows(); ++i)
      some.row(i) = rest.row(i * step);
    const Points ofTissue = soft.posedPoints(some);
    double differ = 0;
    for (Eigen::Index i = 0; i < some.rows(); ++i)
      differ = std::max(
          differ, (body.toPose * Vec3(some.row(i).transpose()) - Vec3(ofTissue.row(i).transpose())).norm());
    const double widest = kRoomAround * boundsOf(rest).diagonal() - 2 * body.spacing;
    body.band = std::clamp(kBandOfMotion * differ, std::min(kLeastBandCells * body.spacing, widest), widest);
  }
}

/// A body counts by its weight times what the others leave over, and tissue by what all leave over. Where two
/// bodies overlap nothing is left over, and both count alike.
StiffBodies::Mix StiffBodies::mixed(const std::vector<double>& weights,
                                    const std::vector<Vec3>& places) const {
  Mix mix;
  double sum = 1;
  for (const double weight : weights)
    sum *= 1 - weight;
  mix.soft = sum;
  std::vector<double> shares(weights.size());
  for (std::size_t b = 0; b < weights.size(); ++b) {
    shares[b] = weights[b];
    for (std::size_t c = 0; c < weights.size(); ++c)
      shares[b] *= c == b ? 1 : 1 - weights[c];
    sum += shares[b];
  }
  if (!(sum > 0)) {
    shares = weights;
    sum = 0;
    for (const double weight : weights)
      sum += weight;
  }
  mix.soft /= sum;
  for (std::size_t b = 0; b < weights.size(); ++b)
    if (shares[b] > 0)
      mix.ofBodies += shares[b] / sum * places[b];
  return mix;
}

StiffBodies::Mix StiffBodies::mixAtPosed(const Vec3& posed) const {
  std::vector<double> weights;
  std::vector<Vec3> places;
  for (const Body& body : bodies_) {
    const Vec3 place = body.toRest * posed;
    const double weight = body.weightAt(place);
    if (weight > 0) {
      weights.push_back(weight);
      places.push_back(place);
    }
  }
  return weights.empty() ? Mix() : mixed(weights, places);
}

void StiffBodies::stiffen(const SamplePlane& plane, RestPoints& rest) const {
  if (bodies_.empty())
    return;
  parallelRanges(rest.points.rows(), kStiffSamplesAtOnce, threads_,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (Eigen::Index i = begin; i < end; ++i) {
                     const Mix mix = mixAtPosed(plane.at(i % plane.columns, i / plane.columns));
                     if (!mix.touched())
                       continue;
                     // Far in a body its place counts alone, whatever became of the tissue there.
                     rest.points.row(i) =
                         (mix.soft > 0 ? mix.with(rest.points.row(i).transpose()) : mix.ofBodies).transpose();
                     RestState& state = rest.states[static_cast<std::size_t>(i)];
                     if (state == RestState::still || !(mix.soft > 0))
                       state = RestState::moved;
                   }
                 });
}

Vec3 StiffBodies::restOf(const InverseMap& soft, const Vec3& posed) const {
  const Mix mix = mixAtPosed(posed);
  if (mix.touched() && !(mix.soft > 0))
    return mix.ofBodies;
  return mix.with(soft.restPoints(posed.transpose()).points.row(0).transpose());
}

Vec3 StiffBodies::posedOf(const InverseMap& soft, const Vec3& rest) const {
  std::vector<double> weights;
  std::vector<Vec3> places;
  for (const Body& body : bodies_)
    if (const double weight = body.weightAt(rest); weight > 0) {
      weights.push_back(weight);
      places.push_back(body.toPose * rest);
    }
  const Vec3 ofTissue = soft.posedPoints(rest.transpose()).row(0).transpose();
  // The same mix of the motions themselves is near; what is left is searched: y with restOf(y) = rest.
  BroydenSearch search;
  search.target = rest;
  search.at = weights.empty() ? ofTissue : mixed(weights, places).with(ofTissue);
  for (int step = 0; step < kMostReverseSteps; ++step)
    if (!search.advance(restOf(soft, search.at) - search.at, kReverseMm))
      break;
  return std::isfinite(search.bestError) ? search.best : search.at;
}

} // namespace viscera::deformation
