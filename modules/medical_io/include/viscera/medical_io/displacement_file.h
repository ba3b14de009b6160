#pragma once

#include <filesystem>
#include <string>

#include "viscera/core/arrays.h"
#include "viscera/deformation/inverse_displacements.h"
#include "viscera/geometry/triangle_mesh.h"

/// Writes displacements of tissue for other programs.
namespace viscera::medical_io {

/// Writes a surface at rest with the vector "displacement" (mm, LPS, where each vertex went) as VTP, for
/// ParaView's glyphs and its Warp By Vector. Atomic. Throws `CannotCreateError` when the file cannot be
/// written or does not end in .vtp, `DataError` when there are not as many moved points as vertices.
void writeDisplacements(const std::filesystem::path& file, const geometry::TriangleMesh& rest,
                        const Points& moved, const std::string& name);

/// Writes a displacement field as an image of vectors: NRRD (.nrrd), MetaImage (.mha) or NIfTI (.nii,
/// .nii.gz; five dimensions, intent code 1007, as ANTs and ITK have them), doubles; the vectors are LPS mm in
/// all. 3D Slicer and ITK take such a file as a resampling transform: the vector at x leads from the posed
/// space to where that tissue was at rest, which is what `inverseDisplacements` gives. Slicer sets it as the
/// transform *from* parent, so that a rest surface put under it is shown posed. Atomic. Throws
/// `CannotCreateError` when the file cannot be written or has another ending.
void writeTransform(const std::filesystem::path& file, const deformation::DisplacementGrid& grid);

} // namespace viscera::medical_io
