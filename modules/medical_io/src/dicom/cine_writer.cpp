#include "viscera/medical_io/cine_writer.h"

#include <cmath>
#include <cstdio>

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/quiet_dcmtk.h"

namespace viscera::medical_io {
namespace {

/// Decimal strings have 16 characters at most.
std::string decimalText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string decimalTexts(const Vec3& v) {
  return decimalText(v.x()) + '\\' + decimalText(v.y()) + '\\' + decimalText(v.z());
}

void putText(DcmDataset& dataset, const DcmTagKey& tag, const std::string& text) {
  if (const OFCondition done = dataset.putAndInsertString(tag, text.c_str()); done.bad())
    throw CannotCreateError(misuse("DCMTK cannot write this element: %1", std::string(done.text())));
}

void putWord(DcmDataset& dataset, const DcmTagKey& tag, int value) {
  if (const OFCondition done = dataset.putAndInsertUint16(tag, static_cast<Uint16>(value)); done.bad())
    throw CannotCreateError(misuse("DCMTK cannot write this element: %1", std::string(done.text())));
}

void putSeries(DcmDataset& dataset, const CineSeries& series, int phase) {
  const std::string number = std::to_string(phase + 1);
  putText(dataset, DCM_SOPClassUID, UID_MRImageStorage);
  putText(dataset, DCM_SOPInstanceUID, series.seriesUid + "." + number);
  putText(dataset, DCM_Modality, "MR");
  putText(dataset, DCM_ImageType, "DERIVED\\PRIMARY\\M");
  putText(dataset, DCM_SeriesDescription, series.description);
  putText(dataset, DCM_PatientName, series.patientName);
  putText(dataset, DCM_PatientID, series.patientId);
  putText(dataset, DCM_StudyInstanceUID, series.studyUid);
  putText(dataset, DCM_SeriesInstanceUID, series.seriesUid);
  putText(dataset, DCM_SeriesNumber, std::to_string(series.number));
  putText(dataset, DCM_InstanceNumber, number);
  putText(dataset, DCM_TriggerTime, decimalText(series.intervalMs * phase / series.phases));
  putText(dataset, DCM_NominalInterval, std::to_string(std::lround(series.intervalMs)));
  putText(dataset, DCM_CardiacNumberOfImages, std::to_string(series.phases));
}

void putGeometry(DcmDataset& dataset, const CineSeries& series) {
  const CineGeometry& geometry = series.geometry;
  putText(dataset, DCM_SliceThickness, decimalText(geometry.thickness));
  putText(dataset, DCM_ImagePositionPatient, decimalTexts(geometry.origin));
  putText(dataset, DCM_ImageOrientationPatient,
          decimalTexts(geometry.row) + '\\' + decimalTexts(geometry.column));
  putText(dataset, DCM_FrameOfReferenceUID, series.frameOfReferenceUid);
  putText(dataset, DCM_PixelSpacing,
          decimalText(geometry.betweenRows) + '\\' + decimalText(geometry.betweenColumns));
  putWord(dataset, DCM_SamplesPerPixel, 1);
  putText(dataset, DCM_PhotometricInterpretation, "MONOCHROME2");
  putWord(dataset, DCM_Rows, geometry.rows);
  putWord(dataset, DCM_Columns, geometry.columns);
  putWord(dataset, DCM_BitsAllocated, 16);
  putWord(dataset, DCM_BitsStored, 16);
  putWord(dataset, DCM_HighBit, 15);
  putWord(dataset, DCM_PixelRepresentation, 0);
}

} // namespace

void writeCinePicture(const std::filesystem::path& file, const CineSeries& series, int phase,
                      const std::vector<std::uint16_t>& pixels) {
  const auto count =
      static_cast<std::size_t>(series.geometry.rows) * static_cast<std::size_t>(series.geometry.columns);
  if (pixels.size() != count || count == 0)
    throw DataError(misuse("It has %n {pixel|pixels} in place of %2", pixels.size(), count), file.string());
  if (phase < 0 || phase >= series.phases)
    throw DataError(misuse("the series has no phase %1", phase), file.string());
  silenceDcmtk();
  DcmFileFormat format;
  DcmDataset& dataset = *format.getDataset();
  putSeries(dataset, series, phase);
  putGeometry(dataset, series);
  if (const OFCondition done = dataset.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
      done.bad())
    throw CannotCreateError(misuse("DCMTK cannot write this element: %1", std::string(done.text())),
                            file.string());
  AtomicFile atomic(file);
  if (const OFCondition done = format.saveFile(atomic.temporary().c_str(), EXS_LittleEndianExplicit);
      done.bad())
    throw CannotCreateError(phrase("It cannot be written: %1", std::string(done.text())), file.string());
  atomic.commit();
}

} // namespace viscera::medical_io
