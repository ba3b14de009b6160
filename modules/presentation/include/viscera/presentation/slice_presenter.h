#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/deformation/inverse_map.h"
#include "viscera/document/document.h"
#include "viscera/document/measured_values.h"
#include "viscera/document/scan_item.h"
#include "viscera/live/live_warp.h"
#include "viscera/live/posed_organs.h"
#include "viscera/medical_io/sample_slice.h"
#include "viscera/presentation/view_state.h"
#include "viscera/scene/measurement_glyphs.h"
#include "viscera/scene/slice_view.h"

namespace viscera::presentation {

/// The inverse deformation with which the scan is deformed on slices.
struct Warping {
  /// Finds the places at rest, mm LPS, of the samples of a plane in the pose; NaN where there is no answer.
  std::function<void(const deformation::SamplePlane& plane, deformation::RestPoints& rest)> rest;
  std::uint64_t revision = 0; ///< A number that changes whenever `rest` returns other places.
  /// The reverse of `rest` for one place: where the tissue that is there at rest is drawn.
  document::TissueMotion posed = {};
};

/// The inverse deformation of the open document in the displayed pose; none at rest and while it is being
/// bound. Valid until the pose changes; `warp` has to live as long.
std::optional<Warping> warpingOf(live::LiveWarp& warp);
struct PendingMeasurement;

/// The direction and the size in pixels of a slice to be drawn.
struct SlicePane {
  int direction = 0; ///< Of `medical_io::sliceDirections`.
  int width = 0;     ///< Device pixels, at least 1.
  int height = 0;    ///< Device pixels, at least 1.
};

/// Everything that slices show: document, organs, view state. Only read while they are made.
struct SliceScene {
  const document::DocumentState& state;
  const live::PosedOrgans& organs;
  const ViewState& view;
  const Warping* warping = nullptr; ///< Used if the view deforms the scan by the pose; null: that is not
                                    ///< possible.
  const PendingMeasurement* measuring = nullptr; ///< The measurement under way (presenter.h).
  int activeHandle = -1;                         ///< The row of the handle under the mouse or being dragged.
};

/// The scan's value and the organ at a place of a slice.
struct SliceReading {
  Vec3 position = Vec3::Zero(); ///< mm LPS.
  std::optional<double> value;  ///< Value of the scan as displayed; none outside of the scan.
  bool folded = false;          ///< The pose folds the tissue here: the value is an estimate.
  document::OrganId organ;      ///< The innermost organ around the place; none outside of all.
};

/// The contour of one organ on a slice.
struct ContourFigure {
  document::OrganId organ;
  std::string name;
  Eigen::Index points = 0;
  double lengthMm = 0;
};

/// Draws slices of a document: the scan's grey levels, the contours of its organs as they are posed and at
/// rest, handles near it, what is measured in it, crosshair and letters. The window and the command line each
/// have one. Like `Presenter`, it compares with the last scene, updates only what differs, and does not
/// change the document. For one thread.
///
///     SlicePresenter slices;
///     slices.update({document.state(), live, viewState}, {{0, width, height}});
///     view.show(slices.picture(0));
class SlicePresenter {
public:
  using Translate = std::function<std::string(const char* text)>;

  explicit SlicePresenter(Threads threads = {}, Translate translate = {});
  ~SlicePresenter();
  SlicePresenter(const SlicePresenter&) = delete;
  SlicePresenter& operator=(const SlicePresenter&) = delete;
  /// Sets the decimal mark of numbers, a point by default: ',' in German. Call it before `update`.
  void setDecimalMark(char mark);

  /// Updates the pictures of these panes; at most one pane for each direction.
  void update(const SliceScene& scene, const std::vector<SlicePane>& panes);

  /// The functions below require a direction that was among the panes.
  const scene::SlicePicture& picture(int direction) const;
  const medical_io::SliceFrame& frame(int direction) const;
  /// The scan's value and the organ at a pixel (whole numbers are centres, from the lower left).
  SliceReading read(int direction, const Eigen::Vector2d& pixel) const;
  /// The row of the nearest handle within `reach` pixels; or -1.
  int handleAt(int direction, const Eigen::Vector2d& pixel, double reach) const;
  /// The same for points of measurements that lie on no organ; items are in the document's order.
  std::optional<scene::MeasurementGlyphs::Mark> measuredAt(int direction, const Eigen::Vector2d& pixel,
                                                           double reach) const;
  /// The contours of the organs that the slice meets.
  std::vector<ContourFigure> contours(int direction) const;
  /// The organ's cut, for measurements; null when the organ is not visible.
  const geometry::PlaneCut* cut(int direction, document::OrganId organ) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The bounding box of everything that slices show: the scan's, else that of the organs at rest; a box of 200
/// mm without either.
Bounds boxOfSlices(const document::DocumentState& state);

/// The point in which the three slices meet: the view's, else the middle of the box.
Vec3 focusOf(const document::DocumentState& state, const ScanLook& look);

/// How far the voxels of the scan are apart along an axis of the patient (x, y, z as 0, 1, 2), or slices
/// without a scan, mm.
double stepAlong(const document::DocumentState& state, int axis);

/// "S 120.0 mm": how far a place lies along a slice's axis, by the letter of its side.
std::string formatSlicePosition(int axis, double mm, char decimalMark = '.');
/// "R 110.1, A 3.0, S 5.0": a place in the patient (LPS, mm) by the letters of its sides, in every list and
/// card alike. A decimal comma is followed by semicolons. UTF-8.
std::string formatPlace(const Vec3& place, char decimalMark = '.');

/// The level and width that a scan is shown with: the view's, else what the scan proposes.
medical_io::ValueWindow windowOf(const medical_io::Scan& scan, const ScanLook& look);

} // namespace viscera::presentation
