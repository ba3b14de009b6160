#include "cli/npy_file.h"

#include <bit>
#include <cstdint>
#include <ostream>
#include <string>

#include "viscera/core/atomic_file.h"

namespace viscera::app::cli {
namespace {

constexpr std::size_t kAlignment = 64; ///< Of the data in the file; so says the format.

std::string header(Eigen::Index rows, Eigen::Index cols) {
  static_assert(std::endian::native == std::endian::little, "the header below says little-endian");
  std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
                     std::to_string(cols) + "), }";
  const std::string magic("\x93NUMPY\x01\x00", 8);
  const std::size_t before = magic.size() + sizeof(std::uint16_t);
  text.append(kAlignment - (before + text.size() + 1) % kAlignment, ' ');
  text += '\n';
  const auto size = static_cast<std::uint16_t>(text.size());
  return magic + static_cast<char>(size & 0xff) + static_cast<char>(size >> 8) + text;
}

} // namespace

void writeNpy(const std::filesystem::path& file, const Weights& matrix) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << header(matrix.rows(), matrix.cols());
    stream.write(reinterpret_cast<const char*>(matrix.data()),
                 static_cast<std::streamsize>(matrix.size() * static_cast<Eigen::Index>(sizeof(double))));
  });
}

} // namespace viscera::app::cli
