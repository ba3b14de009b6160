#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "build_paths.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {

/// The project's own definitions, and no cache.
inline sample_organs::SampleLibrary projectLibrary() {
  return {std::filesystem::path(VISCERA_SOURCE_DIR) / "sample_organs", {}};
}

/// A folder for one test, removed with it. Holds definitions in `definitions` and a cache in `cache`.
class TemporaryLibrary {
public:
  TemporaryLibrary() {
    std::string name = (std::filesystem::temp_directory_path() / "viscera-organs-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    std::filesystem::create_directories(library().definitions);
  }
  ~TemporaryLibrary() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryLibrary(const TemporaryLibrary&) = delete;
  TemporaryLibrary& operator=(const TemporaryLibrary&) = delete;

  sample_organs::SampleLibrary library() const { return {folder_ / "definitions", folder_ / "cache"}; }

  void write(const std::string& organ, const std::string& content) const {
    std::ofstream(library().definitions / (organ + ".json")) << content;
  }

  /// A definition of one surface with the given root, and nodes.
  void writeRoot(const std::string& organ, const std::string& root, const std::string& nodes = "") const {
    write(organ, R"({"name": ")" + organ + R"(", "units": "mm", "frame": "LPS", "nodes": [)" + nodes +
                     R"(], "surfaces": [{"name": "outer", "triangles": {"low": 500, "medium": 1000,)" +
                     R"( "high": 2000}, "root": )" + root + "}]}");
  }

private:
  std::filesystem::path folder_;
};

/// A ball of 20 mm.
inline constexpr const char* kBall = R"({"type": "ellipsoid", "center": [1, 2, 3], "radii": [20, 20, 20]})";

} // namespace viscera::tests
