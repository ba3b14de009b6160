#pragma once

#include "viscera/core/arrays.h"

namespace viscera::scene {

/// The colours of everything in a view that is not an organ. Red green blue, 0 to 1.
struct Theme {
  Vec3 backgroundTop;    ///< Upper end of the background's gradient.
  Vec3 backgroundBottom; ///< Lower end.
  Vec3 panel;            ///< Behind charts, as the window's panels.
  Vec3 text;             ///< Legends, scale bar, axes.
  Vec3 muted;            ///< Grid lines, ghost outlines.
  Vec3 accent;           ///< Selection, cursor, allowed plane.
  Vec3 rim;              ///< The rim of a selected handle: far from the background.
  bool dark = true;
};

/// The window's two palettes.
Theme darkTheme();
Theme lightTheme();

} // namespace viscera::scene
