#include "viscera/medical_io/surface_file.h"

#include <algorithm>
#include <array>
#include <new>
#include <string_view>
#include <utility>

#include "file_bytes.h"
#include "file_signature.h"
#include "raw_surface.h"
#include "surface_formats.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

struct SurfaceFormat {
  Signature signature;
  RawSurface (*read)(const FileBytes&);
  void (*write)(std::ostream&, const geometry::TriangleMesh&, const WriteSurface&);
};

constexpr std::array<SurfaceFormat, 8> kSurfaceFormats = {{
    {Signature::stl, readStl, writeStl},
    {Signature::obj, readObj, writeObj},
    {Signature::ply, readPly, writePly},
    {Signature::off, readOff, writeOff},
    {Signature::legacyVtk, readLegacyVtk, writeLegacyVtk},
    {Signature::vtp, readVtp, writeVtp},
    {Signature::glb, readGltf, writeGlb},
    {Signature::gltf, readGltf, nullptr},
}};

/// Null for a signature of no surface.
const SurfaceFormat* formatOf(Signature signature) {
  const auto found =
      std::find_if(kSurfaceFormats.begin(), kSurfaceFormats.end(),
                   [signature](const SurfaceFormat& format) { return format.signature == signature; });
  return found == kSurfaceFormats.end() ? nullptr : &*found;
}

const SurfaceFormat& formatOf(const FileBytes& file) {
  return *formatOf(signatureFor(file, FileKind::surface));
}

std::string writtenEndings() {
  std::string list;
  for (const FileFormat& format : fileFormats())
    if (format.kind == FileKind::surface && format.written)
      list += (list.empty() ? "" : ", ") + format.endings.front();
  return list;
}

geometry::TriangleMesh inSpace(const geometry::TriangleMesh& mesh, Space space) {
  geometry::TriangleMesh result = mesh;
  if (space == Space::ras)
    result.points.leftCols<2>() = (0.0 - result.points.leftCols<2>().array()).matrix();
  return result;
}

} // namespace

RawSurface readRawSurface(const std::filesystem::path& file) {
  const FileBytes bytes = readWholeFile(file);
  const SurfaceFormat& format = formatOf(bytes);
  try {
    return format.read(bytes);
  } catch (const std::bad_alloc&) {
    bytes.fail("it does not fit into memory", "reduce the surface first");
  }
}

SurfaceFile readSurface(const std::filesystem::path& file) {
  RawSurface raw = readRawSurface(file);
  try {
    return assembleSurface(std::move(raw), file);
  } catch (const std::bad_alloc&) {
    throw DataError("it does not fit into memory", file.string(), "reduce the surface first");
  }
}

std::vector<SurfacePart> readSurfaces(const std::filesystem::path& file) {
  std::vector<SurfacePart> parts;
  if (extensionOf(file) == ".glb") {
    const FileBytes bytes = readWholeFile(file);
    formatOf(bytes);
    try {
      for (RawPart& raw : readGltfParts(bytes))
        parts.push_back(
            {assembleSurface(std::move(raw.surface), file), raw.color, raw.opacity, raw.cavityOf});
    } catch (const std::bad_alloc&) {
      bytes.fail("it does not fit into memory", "reduce the surface first");
    }
  }
  if (parts.empty())
    parts.push_back({readSurface(file), {}, 1, -1});
  return parts;
}

void writeSurface(const std::filesystem::path& file, const geometry::TriangleMesh& mesh,
                  const WriteSurface& options) {
  const SurfaceFormat* format = formatOf(signatureOfEnding(file));
  if (format == nullptr || format->write == nullptr)
    throw CannotCreateError(phrase("surfaces cannot be written as \"%1\"", extensionOf(file)), file.string(),
                            phrase("use one of: %1", writtenEndings()));
  geometry::requireValid(mesh, file.string());
  if (mesh.triangles.rows() == 0)
    throw DataError("there is no triangle to write", file.string(), "choose a surface that has some");
  const geometry::TriangleMesh written = inSpace(mesh, options.space);
  writeAtomically(file, [&](std::ostream& out) { format->write(out, written, options); });
}

} // namespace viscera::medical_io
