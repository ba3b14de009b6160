#include "window/mode.h"

#include <QCoreApplication>

namespace viscera::app {
namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("viscera::app::Mode", text);
}

} // namespace

std::vector<ModeDescription> modeDescriptions() {
  return {
      {Mode::explore, "explore", "explore", 1, translated("Explore"),
       translated(
           "Left drag rotates, Shift+left pans, right drag or wheel zooms, click selects an organ, D and A "
           "measure")},
      {Mode::handles, "handles", "handles", 2, translated("Handles"),
       translated(
           "Click the organ to add a handle, drag to move it, Delete removes it; the rest shape stays")},
      {Mode::deform, "deform", "deform", 3, translated("Deform"),
       translated("Drag a handle and the organ follows; K locks the volume, T turns and scales, M mirrors")},
      {Mode::stress, "stress", "stress", 4, translated("Stress"),
       translated(
           "Click the tissue to see its values; C cuts the organ open; drag a handle, the map follows")},
      {Mode::play, "play", "beat", 5, translated("Play"),
       translated("Space plays or pauses; drag the timeline to look at one instant")},
  };
}

Mode modeFromId(const QString& id) {
  for (const ModeDescription& description : modeDescriptions())
    if (id == QLatin1String(description.id))
      return description.mode;
  return Mode::explore;
}

} // namespace viscera::app
