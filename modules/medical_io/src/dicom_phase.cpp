#include <system_error>

#include "dicom/deflated_dicom.h"
#include "dicom/quiet_dcmtk.h"
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
  silenceDcmtk();
  DicomPhase phase;
  std::error_code error;
  try {
    requireBoundedInflation(file);
  } catch (const DataError&) {
    return phase;
  }
  DcmFileFormat format;
  if (!std::filesystem::is_regular_file(file, error) ||
      format.loadFile(file.c_str(), EXS_Unknown, EGL_noChange, 4096, ERM_fileOnly).bad())
    return phase;
  DcmDataset& dataset = *format.getDataset();
  phase.triggerMs = numberAnywhere(dataset, DCM_TriggerTime);
  if (!phase.triggerMs)
    phase.triggerMs = numberAnywhere(dataset, DCM_NominalCardiacTriggerDelayTime);
  phase.nominalIntervalMs = numberAnywhere(dataset, DCM_NominalInterval);
  phase.percent = numberAnywhere(dataset, DCM_NominalPercentageOfCardiacPhase);
  return phase;
}

} // namespace viscera::medical_io
