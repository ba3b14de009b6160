#include "surface_cache.h"

#include <cstring>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "viscera/core/atomic_file.h"
#include "viscera/core/content_hash.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"

namespace viscera::sample_organs {
namespace {

using geometry::TriangleMesh;
namespace fs = std::filesystem;

/// The start of a file. Numbers are in the machine's byte order: another order does not give the magic
/// number.
struct Header {
  std::uint64_t magic = 0x56534f52474e3031ULL;
  std::uint64_t content = 0;
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  std::uint64_t checksum = 0; ///< Of everything after the header.
};
static_assert(sizeof(Header) == 5 * sizeof(std::uint64_t));

template <class Array>
std::string_view bytesOf(const Array& array) {
  return {reinterpret_cast<const char*>(array.data()),
          static_cast<std::size_t>(array.size()) * sizeof(typename Array::Scalar)};
}

std::uint64_t checksumOf(const TriangleMesh& mesh) {
  std::uint64_t sum = contentHash(bytesOf(mesh.points));
  sum = contentHash(bytesOf(mesh.triangles), sum);
  return contentHash(bytesOf(mesh.colors), sum);
}

std::size_t bodySize(const Header& header) {
  const std::size_t point = 3 * (sizeof(Points::Scalar) + sizeof(Colors::Scalar));
  return header.points * point + header.triangles * 3 * sizeof(Triangles::Scalar);
}

template <class Array>
std::size_t fill(Array& array, std::uint64_t rows, const std::string& bytes, std::size_t from) {
  array.resize(static_cast<Eigen::Index>(rows), 3);
  const std::size_t size = bytesOf(array).size();
  std::memcpy(array.data(), bytes.data() + from, size);
  return from + size;
}

/// Empty when the file is not there or cannot be read: the surface is generated again then.
std::string readAll(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  try {
    return restOf(file, path.string());
  } catch (const NoInputError&) {
    return {};
  }
}

} // namespace

fs::path SurfaceCache::fileOf(const CacheKey& key) const {
  std::ostringstream name;
  name << key.name << '-' << std::hex << std::setw(16) << std::setfill('0') << key.content << ".surface";
  return folder_ / name.str();
}

std::optional<TriangleMesh> SurfaceCache::load(const CacheKey& key) const {
  if (folder_.empty())
    return {};
  const std::string bytes = readAll(fileOf(key));
  Header header;
  const Header expected;
  if (bytes.size() < sizeof header)
    return {};
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.magic != expected.magic || header.content != key.content)
    return {};
  if (header.points > bytes.size() || header.triangles > bytes.size())
    return {};
  if (bytes.size() != sizeof header + bodySize(header))
    return {};
  TriangleMesh mesh;
  std::size_t from = fill(mesh.points, header.points, bytes, sizeof header);
  from = fill(mesh.triangles, header.triangles, bytes, from);
  fill(mesh.colors, header.points, bytes, from);
  if (checksumOf(mesh) != header.checksum)
    return {};
  try {
    geometry::requireValid(mesh, key.name);
  } catch (const DataError&) {
    return {};
  }
  return mesh;
}

void SurfaceCache::store(const CacheKey& key, const TriangleMesh& mesh) const {
  if (folder_.empty())
    return;
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  Header header;
  header.content = key.content;
  header.points = static_cast<std::uint64_t>(mesh.points.rows());
  header.triangles = static_cast<std::uint64_t>(mesh.triangles.rows());
  header.checksum = checksumOf(mesh);
  try {
    writeAtomically(fileOf(key), [&](std::ostream& file) {
      file.write(reinterpret_cast<const char*>(&header), sizeof header);
      for (const std::string_view bytes :
           {bytesOf(mesh.points), bytesOf(mesh.triangles), bytesOf(mesh.colors)})
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
  } catch (const CannotCreateError&) {
    // The next start only takes longer where there is no cache.
  }
}

} // namespace viscera::sample_organs
