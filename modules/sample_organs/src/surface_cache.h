#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::sample_organs {

/// Identifies the surface in a cache file.
struct CacheKey {
  std::string name;          ///< "heart-outer-medium"; the file is called after it.
  std::uint64_t content = 0; ///< Hash of all that the surface depends on.
};

/// Generated surfaces in a folder, one file each. A file is written under another name and then renamed, so
/// that another program never sees half of one, and is believed only when its length, key, checksum and
/// indices are right.
class SurfaceCache {
public:
  /// An empty path keeps nothing.
  explicit SurfaceCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The surface, or nothing when it is not there, damaged, or of another version of the definition.
  std::optional<geometry::TriangleMesh> load(const CacheKey& key) const;

  /// Keeps a surface; does nothing when the folder cannot be written, since the cache only saves time.
  void store(const CacheKey& key, const geometry::TriangleMesh& mesh) const;

  /// Where a surface is kept.
  std::filesystem::path fileOf(const CacheKey& key) const;

private:
  std::filesystem::path folder_;
};

} // namespace viscera::sample_organs
