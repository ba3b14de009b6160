#include "viscera/medical_io/surface_file.h"

#include <algorithm>
#include <array>
#include <new>
#include <string_view>
#include <utility>

#include "dicom/encapsulated_surface.h"
#include "file_bytes.h"
#include "file_signature.h"
#include "image_formats/unpack.h"
#include "mesh_formats/cell_mesh.h"
#include "raw_surface.h"
#include "surface_formats.h"
#include "surface_parts.h"
#include "text_scanner.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/cell_file.h"
#include "viscera/medical_io/organ_names.h"

namespace viscera::medical_io {
namespace {

struct SurfaceFormat {
  Signature signature;
  RawSurface (*read)(const FileBytes&);
  void (*write)(std::ostream&, const geometry::TriangleMesh&, const WriteSurface&);
  std::vector<RawOrgan> (*readOrgans)(const FileBytes&) = nullptr; ///< Of a mesh that may have cavities.
  CellMesh (*readCells)(const FileBytes&) = nullptr;               ///< Of a mesh of cells.
};

constexpr std::array<SurfaceFormat, 17> kSurfaceFormats = {{
    {Signature::stl, readStl, writeStl},
    {Signature::obj, readObj, writeObj},
    {Signature::ply, readPly, writePly},
    {Signature::off, readOff, writeOff},
    {Signature::legacyVtk, readLegacyVtk, writeLegacyVtk, readLegacyVtkOrgans, readLegacyVtkCells},
    {Signature::vtp, readVtp, writeVtp},
    {Signature::vtm, readVtm, nullptr},
    {Signature::glb, readGltf, writeGlb},
    {Signature::gltf, readGltf, nullptr},
    {Signature::threeMf, readThreeMf, writeThreeMf},
    {Signature::gifti, readGifti, nullptr},
    {Signature::freeSurfer, readFreeSurfer, nullptr},
    {Signature::carto, readCarto, nullptr},
    {Signature::vtu, readBoundary<readVtuCells>, nullptr, readBoundaryOrgans<readVtuCells>, readVtuCells},
    {Signature::gmsh, readBoundary<readGmshCells>, nullptr, readBoundaryOrgans<readGmshCells>, readGmshCells},
    {Signature::medit, readBoundary<readMeditCells>, nullptr, readBoundaryOrgans<readMeditCells>,
     readMeditCells},
    {Signature::openCarp, readBoundary<readOpenCarpCells>, nullptr, readBoundaryOrgans<readOpenCarpCells>,
     readOpenCarpCells},
}};

/// Null for a signature of no surface.
const SurfaceFormat* formatOf(Signature signature) {
  const auto found =
      std::find_if(kSurfaceFormats.begin(), kSurfaceFormats.end(),
                   [signature](const SurfaceFormat& format) { return format.signature == signature; });
  return found == kSurfaceFormats.end() ? nullptr : &*found;
}

const SurfaceFormat& surfaceFormatOf(const FileBytes& file) {
  return *formatOf(signatureFor(file, FileKind::surface));
}

/// Larger surfaces do not come compressed, but a small file may unpack to any size.
constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 32U;

/// The file, unpacked if it is compressed.
FileBytes readUnpacked(const std::filesystem::path& file) {
  FileBytes bytes = readWholeFile(file);
  if (signatureOf(bytes) != Signature::gzip)
    return bytes;
  try {
    std::string inside = unpacked(bytes, bytes.view(), Packing::zlib, kMostUnpacked);
    if (inside.size() == kMostUnpacked)
      bytes.fail("it does not fit into memory", "reduce the surface first");
    bytes.bytes = std::move(inside);
    bytes.length = bytes.bytes.size();
  } catch (const std::bad_alloc&) {
    bytes.fail("it does not fit into memory", "reduce the surface first");
  }
  if (bytes.bytes.empty())
    bytes.fail("the file is empty");
  return bytes;
}

std::string writtenEndings() {
  std::string list;
  for (const FileFormat& format : fileFormats())
    if (format.kind == FileKind::surface && format.written)
      list += (list.empty() ? "" : ", ") + format.endings.front();
  return list;
}

/// What `read` gives, or an error when memory is short.
template <class Read>
auto inMemory(const std::filesystem::path& file, const Read& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw DataError("it does not fit into memory", file.string(), "reduce the surface first");
  }
}

geometry::TriangleMesh inSpace(const geometry::TriangleMesh& mesh, Space space) {
  geometry::TriangleMesh result = mesh;
  if (space == Space::ras)
    result.points.leftCols<2>() = (0.0 - result.points.leftCols<2>().array()).matrix();
  return result;
}

RawSurface rawSurfaceOf(const FileBytes& file) {
  return signatureOf(file) == Signature::dicom ? readDicomSurface(file) : surfaceFormatOf(file).read(file);
}

std::vector<RawOrgan> rawOrgansOf(const FileBytes& file) {
  if (signatureOf(file) != Signature::dicom && surfaceFormatOf(file).readOrgans != nullptr)
    return surfaceFormatOf(file).readOrgans(file);
  return organsOf(rawSurfaceOf(file), file.file);
}

} // namespace

RawSurface readRawSurface(const std::filesystem::path& file) {
  return inMemory(file, [&] { return rawSurfaceOf(readUnpacked(file)); });
}

SurfaceFile readSurface(const std::filesystem::path& file, SeveralOrgans several) {
  return inMemory(file, [&] {
    RawSurface raw = readRawSurface(file);
    if (several == SeveralOrgans::join && organNames(raw, file).size() > 1) {
      if (std::any_of(raw.parts.begin(), raw.parts.end(), [](const RawPart& part) { return part.plain; }))
        raw.colors.clear();
      return assembleSurface(std::move(raw), file);
    }
    requireOneOrgan(raw, file);
    return assembleSurface(std::move(organsOf(std::move(raw), file).front().surface), file);
  });
}

std::vector<SurfacePart> readSurfaces(const std::filesystem::path& file) {
  return inMemory(file, [&] {
    const FileBytes bytes = readUnpacked(file);
    std::vector<SurfacePart> parts;
    for (RawOrgan& organ : rawOrgansOf(bytes)) {
      parts.push_back(
          {assembleSurface(std::move(organ.surface), file), organ.color, organ.opacity, organ.cavityOf});
      organ.surface = {};
    }
    warnOfNested(parts);
    return parts;
  });
}

std::optional<deformation::WitnessMesh> readCells(const std::filesystem::path& file) {
  return inMemory(file, [&]() -> std::optional<deformation::WitnessMesh> {
    const FileBytes bytes = readUnpacked(file);
    const SurfaceFormat* format = formatOf(signatureOf(bytes));
    if (format == nullptr || format->readCells == nullptr)
      return std::nullopt;
    return witnessMeshOf(format->readCells(bytes), bytes);
  });
}

std::size_t partNamed(const std::vector<SurfacePart>& parts, const std::string& name, const Text& where) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (comparableName(parts[i].surface.name) == comparableName(name))
      return i;
    names.push_back(parts[i].surface.name);
  }
  const std::optional<std::int64_t> number = parseInteger(trimmed(name));
  if (number && *number >= 1 && static_cast<std::uint64_t>(*number) <= parts.size())
    return static_cast<std::size_t>(*number - 1);
  throw noSuchOrgan(name, names, where);
}

SurfacePart readSurfacePart(const std::filesystem::path& file, const std::string& name) {
  std::vector<SurfacePart> parts = readSurfaces(file);
  return std::move(parts[partNamed(parts, name, file.string())]);
}

void writeSurface(const std::filesystem::path& file, const geometry::TriangleMesh& mesh,
                  const WriteSurface& options) {
  const bool packed = extensionWithin(file) != extensionOf(file);
  const SurfaceFormat* format = packed ? nullptr : formatOf(signatureOfEnding(file));
  if (format == nullptr || format->write == nullptr)
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(extensionOf(file))),
                            file.string(), phrase("use one of: %1", writtenEndings()));
  geometry::requireValid(mesh, file.string());
  if (mesh.triangles.rows() == 0)
    throw DataError("there is no triangle to write", file.string(), "choose a surface that has some");
  const geometry::TriangleMesh written = inSpace(mesh, options.space);
  writeAtomically(file, [&](std::ostream& out) { format->write(out, written, options); });
}

void writeSurfaces(const std::filesystem::path& file, const std::vector<NamedSurface>& surfaces,
                   Space space) {
  const Signature format = signatureOfEnding(file);
  if (format != Signature::glb && format != Signature::threeMf)
    throw CannotCreateError(phrase("several surfaces cannot be written as %1", inQuotes(extensionOf(file))),
                            file.string(), phrase("let its name end in %1", ".glb, .3mf"));
  if (surfaces.empty())
    throw DataError("there is no surface to write", file.string(), "open one first");
  std::vector<NamedSurface> written = surfaces;
  for (std::size_t i = 0; i < written.size(); ++i) {
    geometry::requireValid(*written[i].mesh, written[i].name);
    if (written[i].cavityOf >= static_cast<int>(i))
      throw DataError(misuse("surface %1 is a cavity of one that does not come before it", i), file.string());
    if (space != Space::lps)
      written[i].mesh = std::make_shared<const geometry::TriangleMesh>(inSpace(*written[i].mesh, space));
  }
  writeAtomically(file, [&](std::ostream& out) {
    (format == Signature::glb ? writeGlbParts : writeThreeMfParts)(out, written, space);
  });
}

} // namespace viscera::medical_io
