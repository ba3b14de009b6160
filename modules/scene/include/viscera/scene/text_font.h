#pragma once

#include <string>

namespace viscera::scene {

/// The font family of texts in views until `setTextFont` is called: the system's sans-serif family.
inline constexpr char kDefaultFontFamily[] = "sans-serif";

/// Sets the font family of all views, charts and pictures to that of the window around them, so that the
/// program has one font in 2-D and in 3-D. Fontconfig finds the files of its regular and bold faces, or of
/// the nearest match; if it finds none that VTK can open, VTK's own font stays. VTK has one text renderer for
/// the program, so this applies to all views; texts that are drawn already change when they are drawn anew.
/// Thread-safe; some milliseconds.
///
///     scene::setTextFont("DejaVu Sans"); // The family of the window.
void setTextFont(const std::string& family);

/// The file of the font of views; empty: VTK's own font. Thread-safe.
std::string textFontFile();

} // namespace viscera::scene
