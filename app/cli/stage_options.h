#pragma once

#include <string>

#include "viscera/presentation/stage.h"

namespace CLI {
class App;
}

namespace viscera::app::cli {

/// Width and height of a picture or a window, in pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};

/// Reads "1600x1000". Throws `UsageError` for anything else and for sides outside [16, 16384].
PictureSize pictureSize(const std::string& text);

/// Room around organs on pictures of several parts.
inline constexpr double kRoomOnASheet = 0.07;

/// Size, view direction and colours of the pictures that a command renders.
struct StageOptions {
  PictureSize size{1600, 1000};
  std::string theme = "dark";    ///< Or "light".
  std::string view = "anterior"; ///< A name of `scene::StandardView`.
};

/// Adds `--size`, `--view` and `--theme`. The size is text until the command runs `pictureSize`.
void addStageOptions(CLI::App& options, StageOptions& stage, std::string& size);

/// The colours of `--theme`.
scene::Theme themeOf(const StageOptions& options);

/// A stage of that size and theme. Throws as `presentation::Stage`.
presentation::Stage stageFor(const StageOptions& options, Threads threads);

} // namespace viscera::app::cli
