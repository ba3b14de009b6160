#include "viscera/medical_io/contour.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>

#include "contour_cases.h"
#include "viscera/core/parallel.h"

// Flying edges (Schroeder, Maynard and Geveci 2015, doi 10.1109/LDAV.2015.7348069): points are counted row by
// row first, so that all threads then write to places of their own. Here a row of the grid is a row of bits,
// and 64 cells without the surface cost a few instructions. Points and triangles come in VTK's order, with
// the coordinates in single precision that VTK's filter of the same name gives.
namespace viscera::medical_io {
namespace {

using Word = std::uint64_t;
constexpr int kBits = 64;
constexpr int kEdges = 12;
/// So many take longer than to start another thread.
constexpr Eigen::Index kValuesAtOnce = Eigen::Index{1} << 18U;

/// The edges that a case cuts, one bit each, and its number of triangles.
struct ContourCase {
  std::array<std::uint8_t, 15> edges{};
  int triangles = 0;
  unsigned cut = 0;
};

using ContourCases = std::array<ContourCase, 256>;

ContourCases readContourCases() {
  ContourCases cases;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const std::string_view digits = kContourCases[c];
    cases[c].triangles = static_cast<int>(digits.size() / 3);
    for (std::size_t i = 0; i < digits.size(); ++i) {
      const int edge = digits[i] <= '9' ? digits[i] - '0' : digits[i] - 'a' + 10;
      cases[c].edges[i] = static_cast<std::uint8_t>(edge);
      cases[c].cut |= 1U << static_cast<unsigned>(edge);
    }
  }
  return cases;
}

const ContourCases& contourCases() {
  static const ContourCases kCases = readContourCases();
  return kCases;
}

/// What a row of the grid gives: the points on edges from it along x, y and z, in this order, and the
/// triangles of the cells that begin at it.
struct RowParts {
  Eigen::Index firstPoint = 0, firstTriangle = 0;
  Eigen::Index alongX = 0, alongY = 0, alongZ = 0, triangles = 0;
};

/// Calls `visit(i)` for each bit that is set.
template <class Visit>
void forEachBit(Word word, Eigen::Index first, const Visit& visit) {
  for (; word != 0; word &= word - 1)
    visit(first + std::countr_zero(word));
}

template <class Value>
class Contour {
public:
  Contour(const std::vector<Value>& values, const std::array<int, 3>& size, double level, const Vec3& origin,
          double spacing)
      : values_(values.data()), nx_(size[0]), ny_(size[1]), nz_(size[2]), words_((nx_ + kBits - 1) / kBits),
        level_(level), origin_(origin), spacing_(spacing),
        inside_(static_cast<std::size_t>(words_ * ny_ * nz_)), rows_(static_cast<std::size_t>(ny_ * nz_)) {}

  geometry::TriangleMesh run() {
    forSlices([this](Eigen::Index k) { compare(k); });
    forSlices([this](Eigen::Index k) { count(k); });
    RowParts total;
    for (RowParts& row : rows_) {
      row.firstPoint = total.firstPoint;
      row.firstTriangle = total.firstTriangle;
      total.firstPoint += row.alongX + row.alongY + row.alongZ;
      total.firstTriangle += row.triangles;
    }
    mesh_.points.resize(total.firstPoint, 3);
    mesh_.triangles.resize(total.firstTriangle, 3);
    forSlices([this](Eigen::Index k) { make(k); });
    return std::move(mesh_);
  }

private:
  template <class Function>
  void forSlices(const Function& function) const {
    parallelRanges(nz_, std::max<Eigen::Index>(1, kValuesAtOnce / (nx_ * ny_)), {},
                   [&](Eigen::Index begin, Eigen::Index end) {
                     for (Eigen::Index k = begin; k < end; ++k)
                       function(k);
                   });
  }

  const Word* bitsOf(Eigen::Index j, Eigen::Index k) const { return inside_.data() + words_ * (j + ny_ * k); }
  RowParts& rowAt(Eigen::Index j, Eigen::Index k) { return rows_[static_cast<std::size_t>(j + ny_ * k)]; }

  /// Which values of a slice are inside.
  void compare(Eigen::Index k) {
    for (Eigen::Index j = 0; j < ny_; ++j) {
      const Value* from = values_ + nx_ * (j + ny_ * k);
      Word* bits = inside_.data() + words_ * (j + ny_ * k);
      for (Eigen::Index begin = 0; begin < nx_; begin += kBits, from += kBits) {
        const Eigen::Index count = std::min<Eigen::Index>(kBits, nx_ - begin);
        Word word = 0;
        for (Eigen::Index b = 0; b < count; ++b)
          word |= static_cast<Word>(from[b] >= level_) << b;
        *bits++ = word;
      }
    }
  }

  /// The bits of the next places along x.
  Word shifted(const Word* bits, Eigen::Index w) const {
    return bits[w] >> 1U | (w + 1 < words_ ? bits[w + 1] << (kBits - 1) : 0);
  }

  /// The places of a word that begin an edge along x.
  Word edgesIn(Eigen::Index w) const {
    const Eigen::Index left = nx_ - 1 - w * kBits;
    return left >= kBits ? ~Word{0} : (Word{1} << left) - 1;
  }

  /// Four rows around a row of cells, a word of them.
  struct Corners {
    std::array<Word, 4> low, high; ///< Of each row: the corners at the cells' beginnings and ends.
    Word cut = 0;                  ///< The cells with the surface.

    unsigned caseAt(int bit) const {
      unsigned number = 0;
      for (unsigned r = 0; r < 4; ++r)
        number |= static_cast<unsigned>(low[r] >> bit & 1U) << (2 * r) |
                  static_cast<unsigned>(high[r] >> bit & 1U) << (2 * r + 1);
      return number;
    }
  };

  Corners cornersOf(Eigen::Index j, Eigen::Index k, Eigen::Index w) const {
    Corners corners;
    Word any = 0, all = ~Word{0};
    for (unsigned r = 0; r < 4; ++r) {
      const Word* bits = bitsOf(j + (r & 1U), k + (r >> 1U));
      corners.low[r] = bits[w];
      corners.high[r] = shifted(bits, w);
      any |= corners.low[r] | corners.high[r];
      all &= corners.low[r] & corners.high[r];
    }
    corners.cut = any & ~all & edgesIn(w);
    return corners;
  }

  Word cutAlongX(Eigen::Index j, Eigen::Index k, Eigen::Index w) const {
    const Word* bits = bitsOf(j, k);
    return (bits[w] ^ shifted(bits, w)) & edgesIn(w);
  }
  Word cutAlongY(Eigen::Index j, Eigen::Index k, Eigen::Index w) const {
    return j + 1 < ny_ ? bitsOf(j, k)[w] ^ bitsOf(j + 1, k)[w] : 0;
  }
  Word cutAlongZ(Eigen::Index j, Eigen::Index k, Eigen::Index w) const {
    return k + 1 < nz_ ? bitsOf(j, k)[w] ^ bitsOf(j, k + 1)[w] : 0;
  }

  bool beginsCells(Eigen::Index j, Eigen::Index k) const { return j + 1 < ny_ && k + 1 < nz_; }

  void count(Eigen::Index k) {
    for (Eigen::Index j = 0; j < ny_; ++j) {
      RowParts& row = rowAt(j, k);
      for (Eigen::Index w = 0; w < words_; ++w) {
        row.alongX += std::popcount(cutAlongX(j, k, w));
        row.alongY += std::popcount(cutAlongY(j, k, w));
        row.alongZ += std::popcount(cutAlongZ(j, k, w));
        if (!beginsCells(j, k))
          continue;
        const Corners corners = cornersOf(j, k, w);
        forEachBit(corners.cut, 0, [&](Eigen::Index bit) {
          row.triangles += cases_[corners.caseAt(static_cast<int>(bit))].triangles;
        });
      }
    }
  }

  void make(Eigen::Index k) {
    for (Eigen::Index j = 0; j < ny_; ++j) {
      makePoints(j, k);
      if (beginsCells(j, k) && rowAt(j, k).triangles > 0)
        makeTriangles(j, k);
    }
  }

  void makePoints(Eigen::Index j, Eigen::Index k) {
    Eigen::Index next = rowAt(j, k).firstPoint;
    for (Eigen::Index w = 0; w < words_; ++w)
      forEachBit(cutAlongX(j, k, w), w * kBits, [&](Eigen::Index i) { makePoint(next++, {i, j, k}, 0); });
    for (Eigen::Index w = 0; w < words_; ++w)
      forEachBit(cutAlongY(j, k, w), w * kBits, [&](Eigen::Index i) { makePoint(next++, {i, j, k}, 1); });
    for (Eigen::Index w = 0; w < words_; ++w)
      forEachBit(cutAlongZ(j, k, w), w * kBits, [&](Eigen::Index i) { makePoint(next++, {i, j, k}, 2); });
  }

  /// The point on the edge from `place` along an axis.
  void makePoint(Eigen::Index point, const std::array<Eigen::Index, 3>& place, std::size_t axis) {
    const std::array<Eigen::Index, 3> steps = {1, nx_, nx_ * ny_};
    const Value* value = values_ + place[0] + place[1] * steps[1] + place[2] * steps[2];
    const double along = (level_ - *value) / (value[steps[axis]] - *value);
    for (std::size_t a = 0; a < 3; ++a) {
      const double at = static_cast<double>(place[a]) + (a == axis ? along : 0.0);
      const auto column = static_cast<Eigen::Index>(a);
      mesh_.points(point, column) =
          static_cast<float>(static_cast<double>(static_cast<float>(at)) * spacing_ + origin_[column]);
    }
  }

  /// The points of the first cell's edges, where the surface cuts these.
  std::array<Eigen::Index, kEdges> firstPoints(Eigen::Index j, Eigen::Index k) {
    const RowParts &here = rowAt(j, k), &ahead = rowAt(j + 1, k), &above = rowAt(j, k + 1);
    const Eigen::Index y = here.firstPoint + here.alongX, yAbove = above.firstPoint + above.alongX;
    const Eigen::Index z = y + here.alongY, zAhead = ahead.firstPoint + ahead.alongX + ahead.alongY;
    return {here.firstPoint,
            ahead.firstPoint,
            above.firstPoint,
            rowAt(j + 1, k + 1).firstPoint,
            y,
            y,
            yAbove,
            yAbove,
            z,
            z,
            zAhead,
            zAhead};
  }

  void makeTriangles(Eigen::Index j, Eigen::Index k) {
    std::array<Eigen::Index, kEdges> points = firstPoints(j, k);
    std::int32_t* corner = mesh_.triangles.row(rowAt(j, k).firstTriangle).data();
    for (Eigen::Index w = 0; w < words_; ++w) {
      const Corners corners = cornersOf(j, k, w);
      forEachBit(corners.cut, 0, [&](Eigen::Index bit) {
        const ContourCase& cell = cases_[corners.caseAt(static_cast<int>(bit))];
        const auto cuts = [&](std::size_t edge) { return static_cast<Eigen::Index>(cell.cut >> edge & 1U); };
        // An edge along y or z at a cell's end comes behind the one at its beginning.
        for (std::size_t edge = 4; edge < kEdges; edge += 2)
          points[edge + 1] = points[edge] + cuts(edge);
        for (std::size_t c = 0; c < 3 * static_cast<std::size_t>(cell.triangles); ++c)
          *corner++ = static_cast<std::int32_t>(points[cell.edges[c]]);
        for (std::size_t edge = 0; edge < kEdges; edge += edge < 4 ? 1 : 2)
          points[edge] += cuts(edge);
      });
    }
  }

  const Value* values_;
  Eigen::Index nx_, ny_, nz_, words_;
  double level_;
  Vec3 origin_;
  double spacing_;
  std::vector<Word> inside_; ///< A bit a value: whether it is at least the level. Rows begin at whole words.
  std::vector<RowParts> rows_;
  const ContourCases& cases_ = contourCases();
  geometry::TriangleMesh mesh_;
};

} // namespace

template <class Value>
geometry::TriangleMesh contourOf(const std::vector<Value>& values, const std::array<int, 3>& size,
                                 double level, const Vec3& origin, double spacing) {
  assert(values.size() == std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]));
  if (*std::min_element(size.begin(), size.end()) < 2)
    return {};
  return Contour(values, size, level, origin, spacing).run();
}

template geometry::TriangleMesh contourOf(const std::vector<float>&, const std::array<int, 3>&, double,
                                          const Vec3&, double);
template geometry::TriangleMesh contourOf(const std::vector<unsigned char>&, const std::array<int, 3>&,
                                          double, const Vec3&, double);

} // namespace viscera::medical_io
