#include "dicom_object.h"
#include "encapsulated.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::clinic {

void putEncapsulated(DcmDataset& dataset, const ObjectSeries& series, const std::string& title,
                     const std::string& mimeType, std::string_view bytes) {
  const std::string date = series.dateTime.substr(0, 8), time = series.dateTime.substr(8);
  put(dataset, DCM_ContentDate, date);
  put(dataset, DCM_ContentTime, time);
  put(dataset, DCM_AcquisitionDateTime, series.dateTime);
  put(dataset, DCM_BurnedInAnnotation, "YES"); // A document may name the patient.
  put(dataset, DCM_DocumentTitle, title);
  putEmptySequence(dataset, DCM_ConceptNameCodeSequence);
  put(dataset, DCM_MIMETypeOfEncapsulatedDocument, mimeType);
  putLong(dataset, DCM_EncapsulatedDocumentLength, static_cast<std::uint32_t>(bytes.size()));
  std::string even(bytes);
  if (even.size() % 2 != 0)
    even += '\0';
  if (dataset
          .putAndInsertUint8Array(DCM_EncapsulatedDocument, reinterpret_cast<const Uint8*>(even.data()),
                                  even.size())
          .bad())
    throw CannotCreateError(misuse("DCMTK cannot write the document"));
}

WrittenObject writeDocumentObject(const std::filesystem::path& file, const StudyIdentity& identity,
                                  const ObjectSeries& series, const std::string& title,
                                  std::string_view pdf) {
  if (!pdf.starts_with("%PDF-"))
    throw DataError("It is no PDF document", file.string());
  DcmFileFormat format;
  DcmDataset& dataset = *format.getDataset();
  putCommon(dataset, identity, series, UID_EncapsulatedPDFStorage, "DOC");
  put(dataset, DCM_ConversionType, "WSD");
  putEncapsulated(dataset, series, title, "application/pdf", pdf);
  return save(format, file, series);
}

} // namespace viscera::clinic
