#pragma once

#include <cstddef>
#include <vector>

namespace viscera::motion {

/// One number over a cycle, filled in as its instants are seen, in whatever order: what a monitor beside a
/// bed draws. An instant that is seen again takes the place of what was there. For one thread.
class CycleTrace {
public:
  /// `slots` instants of the cycle are told apart.
  explicit CycleTrace(std::size_t slots = 160);

  /// `fraction` of the cycle in [0, 1].
  void add(double fraction, double value);
  void clear();

  /// The instants that were seen, ascending, and the number at each.
  std::vector<double> fractions() const;
  std::vector<double> values() const;
  std::size_t seen() const { return seen_; }

private:
  struct Slot {
    bool filled = false;
    double fraction = 0;
    double value = 0;
  };
  std::vector<Slot> slots_;
  std::size_t seen_ = 0;
};

} // namespace viscera::motion
