#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "viscera/report/report.h"

/// Converts a report to markup for browsers and for Qt's rich text.
namespace viscera::report {

/// The width of an A4 page between its margins, mm.
inline constexpr double kTextWidthMm = 174;

/// Escapes all markup in a text. Characters that are not allowed in a page are left out.
std::string escaped(const std::string& text);

/// Returns the address of a picture in the page, by its index in the report.
using PictureSource = std::function<std::string(std::size_t place)>;

/// The content between `<body>` and `</body>`, in markup that both browsers and Qt's rich text support.
std::string bodyOf(const Report& report, const PictureSource& pictures, double pixelsPerMm);

} // namespace viscera::report
