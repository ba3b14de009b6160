#pragma once

#include <QString>

#include <vector>

namespace viscera::app {

/// What the mouse does in the view and which property page shows.
enum class Mode { explore, handles, deform, stress, play };

/// Whether a dragged handle makes a pose there, and leaves the rest shape as it is.
constexpr bool posesHandles(Mode mode) {
  return mode == Mode::deform || mode == Mode::stress;
}

/// A mode as the user meets it.
struct ModeDescription {
  Mode mode = Mode::explore;
  const char* id = "";   ///< "explore"; as in settings and options.
  const char* icon = ""; ///< Of the icon set.
  int key = 0;           ///< The digit that chooses it; stays the same whatever other modes there are.
  QString name;          ///< Under the icon.
  QString hint;          ///< For the status bar: what the mouse does.
};

/// All modes, in the order of the rail.
std::vector<ModeDescription> modeDescriptions();

/// The mode of that id, or Explore.
Mode modeFromId(const QString& id);

} // namespace viscera::app
