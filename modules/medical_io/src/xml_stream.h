#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// The attributes of an element while it is announced.
class XmlAttributes {
public:
  explicit XmlAttributes(const char** list) : list_(list) {}

  /// The value of an attribute, whose name may have a prefix ("p:path" is "path"); empty when it is absent.
  std::string_view value(std::string_view key) const;

private:
  const char** list_; ///< Names and values in turn, then null.
};

/// Is told what a document has, in its order. Element names come without their prefix: "m:color" is "color".
/// Its functions throw nothing.
class XmlListener {
public:
  virtual ~XmlListener() = default;
  virtual void startElement(std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void endElement(std::string_view name) = 0;
  virtual void characters(std::string_view text) = 0;
  /// Whether the rest of the document is not wanted any more.
  virtual bool hasEnough() const = 0;
};

/// Parses a document as it comes, without keeping it, with expat. `read` fills a buffer with the next
/// bytes and says how many; what it throws passes through. Empty: there was nothing wrong. Prints nothing.
Text streamXml(const std::function<std::size_t(char*, std::size_t)>& read, XmlListener& listener);

} // namespace viscera::medical_io
