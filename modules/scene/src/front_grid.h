#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "view_geometry.h"

namespace viscera::scene {

/// What is in front, in coarse cells of the display: a line may only end where its organ is seen.
class FrontGrid {
public:
  static constexpr double kNothing = std::numeric_limits<double>::infinity();
  static constexpr double kCell = 16; ///< Logical pixels.
  /// The line of an organ's own label ends at least that part of its size away from its named parts.
  static constexpr double kOffParts = 0.06;

  explicit FrontGrid(const ViewGeometry& view)
      : cell_(kCell * view.pixelRatio), columns_(cellsIn(2 * view.centerX)), rows_(cellsIn(view.pixelHeight)),
        fronts_(columns_ * rows_) {}

  struct Front {
    double depth = kNothing;
    std::size_t owner = 0;
    bool inside = false;
    double offParts = kNothing; ///< How far the place is from its organ's named parts, of the organ's size.
    double x = 0, y = 0;        ///< Where it is.

    bool any() const { return std::isfinite(depth); }
  };

  void add(const DisplayPoint& place, const Front& front) {
    const auto cell = cellOf(place);
    if (cell && front.depth < fronts_[*cell].depth)
      fronts_[*cell] = front;
  }

  const Front& at(std::size_t cell) const { return fronts_[cell]; }

  /// How far away the nearest thing in the place's cell is; infinite where there is none.
  double depthAt(const DisplayPoint& place) const {
    const auto cell = cellOf(place);
    return cell ? fronts_[*cell].depth : kNothing;
  }

  /// Whether the nearest thing in the place's cell was added as an inside.
  bool isInsideAt(const DisplayPoint& place) const {
    const auto cell = cellOf(place);
    return cell && fronts_[*cell].inside;
  }

  std::size_t cells() const { return fronts_.size(); }

  std::array<double, 2> centerOf(std::size_t cell) const {
    return {(static_cast<double>(cell % columns_) + 0.5) * cell_,
            (static_cast<double>(cell / columns_) + 0.5) * cell_};
  }

  /// The neighbours of a cell; none beyond the edges.
  std::array<std::optional<std::size_t>, 4> beside(std::size_t cell) const {
    const auto [x, y] = centerOf(cell);
    return {cellOf({x - cell_, y, 0}), cellOf({x + cell_, y, 0}), cellOf({x, y - cell_, 0}),
            cellOf({x, y + cell_, 0})};
  }

  /// The cell that lies farthest from the named parts of its organ, of those that `counts`; none where all
  /// lie on them.
  template <class Counts>
  std::optional<std::size_t> farthestOffParts(const Counts& counts) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < fronts_.size(); ++i)
      if (fronts_[i].any() && fronts_[i].offParts > kOffParts && counts(i) &&
          (!best || fronts_[i].offParts > fronts_[*best].offParts))
        best = i;
    return best;
  }

  /// The middle of the cells that `counts`, moved into the nearest one of them.
  template <class Counts>
  std::optional<std::array<double, 2>> middleWhere(const Counts& counts) const {
    std::vector<std::array<double, 2>> seen;
    std::array<double, 2> mean{0, 0};
    for (std::size_t i = 0; i < fronts_.size(); ++i) {
      if (!counts(i))
        continue;
      seen.push_back(centerOf(i));
      mean[0] += seen.back()[0];
      mean[1] += seen.back()[1];
    }
    if (seen.empty())
      return std::nullopt;
    for (double& part : mean)
      part /= static_cast<double>(seen.size());
    const auto away = [&](const auto& place) { return std::hypot(place[0] - mean[0], place[1] - mean[1]); };
    const auto nearest = *std::min_element(seen.begin(), seen.end(),
                                           [&](const auto& a, const auto& b) { return away(a) < away(b); });
    return away(nearest) < cell_ ? mean : nearest;
  }

  std::optional<std::size_t> cellOf(const DisplayPoint& place) const {
    if (place.x < 0 || place.y < 0)
      return std::nullopt;
    const auto column = static_cast<std::size_t>(place.x / cell_);
    const auto row = static_cast<std::size_t>(place.y / cell_);
    return column < columns_ && row < rows_ ? std::optional(row * columns_ + column) : std::nullopt;
  }

private:
  std::size_t cellsIn(double pixels) const {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(pixels / cell_)));
  }

  double cell_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<Front> fronts_;
};

} // namespace viscera::scene
