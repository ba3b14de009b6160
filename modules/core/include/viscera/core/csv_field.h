#pragma once

#include <string>

namespace viscera {

/// A text as a field of comma-separated values (RFC 4180): quoted where it needs it.
inline std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

} // namespace viscera
