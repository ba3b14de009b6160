#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace viscera::document {

/// The SHA-256 of bytes that come in pieces, by OpenSSL. For one thread.
class Sha256 {
public:
  /// Throws `std::bad_alloc`.
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view bytes);
  /// The hash as 64 lower-case digits in base 16. To be called once.
  std::string hex();

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace viscera::document
