#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// A binary tree over items in space. Every branch has a `Summary` of its items, such as the box around them,
/// and is halved at the median across the longest side of a box, so that the tree is as deep as the logarithm
/// of the number of items. The caller keeps the items and says what a summary is. Immutable once made; may be
/// searched from several threads.
///
///     const MedianTree<Bounds> tree(count, 4, boxAround, comesFirst);
///     const auto searchItems = [&](int begin, int end) { compare(tree.order(), begin, end); };
///     tree.searchNearestFirst(distanceToBox, isFartherThanTheBest, searchItems);
template <class Summary>
class MedianTree {
public:
  /// A tree without items.
  MedianTree() = default;

  /// Halves branches of more than `leafSize` of `count` items. `summarise(std::span<const int> items, Vec3&
  /// sides)` returns the summary of some items and writes the sides of the box that is halved across its
  /// longest one; `before(int a, int b, Eigen::Index axis)` compares items along an axis. O(n log n) calls of
  /// `before`, n summaries of O(log n) items in all.
  template <class Summarise, class Before>
  MedianTree(int count, int leafSize, const Summarise& summarise, const Before& before)
      : order_(static_cast<std::size_t>(count)) {
    std::iota(order_.begin(), order_.end(), 0);
    if (count > 0)
      grow(0, count, leafSize, summarise, before);
  }

  bool empty() const { return branches_.empty(); }
  /// The items in the order of the leaves: a leaf has those from `begin` to before `end`.
  const std::vector<int>& order() const { return order_; }

  /// Visits branches from the root, first children first: `enter(summary)` says whether the items of a branch
  /// are wanted one by one; then its leaves come to `leaf(int begin, int end)`, places in `order`.
  template <class Enter, class Leaf>
  void walk(const Enter& enter, const Leaf& leaf) const {
    if (empty())
      return;
    std::array<int, kDeepest> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const int index = waiting[--count];
      const Branch& branch = branches_[static_cast<std::size_t>(index)];
      if (!enter(branch.summary))
        continue;
      if (branch.second == 0) {
        leaf(branch.begin, branch.end);
        continue;
      }
      waiting[count++] = branch.second;
      waiting[count++] = index + 1;
    }
  }

  /// Visits branches from the root, of two children the one for which `distance(summary)` is less first, the
  /// first one where they are equal: what it finds rules out more of the other. A branch is left out where
  /// `skip(summary, distance)` says so when its turn comes; leaves come to `leaf(int begin, int end)`.
  template <class Distance, class Skip, class Leaf>
  void searchNearestFirst(const Distance& distance, const Skip& skip, const Leaf& leaf) const {
    if (empty())
      return;
    using Visit = std::pair<int, double>;
    const auto visitTo = [&](int index) {
      return Visit{index, distance(branches_[static_cast<std::size_t>(index)].summary)};
    };
    std::array<Visit, kDeepest> waiting;
    std::size_t count = 0;
    waiting[count++] = visitTo(0);
    while (count > 0) {
      const auto [index, away] = waiting[--count];
      const Branch& branch = branches_[static_cast<std::size_t>(index)];
      if (skip(branch.summary, away))
        continue;
      if (branch.second == 0) {
        leaf(branch.begin, branch.end);
        continue;
      }
      Visit near = visitTo(index + 1), far = visitTo(branch.second);
      if (far.second < near.second)
        std::swap(near, far);
      waiting[count++] = far;
      waiting[count++] = near;
    }
  }

private:
  /// Halving 2^31 items down to one takes fewer levels, and each level leaves one branch waiting.
  static constexpr std::size_t kDeepest = 64;

  struct Branch {
    Summary summary;
    int begin = 0, end = 0; ///< In `order_`.
    int second = 0;         ///< The second child; the first follows its parent. 0 for a leaf.
  };

  template <class Summarise, class Before>
  int grow(int begin, int end, int leafSize, const Summarise& summarise, const Before& before) {
    const int index = static_cast<int>(branches_.size());
    const auto first = order_.begin() + begin;
    Vec3 sides = Vec3::Zero();
    branches_.push_back(
        {summarise(std::span<const int>(first, static_cast<std::size_t>(end - begin)), sides), begin, end});
    if (end - begin <= leafSize)
      return index;
    Eigen::Index axis = 0;
    sides.maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(first, order_.begin() + middle, order_.begin() + end,
                     [&before, axis](int a, int b) { return before(a, b, axis); });
    grow(begin, middle, leafSize, summarise, before);
    const int second = grow(middle, end, leafSize, summarise, before);
    branches_[static_cast<std::size_t>(index)].second = second;
    return index;
  }

  std::vector<int> order_;
  std::vector<Branch> branches_; ///< The root is the first.
};

} // namespace viscera::geometry
