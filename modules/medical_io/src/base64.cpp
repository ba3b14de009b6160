#include "base64.h"

#include <array>

#include <vtkBase64Utilities.h>

namespace viscera::medical_io {

std::optional<std::string> decodeBase64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::array<unsigned char, 4> group{};
  std::size_t filled = 0;
  bool ended = false;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
      continue;
    if (ended)
      return std::nullopt;
    group[filled++] = static_cast<unsigned char>(c);
    if (filled < 4)
      continue;
    filled = 0;
    std::array<unsigned char, 3> out{};
    const int count =
        vtkBase64Utilities::DecodeTriplet(group[0], group[1], group[2], group[3], &out[0], &out[1], &out[2]);
    if (count == 0)
      return std::nullopt;
    ended = count < 3;
    for (int i = 0; i < count; ++i)
      bytes += static_cast<char>(out[static_cast<std::size_t>(i)]);
  }
  return filled == 0 ? std::optional(std::move(bytes)) : std::nullopt;
}

} // namespace viscera::medical_io
