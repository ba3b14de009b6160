#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace viscera {

/// A union-find structure: groups the numbers 0 to count - 1 that are joined, directly or through others. A
/// group's root is its smallest member, whatever the order of joining. Almost constant time a call (path
/// halving); no thread safety.
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t one = root(a), other = root(b);
    parent_[std::max(one, other)] = std::min(one, other);
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace viscera
