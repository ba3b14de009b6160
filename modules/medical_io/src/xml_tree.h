#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// One element of an XML document with all below it.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text; ///< The characters directly within it.
  std::vector<XmlElement> children;

  /// The attribute's value; empty when it is absent.
  std::string_view attribute(std::string_view key) const;
  /// The first child of that name; null when there is none.
  const XmlElement* child(std::string_view childName) const;
};

/// A parsed document, or what is wrong with it.
struct XmlTree {
  XmlElement root;
  Text error; ///< Empty: none.
};

/// Parses a document with expat. Deeper than 64 levels is an error. Prints nothing.
XmlTree parseXml(std::string_view document);

} // namespace viscera::medical_io
