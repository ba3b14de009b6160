#include "xml_tree.h"

#include <algorithm>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLParser.h>

#include "quiet_vtk.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kDeepestElement = 64;
/// expat takes sizes as `int`.
constexpr std::size_t kChunk = std::size_t{1} << 20U;

/// Builds the tree while VTK's parser walks through the document.
class vtkVisceraXmlTree : public vtkXMLParser {
public:
  static vtkVisceraXmlTree* New();
  vtkVisceraXmlTree(const vtkVisceraXmlTree&) = delete;
  void operator=(const vtkVisceraXmlTree&) = delete;

  XmlElement top;
  bool tooDeep = false;

protected:
  vtkVisceraXmlTree() = default;
  ~vtkVisceraXmlTree() override = default;

  void StartElement(const char* name, const char** attributes) override {
    ++depth_;
    if (depth_ > kDeepestElement) {
      tooDeep = true;
      return;
    }
    XmlElement element;
    element.name = name;
    for (const char** a = attributes; a != nullptr && a[0] != nullptr && a[1] != nullptr; a += 2)
      element.attributes.emplace_back(a[0], a[1]);
    path_.push_back(std::move(element));
  }

  void EndElement(const char*) override {
    if (depth_-- > kDeepestElement)
      return;
    XmlElement finished = std::move(path_.back());
    path_.pop_back();
    XmlElement& parent = path_.empty() ? top : path_.back();
    parent.children.push_back(std::move(finished));
  }

  void CharacterDataHandler(const char* data, int length) override {
    if (!path_.empty() && depth_ <= kDeepestElement)
      path_.back().text.append(data, static_cast<std::size_t>(length));
  }

private:
  std::vector<XmlElement> path_; ///< The open elements, outermost first.
  std::size_t depth_ = 0;
};
vtkStandardNewMacro(vtkVisceraXmlTree)

} // namespace

std::string_view XmlElement::attribute(std::string_view key) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.first == key; });
  return found == attributes.end() ? std::string_view() : std::string_view(found->second);
}

const XmlElement* XmlElement::child(std::string_view childName) const {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const XmlElement& e) { return e.name == childName; });
  return found == children.end() ? nullptr : &*found;
}

XmlTree parseXml(std::string_view document) {
  vtkNew<vtkVisceraXmlTree> parser;
  const QuietVtk quiet(parser);
  bool good = parser->InitializeParser() != 0;
  for (std::size_t at = 0; at < document.size() && good; at += kChunk) {
    const std::string_view chunk = document.substr(at, kChunk);
    good = parser->ParseChunk(chunk.data(), static_cast<unsigned int>(chunk.size())) != 0;
  }
  good = parser->CleanupParser() != 0 && good;

  XmlTree tree;
  if (parser->tooDeep)
    tree.error = diagnostic("its XML is nested too deeply");
  else if (quiet.failed() || !good || parser->top.children.empty())
    tree.error = quiet.failed() ? Text(quiet.error()) : diagnostic("its XML is not complete");
  else
    tree.root = std::move(parser->top.children.front());
  return tree;
}

} // namespace viscera::medical_io
