#include "dicom/mixed_slices.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "scan_sampling.h"
#include "viscera/core/parallel.h"

namespace viscera::medical_io {
namespace {

template <class Sample>
Sample mixOf(Sample a, Sample b, double part) {
  const double value = (1 - part) * double(a) + part * double(b);
  if constexpr (std::is_floating_point_v<Sample>)
    return static_cast<Sample>(value);
  else
    return static_cast<Sample>(std::llround(value));
}

} // namespace

Scan::Samples mixedSlices(const Scan::Samples& measured, std::size_t slice,
                          const std::vector<SliceMix>& mixes, const std::optional<double>& padding) {
  return std::visit(
      [&]<class Sample>(const std::vector<Sample>& all) -> Scan::Samples {
        const Measured<Sample> isMeasured(padding);
        std::vector<Sample> mixed(slice * mixes.size());
        parallelRanges(
            static_cast<Eigen::Index>(mixes.size()), 1, {}, [&](Eigen::Index begin, Eigen::Index end) {
              for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
                const Sample* below = all.data() + mixes[k].below * slice;
                const double part = mixes[k].above;
                const Sample* above = part > 0 ? below + slice : below;
                const bool nearBelow = part <= 0.5;
                for (std::size_t i = 0; i < slice; ++i) {
                  const Sample near = nearBelow ? below[i] : above[i];
                  const bool both = isMeasured(below[i]) && isMeasured(above[i]);
                  mixed[k * slice + i] = both ? mixOf(below[i], above[i], part) : near;
                }
              }
            });
        return mixed;
      },
      measured);
}

} // namespace viscera::medical_io
