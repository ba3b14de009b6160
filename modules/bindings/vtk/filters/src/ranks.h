#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "viscera/core/exact_sum.h"

class vtkMultiProcessController;

namespace viscera::vtk_filters {

/// Communication between the processes of one run. Every member but `count` and `first` is collective: all
/// ranks call it, in the same order, or none does. Without a controller there is one rank.
class Ranks {
public:
  explicit Ranks(vtkMultiProcessController* controller) : controller_(controller) {}

  int count() const;
  bool first() const;

  /// Runs the local work of each rank. When it throws on one of them, all throw a `DataError` with that
  /// rank's message, so that no rank waits in the next collective call.
  void together(const std::function<void()>& part) const;

  /// The numbers of all ranks, a vector for each.
  std::vector<std::vector<double>> gather(std::vector<double> mine) const;

  /// Sums over the ranks, in place, exactly.
  void add(std::vector<ExactSum*> sums) const;
  void add(std::int64_t& count) const;

  double largest(double value) const;

private:
  std::vector<std::string> gatherTexts(const std::string& mine) const;

  vtkMultiProcessController* controller_;
};

} // namespace viscera::vtk_filters
