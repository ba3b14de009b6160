#pragma once

#include <string>
#include <vector>

namespace viscera::app {

/// The options of the command line with which the window starts.
struct WindowOptions {
  std::vector<std::string> files; ///< Opened after the window shows.
  std::string sample = "heart";   ///< Shown, and moving if it can, where no file is opened.
  std::string theme;              ///< "dark", "light", or empty for the one used last.
  std::string language;           ///< "de"; empty: the one chosen in the window, or the system's.
  std::string screenshot; ///< Not empty: a PNG of the window once everything shows, then the program ends.
  std::string mode;       ///< "explore", "handles", "deform", "play"; empty: the standard one.
  int width = 0;          ///< Of the window in pixels; 0: as it was left last time.
  int height = 0;
  std::vector<std::string> pluginPath; ///< Folders and files searched for plugins first.
  bool freshSettings = false; ///< True: neither reads nor writes the user's settings (screenshots, tests).
};

} // namespace viscera::app
