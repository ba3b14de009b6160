#include "tetra_faces.h"

#include <algorithm>
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

} // namespace viscera::scene
