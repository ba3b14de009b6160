#pragma once

#include <string>
#include <vector>

namespace viscera::app {

/// The options of the command line with which the window starts.
struct WindowOptions {
  std::vector<std::string> files; ///< Opened after the window shows.
  std::string sample = "heart";   ///< Sample organ that is shown, and played if it has a motion, when no file
                                  ///< is opened.
  std::string theme;              ///< "dark", "light", or empty for the one used last.
  std::string language;           ///< "de"; empty: the one chosen in the window, or the system's.
  std::string screenshot; ///< Not empty: a PNG of the window once everything shows, then the program ends.
  std::string mode;       ///< "explore", "handles", "deform", "play"; empty: the standard one.
  int width = 0;          ///< Width of the window in pixels; 0: as in the last session.
  int height = 0;
  std::vector<std::string> pluginPath; ///< Folders and files searched for plugins first.
  bool freshSettings = false; ///< True: neither reads nor writes the user's settings (screenshots, tests).
};

} // namespace viscera::app
