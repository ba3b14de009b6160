#include "dicom/dicom_load.h"
#include "dicom/dicom_mark.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_series.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

namespace viscera::medical_io {
namespace {

/// A number, wherever in the data set it is.
std::optional<double> numberAnywhere(DcmItem& item, const DcmTagKey& key) {
  OFString text; // Numbers in words and in bytes come the same way.
  if (item.findAndGetOFString(key, text, 0, OFTrue).bad())
    return std::nullopt;
  return parseNumber(trimmed(text.c_str()));
}

} // namespace

DicomPhase dicomPhase(const std::filesystem::path& file) {
  DicomPhase phase;
  if (dicomKind(file) == DicomKind::none)
    return phase;
  DcmFileFormat format;
  try {
    loadDicom(format, FileBytes{file, {}});
  } catch (const DataError&) {
    return phase;
  }
  DcmDataset& dataset = *format.getDataset();
  phase.triggerMs = numberAnywhere(dataset, DCM_TriggerTime);
  if (!phase.triggerMs)
    phase.triggerMs = numberAnywhere(dataset, DCM_NominalCardiacTriggerDelayTime);
  phase.nominalIntervalMs = numberAnywhere(dataset, DCM_NominalInterval);
  phase.percent = numberAnywhere(dataset, DCM_NominalPercentageOfCardiacPhase);
  return phase;
}

} // namespace viscera::medical_io
