#pragma once

#include <string>

#include "cli/picture_size.h"
#include "viscera/presentation/stage.h"

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

/// A stage of that size and theme. Throws as `presentation::Stage`.
presentation::Stage stageFor(const StageOptions& options, Threads threads);

} // namespace viscera::app::cli
