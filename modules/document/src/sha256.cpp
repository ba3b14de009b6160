#include "sha256.h"

#include <array>
#include <new>

#include <openssl/crypto.h>
#include <openssl/evp.h>

namespace viscera::document {
namespace {

/// A program whose display has gone writes a session while it exits: libcrypto stays usable until the end.
void keepLibraryUntilTheEnd() {
  static const bool kept = OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr) == 1;
  if (!kept)
    throw std::bad_alloc();
}

} // namespace

struct Sha256::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  ~State() { EVP_MD_CTX_free(context); }
};

Sha256::Sha256() {
  keepLibraryUntilTheEnd();
  state_ = std::make_unique<State>();
  if (state_->context == nullptr || EVP_DigestInit_ex(state_->context, EVP_sha256(), nullptr) != 1)
    throw std::bad_alloc();
}

Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  if (EVP_DigestUpdate(state_->context, bytes.data(), bytes.size()) != 1)
    throw std::bad_alloc();
}

std::string Sha256::hex() {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_DigestFinal_ex(state_->context, digest.data(), &size) != 1)
    throw std::bad_alloc();
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    text += kHexDigits[digest[i] >> 4U];
    text += kHexDigits[digest[i] & 0xFU];
  }
  return text;
}

} // namespace viscera::document
