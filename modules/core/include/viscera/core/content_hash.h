#pragma once

#include <cstdint>
#include <string_view>

namespace viscera {

/// The 64-bit FNV-1a hash of `bytes`, continued from the hash of what came before. It distinguishes versions
/// of a file and detects damage; it is no protection against an attacker.
constexpr std::uint64_t contentHash(std::string_view bytes, std::uint64_t before = 0) {
  std::uint64_t hash = before ^ 0xcbf29ce484222325ULL;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

} // namespace viscera
