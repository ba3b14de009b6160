#pragma once

#include "window/run_window.h"

namespace viscera::app {

/// Shows the window without the user's settings, lets it load what the options say, plays two and a half
/// seconds of its motion on a clock of its own (the same on every machine), writes the picture of the whole
/// window and returns the exit code. Needs a QApplication.
int takePicture(const WindowOptions& options);

} // namespace viscera::app
