#include "viscera/core/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace viscera {
namespace {

constexpr std::string_view kBase64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoBase64Digit = 0xFF;

constexpr std::array<std::uint8_t, 256> base64Values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoBase64Digit);
  for (std::size_t i = 0; i < kBase64Digits.size(); ++i)
    values[static_cast<unsigned char>(kBase64Digits[i])] = static_cast<std::uint8_t>(i);
  return values;
}

constexpr std::array<std::uint8_t, 256> kBase64Values = base64Values();

std::uint32_t base64Value(char digit) {
  return kBase64Values[static_cast<unsigned char>(digit)];
}

/// Appends the one or two bytes of a padded group. False when a character is no digit.
bool appendBase64Tail(std::string& bytes, std::string_view digits) {
  std::uint32_t group = 0;
  for (const char digit : digits) {
    if (base64Value(digit) == kNoBase64Digit)
      return false;
    group = group << 6U | base64Value(digit);
  }
  group <<= 6 * (4 - digits.size());
  for (std::size_t i = 0; i + 1 < digits.size(); ++i)
    bytes += static_cast<char>(group >> (16 - 8 * i) & 0xFFU);
  return true;
}

} // namespace

std::string base64Of(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  char* out = text.data();
  for (std::size_t at = 0; at < bytes.size(); at += 3, out += 4) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i)
      group = group << 8U | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i <= count; ++i)
      out[i] = kBase64Digits[group >> (18 - 6 * i) & 0x3FU];
  }
  return text;
}

std::optional<std::string> bytesOfBase64(std::string_view text) {
  if (text.size() % 4 != 0)
    return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=')
    ++padding;
  const std::size_t whole = (text.size() - padding) / 4 * 4;
  std::string bytes(whole / 4 * 3, '\0');
  char* out = bytes.data();
  for (std::size_t at = 0; at < whole; at += 4) {
    const std::uint32_t a = base64Value(text[at]), b = base64Value(text[at + 1]),
                        c = base64Value(text[at + 2]), d = base64Value(text[at + 3]);
    if (((a | b | c | d) & 0x80U) != 0)
      return std::nullopt;
    const std::uint32_t group = a << 18U | b << 12U | c << 6U | d;
    *out++ = static_cast<char>(group >> 16U);
    *out++ = static_cast<char>(group >> 8U & 0xFFU);
    *out++ = static_cast<char>(group & 0xFFU);
  }
  if (padding > 0 && !appendBase64Tail(bytes, text.substr(whole, 4 - padding)))
    return std::nullopt;
  return bytes;
}

} // namespace viscera
