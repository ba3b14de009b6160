#pragma once

#include <cstddef>
#include <new>
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
  bool parse(std::string_view bytes, bool last);

  XML_Parser parser_;
  Text error_;
};

} // namespace viscera::medical_io
