#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

/// Files in and out. Everything inside Viscera is LPS millimetres; what a file says otherwise is converted
/// here.
namespace viscera::medical_io {

/// The axes in which a file's coordinates are written.
enum class Space { lps, ras };

/// A surface as it came from a file.
struct SurfaceFile {
  geometry::TriangleMesh mesh;       ///< LPS mm, triangles only, equal points merged.
  std::string name;                  ///< From the file's contents or its name.
  Space space = Space::lps;          ///< What the file was written in.
  bool spaceStated = false;          ///< False: the file does not say, LPS assumed.
  std::vector<std::string> warnings; ///< What was mended or looks odd, one sentence each.
};

/// Reads STL, OBJ, PLY, OFF, VTK (polygons and strips), VTP, GLB or GLTF, by its extension. Throws
/// `NoInputError` when the file is missing or not readable, `DataError` naming file and reason when it is
/// empty, truncated, of another kind than its name says, holds no triangle, or has coordinates that are not
/// finite.
SurfaceFile readSurface(const std::filesystem::path& file);

/// Options of `writeSurface`.
struct WriteSurface {
  Space space = Space::lps;
  std::string name; ///< Written where the format has a place for it.
};

/// Writes by extension (STL, OBJ, PLY, OFF, VTK, VTP, GLB): first to a temporary name beside it, then
/// renamed, so that nothing half-written is left. Colours go along where the format has them. Throws
/// `CannotCreateError`.
void writeSurface(const std::filesystem::path& file, const geometry::TriangleMesh& mesh,
                  const WriteSurface& options = {});

/// Lower-case extensions with the dot that `readSurface` takes.
const std::vector<std::string>& surfaceExtensions();

} // namespace viscera::medical_io
