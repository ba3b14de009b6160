#include "xml_tree.h"

#include <algorithm>

#include "expat_parser.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kDeepestElement = 64;
/// expat takes sizes as `int`.
constexpr std::size_t kChunk = std::size_t{1} << 20U;

/// Builds the tree while the parser walks through the document.
class TreeBuilder {
public:
  XmlElement top;
  bool tooDeep = false;

  void start(const char* name, const char** attributes) {
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

  void end(const char*) {
    if (depth_-- > kDeepestElement)
      return;
    XmlElement finished = std::move(path_.back());
    path_.pop_back();
    XmlElement& parent = path_.empty() ? top : path_.back();
    parent.children.push_back(std::move(finished));
  }

  void characters(std::string_view text) {
    if (!path_.empty() && depth_ <= kDeepestElement)
      path_.back().text += text;
  }

private:
  std::vector<XmlElement> path_; ///< The open elements, outermost first.
  std::size_t depth_ = 0;
};

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
  TreeBuilder builder;
  ExpatParser parser(builder);
  bool good = true;
  for (std::size_t at = 0; at < document.size() && good; at += kChunk)
    good = parser.parse(document.substr(at, kChunk));
  good = parser.finish() && good;

  XmlTree tree;
  if (builder.tooDeep)
    tree.error = diagnostic("its XML is nested too deeply");
  else if (!good || builder.top.children.empty())
    tree.error = !good ? parser.error() : diagnostic("its XML is not complete");
  else
    tree.root = std::move(builder.top.children.front());
  return tree;
}

} // namespace viscera::medical_io
