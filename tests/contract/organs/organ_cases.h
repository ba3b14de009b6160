#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "build_paths.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {

/// An organ by its sample's name, or a surface of the folder beside the project.
struct OrganCase {
  std::string name;
  std::string file; ///< Empty for a sample organ.
  friend std::ostream& operator<<(std::ostream& out, const OrganCase& organ) { return out << organ.name; }
};

inline std::vector<OrganCase> organCases() {
  return {{"heart", ""},
          {"stomach", ""},
          {"liver", ""},
          {"atlas_liver", "liver.vtk"},
          {"atlas_kidney", "kidney_left.vtk"}};
}

/// The organ's outer surface; nothing when its file is not there.
inline std::optional<geometry::TriangleMesh> load(const OrganCase& organ) {
  if (organ.file.empty()) {
    Progress progress;
    return *sample_organs::sampleOrgan(sample_organs::standardLibrary(), organ.name,
                                       sample_organs::Resolution::low, progress)
                .surfaces.front()
                .mesh;
  }
  const auto path = std::filesystem::path(VISCERA_SHARED_ORGANS) / organ.file;
  if (!std::filesystem::exists(path))
    return std::nullopt;
  auto mesh = medical_io::readSurface(path).mesh;
  geometry::orientOutward(mesh);
  return mesh;
}

} // namespace viscera::tests
