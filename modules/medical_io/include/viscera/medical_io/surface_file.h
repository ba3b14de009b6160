#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/space.h"

/// Reads and writes surface files. Everything inside Viscera is LPS millimetres; files in other axes or units
/// are converted here.
namespace viscera::medical_io {

/// A surface that was read from a file, with its axes and warnings.
struct SurfaceFile {
  geometry::TriangleMesh mesh;    ///< LPS mm, triangles only, equal points merged.
  std::string name;               ///< From the file's contents or its name.
  Space space = Space::lps;       ///< What the file was written in.
  bool spaceStated = false;       ///< False: the file does not say, LPS assumed.
  std::vector<Text> warnings;     ///< Repairs and doubts, one sentence each.
  geometry::SurfaceReport report; ///< Of `mesh`.
};

/// Reads the one organ of a file: any surface format of `fileFormats`, and a DICOM file with an STL or OBJ
/// file within, under any name. Equal points are merged, polygons cut into triangles, triangles with a
/// repeated corner and points without a triangle dropped; warnings list this and other doubts: open, inside
/// out, a size or volume that no such organ has. Scales only what states another unit than mm, and never
/// turns a surface around. How axes are stated, and what an organ is in a file of several parts:
/// docs/file_formats.md.
///
/// Throws `NoInputError` when the file is missing or not readable, `DataError` naming file and reason when it
/// is empty, truncated, of another kind than its name says, holds no triangle, or has coordinates that are
/// not finite or more than 1000 km away, `UsageError` that lists the organs when it holds several. Prints
/// nothing, and takes memory for what is in the file, not for what its header promises. O(n + m log m); may
/// be called from several threads.
///
/// With `SeveralOrgans::join` a file of several organs gives one surface of them all: for documents that were
/// saved when such files were read so.
enum class SeveralOrgans { refuse, join };
SurfaceFile readSurface(const std::filesystem::path& file, SeveralOrgans several = SeveralOrgans::refuse);

/// One of the organs in a file that holds several.
struct SurfacePart {
  SurfaceFile surface;
  std::optional<Vec3> color; ///< Red green blue, 0 to 1; none: the file gives it none.
  double opacity = 1;        ///< 0 to 1.
  int cavityOf = -1;         ///< The part whose cavity this is; -1: an organ of its own.
};

/// Reads all organs of a file, with names, colours and, where Viscera has written it, cavities. Organs are
/// the named parts of the file (OBJ: objects, else groups, else materials; glTF: nodes; STL: solids; VTM:
/// blocks; 3MF: objects) that are closed; open parts that share points are one organ. A warning says when an
/// organ lies inside another, whose volume then contains its volume. Throws what `readSurface` throws, but
/// for several organs. O(n + m log m).
std::vector<SurfacePart> readSurfaces(const std::filesystem::path& file);

/// The place of the organ with that name, as `segmentsNamed` compares names, or with that number from 1.
/// Throws `UsageError` that lists the organs when there is none.
std::size_t partNamed(const std::vector<SurfacePart>& parts, const std::string& name, const Text& where);

/// Reads one organ of a file, chosen as by `partNamed`. Throws what `readSurfaces` and `partNamed` throw.
SurfacePart readSurfacePart(const std::filesystem::path& file, const std::string& name);

/// Options of `writeSurface`.
struct WriteSurface {
  Space space = Space::lps;
  std::string name; ///< On one line; truncated if the format has little room for it.
};

/// Writes by extension (STL, OBJ, PLY, OFF, VTK, VTP, GLB, 3MF): first to a temporary name beside it, then
/// renamed, so that nothing half-written is left. Colours are written if the format has them (all but STL).
/// STL and GLB are in single precision, the others keep every bit. Throws `CannotCreateError` when the file
/// cannot be written or has another ending, `DataError` for a mesh without triangles, with coordinates that
/// are not finite or with indices out of range. O(n + m).
void writeSurface(const std::filesystem::path& file, const geometry::TriangleMesh& mesh,
                  const WriteSurface& options = {});

/// One of several surfaces in a file.
struct NamedSurface {
  std::shared_ptr<const geometry::TriangleMesh> mesh; ///< LPS mm.
  std::string name;
  Vec3 color = {0.8, 0.8, 0.8}; ///< Red green blue, 0 to 1; of a mesh without colours of its own.
  double opacity = 1;           ///< 0 to 1.
  int cavityOf = -1;            ///< The place in the list of the surface whose cavity this is; -1: of none.
};

/// Writes several surfaces into one GLB or 3MF, each with its name and colour, in LPS mm as by
/// `writeSurface`, or in RAS; `readSurfaces` reads them again. A cavity comes behind its organ. In a GLB it
/// is a surface of its own; in a 3MF, which is for printing, it is in the mesh of its organ, with its
/// triangles turned so that the organ is hollow there. Atomic. Throws `CannotCreateError` when the file
/// cannot be written or has another ending, `DataError` for no surface, one that is not valid, or a cavity
/// that comes before its organ.
void writeSurfaces(const std::filesystem::path& file, const std::vector<NamedSurface>& surfaces,
                   Space space = Space::lps);

} // namespace viscera::medical_io
