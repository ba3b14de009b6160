#pragma once

#include <string>

#include <bzlib.h>

namespace viscera::tests {

/// `bytes` packed by bzip2, one stream.
inline std::string bzipped(const std::string& bytes) {
  std::string out(bytes.size() + bytes.size() / 100 + 600, '\0'); // What bzlib's manual asks for.
  auto size = static_cast<unsigned>(out.size());
  BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(bytes.data()),
                           static_cast<unsigned>(bytes.size()), 1, 0, 0);
  out.resize(size);
  return out;
}

} // namespace viscera::tests
