#include "dicom_files.h"

#include <memory>
#include <stdexcept>

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmiod/iodmacro.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include "temporary_folder.h"

namespace viscera::tests {
namespace {

constexpr Uint8 kLargestFraction = 200;

void require(const OFCondition& condition) {
  if (condition.bad())
    throw std::runtime_error(std::string("DCMTK cannot write: ") + condition.text());
}

/// Decimal strings of DICOM have 16 characters at most.
OFString text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.9g", value);
  return buffer;
}

class Writer {
public:
  Writer(const LabelImage& image, const DicomWriting& writing)
      : image_(image), writing_(writing), spacing_(image.indexToLps.linear().colwise().norm()) {}

  std::string run() {
    create();
    addSharedGroups();
    for (std::size_t segment = 0; segment < writing_.names.size(); ++segment)
      addSegment(segment);
    DcmDataset dataset;
    require(segmentation_->writeDataset(dataset));
    if (!writing_.characterSet.empty())
      require(dataset.putAndInsertString(DCM_SpecificCharacterSet, writing_.characterSet.c_str()));
    const TemporaryFolder folder;
    DcmFileFormat format(&dataset);
    require(format.saveFile((folder / "a.dcm").c_str(), EXS_LittleEndianExplicit));
    return contentsOf(folder / "a.dcm");
  }

private:
  void create() {
    const IODGeneralEquipmentModule::EquipmentInfo equipment("Viscera", "0", "test", "0");
    ContentIdentificationMacro content;
    require(content.setInstanceNumber("1"));
    require(content.setContentLabel("SEG"));
    require(content.setContentDescription("organs"));
    require(content.setContentCreatorName("Viscera"));
    const auto rows = static_cast<Uint16>(image_.size[1]), columns = static_cast<Uint16>(image_.size[0]);
    DcmSegmentation* made = nullptr;
    if (writing_.fractional)
      require(DcmSegmentation::createFractionalSegmentation(made, rows, columns, DcmSegTypes::SFT_PROBABILITY,
                                                            kLargestFraction, equipment, content));
    else
      require(DcmSegmentation::createBinarySegmentation(made, rows, columns, equipment, content));
    segmentation_.reset(made);
    segmentation_->setCheckFGOnWrite(OFFalse);
    segmentation_->setCheckDimensionsOnWrite(OFFalse);
    require(segmentation_->getSeries().setSeriesNumber("1"));
    require(segmentation_->getFrameOfReference().setFrameOfReferenceUID("1.2.3.4"));
    require(segmentation_->getDimensions().addDimensionIndex(DCM_ReferencedSegmentNumber, "1.2.3.5",
                                                             DCM_SegmentIdentificationSequence, "segment"));
  }

  void addSharedGroups() {
    const Vec3 row = image_.indexToLps.linear().col(0) / spacing_[0];
    const Vec3 column = image_.indexToLps.linear().col(1) / spacing_[1];
    const std::unique_ptr<FGPlaneOrientationPatient> plane(FGPlaneOrientationPatient::createMinimal(
        text(row[0]), text(row[1]), text(row[2]), text(column[0]), text(column[1]), text(column[2])));
    require(segmentation_->addForAllFrames(*plane));
    FGPixelMeasures measures;
    require(measures.setPixelSpacing(text(spacing_[1]) + "\\" + text(spacing_[0])));
    require(measures.setSliceThickness(text(spacing_[2])));
    require(measures.setSpacingBetweenSlices(text(spacing_[2])));
    require(segmentation_->addForAllFrames(measures));
  }

  void addSegment(std::size_t index) {
    DcmSegment* segment = nullptr;
    require(DcmSegment::create(
        segment, writing_.names[index].c_str(), CodeSequenceMacro("85756007", "SCT", "Tissue"),
        CodeSequenceMacro("10200004", "SCT", "Liver"), DcmSegTypes::SAT_AUTOMATIC, "test"));
    // Full lightness and next to no colour, then a strong red.
    require(index == 0 ? segment->setRecommendedDisplayCIELabValue(65535, 32896, 32896)
                       : segment->setRecommendedDisplayCIELabValue(34885, 53485, 50171));
    Uint16 number = 0;
    require(segmentation_->addSegment(segment, number));
    for (int k = 0; k < image_.size[2]; ++k)
      addFrame(static_cast<std::int16_t>(index + 1), number, k);
  }

  void addFrame(std::int16_t label, Uint16 segment, int k) {
    const std::size_t pixels = std::size_t(image_.size[0]) * std::size_t(image_.size[1]);
    std::vector<Uint8> frame(pixels);
    bool empty = true;
    for (std::size_t p = 0; p < pixels; ++p) {
      const bool inside = image_.voxels[std::size_t(k) * pixels + p] == label;
      empty = empty && !inside;
      frame[p] = writing_.fractional ? (inside ? kLargestFraction : p % 4 == 0 ? 0 : 20) : (inside ? 1 : 0);
    }
    if (empty && writing_.withoutEmptyFrames)
      return;
    const double off = k + 1 == image_.size[2] ? writing_.lastSliceOffMm : 0;
    const Vec3 position =
        image_.indexToLps * Vec3(0, 0, k) + off * image_.indexToLps.linear().col(2).normalized();
    const std::unique_ptr<FGPlanePosPatient> place(
        FGPlanePosPatient::createMinimal(text(position[0]), text(position[1]), text(position[2])));
    FGFrameContent content;
    require(content.setStackID("1"));
    require(content.setInStackPositionNumber(static_cast<Uint32>(k + 1)));
    require(content.setDimensionIndexValues(segment, 0));
    OFVector<FGBase*> groups;
    groups.push_back(place.get());
    groups.push_back(&content);
    require(segmentation_->addFrame(frame.data(), segment, groups));
  }

  const LabelImage& image_;
  const DicomWriting& writing_;
  Vec3 spacing_;
  std::unique_ptr<DcmSegmentation> segmentation_;
};

} // namespace

std::string dicomFile(const LabelImage& image, const DicomWriting& writing) {
  return Writer(image, writing).run();
}

} // namespace viscera::tests
