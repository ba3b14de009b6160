#include "dicom/encapsulated_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "dicom/dicom_kinds.h"
#include "dicom/dicom_load.h"
#include "dicom/dicom_mark.h"
#include "dicom/dicom_text.h"
#include "dicom/lab_color.h"
#include "surface_formats.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

namespace viscera::medical_io {
namespace {

constexpr std::string_view kEncapsulatedObj = "1.2.840.10008.5.1.4.1.1.104.4";

struct UcumUnit {
  std::string_view code; ///< UCUM.
  double mm;
};
constexpr std::array<UcumUnit, 5> kUcumUnits = {
    {{"mm", 1}, {"um", 1e-3}, {"cm", 10}, {"m", 1000}, {"[in_i]", 25.4}}};

/// The code in the first item of a sequence; empty when there is none.
std::string codeIn(DcmItem& dataset, const DcmTagKey& sequence, const DcmTagKey& key) {
  DcmItem* item = nullptr;
  return dataset.findAndGetSequenceItem(sequence, item, 0).good() && item != nullptr
             ? textAt(dataset, *item, key)
             : std::string();
}

/// The file within, without the byte that makes its length even.
std::string embeddedBytes(DcmItem& dataset, const FileBytes& file) {
  const Uint8* bytes = nullptr;
  unsigned long size = 0;
  if (dataset.findAndGetUint8Array(DCM_EncapsulatedDocument, bytes, &size).bad() || bytes == nullptr ||
      size == 0)
    file.fail(diagnostic("It has no surface within"));
  const auto stated = numbersAt(dataset, DCM_EncapsulatedDocumentLength);
  if (!stated.empty() && stated[0] > 0 && stated[0] < double(size))
    size = static_cast<unsigned long>(stated[0]);
  std::string document(reinterpret_cast<const char*>(bytes), size);
  const std::size_t end = document.find_last_not_of('\0') + 1;
  if (document.find('\0') == end) // A text, and its padding.
    document.resize(end);
  return document;
}

void takeUnit(DcmItem& dataset, RawSurface& raw) {
  const std::string code = codeIn(dataset, DCM_MeasurementUnitsCodeSequence, DCM_CodeValue);
  const auto unit = std::find_if(kUcumUnits.begin(), kUcumUnits.end(),
                                 [&](const UcumUnit& one) { return one.code == code; });
  if (unit == kUcumUnits.end()) {
    if (!code.empty())
      raw.warnings.push_back(phrase("its unit %1 is not known; mm are assumed", inQuotes(code)));
    return;
  }
  for (double& coordinate : raw.coordinates)
    coordinate *= unit->mm;
}

void takeColor(DcmItem& dataset, RawSurface& raw) {
  const auto color = recommendedColor(dataset);
  if (!color || raw.colors.size() == raw.coordinates.size())
    return;
  raw.colors.clear();
  for (std::size_t point = 0; point < raw.pointCount(); ++point)
    for (int channel = 0; channel < 3; ++channel)
      raw.addChannel(255 * (*color)[channel]);
}

} // namespace

RawSurface readDicomSurface(const FileBytes& file) {
  const std::string known = dicomClass(file.file); // A damaged file of another kind is named by it, too.
  if (kindOfDicomClass(known) == DicomKind::other)
    failAsDicomObject(file, known);
  DcmFileFormat format;
  loadDicom(format, file);
  DcmDataset& dataset = *format.getDataset();
  const std::string uid = codeAt(dataset, DCM_SOPClassUID);
  const DicomKind kind = kindOfDicomClass(uid);
  if (kind == DicomKind::image || kind == DicomKind::segmentation)
    file.fail("It is a DICOM image, not a surface", "make a label map of it first, or open it as one");
  if (kind != DicomKind::surface)
    failAsDicomObject(file, uid);
  FileBytes embedded{file.file, embeddedBytes(dataset, file), 0};
  embedded.length = embedded.bytes.size();
  RawSurface raw = uid == kEncapsulatedObj ? readObj(embedded) : readStl(embedded);
  std::string name = textAt(dataset, dataset, DCM_DocumentTitle);
  if (name.empty())
    name = codeIn(dataset, DCM_ConceptNameCodeSequence, DCM_CodeMeaning);
  if (name.empty())
    name = raw.name;
  if (name.empty())
    name = textAt(dataset, dataset, DCM_SeriesDescription);
  raw.name = name;
  if (!raw.space)
    raw.space = Space::lps;
  takeUnit(dataset, raw);
  takeColor(dataset, raw);
  return raw;
}

} // namespace viscera::medical_io
