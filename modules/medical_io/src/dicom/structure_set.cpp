#include "dicom/structure_set.h"

#include <algorithm>
#include <map>

#include "dicom/dicom_load.h"
#include "dicom/dicom_text.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

namespace viscera::medical_io {
namespace {

/// Calls `visit` with every item of a sequence; with none where it is missing.
template <class Visit>
void forEachItem(DcmItem& item, const DcmTagKey& key, const Visit& visit) {
  DcmSequenceOfItems* sequence = nullptr;
  if (item.findAndGetSequence(key, sequence).bad() || sequence == nullptr)
    return;
  DcmObject* at = nullptr;
  while ((at = sequence->nextInContainer(at)) != nullptr)
    if (auto* one = dynamic_cast<DcmItem*>(at))
      visit(*one);
}

std::optional<int> numberOf(DcmItem& item, const DcmTagKey& key) {
  Sint32 number = 0;
  return item.findAndGetSint32(key, number).good() ? std::optional<int>(number) : std::nullopt;
}

class StructureSetReader {
public:
  explicit StructureSetReader(const FileBytes& file) : file_(file) {}

  StructureSet run() {
    loadDicom(format_, file_);
    DcmDataset& dataset = *format_.getDataset();
    set_.seriesUid = codeAt(dataset, DCM_SeriesInstanceUID);
    set_.description = textAt(dataset, dataset, DCM_StructureSetLabel);
    if (set_.description.empty())
      set_.description = textAt(dataset, dataset, DCM_SeriesDescription);
    readReferences(dataset);
    readRegions(dataset);
    readContours(dataset);
    return std::move(set_);
  }

private:
  void readReferences(DcmDataset& dataset) {
    forEachItem(dataset, DCM_ReferencedFrameOfReferenceSequence, [this](DcmItem& frame) {
      if (set_.frameOfReference.empty())
        set_.frameOfReference = codeAt(frame, DCM_FrameOfReferenceUID);
      forEachItem(frame, DCM_RTReferencedStudySequence, [this](DcmItem& study) {
        forEachItem(study, DCM_RTReferencedSeriesSequence, [this](DcmItem& series) {
          set_.series.insert(codeAt(series, DCM_SeriesInstanceUID));
          forEachItem(series, DCM_ContourImageSequence, [this](DcmItem& image) {
            set_.instances.insert(codeAt(image, DCM_ReferencedSOPInstanceUID));
          });
        });
      });
    });
    set_.series.erase("");
    set_.instances.erase("");
    if (set_.frameOfReference.empty())
      set_.frameOfReference = codeAt(dataset, DCM_FrameOfReferenceUID);
  }

  /// Two coordinate systems cannot share one grid: those of the first one are read.
  bool isElsewhere(DcmItem& item) const {
    const std::string frame = codeAt(item, DCM_ReferencedFrameOfReferenceUID);
    return !frame.empty() && !set_.frameOfReference.empty() && frame != set_.frameOfReference;
  }

  void readRegions(DcmDataset& dataset) {
    forEachItem(dataset, DCM_StructureSetROISequence, [&](DcmItem& item) {
      const std::optional<int> number = numberOf(item, DCM_ROINumber);
      if (!number)
        file_.fail(diagnostic("its structures cannot be read: a region has no number"));
      if (isElsewhere(item)) {
        ++set_.elsewhere;
        return;
      }
      if (placeOf_.emplace(*number, set_.regions.size()).second)
        set_.regions.push_back({*number, textAt(dataset, item, DCM_ROIName), std::nullopt, {}});
    });
    if (set_.regions.empty())
      file_.fail("It is a structure set without regions of interest", "export the contours again");
  }

  void readContours(DcmDataset& dataset) {
    forEachItem(dataset, DCM_ROIContourSequence, [this](DcmItem& item) {
      const std::optional<int> number = numberOf(item, DCM_ReferencedROINumber);
      const auto place = number ? placeOf_.find(*number) : placeOf_.end();
      if (place == placeOf_.end())
        return;
      DrawnRegion& region = set_.regions[place->second];
      if (const std::vector<double> color = numbersAt(item, DCM_ROIDisplayColor); color.size() == 3)
        region.color = (Vec3(color[0], color[1], color[2]) / 255).cwiseMax(0).cwiseMin(1);
      forEachItem(item, DCM_ContourSequence, [&](DcmItem& contour) { readContour(contour, region); });
    });
  }

  void readContour(DcmItem& item, DrawnRegion& region) {
    const std::string type = codeAt(item, DCM_ContourGeometricType);
    if (!type.empty() && !type.starts_with("CLOSED")) { // CLOSEDPLANAR_XOR of 2019 is closed as well.
      ++set_.notClosed;
      return;
    }
    const std::vector<double> numbers = numbersAt(item, DCM_ContourData);
    const std::size_t corners = numbers.size() / 3;
    const std::optional<int> stated = numberOf(item, DCM_NumberOfContourPoints);
    if (numbers.empty() || numbers.size() % 3 != 0 || (stated && std::size_t(*stated) != corners)) {
      ++set_.damaged;
      return;
    }
    if (corners < 3) {
      ++set_.notClosed;
      return;
    }
    region.closed.push_back(Eigen::Map<const Points>(numbers.data(), static_cast<Eigen::Index>(corners), 3));
  }

  const FileBytes& file_;
  DcmFileFormat format_;
  StructureSet set_;
  std::map<int, std::size_t> placeOf_; ///< In `regions`, by their numbers.
};

} // namespace

StructureSet readStructureSet(const FileBytes& file) {
  return StructureSetReader(file).run();
}

} // namespace viscera::medical_io
