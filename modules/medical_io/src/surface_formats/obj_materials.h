#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "raw_surface.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// The materials of an OBJ file, which are in files beside it. What cannot be read there is a warning: the
/// shape does not need it.
class ObjMaterials {
public:
  /// `obj` is the file that names the others.
  explicit ObjMaterials(std::filesystem::path obj) : obj_(std::move(obj)) {}

  /// What stands behind "mtllib": a name, which may have spaces, or several.
  void addFile(const std::string& names) { named_.push_back(names); }
  /// Reads all files that were added; throws nothing but `std::bad_alloc`.
  void read(std::vector<Text>& warnings);
  /// Gives a part the material of that name; nothing for the empty name.
  void giveTo(RawPart& part, const std::string& material) const;

private:
  struct Material {
    std::optional<Vec3> color;
    std::optional<double> opacity, transparency;
  };

  std::vector<std::filesystem::path> filesOf(const std::string& names) const;
  void readFile(const std::filesystem::path& file);
  void readStatement(std::string_view line, bool byVtk, Material*& current);

  std::filesystem::path obj_;
  std::vector<std::string> named_;
  std::map<std::string, Material> materials_;
};

} // namespace viscera::medical_io
