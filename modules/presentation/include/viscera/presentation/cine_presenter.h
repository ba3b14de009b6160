#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/geometry/plane_cut.h"
#include "viscera/presentation/slice_presenter.h"

namespace viscera::presentation {

/// A place on an organ's contour in a pane.
struct ContourPlace {
  document::OrganId organ;
  Vec3 place = Vec3::Zero(); ///< mm.
};

/// A contour that is being bent by hand, in one pane.
struct BentContour {
  int direction = 0;
  document::OrganId organ;
  Points points; ///< `n x 3` mm.
  bool closed = false;
};

/// Draws slices of a document's cine study in their own planes: grey levels of the phase that belongs to the
/// view's fraction of the cycle, contours of the organs as they are posed and at rest, and where the planes
/// of the other panes cut, handles near each plane and distances and angles in it. As `SlicePresenter`, it
/// updates only what differs. The `direction` of a pane is its place, 0 to 2. Nothing is drawn where nothing
/// was measured: beside a picture, and in a phase whose picture is missing. For one thread.
class CinePresenter {
public:
  explicit CinePresenter(Threads threads = {}, SlicePresenter::Translate translate = {});
  ~CinePresenter();
  CinePresenter(const CinePresenter&) = delete;
  CinePresenter& operator=(const CinePresenter&) = delete;
  /// Sets the decimal mark of numbers, a point by default. Call it before `update`.
  void setDecimalMark(char mark);

  /// Updates the pictures of these panes; at most one for each direction. Throws `UsageError` without a study
  /// in the document.
  void update(const SliceScene& scene, const std::vector<SlicePane>& panes);

  /// The functions below require a direction that was among the panes.
  const scene::SlicePicture& picture(int direction) const;
  const medical_io::SliceFrame& frame(int direction) const;
  /// The slice of the study, and the phase that is shown; none when its picture is missing.
  std::size_t slice(int direction) const;
  std::optional<std::size_t> phase(int direction) const;
  /// The value and the organ at a pixel (whole numbers are centres, from the lower left).
  SliceReading read(int direction, const Eigen::Vector2d& pixel) const;
  /// The contour nearest to a pixel, at most `reach` pixels away; none where there is none.
  std::optional<ContourPlace> contourAt(int direction, const Eigen::Vector2d& pixel, double reach) const;
  /// An organ's cut by the pane's plane; without lines for an organ that it does not meet.
  geometry::PlaneCut cut(int direction, document::OrganId organ) const;
  /// Sets the contour that is being bent, which is drawn from the next update on over the organ's own, thin
  /// one; none: no contour.
  void setBent(std::optional<BentContour> bent);
  /// The same as `SlicePresenter` gives: the row of the nearest handle within `reach` pixels, or -1; and the
  /// nearest point of a measurement that lies on no organ.
  int handleAt(int direction, const Eigen::Vector2d& pixel, double reach) const;
  std::optional<scene::MeasurementGlyphs::Mark> measuredAt(int direction, const Eigen::Vector2d& pixel,
                                                           double reach) const;
  /// The contours of the organs that the slice meets.
  std::vector<ContourFigure> contours(int direction) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Level and width for a study: the view's, else `proposed`.
medical_io::ValueWindow windowOf(const ScanLook& look, const medical_io::ValueWindow& proposed);

} // namespace viscera::presentation
