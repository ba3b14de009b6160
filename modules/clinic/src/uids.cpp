#include <array>
#include <cstdint>
#include <string>

#include <openssl/evp.h>
#include <openssl/rand.h>

#include "viscera/clinic/study_identity.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::clinic {
namespace {

constexpr std::size_t kBytes = 16;

/// PS3.5, B.2: a UUID as one decimal number below 2.25.
std::string uidOfBytes(std::array<std::uint8_t, kBytes> bytes) {
  std::string digits;
  bool left = true;
  while (left) {
    unsigned remainder = 0;
    left = false;
    for (std::uint8_t& byte : bytes) { // Divides the number by ten.
      const unsigned value = remainder * 256 + byte;
      byte = static_cast<std::uint8_t>(value / 10);
      remainder = value % 10;
      left = left || byte != 0;
    }
    digits.insert(digits.begin(), static_cast<char>('0' + remainder));
  }
  return "2.25." + digits;
}

/// Marks the bits as a UUID of a version (RFC 9562).
void markAsUuid(std::array<std::uint8_t, kBytes>& bytes, unsigned version) {
  bytes[6] = static_cast<std::uint8_t>((bytes[6] & 0x0FU) | version << 4U);
  bytes[8] = static_cast<std::uint8_t>((bytes[8] & 0x3FU) | 0x80U);
}

} // namespace

std::string newUid() {
  std::array<std::uint8_t, kBytes> bytes;
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw CannotCreateError(misuse("the system gives no random numbers"));
  markAsUuid(bytes, 4);
  return uidOfBytes(bytes);
}

std::string uidFrom(std::string_view uid, std::string_view secret) {
  // The secret's length keeps two pairs apart that join to the same text.
  const std::string joined = std::to_string(secret.size()) + ':' + std::string(secret) + std::string(uid);
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> digest;
  unsigned length = 0;
  if (EVP_Digest(joined.data(), joined.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw CannotCreateError(misuse("libcrypto cannot make a digest"));
  std::array<std::uint8_t, kBytes> bytes;
  std::copy_n(digest.begin(), kBytes, bytes.begin());
  markAsUuid(bytes, 8);
  return uidOfBytes(bytes);
}

} // namespace viscera::clinic
