#include "expat_parser.h"

#include <string>

namespace viscera::medical_io {

bool ExpatParser::parse(std::string_view bytes, bool last) {
  if (!error_.empty())
    return false;
  if (XML_Parse(parser_, bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0) != XML_STATUS_ERROR)
    return true;
  error_ = Text("Error parsing XML in stream at line " + std::to_string(XML_GetCurrentLineNumber(parser_)) +
                ", column " + std::to_string(XML_GetCurrentColumnNumber(parser_)) + ", byte index " +
                std::to_string(XML_GetCurrentByteIndex(parser_)) + ": " +
                XML_ErrorString(XML_GetErrorCode(parser_)));
  return false;
}

} // namespace viscera::medical_io
