#include "viscera/strain/heart_strain.h"

namespace viscera::strain {

ContourStrain contourStrain(const std::string& name, const MaterialContour& contour,
                            const std::vector<Points>& phases, const std::vector<double>& seconds,
                            std::size_t reference) {
  std::vector<double> lengths;
  for (const Points& phase : phases)
    lengths.push_back(contour.lengthAt(phase));
  ContourStrain strain{name, lengths[reference], changeFrom(lengths, reference), {}};
  strain.peak = shortestOf(strain.curve, seconds);
  return strain;
}

} // namespace viscera::strain
