#include "tetra_surfaces.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace viscera::scene {
namespace {

/// Opposite each corner, outward for a tetrahedron of positive volume.
constexpr int kOpposite[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

bool isPositive(const Tetrahedra& tetrahedra, const Points& points, Eigen::Index t) {
  const Vec3 origin = points.row(tetrahedra(t, 0));
  const Vec3 a = points.row(tetrahedra(t, 1)).transpose() - origin;
  const Vec3 b = points.row(tetrahedra(t, 2)).transpose() - origin;
  const Vec3 c = points.row(tetrahedra(t, 3)).transpose() - origin;
  return a.cross(b).dot(c) > 0;
}

/// A face of one tetrahedron with its corners ascending, to find the other one's.
struct HalfFace {
  std::array<std::int32_t, 3> sorted{};
  TetraFace face;
};

struct CutCorner {
  Vec3 at = Vec3::Zero();
  double value = 0;
};

/// Where the plane crosses an edge, for distances of opposite signs.
CutCorner crossing(const Points& at, const Values* numbers, const std::vector<double>& side, std::int32_t a,
                   std::int32_t b) {
  const double da = side[static_cast<std::size_t>(a)], db = side[static_cast<std::size_t>(b)];
  // d_a + t (d_b - d_a) = 0.
  const double part = da / (da - db);
  CutCorner corner;
  corner.at = (1 - part) * at.row(a).transpose() + part * at.row(b).transpose();
  if (numbers)
    corner.value = (1 - part) * (*numbers)[a] + part * (*numbers)[b];
  return corner;
}

} // namespace

std::vector<TetraFace> tetraFaces(const Tetrahedra& tetrahedra, const Points& points) {
  // Faces are thrown into one bucket for each lowest corner: sorting those few is faster than sorting all.
  std::vector<std::size_t> begins(static_cast<std::size_t>(points.rows()) + 1, 0);
  std::vector<HalfFace> halves(static_cast<std::size_t>(4 * tetrahedra.rows()));
  for (const bool counting : {true, false}) {
    for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t) {
      const bool positive = counting || isPositive(tetrahedra, points, t);
      for (const auto& corners : kOpposite) {
        HalfFace half;
        for (int c = 0; c < 3; ++c)
          half.face.corners[std::size_t(c)] = tetrahedra(t, corners[positive ? c : 2 - c]);
        half.sorted = half.face.corners;
        std::sort(half.sorted.begin(), half.sorted.end());
        half.face.first = static_cast<std::int32_t>(t);
        const auto bucket = static_cast<std::size_t>(half.sorted[0]);
        if (counting)
          ++begins[bucket + 1];
        else
          halves[begins[bucket]++] = half;
      }
    }
    if (counting)
      for (std::size_t i = 1; i < begins.size(); ++i)
        begins[i] += begins[i - 1];
  }
  // Filling has moved each begin to the next bucket's.
  std::vector<TetraFace> faces;
  faces.reserve(halves.size() / 2 + halves.size() / 16);
  std::size_t begin = 0;
  for (std::size_t bucket = 0; bucket + 1 < begins.size(); ++bucket) {
    const std::size_t end = begins[bucket];
    const auto from = halves.begin() + static_cast<std::ptrdiff_t>(begin);
    std::stable_sort(from, halves.begin() + static_cast<std::ptrdiff_t>(end),
                     [](const HalfFace& a, const HalfFace& b) { return a.sorted < b.sorted; });
    for (; begin < end; ++begin) {
      TetraFace face = halves[begin].face;
      if (begin + 1 < end && halves[begin + 1].sorted == halves[begin].sorted)
        face.second = halves[++begin].face.first;
      faces.push_back(face);
    }
  }
  return faces;
}

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
