#pragma once

#include "viscera/core/arrays.h"

namespace viscera::scene {

/// The look of everything in a view that is not an organ: colours (red green blue, 0 to 1) and the size of
/// type.
struct Theme {
  Vec3 backgroundTop;    ///< Upper end of the background's gradient.
  Vec3 backgroundBottom; ///< Lower end.
  Vec3 panel;            ///< Behind charts, as the window's panels.
  Vec3 text;             ///< Legends, scale bar, axes.
  Vec3 muted;            ///< Grid lines, ghost outlines.
  Vec3 accent;           ///< Selection, cursor, allowed plane.
  Vec3 rim;              ///< The rim of a selected handle: far from the background.
  bool dark = true;
  /// A factor for the size of text in views, and of legend, scale bar and orientation cube with it.
  double typeScale = 1;
};

/// The window's two palettes.
Theme darkTheme();
Theme lightTheme();

/// The factor of text size in a lecture, so that text can be read from the last row.
inline constexpr double kLectureTypeScale = 1.8;

/// A theme for a lecture, with the strongest contrast that there is and large type: white on black, or black
/// on white.
Theme lectureTheme(bool dark);

} // namespace viscera::scene
