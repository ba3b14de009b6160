#pragma once

#include <string>

namespace viscera {

/// `value` with that many digits after the point, always with a point, whatever the locale: "83.4". No
/// errors; from any thread.
std::string fixed(double value, int digits);
/// `value` with that many significant digits, likewise: "3.1e-15".
std::string significant(double value, int digits = 3);

} // namespace viscera
