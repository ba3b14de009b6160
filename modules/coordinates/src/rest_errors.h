#pragma once

#include <limits>
#include <vector>

#include "viscera/coordinates/binding.h"

namespace viscera::coordinates {

/// The largest errors that weights make at rest, and the least weight, of the points added so far. The result
/// does not depend on their order.
struct RestErrors {
  double identity = 0; ///< max |sum a_i v_i - p|, mm.
  double unity = 0;    ///< max |sum a_i - 1|.
  double least = std::numeric_limits<double>::infinity();

  void add(const RestErrors& other);
  /// Adds the points of a tile of weights (`handles x 16`) but for those whose bit in `failed` is set.
  void addTile(const double* weights, const Points& handles, const Points& rest, Eigen::Index tile,
               unsigned failed);

private:
  void add(double identityError, double unityError, double weight);
};

/// Writes the errors of all `ranges` into the report of `points` points, whose failures are known.
void tellErrors(const std::vector<RestErrors>& ranges, Eigen::Index points, BindingReport& report);

} // namespace viscera::coordinates
