#pragma once

#include <memory>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "cli/inputs.h"
#include "cli/picture_size.h"
#include "viscera/core/parallel.h"
#include "viscera/scene/organ_view.h"
#include "viscera/scene/surfaceless_window.h"

class vtkImageData;

namespace CLI {
class App;
}

namespace viscera::app::cli {

/// Room around organs on pictures of several parts.
inline constexpr double kRoomOnASheet = 0.07;

/// How pictures are taken.
struct StageOptions {
  PictureSize size{1600, 1000};
  std::string theme = "dark";    ///< Or "light".
  std::string view = "anterior"; ///< A name of `scene::StandardView`.
};

/// Adds `--size`, `--view` and `--theme`. The size is text until the command runs `pictureSize`.
void addStageOptions(CLI::App& options, StageOptions& stage, std::string& size);

/// A view of organs and handles that needs no display. For the thread that made it.
class Stage {
public:
  /// Throws `UsageError` for an unknown view, `Error` when there is nothing to draw with.
  explicit Stage(const StageOptions& options, Threads threads = {});

  /// Puts an organ on the stage, at rest.
  std::shared_ptr<scene::OrganActor> add(const document::Organ& organ, double opacity = 1);

  /// Shows handles at `rig`'s rest, each in the colour of its group.
  void showHandles(const RigInput& rig);

  /// Turns to the side asked for and brings all organs and handles into the picture. Call once, when all are
  /// there.
  void compose();
  /// The same from another side, with `room` around as a part of the size of what is shown: small pictures
  /// need some for the scale bar.
  void compose(const std::string& view, double room);

  vtkSmartPointer<vtkImageData> picture();
  scene::OrganView& view() { return view_; }

private:
  void lookAtAll(double room);
  Threads threads_;
  scene::StandardView side_;
  scene::SurfacelessWindow window_;
  scene::OrganView view_;
};

} // namespace viscera::app::cli
