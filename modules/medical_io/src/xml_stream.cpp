#include "xml_stream.h"

#include <vector>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

#include "quiet_vtk.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kStreamBlock = std::size_t{1} << 18U;

std::string_view withoutPrefix(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

/// Hands everything on to the listener.
class vtkVisceraXmlStream : public vtkXMLParser {
public:
  static vtkVisceraXmlStream* New();
  vtkVisceraXmlStream(const vtkVisceraXmlStream&) = delete;
  void operator=(const vtkVisceraXmlStream&) = delete;

  XmlListener* listener = nullptr;

protected:
  vtkVisceraXmlStream() = default;
  ~vtkVisceraXmlStream() override = default;

  void StartElement(const char* name, const char** attributes) override {
    listener->startElement(withoutPrefix(name), XmlAttributes(attributes));
  }
  void EndElement(const char* name) override { listener->endElement(withoutPrefix(name)); }
  void CharacterDataHandler(const char* data, int length) override {
    listener->characters({data, static_cast<std::size_t>(length)});
  }
};
vtkStandardNewMacro(vtkVisceraXmlStream)

    /// Ends VTK's parser also when reading throws.
    class OpenParser {
public:
  explicit OpenParser(vtkXMLParser& parser) : parser_(parser) { good_ = parser.InitializeParser() != 0; }
  ~OpenParser() { end(); }
  OpenParser(const OpenParser&) = delete;
  OpenParser& operator=(const OpenParser&) = delete;

  bool good() const { return good_; }
  bool end() {
    if (open_)
      good_ = parser_.CleanupParser() != 0 && good_;
    open_ = false;
    return good_;
  }

private:
  vtkXMLParser& parser_;
  bool open_ = true;
  bool good_ = false;
};

} // namespace

std::string_view XmlAttributes::value(std::string_view key) const {
  for (const char** at = list_; at != nullptr && at[0] != nullptr && at[1] != nullptr; at += 2)
    if (withoutPrefix(at[0]) == key)
      return at[1];
  return {};
}

Text streamXml(const std::function<std::size_t(char*, std::size_t)>& read, XmlListener& listener) {
  vtkNew<vtkVisceraXmlStream> parser;
  const QuietVtk quiet(parser);
  parser->listener = &listener;
  OpenParser open(*parser);
  bool good = open.good();
  std::vector<char> block(kStreamBlock);
  for (std::size_t got = block.size(); good && got == block.size() && !listener.hasEnough();) {
    got = read(block.data(), block.size());
    if (got > 0)
      good = parser->ParseChunk(block.data(), static_cast<unsigned int>(got)) != 0;
  }
  if (listener.hasEnough())
    return {};
  good = open.end() && good;
  if (quiet.failed())
    return Text(quiet.error());
  return good ? Text() : diagnostic("its XML is not complete");
}

} // namespace viscera::medical_io
