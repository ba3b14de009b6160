#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "file_bytes.h"
#include "raw_surface.h"
#include "viscera/medical_io/surface_file.h"

/// The readers and writers of surface formats, one source for each format in surface_formats/. Readers check
/// every size against the bytes that are there and throw `DataError`; none prints, and none returns a part of
/// a damaged file. Writers get a valid mesh whose coordinates are already in `options.space`.
namespace viscera::medical_io {

RawSurface readStl(const FileBytes& file);
RawSurface readObj(const FileBytes& file);
RawSurface readPly(const FileBytes& file);
RawSurface readOff(const FileBytes& file);
/// Polygons, or the surface around the cells of an unstructured grid.
RawSurface readLegacyVtk(const FileBytes& file);
RawSurface readVtp(const FileBytes& file);
/// GLB, or the JSON of a GLTF, whose buffers are beside it.
RawSurface readGltf(const FileBytes& file);
RawSurface readGifti(const FileBytes& file);
/// Binary or text.
RawSurface readFreeSurfer(const FileBytes& file);
/// A map of Biosense Webster's CARTO.
RawSurface readCarto(const FileBytes& file);

/// A 3MF package: every object that is placed is a part.
RawSurface readThreeMf(const FileBytes& file);

/// VTK's multiblock data: the surfaces beside the file that its blocks name, each a part.
RawSurface readVtm(const FileBytes& file);

void writeStl(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
void writeObj(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
void writePly(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
void writeOff(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
void writeLegacyVtk(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
void writeVtp(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
/// A vector at each point, under a name.
struct PointVectors {
  std::string name;
  Points values;
};
/// The same with vectors, unless null.
void writeVtp(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options,
              const PointVectors* vectors);
void writeGlb(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
void writeThreeMf(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options);
/// Several valid surfaces in `space`; none is within one that comes behind it.
void writeGlbParts(std::ostream& out, const std::vector<NamedSurface>& surfaces, Space space);
void writeThreeMfParts(std::ostream& out, const std::vector<NamedSurface>& surfaces, Space space);

} // namespace viscera::medical_io
