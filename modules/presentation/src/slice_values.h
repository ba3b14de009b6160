#pragma once

#include "viscera/presentation/slice_presenter.h"

namespace viscera::presentation {

/// The values of a slice of the scan, at rest or deformed by a pose, and their grey levels.
class SliceValues {
public:
  /// Samples the scan; with `warping`, which may be null, at the place where the tissue at each pixel was at
  /// rest.
  void take(const medical_io::Scan& scan, const medical_io::SliceFrame& frame,
            const medical_io::SampleOptions& options, const Warping* warping);
  void clear();
  /// Places where the pose folds the tissue are hatched: what is between the lines is an estimate.
  void shade(const medical_io::ValueWindow& window, std::vector<std::uint8_t>& grey, Threads threads) const;

  /// The value at a pixel; none outside of the scan and of the slice.
  std::optional<double> at(long x, long y) const;
  bool foldedAt(long x, long y) const;
  /// Whether any pixel is hatched.
  bool anyFolded() const { return !hatched_.empty(); }

private:
  void findHatched(std::size_t width);
  std::optional<std::size_t> indexOf(long x, long y) const;

  medical_io::ValueImage values_;
  deformation::RestPoints rest_;      ///< Without states when nothing is warped.
  std::vector<std::uint8_t> hatched_; ///< One a pixel; empty when none is.
};

} // namespace viscera::presentation
