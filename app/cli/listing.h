#pragma once

#include <string>
#include <utility>
#include <vector>

namespace viscera::app::cli {

/// Lines "label  value" for a reader, the values below each other.
class Listing {
public:
  Listing& add(std::string label, std::string value);
  std::string text() const;

private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// `value` with that many digits after the point, always with a point: "83.4".
std::string fixed(double value, int digits);
/// `value` with that many significant digits: "3.1e-15".
std::string significant(double value, int digits = 3);

} // namespace viscera::app::cli
