#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "cli/stage_options.h"
#include "viscera/presentation/slice_presenter.h"

namespace viscera::app::cli {

/// The direction of a slice and its place along x, y or z in mm LPS, as in "axial:120", "coronal:-40.5" or
/// "sagittal:0".
struct SliceRequest {
  int direction = 0; ///< Of `medical_io::sliceDirections`.
  double mm = 0;
};

/// Reads a direction and a place from a text such as "axial:120". Throws `UsageError` for anything else.
SliceRequest sliceRequest(const std::string& text);

/// The picture of a slice and its contours as JSON (`organ`, `points`, `lengthMm`).
struct SliceOutcome {
  vtkSmartPointer<vtkImageData> image;
  nlohmann::ordered_json contours;
};

/// Draws a slice through organs, as they are posed, and the scan beside them, if there is one. The scene's
/// view determines level, width and everything else but the place. Throws as `presentation::Stage`.
SliceOutcome slicePicture(const presentation::SliceScene& scene, const SliceRequest& slice,
                          const StageOptions& stage, Threads threads);

} // namespace viscera::app::cli
