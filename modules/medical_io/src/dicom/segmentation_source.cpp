#include "dicom/segmentation_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dicom/dicom_kinds.h"
#include "dicom/dicom_load.h"
#include "dicom/dicom_mark.h"
#include "dicom/dicom_text.h"
#include "dicom/structure_grid.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

namespace viscera::medical_io {
namespace {

constexpr double kSameVoxel = 0.1;         ///< Of a voxel: centres that are nearer are the same.
constexpr double kSameSliceSpacing = 0.02; ///< Of the spacing.
constexpr int kDeepestReference = 8;

/// Sequences below which references to images are.
bool leadsToReferences(const DcmTagKey& key) {
  static const std::array<DcmTagKey, 7> kSequences = {DCM_ReferencedSeriesSequence,
                                                      DCM_ReferencedInstanceSequence,
                                                      DCM_DerivationImageSequence,
                                                      DCM_SourceImageSequence,
                                                      DCM_StudiesContainingOtherReferencedInstancesSequence,
                                                      DCM_SharedFunctionalGroupsSequence,
                                                      DCM_PerFrameFunctionalGroupsSequence};
  return std::find(kSequences.begin(), kSequences.end(), key) != kSequences.end();
}

void collectReferences(DcmItem& item, SegmentationSource& source, int depth) {
  if (depth > kDeepestReference)
    return;
  DcmObject* at = nullptr;
  while ((at = item.nextInContainer(at)) != nullptr) {
    auto* sequence = dynamic_cast<DcmSequenceOfItems*>(at);
    const DcmTagKey key = at->getTag().getXTag();
    if (sequence == nullptr || !leadsToReferences(key))
      continue;
    DcmObject* inner = nullptr;
    while ((inner = sequence->nextInContainer(inner)) != nullptr) {
      auto* one = dynamic_cast<DcmItem*>(inner);
      if (one == nullptr)
        continue;
      if (key == DCM_ReferencedSeriesSequence)
        source.series.insert(codeAt(*one, DCM_SeriesInstanceUID));
      if (key == DCM_ReferencedInstanceSequence || key == DCM_SourceImageSequence)
        source.instances.insert(codeAt(*one, DCM_ReferencedSOPInstanceUID));
      collectReferences(*one, source, depth + 1);
    }
  }
}

/// Whether every voxel of the segmentation is one of the series. `step` is how many slices of the series are
/// from one of the segmentation to the next.
bool liesOn(const SegmentationGrid& grid, const ScanSeries& series, int& step) {
  const Eigen::Affine3d toSeries = series.indexToLps.inverse() * grid.indexToLps;
  Eigen::Affine3d whole = toSeries;
  whole.matrix() = toSeries.matrix().array().round().matrix();
  const Vec3 i = whole.linear().col(0), j = whole.linear().col(1), k = whole.linear().col(2);
  step = 1;
  if (i.cwiseAbs().sum() != 1 || j.cwiseAbs().sum() != 1 || i.cross(j).squaredNorm() != 1)
    return false;
  if (grid.size[2] > 1) { // A single slice has no step: its thickness is no distance.
    step = static_cast<int>(std::lround(k.norm()));
    if (step < 1 || k.cross(i.cross(j)).squaredNorm() != 0)
      return false;
  }
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 own;
    for (int axis = 0; axis < 3; ++axis)
      own[axis] = (corner >> axis & 1) != 0 ? grid.size[std::size_t(axis)] - 1 : 0;
    const Vec3 there = whole * own;
    if (!((toSeries * own - there).cwiseAbs().maxCoeff() <= kSameVoxel))
      return false;
    for (int axis = 0; axis < 3; ++axis)
      if (there[axis] < 0 || there[axis] > series.size[std::size_t(axis)] - 1)
        return false;
  }
  return true;
}

std::string seriesUidOf(const ScanSeries& series) {
  return series.id.substr(0, series.id.find_first_of("#@"));
}

bool hasReferencedImage(const SegmentationSource& segmentation, const ScanSeries& series) {
  return std::any_of(series.files.begin(), series.files.end(), [&](const std::filesystem::path& file) {
    try {
      return segmentation.instances.contains(readDicomHeader(file).instanceUid);
    } catch (const DataError&) {
      return false;
    }
  });
}

/// Contours have no voxels: its grid is the one that they are filled on.
SegmentationSource structureSource(const FileBytes& file) {
  StructureSet set = readStructureSet(file);
  const StructureGrid grid = structureGrid(set, file);
  SegmentationSource source;
  source.frameOfReference = set.frameOfReference;
  source.contours = true;
  source.grid = {grid.size, grid.indexToLps, {}};
  source.series = std::move(set.series);
  source.instances = std::move(set.instances);
  ScanSeries& own = source.described;
  own.id = set.seriesUid;
  own.description = set.description;
  own.modality = "RTSTRUCT";
  own.size = grid.size;
  own.indexToLps = grid.indexToLps;
  own.spacing = grid.indexToLps.linear().colwise().norm();
  own.frameOfReference = source.frameOfReference;
  own.files = {file.file};
  return source;
}

} // namespace

SegmentationSource segmentationSource(const std::filesystem::path& file) {
  DcmFileFormat format;
  FileBytes named{file, {}};
  std::error_code error;
  named.length = std::filesystem::file_size(file, error);
  if (isStructureSetClass(dicomClass(file)))
    return structureSource(named);
  loadDicom(format, named);
  const DicomHeader header = dicomHeaderOf(file, format);
  if (!header.notAScan.empty())
    named.fail(phrase("It is a segmentation that %1", header.notAScan), "convert it to .seg.nrrd");
  SegmentationSource source;
  source.frameOfReference = header.frameOfReference;
  source.grid = segmentationGrid(header, named);
  const DicomFrame& first = header.frames.front();
  source.sliceSpacing = first.betweenSlices > 0 ? first.betweenSlices : first.thickness;
  collectReferences(*format.getDataset(), source, 0);
  source.series.erase("");
  source.instances.erase("");
  ScanSeries& own = source.described;
  own.id = header.seriesUid;
  own.description = header.description;
  own.modality = header.modality;
  own.size = source.grid.size;
  own.indexToLps = source.grid.indexToLps;
  own.spacing = own.indexToLps.linear().colwise().norm();
  own.frameOfReference = header.frameOfReference;
  own.files = {file};
  return source;
}

std::string frameOfReferenceIn(const std::filesystem::path& file) {
  DcmFileFormat format;
  try {
    loadDicom(format, FileBytes{file, {}});
  } catch (const DataError&) {
    return {};
  }
  return codeAt(*format.getDataset(), DCM_FrameOfReferenceUID);
}

bool isMadeFrom(const SegmentationSource& segmentation, const ScanSeries& series) {
  if (segmentation.frameOfReference.empty() || segmentation.frameOfReference != series.frameOfReference)
    return false;
  const bool refers = !segmentation.series.empty();
  if (refers && !segmentation.series.contains(seriesUidOf(series)))
    return false;
  if (segmentation.contours)
    return refers || segmentation.instances.empty() || hasReferencedImage(segmentation, series);
  int step = 1;
  if (!liesOn(segmentation.grid, series, step))
    return false;
  // A thick series may have its slices among those of a thin one.
  const double spacing = segmentation.sliceSpacing > 0 ? segmentation.sliceSpacing : series.spacing[2];
  if (step > 1 && !refers && std::abs(spacing - series.spacing[2]) > kSameSliceSpacing * series.spacing[2])
    return false;
  return refers || segmentation.instances.empty() || hasReferencedImage(segmentation, series);
}

} // namespace viscera::medical_io
