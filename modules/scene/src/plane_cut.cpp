#include "plane_cut.h"

#include <array>
#include <numeric>
#include <utility>

namespace viscera::scene {
namespace {

struct CutCorner {
  Vec3 at = Vec3::Zero();
  double value = 0;
};

/// Where the plane crosses an edge, for distances of opposite signs.
CutCorner crossing(const Points& at, const Values* numbers, const std::vector<double>& side, std::int32_t a,
                   std::int32_t b) {
  const double da = side[static_cast<std::size_t>(a)], db = side[static_cast<std::size_t>(b)];
  const double part = da / (da - db);
  CutCorner corner;
  corner.at = (1 - part) * at.row(a).transpose() + part * at.row(b).transpose();
  if (numbers)
    corner.value = (1 - part) * (*numbers)[a] + part * (*numbers)[b];
  return corner;
}

} // namespace

void PlaneCut::clear() {
  points.clear();
  values.clear();
  corners.clear();
  owners.clear();
}

void PlaneCut::make(const Tetrahedra& tetrahedra, const Points& at, const Values* numbers,
                    const std::vector<char>& shown, const CutPlane& plane) {
  clear();
  side_.resize(static_cast<std::size_t>(at.rows()));
  const double offset = plane.normal.dot(plane.origin);
  for (Eigen::Index i = 0; i < at.rows(); ++i)
    side_[static_cast<std::size_t>(i)] = at.row(i).dot(plane.normal) - offset;
  const auto add = [&](Eigen::Index t, CutCorner a, CutCorner b, const CutCorner& c) {
    if ((b.at - a.at).cross(c.at - a.at).dot(plane.normal) > 0)
      std::swap(a, b);
    for (const CutCorner& corner : {a, b, c}) {
      points.insert(points.end(), corner.at.begin(), corner.at.end());
      if (numbers)
        values.push_back(corner.value);
    }
    owners.push_back(static_cast<std::int32_t>(t));
  };
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t) {
    std::array<std::int32_t, 4> in{}, out{};
    int ins = 0, outs = 0;
    for (int c = 0; c < 4; ++c) {
      const std::int32_t corner = tetrahedra(t, c);
      if (side_[static_cast<std::size_t>(corner)] >= 0)
        in[static_cast<std::size_t>(ins++)] = corner;
      else
        out[static_cast<std::size_t>(outs++)] = corner;
    }
    if (ins == 0 || outs == 0 || (!shown.empty() && shown[static_cast<std::size_t>(t)] == 0))
      continue;
    const auto cross = [&](std::int32_t a, std::int32_t b) { return crossing(at, numbers, side_, a, b); };
    if (ins == 1) {
      add(t, cross(in[0], out[0]), cross(in[0], out[1]), cross(in[0], out[2]));
    } else if (outs == 1) {
      add(t, cross(in[0], out[0]), cross(in[1], out[0]), cross(in[2], out[0]));
    } else {
      const CutCorner a = cross(in[0], out[0]), b = cross(in[0], out[1]);
      const CutCorner c = cross(in[1], out[1]), d = cross(in[1], out[0]);
      add(t, a, b, c);
      add(t, a, c, d);
    }
  }
  corners.resize(3 * owners.size());
  std::iota(corners.begin(), corners.end(), 0);
}

} // namespace viscera::scene
