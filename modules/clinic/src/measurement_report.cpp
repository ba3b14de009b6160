#include "viscera/clinic/measurement_report.h"

#include <cstdio>

#include "dicom_object.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

#include <dcmtk/dcmsr/cmr/tid1500.h>
#include <dcmtk/dcmsr/dsrdoc.h>

namespace viscera::clinic {
namespace {

using Report = TID1500_MeasurementReport;
using Units = CID7181_AbstractMultiDimensionalImageModelComponentUnits;

constexpr std::size_t kLongestMeaning = 64; ///< Letters of a code's meaning.

void require(const OFCondition& done, const std::string& what) {
  if (done.bad())
    throw CannotCreateError(misuse("DCMTK cannot write the report: %1", std::string(done.text())), what);
}

DSRCodedEntryValue entry(const std::string& value, const std::string& scheme, const std::string& meaning) {
  return {value.c_str(), scheme.c_str(), meaning.c_str()};
}

DSRCodedEntryValue entry(const Code& code) {
  return entry(code.value, code.scheme, code.meaning);
}

std::string sixDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// A group of either template. The method stands beside the number, in words.
template <class Group>
void putMeasurements(Group& group, const MeasuredOrgan& organ) {
  require(group.setTrackingIdentifier(organ.name.c_str()), organ.name);
  require(group.setTrackingUniqueIdentifier(organ.trackingUid.c_str()), organ.name);
  if (!organ.timePoint.empty())
    require(group.setTimePoint(organ.timePoint.c_str()), organ.name);
  const PartCode code = codeOf(organ.name);
  require(group.setFinding(entry(code.type)), organ.name);
  for (const WrittenMeasurement& one : organ.measurements) {
    const typename Group::MeasurementValue value(sixDigits(one.value).c_str(),
                                                 Units(entry(one.unit, "UCUM", one.unitMeaning)));
    const CID7469_GenericIntensityAndSizeMeasurements quantity(
        entry(one.quantity.code, one.quantity.scheme, one.quantity.meaning));
    require(group.addMeasurement(quantity, value, OFFalse, OFFalse), organ.name);
    if (!one.method.empty())
      require(
          group.getMeasurement().setMeasurementMethod(
              CID6147_ResponseCriteria(entry("METHOD", "99VISCERA", one.method.substr(0, kLongestMeaning))),
              OFFalse),
          organ.name);
  }
}

void putOrgan(Report& report, const StudyIdentity& identity, const std::optional<WrittenObject>& segmentation,
              const MeasuredOrgan& organ) {
  if (organ.measurements.empty())
    throw DataError("It has no measurement", organ.name);
  if (!organ.segment) {
    require(report.addIndividualMeasurements(), organ.name);
    putMeasurements(report.getIndividualMeasurements(), organ);
    return;
  }
  if (!segmentation)
    throw DataError("Its segment is named without the segmentation", organ.name,
                    "write the segmentation too");
  require(report.addVolumetricROIMeasurements(), organ.name);
  auto& group = report.getVolumetricROIMeasurements();
  DSRImageReferenceValue segment(segmentation->classUid.c_str(), segmentation->instanceUid.c_str(), OFFalse);
  segment.getSegmentList().addItem(static_cast<Uint16>(*organ.segment));
  require(group.setReferencedSegment(segment, OFFalse), organ.name);
  const std::string& source = identity.seriesUid.empty() ? segmentation->seriesUid : identity.seriesUid;
  require(group.setSourceSeriesForSegmentation(source.c_str()), organ.name);
  putMeasurements(group, organ);
}

/// What the report refers to has to be listed with its study and series.
void putEvidence(DSRDocument& document, const StudyIdentity& identity,
                 const std::optional<WrittenObject>& segmentation) {
  auto& evidence = document.getCurrentRequestedProcedureEvidence();
  if (segmentation)
    evidence.addItem(identity.studyUid.c_str(), segmentation->seriesUid.c_str(),
                     segmentation->classUid.c_str(), segmentation->instanceUid.c_str());
  for (const SourceImage& image : identity.images)
    evidence.addItem(identity.studyUid.c_str(), identity.seriesUid.c_str(), image.classUid.c_str(),
                     image.instanceUid.c_str());
}

} // namespace

WrittenObject writeMeasurementReport(const std::filesystem::path& file, const StudyIdentity& identity,
                                     const ObjectSeries& series,
                                     const std::optional<WrittenObject>& segmentation,
                                     const std::vector<MeasuredOrgan>& organs) {
  const std::string name = file.string();
  Report report(CID7021_MeasurementReportDocumentTitles::ImagingMeasurementReport);
  require(report.setLanguage(CID5000_Languages::English_US), name);
  require(report.getObservationContext().addDeviceObserver(uidFrom(series.instanceUid, "observer").c_str(),
                                                           "Viscera", "Viscera", "Viscera", "", ""),
          name);
  require(report.addProcedureReported(CID100_QuantitativeDiagnosticImagingProcedures::ImagingProcedure),
          name);
  for (const MeasuredOrgan& organ : organs)
    putOrgan(report, identity, segmentation, organ);
  DSRDocument document;
  require(document.setTreeFromRootTemplate(report, OFTrue /* expand templates */), name);
  putEvidence(document, identity, segmentation);
  DcmFileFormat format;
  DcmDataset& dataset = *format.getDataset();
  require(document.write(dataset), name);
  dataset.findAndDeleteElement(DCM_ContentDate);
  dataset.findAndDeleteElement(DCM_ContentTime);
  const OFString classUid = document.getDocumentType() == DSRTypes::DT_invalid
                                ? OFString()
                                : OFString(DSRTypes::documentTypeToSOPClassUID(document.getDocumentType()));
  putCommon(dataset, identity, series, classUid.c_str(), "SR");
  put(dataset, DCM_ContentDate, series.dateTime.substr(0, 8));
  put(dataset, DCM_ContentTime, series.dateTime.substr(8));
  return save(format, file, series);
}

} // namespace viscera::clinic
