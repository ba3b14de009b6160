#include "viscera/medical_io/displacement_file.h"

#include <bit>
#include <ostream>
#include <string>

#include "file_bytes.h"
#include "surface_formats.h"
#include "text_scanner.h"
#include "vector_image.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

static_assert(std::endian::native == std::endian::little, "the headers say so");

std::string axisSizes(const Eigen::Vector3i& size) {
  return std::to_string(size[0]) + " " + std::to_string(size[1]) + " " + std::to_string(size[2]);
}

std::string nrrdText(const deformation::DisplacementGrid& grid) {
  const std::string step = exactNumber(grid.spacing);
  return "NRRD0004\ntype: double\ndimension: 4\nspace: left-posterior-superior\nsizes: 3 " +
         axisSizes(grid.size) + "\nspace directions: none (" + step + ",0,0) (0," + step + ",0) (0,0," +
         step + ")\nkinds: vector domain domain domain\nendian: little\nencoding: raw\nspace origin: (" +
         exactNumber(grid.origin.x()) + "," + exactNumber(grid.origin.y()) + "," +
         exactNumber(grid.origin.z()) + ")\n\n";
}

std::string metaImageText(const deformation::DisplacementGrid& grid) {
  const std::string step = exactNumber(grid.spacing);
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = " +
         exactNumber(grid.origin.x()) + " " + exactNumber(grid.origin.y()) + " " +
         exactNumber(grid.origin.z()) +
         "\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = " + step + " " + step +
         " " + step + "\nDimSize = " + axisSizes(grid.size) +
         "\nElementNumberOfChannels = 3\nElementType = MET_DOUBLE\nElementDataFile = LOCAL\n";
}

} // namespace

void writeDisplacements(const std::filesystem::path& file, const geometry::TriangleMesh& rest,
                        const Points& moved, const std::string& name) {
  if (extensionOf(file) != ".vtp")
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(extensionOf(file))),
                            file.string(), phrase("let its name end in %1", ".vtp"));
  if (moved.rows() != rest.points.rows())
    throw DataError(misuse("It has %1 moved points for %2 vertices", moved.rows(), rest.points.rows()),
                    file.string());
  geometry::requireValid(rest, file.string());
  const PointVectors vectors{"displacement", moved - rest.points};
  writeAtomically(file, [&](std::ostream& out) { writeVtp(out, rest, {.name = name}, &vectors); });
}

void writeTransform(const std::filesystem::path& file, const deformation::DisplacementGrid& grid) {
  const std::string ending = extensionOf(file);
  if (ending == ".nii" || ending == ".nii.gz")
    return writeVectorImage(file, {grid.size[0], grid.size[1], grid.size[2]},
                            Eigen::Translation3d(grid.origin) * Eigen::Scaling(grid.spacing), grid.vectors);
  if (ending != ".nrrd" && ending != ".mha")
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(ending)), file.string(),
                            phrase("let its name end in %1", ".nrrd, .mha, .nii.gz, .nii"));
  writeAtomically(file, [&](std::ostream& out) {
    out << (ending == ".nrrd" ? nrrdText(grid) : metaImageText(grid));
    out.write(reinterpret_cast<const char*>(grid.vectors.data()),
              static_cast<std::streamsize>(sizeof(double)) * grid.vectors.size());
  });
}

} // namespace viscera::medical_io
