#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/clinic/study_identity.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

/// Writes what a program gives back to a hospital's archive, as DICOM objects for research and teaching. Each
/// function writes one file, whole or not at all, in UTF-8, explicit or implicit little-endian without
/// compression. Texts of organs are the caller's: `withoutIdentity` does not look into them.
namespace viscera::clinic {

/// An organ's closed surface in one pose.
struct WrittenOrgan {
  std::string name;              ///< Never empty; its SNOMED code is that of `anatomy`'s row for it.
  Vec3 color = {0.8, 0.45, 0.4}; ///< 0 to 1, sRGB.
  const geometry::TriangleMesh* surface = nullptr; ///< mm LPS, outward.
};

/// What all objects of one export share.
struct ObjectSeries {
  std::string seriesUid;   ///< Of the new series; each kind of object has one of its own.
  int number = 900;        ///< Of the series.
  std::string description; ///< "Organs of Viscera"
  std::string dateTime;    ///< When it is made: "20240301143000".
  int instance = 1;        ///< Number of the object in its series.
  std::string instanceUid; ///< Of the object.
  std::string note;        ///< "phase 3 of 25, 240 ms"; may be empty.
};

/// The UID of an object in what refers to it.
struct WrittenObject {
  std::string classUid, instanceUid, seriesUid;
  std::vector<std::string> segments; ///< Of a segmentation: names of its segments, numbered from 1.
};

/// The grid of the images that an identity refers to; else one of `spacing` mm around the organs.
/// `size` voxels, `indexToLps` of their centres.
struct WrittenGrid {
  std::array<int, 3> size = {};
  Eigen::Affine3d indexToLps = Eigen::Affine3d::Identity();
};

/// The images' own grid; throws `DataError` where they have none: fewer than two, or at unequal distances.
WrittenGrid gridOfImages(const StudyIdentity& identity);
/// A grid along the axes around all organs, with a voxel's margin. Throws `DataError` when it would have more
/// than 65535 voxels along an axis.
WrittenGrid gridAround(const std::vector<WrittenOrgan>& organs, double spacingMm);

/// A binary segmentation (PS3.3, A.51) with a segment for each organ, which may overlap: the voxels of `grid`
/// whose centres lie within the surface. Frames without voxels are left out. Throws `DataError` for an organ
/// without a voxel in the grid, `CannotCreateError`, `Cancelled`. O(voxels x organs).
WrittenObject writeSegmentation(const std::filesystem::path& file, const StudyIdentity& identity,
                                const ObjectSeries& series, const WrittenGrid& grid,
                                const std::vector<WrittenOrgan>& organs, Progress& progress);

/// An RT Structure Set (PS3.3, A.19) with the organs' contours in the planes of the identity's images. Inner
/// contours are holes. Throws `DataError` without images, and for an organ that none of them crosses.
WrittenObject writeStructureSet(const std::filesystem::path& file, const StudyIdentity& identity,
                                const ObjectSeries& series, const std::vector<WrittenOrgan>& organs,
                                Progress& progress);

/// One organ as Encapsulated STL (PS3.3, A.85.1) in mm LPS.
WrittenObject writeSurfaceObject(const std::filesystem::path& file, const StudyIdentity& identity,
                                 const ObjectSeries& series, const WrittenOrgan& organ);

/// A PDF document (PS3.3, A.45.1). Throws `DataError` for bytes that are no PDF.
WrittenObject writeDocumentObject(const std::filesystem::path& file, const StudyIdentity& identity,
                                  const ObjectSeries& series, const std::string& title, std::string_view pdf);

} // namespace viscera::clinic
