#include "cine_contours.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "nearest_place.h"

namespace viscera::tracking {
namespace {

constexpr std::size_t kFewestCrossings = 4;
constexpr int kNeighbours = 3;
constexpr double kLongestShare = 4; ///< mm of contour that one point may stand for.
constexpr double kRimMm = 6;
constexpr double kDriftSmoothMm = 6, kMostDriftMm = 6;

/// The vertices of the caps of one surface, and those of them that are also the wall's.
struct CapVertices {
  std::vector<bool> cap, rim;
};

CapVertices capVerticesOf(const geometry::TriangleMesh& mesh, const std::vector<Eigen::Index>& caps) {
  const auto count = static_cast<std::size_t>(mesh.points.rows());
  CapVertices vertices{std::vector<bool>(count, false), std::vector<bool>(count, false)};
  std::vector<bool> isCap(static_cast<std::size_t>(mesh.triangles.rows()), false);
  for (const Eigen::Index t : caps)
    isCap[static_cast<std::size_t>(t)] = true;
  std::vector<bool> wall(count, false);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(mesh.triangles(t, k));
      (isCap[static_cast<std::size_t>(t)] ? vertices.cap : wall)[vertex] = true;
    }
  for (std::size_t v = 0; v < count; ++v)
    vertices.rim[v] = vertices.cap[v] && wall[v];
  return vertices;
}

/// An edge of a surface that crosses a plane: its vertices, and how far from the first to the second.
struct Crossing {
  Eigen::Index a = 0, b = 0;
  double part = 0;
};

std::vector<Crossing> crossingsOf(const Points& points, const Triangles& triangles, const CinePlane& plane) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> edges;
  Values aside(points.rows());
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    aside[v] = plane.aside(points.row(v).transpose());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Index a = triangles(t, k), b = triangles(t, (k + 1) % 3);
      if ((aside[a] > 0) != (aside[b] > 0))
        edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Crossing> crossings;
  for (const auto& [a, b] : edges)
    crossings.push_back({a, b, aside[a] / (aside[a] - aside[b])});
  return crossings;
}

/// The mean distance of each point from its three nearest others, at most some mm: what it stands for.
Values sharesAlong(const Points& points) {
  Values shares(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Values apart = (points.rowwise() - points.row(i)).rowwise().norm();
    apart[i] = std::numeric_limits<double>::infinity();
    std::partial_sort(apart.begin(), apart.begin() + kNeighbours, apart.end());
    shares[i] = std::min(apart.head<kNeighbours>().mean(), kLongestShare);
  }
  return shares;
}

/// Contours of labelled surfaces, cut by planes.
class ContourCutter {
public:
  ContourCutter(const MotionRig& rig, const std::vector<CinePlane>& planes,
                const std::vector<std::vector<Eigen::Index>>& caps)
      : rig_(rig), planes_(planes) {
    for (std::size_t i = 0; i < rig.surfaces().size(); ++i)
      caps_.push_back(
          capVerticesOf(rig.surfaces()[i], i < caps.size() ? caps[i] : std::vector<Eigen::Index>()));
  }

  std::optional<CineContour> cut(const LabelledPose& labelled, std::size_t plane, std::size_t surface) const {
    const Eigen::Index first = rig_.firstRow(surface);
    const Points vertices = labelled.vertices.middleRows(first, rig_.rows(surface));
    const CapVertices& caps = caps_[surface];
    std::vector<Crossing> crossings =
        crossingsOf(vertices, rig_.surfaces()[surface].triangles, planes_[plane]);
    std::erase_if(crossings, [&](const Crossing& crossing) {
      return caps.cap[static_cast<std::size_t>(crossing.a)] && caps.cap[static_cast<std::size_t>(crossing.b)];
    });
    // Every second one: they are nearer to one another than pixels.
    for (std::size_t i = 1; i < crossings.size(); ++i)
      crossings.erase(crossings.begin() + static_cast<std::ptrdiff_t>(i));
    if (crossings.size() < kFewestCrossings)
      return std::nullopt;
    CineContour contour{plane, surface, {}, {}, {}, {}, {}, {}, {}};
    const auto count = static_cast<Eigen::Index>(crossings.size());
    contour.at.resize(count, 3);
    contour.weights.resize(count, rig_.handles());
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto& [a, b, part] = crossings[static_cast<std::size_t>(i)];
      contour.at.row(i) = (1 - part) * vertices.row(a) + part * vertices.row(b);
      contour.weights.row(i) =
          (1 - part) * rig_.weights().row(first + a) + part * rig_.weights().row(first + b);
    }
    contour.lengths = sharesAlong(contour.at);
    contour.onRim = nearRim(contour.at, vertices, caps);
    return contour;
  }

private:
  static Values nearRim(const Points& at, const Points& vertices, const CapVertices& caps) {
    Values near = Values::Zero(at.rows());
    for (Eigen::Index v = 0; v < vertices.rows(); ++v)
      if (caps.rim[static_cast<std::size_t>(v)])
        for (Eigen::Index i = 0; i < at.rows(); ++i)
          if ((at.row(i) - vertices.row(v)).squaredNorm() < kRimMm * kRimMm)
            near[i] = 1;
    return near;
  }

  const MotionRig& rig_;
  const std::vector<CinePlane>& planes_;
  std::vector<CapVertices> caps_;
};

/// Where a contour's tissue arrives beside the next label's own contour in the plane, smoothed along it.
Points driftOf(const CineContour& contour, const Points& arrived, const CineContour& own) {
  Points away(arrived.rows(), 3);
  for (Eigen::Index i = 0; i < arrived.rows(); ++i) {
    const Values apart = (own.at.rowwise() - arrived.row(i)).rowwise().norm();
    std::vector<Eigen::Index> order(static_cast<std::size_t>(apart.size()));
    for (std::size_t k = 0; k < order.size(); ++k)
      order[k] = static_cast<Eigen::Index>(k);
    std::partial_sort(order.begin(), order.begin() + kNeighbours, order.end(),
                      [&](Eigen::Index a, Eigen::Index b) {
                        return apart[a] < apart[b] || (apart[a] == apart[b] && a < b);
                      });
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double weights = 0;
    for (int k = 0; k < kNeighbours; ++k) {
      const Eigen::Index other = order[static_cast<std::size_t>(k)];
      const double weight = 1 / (apart[other] + 0.5);
      sum += weight * (arrived.row(i) - own.at.row(other));
      weights += weight;
    }
    away.row(i) = sum / weights;
  }
  Points drift(arrived.rows(), 3);
  for (Eigen::Index i = 0; i < arrived.rows(); ++i) {
    const Values near = ((contour.at.rowwise() - contour.at.row(i)).rowwise().squaredNorm().array() /
                         (-2 * kDriftSmoothMm * kDriftSmoothMm))
                            .exp();
    drift.row(i) = near.transpose() * away / near.sum();
    if (const double length = drift.row(i).norm(); length > kMostDriftMm)
      drift.row(i) *= kMostDriftMm / length;
  }
  return drift;
}

/// Compares where contours arrive with the surfaces that are labelled there.
void close(const MotionRig& rig, const LabelledPose& next, const std::vector<CineContour>& own,
           CineContour& contour) {
  const Points& arrived = contour.followed.back().at;
  contour.closure = Values::Zero(contour.at.rows());
  contour.drift = Points::Zero(contour.at.rows(), 3);
  if (arrived.rows() == 0)
    return;
  const Points surface = next.vertices.middleRows(rig.firstRow(contour.surface), rig.rows(contour.surface));
  const NearestPlace nearest(surface, rig.surfaces()[contour.surface].triangles);
  for (Eigen::Index i = 0; i < arrived.rows(); ++i)
    contour.closure[i] = nearest.of(arrived.row(i).transpose()).apart;
  for (const CineContour& other : own)
    if (other.plane == contour.plane && other.surface == contour.surface)
      contour.drift = driftOf(contour, arrived, other);
}

/// One way through one segment in one plane: its contours are followed together.
struct CineChain {
  std::size_t segment = 0, plane = 0, source = 0;
  bool ahead = true; ///< Whether it begins where the segment does: of one label both ends are the same.
  std::vector<std::size_t> order;
  std::vector<CineContour> contours;
};

std::vector<CineSegment> emptySegments(const std::vector<LabelledPose>& labelled, const PhaseTimes& times) {
  std::vector<CineSegment> segments;
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    CineSegment& segment = segments.emplace_back();
    segment.from = i;
    segment.to = (i + 1) % labelled.size();
    if (segment.to == 0 && !times.loop) {
      segments.pop_back();
      break;
    }
    const std::size_t begin = labelled[i].phase, end = labelled[segment.to].phase;
    const auto since = [&](std::size_t phase) {
      const double seconds = times.seconds[phase] - times.seconds[begin];
      return seconds > 0 ? seconds : seconds + times.periodSeconds;
    };
    for (std::size_t phase = (begin + 1) % times.count(); phase != end; phase = (phase + 1) % times.count()) {
      segment.phases.push_back(phase);
      segment.parts.push_back(since(phase) / since(end));
    }
  }
  return segments;
}

std::vector<CineChain> chainsOf(const std::vector<CineSegment>& segments,
                                const std::vector<LabelledPose>& labelled, std::size_t planes,
                                std::size_t surfaces, const ContourCutter& cutter) {
  std::vector<CineChain> chains;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const CineSegment& segment = segments[i];
    if (segment.phases.empty())
      continue;
    std::vector<std::size_t> onward = segment.phases, back(segment.phases.rbegin(), segment.phases.rend());
    onward.push_back(labelled[segment.to].phase);
    back.push_back(labelled[segment.from].phase);
    for (std::size_t plane = 0; plane < planes; ++plane)
      for (const bool ahead : {true, false}) {
        CineChain chain{i, plane, ahead ? segment.from : segment.to, ahead, ahead ? onward : back, {}};
        for (std::size_t surface = 0; surface < surfaces; ++surface)
          if (auto contour = cutter.cut(labelled[chain.source], plane, surface))
            chain.contours.push_back(std::move(*contour));
        if (!chain.contours.empty())
          chains.push_back(std::move(chain));
      }
  }
  return chains;
}

/// Follows the contours of a chain, all points at once.
void followChain(const PlaneTracker& tracker, std::size_t source, CineChain& chain, Progress& progress) {
  Eigen::Index count = 0;
  for (const CineContour& contour : chain.contours)
    count += contour.at.rows();
  Points all(count, 3);
  count = 0;
  for (const CineContour& contour : chain.contours) {
    all.middleRows(count, contour.at.rows()) = contour.at;
    count += contour.at.rows();
  }
  const auto followed = tracker.follow(all, source, chain.order, progress);
  count = 0;
  for (CineContour& contour : chain.contours) {
    for (const PlaneTracker::Followed& phase : followed) {
      PlaneTracker::Followed& own = contour.followed.emplace_back();
      if (phase.at.rows() == 0)
        continue;
      own.at = phase.at.middleRows(count, contour.at.rows());
      own.likeness = phase.likeness.segment(count, contour.at.rows());
    }
    count += contour.at.rows();
  }
}

} // namespace

std::vector<CineSegment> cineSegments(const MotionRig& rig, const std::vector<LabelledPose>& labelled,
                                      const std::vector<CinePlane>& planes, const PhaseTimes& times,
                                      const std::vector<std::vector<Eigen::Index>>& caps, Progress& progress,
                                      Threads threads) {
  std::vector<CineSegment> segments = emptySegments(labelled, times);
  const ContourCutter cutter(rig, planes, caps);
  std::vector<CineChain> chains = chainsOf(segments, labelled, planes.size(), rig.surfaces().size(), cutter);
  Points around(0, 3);
  for (const LabelledPose& pose : labelled) {
    around.conservativeResize(around.rows() + pose.vertices.rows(), 3);
    around.bottomRows(pose.vertices.rows()) = pose.vertices;
  }
  std::vector<double> fractions;
  for (const double seconds : times.seconds)
    fractions.push_back(seconds / times.periodSeconds);
  std::vector<std::optional<PlaneTracker>> trackers(planes.size());
  parallelRanges(static_cast<Eigen::Index>(planes.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    progress.throwIfCancelled();
    trackers[static_cast<std::size_t>(begin)].emplace(planes[static_cast<std::size_t>(begin)], fractions,
                                                      around);
  });
  std::atomic<int> done{0};
  parallelRanges(static_cast<Eigen::Index>(chains.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    CineChain& chain = chains[static_cast<std::size_t>(begin)];
    followChain(*trackers[chain.plane], labelled[chain.source].phase, chain, progress);
    progress.report(static_cast<double>(++done) / static_cast<double>(chains.size()), "following the tissue");
  });
  for (CineChain& chain : chains) {
    CineSegment& segment = segments[chain.segment];
    for (CineContour& contour : chain.contours)
      (chain.ahead ? segment.ahead : segment.against).push_back(std::move(contour));
  }
  for (CineSegment& segment : segments) {
    for (CineContour& contour : segment.ahead)
      close(rig, labelled[segment.to], segment.against, contour);
    for (CineContour& contour : segment.against)
      close(rig, labelled[segment.from], segment.ahead, contour);
  }
  return segments;
}

} // namespace viscera::tracking
