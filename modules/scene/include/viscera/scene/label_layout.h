#pragma once

#include <cstddef>
#include <optional>
#include <vector>

/// Places labels along a line so that none overlaps another.
namespace viscera::scene {

/// Moves intervals apart until none overlaps, all lie in `[low, high]`, and together they are as near to
/// where they want to be as can be (least squares). `centers` is where each wants its middle, `sizes` its
/// length; neighbours are `gap` apart at least. Their order is that of the centres. Empty when they do not
/// fit. O(n log n).
std::optional<std::vector<double>> spreadApart(const std::vector<double>& centers,
                                               const std::vector<double>& sizes, double low, double high,
                                               double gap);

/// An upright rectangle on the display, in pixels from the lower left corner.
struct ScreenBox {
  double left = 0;
  double bottom = 0;
  double right = 0;
  double top = 0;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
  bool overlaps(const ScreenBox& other) const {
    return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
  }
};

/// The part of a view that organs cover, as the farthest covered places to the left and to the right in each
/// row of pixels; labels are placed outside of it.
class Footprint {
public:
  /// An uncovered view; a row is `rowHeight` pixels.
  Footprint(double viewHeight, double rowHeight = 4);

  /// Covers a square of half side `reach` about a place.
  void cover(double x, double y, double reach);
  /// Covers what another one of the same view covers.
  void cover(const Footprint& other);

  /// The leftmost and the rightmost covered place between two heights; empty when nothing is covered there.
  struct Extent {
    double left = 0;
    double right = 0;
  };
  std::optional<Extent> between(double bottom, double top) const;
  std::optional<Extent> all() const { return between(0, viewHeight_); }
  /// Whether anything between the leftmost and the rightmost covered place of the rows is in the box.
  bool touches(const ScreenBox& box) const;

private:
  std::size_t rowOf(double y) const;

  double viewHeight_;
  double rowHeight_;
  std::vector<Extent> rows_; ///< Left is larger than right where nothing is covered.
};

/// The size of a label and the place that it names, for the layout of labels.
struct LabelRequest {
  double x = 0; ///< What it names, pixels.
  double y = 0;
  double width = 0; ///< Of the label.
  double height = 0;
  double brokenWidth = 0; ///< Of the same label in two lines; 0: it has only one.
  double brokenHeight = 0;
  /// Level with the label the line ends `inside` the edge of this, where it covers that height; null: always
  /// at (x, y).
  const Footprint* edge = nullptr;
  double inside = 0;
  std::optional<ScreenBox> reach = {}; ///< Of what it names, while that moves; nothing: it stays at (x, y).
  std::optional<ScreenBox> kept = {};  ///< The label stays there where it can.
};

/// The space in a view that labels may take.
struct LabelSpace {
  double width = 0; ///< Of the view, pixels.
  double height = 0;
  double margin = 12;              ///< Kept free along the edges.
  double gap = 14;                 ///< Between a label and what is covered.
  double between = 4;              ///< Between labels.
  std::vector<ScreenBox> reserved; ///< Where something else is written.
};

/// A place on the display, in pixels.
struct ScreenPlace {
  double x = 0;
  double y = 0;
};

/// The start of the line from a label to the place that it names: `gap` beside the box, at half its height;
/// above or below it where the named place is above or below it.
ScreenPlace leaderStart(const ScreenBox& box, const ScreenPlace& named, double gap);

/// The end of the line from a label that is in this box.
ScreenPlace leaderEnd(const LabelRequest& label, const ScreenBox& box);

/// Places labels to the left and to the right of what is covered, each as level with what it names as there
/// is room; in two lines (the box has that size), or on the other side, where that is much nearer to it, as
/// it is in a narrow view. No two overlap, none touches what is covered or reserved, all lie inside the view,
/// and no line runs through another name; one for which there is no such place is left out (empty). Earlier
/// labels go first, and those that are kept before all others. O(labels^2 x height).
std::vector<std::optional<ScreenBox>> placeLabels(const std::vector<LabelRequest>& labels,
                                                  const Footprint& covered, const LabelSpace& space);

/// Whether no line of labels that are in these boxes runs through another name. O(labels^2).
bool linesAreClear(const std::vector<LabelRequest>& labels,
                   const std::vector<std::optional<ScreenBox>>& boxes, const LabelSpace& space);

} // namespace viscera::scene
