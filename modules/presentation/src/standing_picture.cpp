#include "standing_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "slice_values.h"

namespace viscera::presentation {
namespace {

/// Of a standing slice along its longer side; finer than the voxels it is not.
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

} // namespace

void StandingPicture::update(const Scene& scene) {
  const ScanLook& look = scene.view.scan;
  if (!look.standing || !scene.state.scan) {
    if (made_)
      slices_.show({});
    made_.reset();
    return;
  }
  Made made{scene.state.scan, look, {}};
  made.look.framings = {};
  made.look.layout.clear();
  const bool warped = look.warped && scene.warping;
  if (warped)
    made.warped = scene.warping->revision;
  if (made == made_)
    return;
  made_ = made;
  const medical_io::Scan& scan = *scene.state.scan->scan;
  const Vec3 focus = focusOf(scene.state, look);
  const medical_io::ValueWindow window = windowOf(scan, look);
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
  slices_.show(shown);
}

} // namespace viscera::presentation
