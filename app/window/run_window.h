#pragma once

#include "window_options.h"

class QApplication;

namespace viscera::app {

/// Sets the attributes that Qt needs before the QApplication is created: the surface format for VTK, and
/// high-DPI scaling; limits how much freed memory the process keeps. Call it before other threads begin.
void prepareForApplication();

/// Sets name and version of the application, and installs the plurals of the English texts.
void setUpApplication(QApplication& application);

class SessionFiles;

/// Called when the connection to the display is lost and the program is about to end: saves unsaved work in
/// the recovery file, and reports the result on stderr.
void keepWithoutDisplay(SessionFiles& sessions) noexcept;

/// Runs the window until the user closes it and returns the exit code. Makes the QApplication: call it once,
/// from the main thread, before anything of Qt's. Needs a display: without one it writes an error to stderr
/// and returns 69.
int runWindow(int argc, char** argv, const WindowOptions& options);

} // namespace viscera::app
