#include "cli/slice_picture.h"

#include <charconv>
#include <cmath>

#include <vtkRenderWindow.h>

#include "viscera/core/error.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"

namespace viscera::app::cli {

SliceRequest sliceRequest(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto directions = medical_io::sliceDirections();
  for (std::size_t i = 0; i < directions.size() && colon != text.npos; ++i) {
    if (name != directions[i].id)
      continue;
    SliceRequest request{static_cast<int>(i), 0};
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + colon + 1, end, request.mm);
    if (read.ec == std::errc() && read.ptr == end && std::isfinite(request.mm))
      return request;
  }
  throw UsageError("It is not a slice", "\"" + text + "\"",
                   "take axial, coronal or sagittal and a place in mm: axial:120");
}

SliceOutcome slicePicture(const presentation::SliceScene& scene, const SliceRequest& slice,
                          const StageOptions& stage, Threads threads) {
  presentation::ViewState wanted = scene.view;
  const int axis = medical_io::sliceDirections()[static_cast<std::size_t>(slice.direction)].axis;
  Vec3 focus = presentation::focusOf(scene.state, wanted.scan);
  focus[axis] = slice.mm;
  wanted.scan.focus = focus;
  presentation::SlicePresenter presenter(threads);
  presenter.update({scene.state, scene.organs, wanted, scene.warping},
                   {{slice.direction, stage.size.width, stage.size.height}});
  scene::SurfacelessWindow window(stage.size.width, stage.size.height);
  scene::SliceView drawn;
  drawn.setWindow(window.window());
  drawn.setTheme(stage.theme == "light" ? scene::lightTheme() : scene::darkTheme());
  scene::SlicePicture picture = presenter.picture(slice.direction);
  picture.cross.reset(); // A picture has no mouse, so no crosshair is drawn.
  drawn.show(picture);
  SliceOutcome outcome;
  outcome.image = scene::grabPicture(window.window());
  outcome.contours = nlohmann::ordered_json::array();
  for (const presentation::ContourFigure& contour : presenter.contours(slice.direction))
    outcome.contours.push_back(
        {{"organ", contour.name}, {"points", contour.points}, {"lengthMm", contour.lengthMm}});
  return outcome;
}

} // namespace viscera::app::cli
