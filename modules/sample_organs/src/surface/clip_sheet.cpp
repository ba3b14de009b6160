#include "surface/clip_sheet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::sample_organs {
namespace {

using geometry::TriangleMesh;
using Index = SheetParts::Index;

// A point near the rim is moved along an edge to lie on it, by at most this share of the edge, and this many
// mm, so that thin walls stay as they are.
constexpr double kMoved = 0.35;
constexpr double kFarthestMove = 0.4;

class Clip {
public:
  Clip(const TriangleMesh& sheet, std::vector<double> values, Facing facing, SheetParts& parts)
      : sheet_(sheet), points_(sheet.points), values_(std::move(values)), turned_(facing == Facing::inward),
        parts_(parts), kept_(values_.size(), -1) {}

  std::vector<Rim> run() {
    moveOntoRim();
    for (Eigen::Index t = 0; t < sheet_.triangles.rows(); ++t)
      addPart({sheet_.triangles(t, 0), sheet_.triangles(t, turned_ ? 2 : 1),
               sheet_.triangles(t, turned_ ? 1 : 2)});
    return rims();
  }

private:
  double value(Index v) const { return values_[static_cast<std::size_t>(v)]; }

  /// Where, as a share of the way from a to b, the values pass zero.
  double passes(Index a, Index b) const { return value(a) / (value(a) - value(b)); }

  /// Every point from which the values pass zero within a small share of an edge is moved there, along the
  /// edge on which that is nearest.
  void moveOntoRim() {
    struct Move {
      double share = kMoved;
      Index towards = -1;
    };
    std::vector<Move> moves(values_.size());
    for (Eigen::Index t = 0; t < sheet_.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Index a = sheet_.triangles(t, k), b = sheet_.triangles(t, (k + 1) % 3);
        if ((value(a) > 0) == (value(b) > 0))
          continue;
        const double share = passes(a, b);
        const double length = (sheet_.points.row(a) - sheet_.points.row(b)).norm();
        for (const auto& [from, to, part] : {std::tuple(a, b, share), std::tuple(b, a, 1 - share)})
          if (Move& move = moves[static_cast<std::size_t>(from)];
              part < move.share && part * length < kFarthestMove)
            move = {part, to};
      }
    for (std::size_t v = 0; v < moves.size(); ++v)
      if (moves[v].towards >= 0) {
        const auto row = static_cast<Eigen::Index>(v);
        points_.row(row) += moves[v].share * (sheet_.points.row(moves[v].towards) - sheet_.points.row(row));
        values_[v] = 0;
      }
  }

  Vec3 colorOf(Index v) const { return sheet_.colors.row(v).cast<double>().transpose(); }

  Index keptPoint(Index v) {
    Index& name = kept_[static_cast<std::size_t>(v)];
    if (name < 0)
      name = parts_.addPoint(points_.row(v), colorOf(v));
    return name;
  }

  Index cutPoint(Index a, Index b) {
    const auto key = std::minmax(a, b);
    const auto [place, isNew] = cuts_.try_emplace(key, -1);
    if (isNew) {
      const double share = passes(key.first, key.second);
      const Vec3 start = points_.row(key.first), end = points_.row(key.second);
      place->second =
          parts_.addPoint(start + share * (end - start),
                          colorOf(key.first) + share * (colorOf(key.second) - colorOf(key.first)));
    }
    return place->second;
  }

  /// The polygon of a triangle's corners and cuts whose values are not negative; nothing when it has no
  /// positive corner.
  void addPart(const std::array<Index, 3>& corner) {
    if (std::none_of(corner.begin(), corner.end(), [this](Index v) { return value(v) > 0; }))
      return;
    std::array<Index, 4> polygon;
    std::array<bool, 4> onRim;
    std::size_t count = 0;
    const auto add = [&](Index v, bool rim) {
      polygon[count] = v;
      onRim[count++] = rim;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = corner[k], b = corner[(k + 1) % 3];
      if (value(a) >= 0)
        add(keptPoint(a), value(a) == 0);
      if (value(a) * value(b) < 0)
        add(cutPoint(a, b), true);
    }
    for (std::size_t k = 2; k < count; ++k)
      parts_.addTriangle({polygon[0], polygon[k - 1], polygon[k]});
    for (std::size_t k = 0; k < count; ++k)
      if (const std::size_t next = (k + 1) % count; onRim[k] && onRim[next])
        addSide(polygon[k], polygon[next]);
  }

  /// A side between two points on the rim is the rim's, unless another triangle has it too.
  void addSide(Index a, Index b) {
    if (sides_.erase({b, a}) == 0)
      sides_.insert({a, b});
  }

  std::vector<Rim> rims() const {
    std::map<Index, Index> next;
    for (const auto& [from, to] : sides_)
      if (!next.emplace(from, to).second)
        throw DataError("two rims of a surface touch each other", {}, "keep the ends of vessels apart");
    std::vector<Rim> all;
    while (!next.empty()) {
      Rim rim;
      for (auto step = next.begin(); step != next.end(); step = next.find(rim.back())) {
        rim.push_back(step->second);
        next.erase(step);
      }
      all.push_back(std::move(rim));
    }
    return all;
  }

  const TriangleMesh& sheet_;
  Points points_; ///< The sheet's, near the rim moved onto it.
  std::vector<double> values_;
  bool turned_;
  SheetParts& parts_;
  std::vector<Index> kept_; ///< The sheet's points in the result, or -1.
  std::map<std::pair<Index, Index>, Index> cuts_;
  std::set<std::pair<Index, Index>> sides_; ///< Of the rims.
};

} // namespace

SheetParts::Index SheetParts::addPoint(const Vec3& point, const Vec3& color) {
  points_.push_back(point);
  colors_.push_back(color);
  return static_cast<Index>(points_.size()) - 1;
}

TriangleMesh SheetParts::mesh() const {
  TriangleMesh result;
  const auto count = static_cast<Eigen::Index>(points_.size());
  result.points.resize(count, 3);
  result.colors.resize(count, 3);
  for (Eigen::Index v = 0; v < count; ++v) {
    result.points.row(v) = points_[static_cast<std::size_t>(v)].transpose();
    for (int k = 0; k < 3; ++k)
      result.colors(v, k) = static_cast<std::uint8_t>(std::lround(colors_[static_cast<std::size_t>(v)][k]));
  }
  result.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
  for (Eigen::Index t = 0; t < result.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      result.triangles(t, k) = triangles_[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
  return result;
}

std::vector<Rim> clipSheet(const TriangleMesh& sheet, std::vector<double> values, Facing facing,
                           SheetParts& parts) {
  return Clip(sheet, std::move(values), facing, parts).run();
}

} // namespace viscera::sample_organs
