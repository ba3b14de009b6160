#pragma once

#include <string>

namespace viscera::app::cli {

/// Width and height of a picture or a window, in pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};

/// Reads "1600x1000". Throws `UsageError` for anything else and for sides outside [16, 16384].
PictureSize pictureSize(const std::string& text);

} // namespace viscera::app::cli
