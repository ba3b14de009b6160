#include "xml_stream.h"

#include <vector>

#include "expat_parser.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kStreamBlock = std::size_t{1} << 18U;

std::string_view withoutPrefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

/// Hands everything on to the listener.
struct StreamHandler {
  XmlListener& listener;

  void start(const char* name, const char** attributes) const {
    listener.startElement(withoutPrefix(name), XmlAttributes(attributes));
  }
  void end(const char* name) const { listener.endElement(withoutPrefix(name)); }
  void characters(std::string_view text) const { listener.characters(text); }
};

} // namespace

std::string_view XmlAttributes::value(std::string_view key) const {
  for (const char** at = list_; at != nullptr && at[0] != nullptr && at[1] != nullptr; at += 2)
    if (withoutPrefix(at[0]) == key)
      return at[1];
  return {};
}

Text streamXml(const std::function<std::size_t(char*, std::size_t)>& read, XmlListener& listener) {
  StreamHandler handler{listener};
  ExpatParser parser(handler);
  std::vector<char> block(kStreamBlock);
  bool good = true;
  for (std::size_t got = block.size(); good && got == block.size() && !listener.hasEnough();) {
    got = read(block.data(), block.size());
    good = got == 0 || parser.parse({block.data(), got});
  }
  if (!listener.hasEnough())
    parser.finish();
  return listener.hasEnough() ? Text() : parser.error();
}

} // namespace viscera::medical_io
