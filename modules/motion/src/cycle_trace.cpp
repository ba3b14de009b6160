#include "viscera/motion/cycle_trace.h"

#include <algorithm>
#include <cassert>

namespace viscera::motion {

CycleTrace::CycleTrace(std::size_t slots) : slots_(slots) {
  assert(slots > 0);
}

void CycleTrace::add(double fraction, double value) {
  assert(fraction >= 0 && fraction <= 1);
  const auto count = static_cast<double>(slots_.size());
  const auto place = std::min(static_cast<std::size_t>(fraction * count), slots_.size() - 1);
  seen_ += slots_[place].filled ? 0 : 1;
  slots_[place] = {true, fraction, value};
}

void CycleTrace::clear() {
  std::fill(slots_.begin(), slots_.end(), Slot{});
  seen_ = 0;
}

std::vector<double> CycleTrace::fractions() const {
  std::vector<double> list;
  for (const Slot& slot : slots_)
    if (slot.filled)
      list.push_back(slot.fraction);
  return list;
}

std::vector<double> CycleTrace::values() const {
  std::vector<double> list;
  for (const Slot& slot : slots_)
    if (slot.filled)
      list.push_back(slot.value);
  return list;
}

} // namespace viscera::motion
