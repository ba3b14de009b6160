#pragma once

#include <cstddef>
#include <new>
#include <string>
#include <string_view>

#include <expat.h>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// expat's parser, which calls back the functions of a handler: `start(name, attributes)` with names and
/// values in turn and null at the end, `end(name)` and `characters(text)`, none of which may throw. For one
/// document.
class ExpatParser {
public:
  template <class Handler>
  explicit ExpatParser(Handler& handler) : parser_(XML_ParserCreate(nullptr)) {
    if (parser_ == nullptr)
      throw std::bad_alloc();
    XML_SetUserData(parser_, &handler);
    XML_SetElementHandler(
        parser_,
        [](void* user, const char* name, const char** list) {
          static_cast<Handler*>(user)->start(name, list);
        },
        [](void* user, const char* name) { static_cast<Handler*>(user)->end(name); });
    XML_SetCharacterDataHandler(parser_, [](void* user, const char* text, int length) {
      static_cast<Handler*>(user)->characters({text, static_cast<std::size_t>(length)});
    });
  }
  ~ExpatParser() { XML_ParserFree(parser_); }
  ExpatParser(const ExpatParser&) = delete;
  ExpatParser& operator=(const ExpatParser&) = delete;

  /// The next bytes of the document, fewer than 2 GB. False after the first fault.
  bool parse(std::string_view bytes) { return parse(bytes, false); }
  /// To be called once behind the last bytes. False when the document was at fault or is not at its end.
  bool finish() { return parse({}, true); }
  /// What was wrong and where; empty for nothing.
  const Text& error() const { return error_; }

private:
  bool parse(std::string_view bytes, bool last) {
    if (!error_.empty())
      return false;
    if (XML_Parse(parser_, bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0) != XML_STATUS_ERROR)
      return true;
    error_ = diagnostic("Error parsing XML in stream at line %1, column %2, byte index %3: %4", line(),
                        column(), byte(), std::string(XML_ErrorString(XML_GetErrorCode(parser_))));
    return false;
  }

  // expat 2.9 has other names for its places.
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
  std::string line() const {
    return std::to_string(XML_GetCurrentLineNumber64(parser_));
  }
  std::string column() const {
    return std::to_string(XML_GetCurrentColumnNumber64(parser_));
  }
  std::string byte() const {
    return std::to_string(XML_GetCurrentByteIndex64(parser_));
  }
#else
  std::string line() const {
    return std::to_string(XML_GetCurrentLineNumber(parser_));
  }
  std::string column() const {
    return std::to_string(XML_GetCurrentColumnNumber(parser_));
  }
  std::string byte() const {
    return std::to_string(XML_GetCurrentByteIndex(parser_));
  }
#endif

  XML_Parser parser_;
  Text error_;
};

} // namespace viscera::medical_io
