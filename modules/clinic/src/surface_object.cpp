#include <cstring>
#include <string>

#include "dicom_object.h"
#include "encapsulated.h"

namespace viscera::clinic {
namespace {

template <class Value>
void append(std::string& bytes, Value value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// Binary STL; the program runs on little-endian machines only.
std::string stlOf(const geometry::TriangleMesh& mesh) {
  std::string bytes = "mm, LPS";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.rows()));
  bytes.reserve(84 + 50 * static_cast<std::size_t>(mesh.triangles.rows()));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)),
               c = mesh.points.row(mesh.triangles(t, 2));
    for (const Vec3& row : {Vec3((b - a).cross(c - a).stableNormalized()), a, b, c})
      for (int axis = 0; axis < 3; ++axis)
        append(bytes, static_cast<float>(row[axis]));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

} // namespace

WrittenObject writeSurfaceObject(const std::filesystem::path& file, const StudyIdentity& identity,
                                 const ObjectSeries& series, const WrittenOrgan& organ) {
  DcmFileFormat format;
  DcmDataset& dataset = *format.getDataset();
  putCommon(dataset, identity, series, UID_EncapsulatedSTLStorage, "M3D");
  put(dataset, DCM_FrameOfReferenceUID, identity.frameOfReference);
  put(dataset, DCM_PositionReferenceIndicator, "");
  putCode(dataset, DCM_MeasurementUnitsCodeSequence, {"mm", "UCUM", "millimeter"});
  put(dataset, DCM_ModelModification, "NO");
  put(dataset, DCM_ModelMirroring, "NO");
  putColor(dataset, organ.color);
  const PartCode code = codeOf(organ.name);
  putCode(dataset, DCM_AnatomicRegionSequence, code.type);
  putEncapsulated(dataset, series, organ.name, "model/stl", stlOf(*organ.surface));
  return save(format, file, series);
}

} // namespace viscera::clinic
