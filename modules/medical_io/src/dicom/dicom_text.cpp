#include "dicom/dicom_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "dicom/iso2022.h"
#include "text_scanner.h"
#include "viscera/core/text.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcspchrs.h>
#include <dcmtk/dcmdata/dctk.h>

namespace viscera::medical_io {
namespace {

constexpr char kEscape = '\x1b';
bool isAsciiLetter(char c) {
  return static_cast<unsigned char>(c) < 0x80;
}

std::optional<std::string> convertedFrom(const std::string& sets, const std::string& text) {
  DcmSpecificCharacterSet set;
  OFString converted;
  if (set.selectCharacterSet(OFString(sets.c_str(), sets.size())).bad() ||
      set.convertString(OFString(text.data(), text.size()), converted).bad())
    return std::nullopt;
  std::string result(converted.c_str(), converted.size());
  return isUtf8(result) && result.find(kEscape) == result.npos ? std::optional(std::move(result))
                                                               : std::nullopt;
}

/// The text without escape sequences; what stands between them in sets of two bytes is not shown as if it
/// were ASCII.
std::string withoutEscapes(const std::string& text) {
  std::string result;
  bool plain = true;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != kEscape) {
      result += plain && isAsciiLetter(text[at]) ? text[at] : '?';
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() && text[end] >= ' ' && text[end] <= '/')
      ++end;
    plain = text.substr(at + 1, 1) != "$" || text.substr(at + 2, 1) == ")";
    at = end;
  }
  return result;
}

std::string inUtf8(const std::string& sets, const std::string& text) {
  const bool ascii = std::all_of(text.begin(), text.end(), isAsciiLetter);
  const bool escapes = text.find(kEscape) != text.npos;
  if (ascii && !escapes)
    return text;
  const bool extended = escapes || sets.find("2022") != sets.npos;
  if (auto result = extended ? fromIso2022(sets, text) : convertedFrom(sets, text))
    return *result;
  if (!escapes && isUtf8(text)) // Written in what most programs use, but not said.
    return text;
  return withoutEscapes(text);
}

} // namespace

std::string rawTextAt(DcmItem& item, const DcmTagKey& key) {
  OFString text;
  if (item.findAndGetOFStringArray(key, text).bad())
    return {};
  return std::string(trimmed(std::string_view(text.c_str(), text.size())));
}

std::string textAt(DcmItem& dataset, DcmItem& item, const DcmTagKey& key) {
  const std::string own = rawTextAt(item, DCM_SpecificCharacterSet);
  const std::string sets = own.empty() ? rawTextAt(dataset, DCM_SpecificCharacterSet) : own;
  return printableName(inUtf8(sets, rawTextAt(item, key)));
}

std::string codeAt(DcmItem& item, const DcmTagKey& key) {
  std::string text = rawTextAt(item, key);
  std::erase_if(text, [](char c) { return c < ' ' || c > '~'; });
  return std::string(trimmed(text));
}

std::vector<double> numbersAt(DcmItem& item, const DcmTagKey& key) {
  std::vector<double> list;
  const std::string text = rawTextAt(item, key);
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\\'), rest.size());
    const auto number = parseNumber(trimmed(rest.substr(0, end)));
    if (!number || !std::isfinite(*number))
      return {};
    list.push_back(*number);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return list;
}

} // namespace viscera::medical_io
