#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "viscera/report/report.h"

namespace viscera::report {

/// Millimetres of an A4 page between its margins.
inline constexpr double kTextWidthMm = 174;

/// A text in which nothing is markup. Characters that no page may hold are left out.
std::string escaped(const std::string& text);

/// Where a page finds a picture, by its place among all of the report.
using PictureSource = std::function<std::string(std::size_t place)>;

/// What stands between `<body>` and `</body>`: in the words that browsers and Qt's rich text both know.
std::string bodyOf(const Report& report, const PictureSource& pictures, double pixelsPerMm);

} // namespace viscera::report
