#include "standing_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/document/study_item.h"
#include "viscera/presentation/cine_presenter.h"
#include "viscera/presentation/cine_view.h"

#include "slice_values.h"

namespace viscera::presentation {
namespace {

/// Pixels of a standing slice along its longer side, which is never finer than the voxels.
constexpr double kMostPixels = 512;

/// A slice through the whole of the scan's box.
medical_io::SliceFrame wholeSlice(const medical_io::SliceDirection& direction, const medical_io::Scan& scan,
                                  const Vec3& focus) {
  const Bounds box = scan.bounds();
  const Vec3 extent = box.high - box.low;
  const double across = direction.right.cwiseAbs().dot(extent), up = direction.up.cwiseAbs().dot(extent);
  const double mm = std::max(std::max(across, up) / kMostPixels, scan.spacing().minCoeff());
  Vec3 center = box.center();
  center[direction.axis] = focus[direction.axis];
  const auto pixels = [mm](double length) { return std::max(1, static_cast<int>(std::ceil(length / mm))); };
  return medical_io::frameAround(direction, center, mm, pixels(across), pixels(up));
}

/// A picture of a study as it was recorded, pixel on pixel.
std::optional<scene::StandingSlices::Slice> standing(const medical_io::CineSlice& slice, double fraction,
                                                     const medical_io::ValueWindow& window, Threads threads) {
  const auto phase = cinePhase(slice, fraction);
  if (!phase)
    return std::nullopt;
  try {
    const auto image = slice.image(*phase);
    const medical_io::CineGeometry& place = slice.geometry;
    medical_io::ValueImage values;
    values.width = place.columns;
    values.height = place.rows;
    for (Eigen::Index row = image->rows() - 1; row >= 0; --row) // The first row of a texture is the lowest.
      values.values.insert(values.values.end(), image->data() + row * image->cols(),
                           image->data() + (row + 1) * image->cols());
    scene::StandingSlices::Slice shown;
    shown.corner = place.at(-0.5, place.rows - 0.5);
    shown.right = place.columns * place.betweenColumns * place.row;
    shown.up = -place.rows * place.betweenRows * place.column;
    shown.width = place.columns;
    shown.height = place.rows;
    medical_io::greyOf(values, window, 0, shown.grey, threads);
    return shown;
  } catch (const DataError&) {
    return std::nullopt;
  }
}

} // namespace

void StandingPicture::update(const Scene& scene) {
  const ScanLook& look = scene.view.scan;
  if (!look.standing || !(scene.state.scan || scene.state.study)) {
    if (made_)
      slices_.show({});
    made_.reset();
    return;
  }
  Made made{scene.state.scan, scene.state.study, look, {}};
  made.look.framings = {};
  made.look.layout.clear();
  if (scene.state.scan && scene.state.scan->time) {
    const auto phase = scene.state.scan->time->shownAt(look.cine.fraction);
    made.look.cine.fraction = phase ? static_cast<double>(*phase) : -1; // Other slices in another phase only.
  }
  if (scene.state.scan && look.warped && scene.warping)
    made.warped = scene.warping->revision;
  if (made == made_)
    return;
  made_ = made;
  slices_.show(scene.state.study ? studySlices(scene) : scanSlices(scene));
}

/// Slices that two panes show stand once.
std::vector<scene::StandingSlices::Slice> StandingPicture::studySlices(const Scene& scene) {
  const ScanLook& look = scene.view.scan;
  const medical_io::CineStudy& study = *scene.state.study->study;
  if (look.width <= 0 && proposedBy_ != scene.state.study) {
    proposedBy_ = scene.state.study;
    proposed_ = cineWindow(study);
  }
  const auto panes = cineSlices(study, look.cine);
  std::vector<scene::StandingSlices::Slice> shown;
  for (const std::size_t slice : std::set<std::size_t>(panes.begin(), panes.end()))
    if (auto one = standing(study.slices[slice], look.cine.fraction, windowOf(look, proposed_), threads_))
      shown.push_back(std::move(*one));
  return shown;
}

std::vector<scene::StandingSlices::Slice> StandingPicture::scanSlices(const Scene& scene) {
  const ScanLook& look = scene.view.scan;
  const bool warped = look.warped && scene.warping;
  const auto phase = document::scanAt(*scene.state.scan, look.cine.fraction);
  if (!phase)
    return {};
  const medical_io::Scan& scan = *phase;
  const Vec3 focus = focusOf(scene.state, look);
  if (look.width <= 0 && scanProposedBy_ != scene.state.scan) {
    scanProposedBy_ = scene.state.scan;
    scanProposed_ = scene.state.scan->scan->firstWindow();
  }
  const medical_io::ValueWindow window = windowOf(look, scanProposed_);
  medical_io::SampleOptions options;
  options.nearest = !look.smooth;
  options.slabMm = look.slabMm;
  options.maximum = look.maximum;
  options.threads = threads_;
  std::vector<scene::StandingSlices::Slice> shown;
  for (const medical_io::SliceDirection& direction : medical_io::sliceDirections()) {
    const medical_io::SliceFrame frame = wholeSlice(direction, scan, focus);
    SliceValues values;
    values.take(scan, frame, options, warped ? scene.warping : nullptr);
    scene::StandingSlices::Slice slice;
    slice.corner = frame.at(-0.5, -0.5);
    slice.right = frame.width * frame.right;
    slice.up = frame.height * frame.up;
    slice.width = frame.width;
    slice.height = frame.height;
    values.shade(window, slice.grey, threads_);
    shown.push_back(std::move(slice));
  }
  return shown;
}

} // namespace viscera::presentation
