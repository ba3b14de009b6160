#include "dicom_object.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "lab_color.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/quiet_dcmtk.h"

namespace viscera::clinic {
namespace {

constexpr const char* kRootOfSoftware = "2.25.264713846402883457129045551738064951872"; ///< Of this program.

const Code kAnatomicalStructure = {"123037004", "SCT", "Anatomical Structure"};

/// The cavities of the heart are concepts of their own.
struct ChamberCode {
  anatomy::Part part;
  const char* snomed;
};
constexpr std::array<ChamberCode, 4> kChambers = {{{anatomy::kLeftVentricle, "87878005"},
                                                   {anatomy::kRightVentricle, "53085002"},
                                                   {anatomy::kLeftAtrium, "82471001"},
                                                   {anatomy::kRightAtrium, "73829009"}}};

void require(const OFCondition& done) {
  if (done.bad())
    throw CannotCreateError(misuse("DCMTK cannot write this element: %1", std::string(done.text())));
}

void putPatientAndStudy(DcmDataset& dataset, const StudyIdentity& identity) {
  put(dataset, DCM_PatientName, identity.patientName);
  put(dataset, DCM_PatientID, identity.patientId);
  put(dataset, DCM_PatientBirthDate, identity.birthDate);
  put(dataset, DCM_PatientSex, identity.sex);
  if (identity.identityRemoved) {
    put(dataset, DCM_PatientIdentityRemoved, "YES");
    put(dataset, DCM_DeidentificationMethod, "Basic profile; UIDs replaced");
    putCode(dataset, DCM_DeidentificationMethodCodeSequence,
            {"113100", "DCM", "Basic Application Confidentiality Profile"});
  }
  put(dataset, DCM_StudyInstanceUID, identity.studyUid);
  put(dataset, DCM_StudyID, identity.studyId);
  put(dataset, DCM_StudyDate, identity.studyDate);
  put(dataset, DCM_StudyTime, identity.studyTime);
  put(dataset, DCM_AccessionNumber, identity.accessionNumber);
  put(dataset, DCM_ReferringPhysicianName, identity.referringPhysician);
  if (!identity.studyDescription.empty())
    put(dataset, DCM_StudyDescription, identity.studyDescription);
}

} // namespace

void put(DcmItem& item, const DcmTagKey& key, const std::string& text) {
  require(item.putAndInsertString(key, text.c_str()));
}

void putWord(DcmItem& item, const DcmTagKey& key, int value) {
  require(item.putAndInsertUint16(key, static_cast<Uint16>(value)));
}

void putLong(DcmItem& item, const DcmTagKey& key, std::uint32_t value) {
  require(item.putAndInsertUint32(key, value));
}

std::string decimalText(double value) {
  char text[32];
  for (int digits = 10; digits > 0; --digits)
    if (std::snprintf(text, sizeof text, "%.*g", digits, value) <= 16)
      break;
  return text;
}

void putNumbers(DcmItem& item, const DcmTagKey& key, const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : "\\") + decimalText(number);
  put(item, key, text);
}

void putPoint(DcmItem& item, const DcmTagKey& key, const Vec3& point) {
  putNumbers(item, key, {point.x(), point.y(), point.z()});
}

void putColor(DcmItem& item, const Vec3& color) {
  const std::array<std::uint16_t, 3> lab = dicomLab(color);
  require(item.putAndInsertUint16Array(DCM_RecommendedDisplayCIELabValue, lab.data(), lab.size()));
}

DcmItem& addItem(DcmItem& item, const DcmTagKey& sequence) {
  DcmItem* added = nullptr;
  require(item.findOrCreateSequenceItem(sequence, added, -2)); // Behind the last one.
  return *added;
}

void putEmptySequence(DcmItem& item, const DcmTagKey& sequence) {
  require(item.insertEmptyElement(sequence));
}

void putCode(DcmItem& item, const DcmTagKey& sequence, const Code& code) {
  DcmItem& one = addItem(item, sequence);
  put(one, DCM_CodeValue, code.value);
  put(one, DCM_CodingSchemeDesignator, code.scheme);
  put(one, DCM_CodeMeaning, code.meaning);
}

void putCommon(DcmDataset& dataset, const StudyIdentity& identity, const ObjectSeries& series,
               const std::string& classUid, const std::string& modality) {
  put(dataset, DCM_SpecificCharacterSet, "ISO_IR 192");
  put(dataset, DCM_SOPClassUID, classUid);
  put(dataset, DCM_SOPInstanceUID, series.instanceUid);
  putPatientAndStudy(dataset, identity);
  put(dataset, DCM_Modality, modality);
  put(dataset, DCM_SeriesInstanceUID, series.seriesUid);
  put(dataset, DCM_SeriesNumber, std::to_string(series.number));
  put(dataset, DCM_SeriesDescription, series.description);
  put(dataset, DCM_InstanceNumber, std::to_string(series.instance));
  const std::string date = series.dateTime.substr(0, 8), time = series.dateTime.substr(8);
  put(dataset, DCM_SeriesDate, date);
  put(dataset, DCM_SeriesTime, time);
  put(dataset, DCM_InstanceCreationDate, date);
  put(dataset, DCM_InstanceCreationTime, time);
  put(dataset, DCM_Manufacturer, "Viscera");
  put(dataset, DCM_ManufacturerModelName, "Viscera");
  put(dataset, DCM_DeviceSerialNumber, kRootOfSoftware);
  put(dataset, DCM_SoftwareVersions, VISCERA_VERSION);
}

void putReferencedSeries(DcmItem& item, const StudyIdentity& identity) {
  if (identity.images.empty())
    return;
  DcmItem& referenced = addItem(item, DCM_ReferencedSeriesSequence);
  put(referenced, DCM_SeriesInstanceUID, identity.seriesUid);
  for (const SourceImage& image : identity.images) {
    DcmItem& one = addItem(referenced, DCM_ReferencedInstanceSequence);
    put(one, DCM_ReferencedSOPClassUID, image.classUid);
    put(one, DCM_ReferencedSOPInstanceUID, image.instanceUid);
  }
}

PartCode codeOf(const std::string& organName) {
  const std::optional<anatomy::Part> part = anatomy::partNamed(organName);
  if (!part)
    return {kAnatomicalStructure, std::nullopt};
  for (const ChamberCode& one : kChambers)
    if (anatomy::Part{one.part} == anatomy::Part{part->organ, part->side, part->chamber})
      return {{one.snomed, "SCT", anatomy::titleOf(one.part)}, std::nullopt};
  const anatomy::OrganFacts& facts = anatomy::organ(part->organ);
  PartCode code{facts.snomed.empty() ? kAnatomicalStructure
                                     : Code{std::string(facts.snomed), "SCT", std::string(facts.title)},
                std::nullopt};
  if (part->side != anatomy::Side::none && !facts.snomed.empty())
    code.side = part->side == anatomy::Side::right ? Code{"24028007", "SCT", "Right"}
                                                   : Code{"7771000", "SCT", "Left"};
  return code;
}

WrittenObject save(DcmFileFormat& format, const std::filesystem::path& file, const ObjectSeries& series,
                   E_TransferSyntax syntax) {
  medical_io::silenceDcmtk();
  OFString classUid;
  format.getDataset()->findAndGetOFString(DCM_SOPClassUID, classUid);
  AtomicFile atomic(file);
  const OFCondition done = format.saveFile(atomic.temporary().c_str(), syntax, EET_ExplicitLength,
                                           EGL_recalcGL, EPD_withoutPadding);
  if (done.bad())
    throw CannotCreateError(phrase("It cannot be written: %1", std::string(done.text())), file.string());
  atomic.commit();
  return {classUid.c_str(), series.instanceUid, series.seriesUid, {}};
}

} // namespace viscera::clinic
