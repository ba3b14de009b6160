#include "viscera/scene/label_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace viscera::scene {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// How finely another height is looked for, pixels.
constexpr double kHeightStep = 4;
/// The heights of a label by which the way to what it names becomes shorter, before the label is broken,
/// changes sides, or stands above or below everything.
constexpr double kForBreaking = 2, kForOtherSide = 5, kForAbove = 10;
/// How often labels are moved because of lines: moving one may open a way for another.
constexpr int kRoundsForLines = 3;

/// Means of runs of numbers, merged until they ascend: the nearest ascending numbers.
std::vector<double> nearestAscending(const std::vector<double>& numbers) {
  struct Run {
    double sum = 0;
    std::size_t count = 0;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Run> runs;
  for (const double number : numbers) {
    runs.push_back({number, 1});
    while (runs.size() > 1 && runs[runs.size() - 2].mean() > runs.back().mean()) {
      runs[runs.size() - 2].sum += runs.back().sum;
      runs[runs.size() - 2].count += runs.back().count;
      runs.pop_back();
    }
  }
  std::vector<double> ascending;
  for (const Run& run : runs)
    ascending.insert(ascending.end(), run.count, run.mean());
  return ascending;
}

/// Whether a line runs through a box.
bool runsThrough(const ScreenPlace& from, const ScreenPlace& to, const ScreenBox& box) {
  double enter = 0, leave = 1; // The part of the line that is inside, of all between 0 and 1.
  const auto clip = [&](double begin, double way, double low, double high) {
    if (way == 0) {
      if (begin <= low || begin >= high)
        leave = -1;
      return;
    }
    const double atLow = (low - begin) / way, atHigh = (high - begin) / way;
    enter = std::max(enter, std::min(atLow, atHigh));
    leave = std::min(leave, std::max(atLow, atHigh));
  };
  clip(from.x, to.x - from.x, box.left, box.right);
  clip(from.y, to.y - from.y, box.bottom, box.top);
  return enter < leave;
}

ScreenBox grown(const ScreenBox& box, double by) {
  return {box.left - by, box.bottom - by, box.right + by, box.top + by};
}

/// Whether the line of a label that is in the box `from` runs through another name, or all but touches it,
/// wherever what it names moves.
bool lineCrosses(const LabelRequest& label, const ScreenBox& from, const ScreenBox& name, double gap) {
  const auto runs = [&](const ScreenPlace& end) {
    return runsThrough(leaderStart(from, end, gap), end, grown(name, gap / 2));
  };
  if (runs(leaderEnd(label, from)))
    return true;
  if (!label.reach)
    return false;
  const ScreenBox& reach = *label.reach;
  return runs({reach.left, reach.bottom}) || runs({reach.left, reach.top}) ||
         runs({reach.right, reach.bottom}) || runs({reach.right, reach.top});
}

/// Looks for places of labels one after the other.
class Placer {
public:
  Placer(const std::vector<LabelRequest>& labels, const Footprint& covered, const LabelSpace& space)
      : labels_(labels), covered_(covered), space_(space), boxes_(labels.size()) {}

  std::vector<std::optional<ScreenBox>> place() {
    const auto extent = covered_.all();
    middle_ = extent ? (extent->left + extent->right) / 2 : space_.width / 2;
    for (const bool left : {true, false}) {
      std::vector<std::size_t> side;
      for (std::size_t i = 0; i < labels_.size(); ++i)
        if (onLeft(i) == left)
          side.push_back(i);
      spread(side);
    }
    keepPlaces();
    for (std::size_t i = 0; i < labels_.size(); ++i)
      if (!boxes_[i])
        boxes_[i] = best(i);
    clearNames();
    leaveOut();
    return boxes_;
  }

private:
  struct Size {
    double width = 0;
    double height = 0;
  };

  bool onLeft(std::size_t label) const { return labels_[label].x < middle_; }

  /// Labels stay where they are as far as they are still free there; they are the last that move.
  void keepPlaces() {
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      const auto& kept = labels_[i].kept;
      if (kept && isInView(*kept) && isFree(*kept, space_.between / 2))
        boxes_[i] = kept;
      else
        order_.push_back(i);
    }
    for (std::size_t i = 0; i < labels_.size(); ++i)
      if (boxes_[i])
        order_.push_back(i);
  }

  /// Labels whose lines run through names, or on which lines of others run, move to the best place where
  /// neither is so; where there is none they stay for now.
  void clearNames() {
    clear_ = true;
    bool moved = true;
    for (int round = 0; moved && round < kRoundsForLines; ++round) {
      moved = false;
      for (const std::size_t i : order_) {
        const auto before = std::exchange(boxes_[i], std::nullopt);
        if (before && !linesAreClear(i, *before))
          boxes_[i] = best(i);
        moved = moved || boxes_[i].has_value();
        if (!boxes_[i])
          boxes_[i] = before;
      }
    }
  }

  /// The later one of two labels that cannot both be there is left out, and has a place where leaving out
  /// others made room.
  void leaveOut() {
    for (std::size_t i = 0; i < labels_.size(); ++i)
      if (const auto box = std::exchange(boxes_[i], std::nullopt); box && linesAreClear(i, *box, i))
        boxes_[i] = box;
    for (std::size_t i = 0; i < labels_.size(); ++i)
      if (!boxes_[i])
        boxes_[i] = best(i);
  }

  /// Whether a label, which has no place yet, can be there so that no line runs through a name, as far as the
  /// first `count` labels are concerned.
  bool linesAreClear(std::size_t label, const ScreenBox& box, std::size_t count) const {
    const double gap = space_.between;
    for (std::size_t i = 0; i < count; ++i)
      if (boxes_[i] && (lineCrosses(labels_[label], box, *boxes_[i], gap) ||
                        lineCrosses(labels_[i], *boxes_[i], box, gap)))
        return false;
    return true;
  }
  bool linesAreClear(std::size_t label, const ScreenBox& box) const {
    return linesAreClear(label, box, boxes_.size());
  }

  /// The place from which the way to what is named is shortest.
  std::optional<ScreenBox> best(std::size_t label) const {
    const LabelRequest& wanted = labels_[label];
    const bool left = onLeft(label);
    std::optional<ScreenBox> found;
    double least = kInfinity;
    const auto tryForm = [&](const Size& size, bool side, double handicap) {
      const auto box = nearest(label, size, side);
      if (!box)
        return;
      const double above = covered_.between(box->bottom, box->top) ? 0 : kForAbove * wanted.height;
      const double way = wayTo(*box, wanted) + handicap + above;
      if (way >= least)
        return;
      found = box;
      least = way;
    };
    for (const bool side : {left, !left}) {
      const double other = side == left ? 0 : kForOtherSide * wanted.height;
      tryForm({wanted.width, wanted.height}, side, other);
      if (wanted.brokenWidth > 0)
        tryForm({wanted.brokenWidth, wanted.brokenHeight}, side, other + kForBreaking * wanted.height);
    }
    return found;
  }

  /// How long the line from the label is.
  static double wayTo(const ScreenBox& box, const LabelRequest& wanted) {
    const ScreenPlace start = leaderStart(box, {wanted.x, wanted.y}, 0);
    return std::hypot(start.x - wanted.x, start.y - wanted.y);
  }

  /// The heights at which the labels of one side do not meet.
  void spread(const std::vector<std::size_t>& side) {
    heights_.resize(labels_.size());
    std::vector<double> centers;
    std::vector<double> sizes;
    for (const std::size_t i : side) {
      heights_[i] = labels_[i].y;
      centers.push_back(labels_[i].y);
      sizes.push_back(labels_[i].height);
    }
    const auto spread =
        spreadApart(centers, sizes, space_.margin, space_.height - space_.margin, space_.between);
    for (std::size_t k = 0; spread && k < side.size(); ++k)
      heights_[side[k]] = (*spread)[k];
  }

  /// The free place on that side whose height is nearest to the wanted one.
  std::optional<ScreenBox> nearest(std::size_t label, const Size& size, bool left) const {
    for (double away = 0; away <= space_.height; away += kHeightStep)
      for (const double y : {heights_[label] + away, heights_[label] - away})
        if (const auto box = at(label, size, y, left))
          return box;
    return std::nullopt;
  }

  std::optional<ScreenBox> at(std::size_t label, const Size& size, double y, bool left) const {
    const LabelRequest& wanted = labels_[label];
    const double bottom = y - size.height / 2;
    const double top = y + size.height / 2;
    if (!isInView({0, bottom, 0, top}))
      return std::nullopt;
    // Level with all of what is covered where there is room, so that labels stand in a column.
    for (const auto& extent : {covered_.all(), covered_.between(bottom, top)}) {
      double x = left ? wanted.x - space_.gap - size.width : wanted.x + space_.gap;
      if (extent)
        x = left ? extent->left - space_.gap - size.width : extent->right + space_.gap;
      else // Above or below everything: as far inside as it has to be.
        x = std::max(space_.margin, std::min(x, space_.width - space_.margin - size.width));
      const ScreenBox box{x, bottom, x + size.width, top};
      if (isFree(box, space_.between) && (!clear_ || linesAreClear(label, box)))
        return box;
    }
    return std::nullopt;
  }

  bool isInView(const ScreenBox& box) const {
    return box.bottom >= space_.margin && box.top <= space_.height - space_.margin;
  }

  bool isFree(const ScreenBox& box, double between) const {
    if (box.left < space_.margin || box.right > space_.width - space_.margin || covered_.touches(box))
      return false;
    const ScreenBox wide = grown(box, between);
    const auto meets = [&](const ScreenBox& other) { return wide.overlaps(other); };
    return std::none_of(space_.reserved.begin(), space_.reserved.end(), meets) &&
           std::none_of(boxes_.begin(), boxes_.end(),
                        [&](const auto& other) { return other && meets(*other); });
  }

  const std::vector<LabelRequest>& labels_;
  const Footprint& covered_;
  const LabelSpace& space_;
  double middle_ = 0;  ///< Of what is covered.
  bool clear_ = false; ///< Only places count where no line runs through a name.
  std::vector<double> heights_;
  std::vector<std::optional<ScreenBox>> boxes_;
  std::vector<std::size_t> order_; ///< In which labels move because of lines.
};

} // namespace

std::optional<std::vector<double>> spreadApart(const std::vector<double>& centers,
                                               const std::vector<double>& sizes, double low, double high,
                                               double gap) {
  const std::size_t count = centers.size();
  if (count == 0)
    return std::vector<double>{};
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return centers[a] < centers[b]; });
  // Each interval is a number without the lengths that lie before it, and the numbers have to ascend.
  std::vector<double> before(count);
  std::vector<double> numbers(count);
  double length = 0;
  for (std::size_t k = 0; k < count; ++k) {
    before[k] = length + sizes[order[k]] / 2;
    numbers[k] = centers[order[k]] - before[k];
    length += sizes[order[k]] + gap;
  }
  const double room = high - low - (length - gap);
  if (room < 0)
    return std::nullopt;
  const std::vector<double> ascending = nearestAscending(numbers);
  std::vector<double> placed(count);
  for (std::size_t k = 0; k < count; ++k)
    placed[order[k]] = std::clamp(ascending[k], low, low + room) + before[k];
  return placed;
}

Footprint::Footprint(double viewHeight, double rowHeight)
    : viewHeight_(viewHeight), rowHeight_(rowHeight),
      rows_(static_cast<std::size_t>(std::ceil(std::max(viewHeight, rowHeight) / rowHeight)),
            Extent{kInfinity, -kInfinity}) {}

std::size_t Footprint::rowOf(double y) const {
  const double row = std::floor(y / rowHeight_);
  return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

void Footprint::cover(double x, double y, double reach) {
  if (y + reach < 0 || y - reach > viewHeight_)
    return;
  for (std::size_t row = rowOf(y - reach); row <= rowOf(y + reach); ++row) {
    rows_[row].left = std::min(rows_[row].left, x - reach);
    rows_[row].right = std::max(rows_[row].right, x + reach);
  }
}

void Footprint::cover(const Footprint& other) {
  for (std::size_t row = 0; row < std::min(rows_.size(), other.rows_.size()); ++row) {
    rows_[row].left = std::min(rows_[row].left, other.rows_[row].left);
    rows_[row].right = std::max(rows_[row].right, other.rows_[row].right);
  }
}

std::optional<Footprint::Extent> Footprint::between(double bottom, double top) const {
  Extent extent{kInfinity, -kInfinity};
  for (std::size_t row = rowOf(bottom); row <= rowOf(top); ++row) {
    extent.left = std::min(extent.left, rows_[row].left);
    extent.right = std::max(extent.right, rows_[row].right);
  }
  if (extent.left > extent.right)
    return std::nullopt;
  return extent;
}

bool Footprint::touches(const ScreenBox& box) const {
  const auto extent = between(box.bottom, box.top);
  return extent && box.left < extent->right && box.right > extent->left;
}

ScreenPlace leaderStart(const ScreenBox& box, const ScreenPlace& named, double gap) {
  const double middle = (box.bottom + box.top) / 2;
  if (named.x > box.right)
    return {box.right + gap, middle};
  if (named.x < box.left)
    return {box.left - gap, middle};
  return {named.x, named.y < middle ? box.bottom - gap : box.top + gap};
}

ScreenPlace leaderEnd(const LabelRequest& label, const ScreenBox& box) {
  const auto level = label.edge ? label.edge->between(box.bottom, box.top) : std::nullopt;
  if (!level)
    return {label.x, label.y};
  return {box.left < label.x ? level->left + label.inside : level->right - label.inside,
          (box.bottom + box.top) / 2};
}

std::vector<std::optional<ScreenBox>> placeLabels(const std::vector<LabelRequest>& labels,
                                                  const Footprint& covered, const LabelSpace& space) {
  return Placer(labels, covered, space).place();
}

bool linesAreClear(const std::vector<LabelRequest>& labels,
                   const std::vector<std::optional<ScreenBox>>& boxes, const LabelSpace& space) {
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < labels.size(); ++j)
      if (i != j && boxes[i] && boxes[j] && lineCrosses(labels[i], *boxes[i], *boxes[j], space.between))
        return false;
  return true;
}

} // namespace viscera::scene
