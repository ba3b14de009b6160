#pragma once

#include <string>

namespace viscera::scene {

/// What views write in until `setTextFont`: the family that the system takes for texts without serifs.
inline constexpr char kDefaultFontFamily[] = "sans-serif";

/// Lets all views, charts and pictures write in the font family of the window around them, so that the
/// program has one font in 2-D and in 3-D. Fontconfig finds the files of its regular and bold faces, or of
/// what is nearest; where it finds none that VTK can open, VTK's own font stays. VTK has one text renderer
/// for the program, so this is for all views of it; texts that are drawn already change when they are drawn
/// anew. Thread-safe; some milliseconds.
///
///     scene::setTextFont("DejaVu Sans"); // The family of the window.
void setTextFont(const std::string& family);

/// The file of the font in which views write; empty: VTK's own font. Thread-safe.
std::string textFontFile();

} // namespace viscera::scene
