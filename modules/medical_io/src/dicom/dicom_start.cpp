#include "dicom/dicom_start.h"

#include <algorithm>
#include <array>
#include <bit>

#include "file_bytes.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kMarkAt = 128, kMarkEnd = 132;
constexpr std::size_t kLongestUid = 64;
constexpr std::uint32_t kUndefinedLength = 0xFFFFFFFF;
constexpr std::uint32_t kMetaClass = 0x00020002, kMetaSyntax = 0x00020010, kRecognition = 0x00080010,
                        kClass = 0x00080016, kInstance = 0x00080018;
/// A file without a mark has at least so many elements in order.
constexpr int kFewestElements = 3;

/// How the elements of a data set are written.
struct ElementCoding {
  bool statesTypes = true;
  std::endian order = std::endian::little;
};
constexpr ElementCoding kExplicit{true, std::endian::little}, kImplicit{false, std::endian::little},
    kBigEndian{true, std::endian::big};

struct DataElement {
  std::uint32_t tag = 0;
  std::uint32_t length = 0;
  std::string_view value; ///< What the window holds of it.
};

bool isLongType(std::string_view type) {
  static constexpr std::array<std::string_view, 13> kLong = {"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                             "SV", "UC", "UN", "UR", "UT", "UV"};
  return std::find(kLong.begin(), kLong.end(), type) != kLong.end();
}

bool isType(std::string_view type) {
  static constexpr std::array<std::string_view, 21> kShort = {"AE", "AS", "AT", "CS", "DA", "DS", "DT",
                                                              "FD", "FL", "IS", "LO", "LT", "PN", "SH",
                                                              "SL", "SS", "ST", "TM", "UI", "UL", "US"};
  return isLongType(type) || std::find(kShort.begin(), kShort.end(), type) != kShort.end();
}

/// Walks over the elements at the beginning of a file.
class ElementWalk {
public:
  ElementWalk(std::string_view window, std::uint64_t fileLength, std::size_t at, ElementCoding coding)
      : window_(window), fileLength_(fileLength), at_(at), coding_(coding) {}

  std::size_t position() const { return at_; }
  /// Whether an element was out of order, of no type or longer than the file.
  bool failed() const { return failed_; }

  /// The next element; none behind the window, or when it is none.
  std::optional<DataElement> next() {
    if (at_ + 8 > window_.size())
      return std::nullopt;
    const auto word = [&](std::size_t at) { return loadValue<std::uint16_t>(&window_[at], coding_.order); };
    DataElement element;
    element.tag = std::uint32_t{word(at_)} << 16U | word(at_ + 2);
    std::size_t header = 8;
    if (!coding_.statesTypes) {
      element.length = loadValue<std::uint32_t>(&window_[at_ + 4], coding_.order);
    } else if (const std::string_view type = window_.substr(at_ + 4, 2); !isType(type)) {
      return fail();
    } else if (!isLongType(type)) {
      element.length = word(at_ + 6);
    } else {
      header = 12;
      if (at_ + header > window_.size())
        return std::nullopt;
      element.length = loadValue<std::uint32_t>(&window_[at_ + 8], coding_.order);
    }
    if (element.tag <= last_)
      return fail();
    last_ = element.tag;
    const std::size_t begin = at_ + header;
    if (element.length == kUndefinedLength) { // A sequence or packed pixels: the walk ends here.
      at_ = window_.size();
      return element;
    }
    if (begin + std::uint64_t{element.length} > fileLength_)
      return fail();
    element.value = window_.substr(begin, element.length);
    at_ = begin + element.length;
    return element;
  }

private:
  std::optional<DataElement> fail() {
    failed_ = true;
    return std::nullopt;
  }

  std::string_view window_;
  std::uint64_t fileLength_;
  std::size_t at_;
  ElementCoding coding_;
  std::uint32_t last_ = 0;
  bool failed_ = false;
};

/// A UID without its padding; empty when the value is none.
std::string uidIn(std::string_view value) {
  while (!value.empty() && (value.back() == '\0' || value.back() == ' '))
    value.remove_suffix(1);
  const bool plain =
      std::all_of(value.begin(), value.end(), [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
  if (!plain || value.size() > kLongestUid || value.find('.') == value.npos || value.front() == '.')
    return {};
  return std::string(value);
}

/// What the elements from `at` on say.
struct StartElements {
  std::string classUid, syntax;
  bool known = false; ///< They state the UID of a class or an instance.
  int count = 0;
  bool failed = false;
  std::size_t end = 0; ///< Behind the elements of group 2.
};

StartElements elementsFrom(std::string_view window, std::uint64_t length, std::size_t at,
                           ElementCoding coding, bool groupTwoOnly) {
  StartElements found;
  found.end = at;
  ElementWalk walk(window, length, at, coding);
  while (const auto element = walk.next()) {
    if (groupTwoOnly != (element->tag >> 16U == 2))
      break;
    if (found.count == 0 && !groupTwoOnly && element->tag >> 16U != 8)
      break;
    ++found.count;
    found.end = walk.position();
    const std::string uid = uidIn(element->value);
    if (element->tag == kMetaClass || element->tag == kClass)
      found.classUid = uid;
    if (element->tag == kMetaSyntax)
      found.syntax = uid;
    const bool identifies = element->tag == kMetaClass || element->tag == kMetaSyntax ||
                            element->tag == kClass || element->tag == kInstance;
    found.known = found.known || (identifies && !uid.empty()) ||
                  (element->tag == kRecognition && element->value.starts_with("ACR-NEMA"));
    // What follows may lie behind the first sequence.
    if (element->tag > kInstance)
      break;
  }
  found.failed = walk.failed();
  return found;
}

/// The elements of group 2, which are written with types; some programs leave the types out.
StartElements metaElements(std::string_view window, std::uint64_t length, std::size_t at) {
  const StartElements typed = elementsFrom(window, length, at, kExplicit, true);
  return typed.count > 0 ? typed : elementsFrom(window, length, at, kImplicit, true);
}

/// The elements of a data set in the first coding that gives some.
StartElements dataElements(std::string_view window, std::uint64_t length, std::size_t at) {
  for (const ElementCoding coding : {kExplicit, kImplicit, kBigEndian}) {
    const StartElements found = elementsFrom(window, length, at, coding, false);
    if (!found.failed && found.known && found.count >= kFewestElements)
      return found;
  }
  return {};
}

} // namespace

std::optional<DicomStart> dicomStart(std::string_view begin, std::uint64_t length) {
  const std::string_view window = begin.substr(0, kDicomStartBytes);
  DicomStart start;
  start.marked = window.size() >= kMarkEnd && window.substr(kMarkAt, 4) == "DICM";
  const StartElements meta = metaElements(window, length, start.marked ? kMarkEnd : 0);
  start.classUid = meta.classUid;
  if (start.classUid.empty() || meta.count == 0) {
    const StartElements data = dataElements(window, length, meta.end);
    if (!start.marked && !meta.known && !data.known)
      return std::nullopt;
    start.classUid = data.classUid;
  } else if (!start.marked && (!meta.known || meta.count < kFewestElements)) {
    return std::nullopt;
  }
  return start;
}

} // namespace viscera::medical_io
