#include "dicom/iso2022.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <iconv.h>

/// DCMTK's converter hands the Japanese sets of two bytes to iconv under names that only GNU libiconv knows;
/// that of glibc, on which Debian builds it, does not.
namespace viscera::medical_io {
namespace {

constexpr char kEsc = '\x1b';
constexpr unsigned char kHighBit = 0x80;

/// A set of letters, and what switches to it.
struct LetterSet {
  std::string_view escape;      ///< Behind the escape character.
  const char* encoding;         ///< iconv's name of one that has these letters.
  int bytes;                    ///< Of a letter.
  int registered;               ///< ISO-IR number.
  std::string_view prefix = {}; ///< Before each letter in that encoding.
};

/// The sets for letters below 128 (G0), but ASCII. The encodings set the highest bit of these letters.
constexpr std::array<LetterSet, 4> kLow = {{{"$B", "EUC-JP", 2, 87},
                                            {"$@", "EUC-JP", 2, 42},
                                            {"$(D", "EUC-JP", 2, 159, "\x8f"},
                                            {"(I", "SHIFT_JIS", 1, 13}}};
/// The sets for letters from 128 on (G1).
constexpr std::array<LetterSet, 14> kHigh = {{{"$)C", "EUC-KR", 2, 149},
                                              {"$)A", "EUC-CN", 2, 58},
                                              {")I", "SHIFT_JIS", 1, 13},
                                              {"-A", "ISO-8859-1", 1, 100},
                                              {"-B", "ISO-8859-2", 1, 101},
                                              {"-C", "ISO-8859-3", 1, 109},
                                              {"-D", "ISO-8859-4", 1, 110},
                                              {"-L", "ISO-8859-5", 1, 144},
                                              {"-G", "ISO-8859-6", 1, 127},
                                              {"-F", "ISO-8859-7", 1, 126},
                                              {"-H", "ISO-8859-8", 1, 138},
                                              {"-M", "ISO-8859-9", 1, 148},
                                              {"-b", "ISO-8859-15", 1, 203},
                                              {"-T", "TIS-620", 1, 166}}};

std::optional<std::string> byIconv(const char* encoding, std::string bytes) {
  const iconv_t converter = iconv_open("UTF-8", encoding);
  if (converter == reinterpret_cast<iconv_t>(-1)) // NOLINT: as POSIX defines it.
    return std::nullopt;
  constexpr std::size_t kLongestOfOne = 4; // Bytes in UTF-8.
  std::string result(bytes.size() * kLongestOfOne, '\0');
  char* in = bytes.data();
  char* out = result.data();
  std::size_t inLeft = bytes.size(), outLeft = result.size();
  const bool done = iconv(converter, &in, &inLeft, &out, &outLeft) != static_cast<std::size_t>(-1);
  iconv_close(converter);
  result.resize(result.size() - outLeft);
  return done ? std::optional(std::move(result)) : std::nullopt;
}

class Iso2022Decoder {
public:
  Iso2022Decoder(std::string_view sets, std::string_view text) : text_(text) {
    for (const LetterSet& set : kHigh)
      if (high_ == nullptr && names(sets, set.registered))
        high_ = &set;
  }

  std::optional<std::string> run() {
    while (at_ < text_.size())
      if (text_[at_] == kEsc ? !takeEscape() : !takeLetter())
        return std::nullopt;
    return std::move(result_);
  }

private:
  static bool names(std::string_view sets, int registered) {
    const std::string number = std::to_string(registered);
    for (std::size_t at = sets.find(number); at != sets.npos; at = sets.find(number, at + 1)) {
      const std::size_t end = at + number.size();
      if (at > 0 && (sets[at - 1] == ' ' || sets[at - 1] == '_') &&
          (end == sets.size() || sets[end] == '\\' || sets[end] == ' '))
        return true;
    }
    return false;
  }

  bool takeEscape() {
    const std::string_view rest = text_.substr(at_ + 1);
    for (const std::string_view ascii : {"(B", "(J"})
      if (rest.starts_with(ascii))
        return take(ascii, low_, nullptr);
    for (const LetterSet& set : kLow)
      if (rest.starts_with(set.escape))
        return take(set.escape, low_, &set);
    for (const LetterSet& set : kHigh)
      if (rest.starts_with(set.escape))
        return take(set.escape, high_, &set);
    return false;
  }

  bool take(std::string_view escape, const LetterSet*& place, const LetterSet* set) {
    place = set;
    at_ += 1 + escape.size();
    return true;
  }

  bool takeLetter() {
    const bool isHigh = (static_cast<unsigned char>(text_[at_]) & kHighBit) != 0;
    const LetterSet* set = isHigh ? high_ : low_;
    if (!isHigh && (set == nullptr || text_[at_] <= ' ')) {
      result_ += text_[at_++];
      return true;
    }
    if (set == nullptr || at_ + static_cast<std::size_t>(set->bytes) > text_.size())
      return false;
    std::string letter(set->prefix);
    for (int i = 0; i < set->bytes; ++i)
      letter += static_cast<char>(static_cast<unsigned char>(text_[at_++]) | kHighBit);
    const std::optional<std::string> converted = byIconv(set->encoding, letter);
    result_ += converted.value_or("");
    return converted.has_value();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string result_;
  const LetterSet* low_ = nullptr;  ///< Null: ASCII.
  const LetterSet* high_ = nullptr; ///< Null: none.
};

} // namespace

std::optional<std::string> fromIso2022(std::string_view sets, std::string_view text) {
  return Iso2022Decoder(sets, text).run();
}

} // namespace viscera::medical_io
