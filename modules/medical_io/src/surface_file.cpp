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
  std::string_view extension;
  Signature signature;
  RawSurface (*read)(const FileBytes&);
  void (*write)(std::ostream&, const geometry::TriangleMesh&, const WriteSurface&);
};

const std::array<SurfaceFormat, 8>& formats() {
  static const std::array<SurfaceFormat, 8> kSurfaceFormats = {{
      {".stl", Signature::stl, readStl, writeStl},
      {".obj", Signature::obj, readObj, writeObj},
      {".ply", Signature::ply, readPly, writePly},
      {".off", Signature::off, readOff, writeOff},
      {".vtk", Signature::legacyVtk, readLegacyVtk, writeLegacyVtk},
      {".vtp", Signature::vtp, readVtp, writeVtp},
      {".glb", Signature::glb, readGltf, writeGlb},
      {".gltf", Signature::gltf, readGltf, nullptr},
  }};
  return kSurfaceFormats;
}

const SurfaceFormat* formatOf(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  const auto& all = formats();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const SurfaceFormat& f) { return f.extension == extension; });
  return found == all.end() ? nullptr : &*found;
}

std::string extensionList(bool writable) {
  std::string list;
  for (const SurfaceFormat& format : formats())
    if (!writable || format.write != nullptr)
      list += (list.empty() ? "" : ", ") + std::string(format.extension);
  return list;
}

/// Names the real kind of a file whose name promises another. A file of no recognisable kind goes to the
/// reader that its name asks for, which says what is wrong.
void requireKind(const FileBytes& file, const SurfaceFormat& format) {
  const Signature found = signatureOf(file);
  if (found == Signature::unknown || found == format.signature)
    return;
  failAsAnotherKind(file, found, "export it as a surface of triangles");
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
  const SurfaceFormat* format = formatOf(file);
  if (format == nullptr) {
    bytes.fail(looksLike(phrase("Viscera reads no surface files that end in \"%1\"", extensionOf(file)),
                         signatureOf(bytes)),
               phrase("known endings: %1", extensionList(false)));
  }
  requireKind(bytes, *format);
  try {
    return format->read(bytes);
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
    requireKind(bytes, *formatOf(file));
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
  const SurfaceFormat* format = formatOf(file);
  if (format == nullptr || format->write == nullptr)
    throw CannotCreateError(phrase("surfaces cannot be written as \"%1\"", extensionOf(file)), file.string(),
                            phrase("use one of: %1", extensionList(true)));
  geometry::requireValid(mesh, file.string());
  if (mesh.triangles.rows() == 0)
    throw DataError("there is no triangle to write", file.string(), "choose a surface that has some");
  const geometry::TriangleMesh written = inSpace(mesh, options.space);
  writeAtomically(file, [&](std::ostream& out) { format->write(out, written, options); });
}

const std::vector<std::string>& surfaceExtensions() {
  static const std::vector<std::string> kExtensions = [] {
    std::vector<std::string> list;
    for (const SurfaceFormat& format : formats())
      list.emplace_back(format.extension);
    return list;
  }();
  return kExtensions;
}

} // namespace viscera::medical_io
