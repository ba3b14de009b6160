#include "dicom/dicom_load.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dicom/deflated_dicom.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/quiet_dcmtk.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dctk.h>

/// DCMTK can give elements of VR UN their type while it parses, but only by a switch for the whole process
/// (`dcmEnableUnknownVRConversion`), which other users of the library would notice. Here it is done after
/// parsing, for one file.
namespace viscera::medical_io {
namespace {

/// Deeper sequences are left as they are: no object of the standard has them.
constexpr int kDeepestSequence = 16;

/// Whether the items of a sequence state the types of their elements, as some programs write them although
/// PS3.5, 6.2.2 says that the value of UN does not.
bool statesTypes(std::string_view sequence) {
  constexpr std::size_t kTypeAt = 8 + 4; // Behind the item's header and the tag.
  const auto isUpper = [&](std::size_t at) { return sequence[at] >= 'A' && sequence[at] <= 'Z'; };
  return sequence.size() >= kTypeAt + 2 && isUpper(kTypeAt) && isUpper(kTypeAt + 1);
}

/// The element as it would be written without types (or with them), ready to be parsed.
std::string encoded(const DcmTag& tag, std::string_view value, bool typed) {
  std::string bytes;
  appendValue(bytes, static_cast<std::uint16_t>(tag.getGroup()));
  appendValue(bytes, static_cast<std::uint16_t>(tag.getElement()));
  if (typed)
    bytes.append("SQ\0\0", 4);
  appendValue(bytes, static_cast<std::uint32_t>(value.size()));
  return bytes.append(value);
}

/// The element of VR UN with the type that the data dictionary states; null where it states none, or the
/// value is none of that type.
std::unique_ptr<DcmElement> typedElement(DcmElement& unknown) {
  const DcmTag known(unknown.getTag().getXTag());
  const DcmEVR type = known.getEVR();
  if (type == EVR_UN || type == EVR_UNKNOWN || known.getXTag() == DCM_PixelData)
    return nullptr;
  Uint8* bytes = nullptr;
  const Uint32 length = unknown.getLengthField();
  if (length != 0 && (unknown.getUint8Array(bytes).bad() || bytes == nullptr))
    return nullptr;
  const std::string_view value(reinterpret_cast<const char*>(bytes), bytes == nullptr ? 0 : length);
  const bool typed = type == EVR_SQ && statesTypes(value);
  const std::string element = encoded(known, value, typed);
  DcmInputBufferStream stream;
  stream.setBuffer(element.data(), static_cast<offile_off_t>(element.size()));
  stream.setEos();
  DcmDataset holder;
  holder.transferInit();
  if (holder.read(stream, typed ? EXS_LittleEndianExplicit : EXS_LittleEndianImplicit).bad())
    return nullptr;
  holder.transferEnd();
  return std::unique_ptr<DcmElement>(holder.remove(known.getXTag()));
}

void giveTypes(DcmItem& item, int depth);

/// The items of a sequence.
void giveTypes(DcmSequenceOfItems& sequence, int depth) {
  DcmObject* at = nullptr;
  while ((at = sequence.nextInContainer(at)) != nullptr)
    if (auto* item = dynamic_cast<DcmItem*>(at))
      giveTypes(*item, depth);
}

void giveTypes(DcmItem& item, int depth) {
  if (depth > kDeepestSequence)
    return;
  std::vector<std::unique_ptr<DcmElement>> typed;
  DcmObject* at = nullptr;
  while ((at = item.nextInContainer(at)) != nullptr) {
    auto* element = dynamic_cast<DcmElement*>(at);
    if (element != nullptr && element->ident() != EVR_SQ && element->getTag().getEVR() == EVR_UN)
      if (auto made = typedElement(*element))
        typed.push_back(std::move(made));
  }
  for (auto& element : typed)
    if (item.insert(element.get(), OFTrue).good())
      element.release(); // The item owns it.
  while ((at = item.nextInContainer(at)) != nullptr)
    if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(at))
      giveTypes(*sequence, depth + 1);
}

} // namespace

void loadDicom(DcmFileFormat& format, const FileBytes& file) {
  silenceDcmtk();
  requireBoundedInflation(file.file);
  const OFCondition loaded =
      format.loadFile(file.file.c_str(), EXS_Unknown, EGL_noChange, kLongestLoadedValue, ERM_autoDetect);
  if (loaded.bad())
    file.fail(diagnostic("It is damaged or no DICOM file: %1", loaded.text()));
  giveTypes(*format.getDataset(), 0);
}

void loadDicomBeforePixels(DcmFileFormat& format, const FileBytes& file) {
  silenceDcmtk();
  requireBoundedInflation(file.file);
  // Elements that were parsed before an error stay in the data set.
  format.loadFileUntilTag(file.file.c_str(), EXS_Unknown, EGL_noChange, kLongestLoadedValue, ERM_autoDetect,
                          DCM_PixelData);
  giveTypes(*format.getDataset(), 0);
}

} // namespace viscera::medical_io
