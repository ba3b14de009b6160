#include "expat_parser.h"

#include <string>

namespace viscera::medical_io {

bool ExpatParser::parse(std::string_view bytes, bool last) {
  if (!error_.empty())
    return false;
  if (XML_Parse(parser_, bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0) != XML_STATUS_ERROR)
    return true;
  error_ = diagnostic("Error parsing XML in stream at line %1, column %2, byte index %3: %4",
                      std::to_string(XML_GetCurrentLineNumber(parser_)),
                      std::to_string(XML_GetCurrentColumnNumber(parser_)),
                      std::to_string(XML_GetCurrentByteIndex(parser_)),
                      std::string(XML_ErrorString(XML_GetErrorCode(parser_))));
  return false;
}

} // namespace viscera::medical_io
