#pragma once

#include "window_options.h"

class QApplication;

namespace viscera::app {

/// Sets up what has to be set before the QApplication is created: the surface format that VTK needs, high
/// density.
void prepareForApplication();

/// Name, version, and the plurals of the English texts.
void setUpApplication(QApplication& application);

class SessionFiles;

/// The display has gone, and the program is about to end: keeps unsaved work, and says on stderr what became
/// of it.
void keepWithoutDisplay(SessionFiles& sessions) noexcept;

/// Runs the window until the user closes it and returns the exit code. Makes the QApplication: call it once,
/// from the main thread, before anything of Qt's. Needs a display: without one it says so on stderr and
/// returns 69.
int runWindow(int argc, char** argv, const WindowOptions& options);

} // namespace viscera::app
