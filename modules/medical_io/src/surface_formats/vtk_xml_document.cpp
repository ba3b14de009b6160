#include "surface_formats/vtk_xml_document.h"

#include <optional>
#include <vector>

#include "space_tag.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::string_view kAppendedTag = "<AppendedData";

} // namespace

VtkXmlDocument::VtkXmlDocument(const FileBytes& file) : file_(file) {
  storage_.file = &file;
  tree_ = parse();
  if (!tree_.error.empty())
    file_.fail(diagnostic("It is not complete XML: %1", tree_.error));
  const XmlElement& root = tree_.root;
  storage_.order = root.attribute("byte_order") == "BigEndian" ? std::endian::big : std::endian::little;
  storage_.headerBytes = root.attribute("header_type") == "UInt64" ? 8 : 4;
  storage_.compressor = root.attribute("compressor");
}

std::string_view VtkXmlDocument::type() const {
  return tree_.root.name == "VTKFile" ? tree_.root.attribute("type") : std::string_view();
}

/// Raw appended data are no XML: the document is parsed up to them.
XmlTree VtkXmlDocument::parse() {
  std::string_view document = file_.view();
  const std::size_t tag = document.find(kAppendedTag);
  if (tag == document.npos)
    return parseXml(document);
  const std::size_t tagEnd = document.find('>', tag);
  const std::size_t begin = tagEnd == document.npos ? tagEnd : document.find('_', tagEnd);
  if (begin == document.npos)
    file_.fail(diagnostic("the file is cut off before its data"));
  const std::string_view opening = document.substr(tag, tagEnd - tag);
  storage_.appendedIsBase64 = opening.find("raw") == opening.npos;
  storage_.appended = document.substr(begin + 1);
  if (file_.view().rfind("</VTKFile>") == file_.view().npos)
    file_.fail(diagnostic("the file is cut off: its end is missing"));
  return parseXml(std::string(document.substr(0, tagEnd + 1)) + "</AppendedData></VTKFile>");
}

void VtkXmlDocument::readFields(RawSurface& raw) const {
  const XmlElement* dataset = data();
  const XmlElement* fields = dataset == nullptr ? nullptr : dataset->child("FieldData");
  if (fields == nullptr)
    return;
  for (const XmlElement& array : fields->children) {
    if (array.attribute("type") != "String")
      continue;
    if (array.attribute("Name") == "SPACE")
      raw.space = findSpace("SPACE=" + readVtpText(storage_, array), raw.warnings);
    else if (array.attribute("Name") == "Name")
      raw.name = readVtpText(storage_, array);
  }
}

std::uint64_t VtkXmlDocument::count(const XmlElement& piece, std::string_view key) const {
  const std::string_view text = piece.attribute(key);
  const std::optional<std::int64_t> value = text.empty() ? 0 : parseInteger(text);
  if (!value || *value < 0)
    file_.fail(diagnostic("%1 is %2, which is no whole number from 0 on", key, inQuotes(text)));
  return static_cast<std::uint64_t>(*value);
}

void VtkXmlDocument::readPoints(const XmlElement& piece, std::uint64_t points, RawSurface& raw) const {
  const XmlElement* element = piece.child("Points");
  const XmlElement* array = element == nullptr ? nullptr : element->child("DataArray");
  if (array == nullptr)
    file_.fail(diagnostic("It holds a piece without points"));
  const std::vector<double> values = readVtpNumbers(storage_, *array);
  if (values.size() != saturatedProduct(points, 3))
    file_.fail(diagnostic("It announces %1 points, but holds %2 coordinates", points, values.size()));
  raw.coordinates.insert(raw.coordinates.end(), values.begin(), values.end());
}

const XmlElement& VtkXmlDocument::cellArray(const XmlElement& cells, std::string_view name) const {
  for (const XmlElement& array : cells.children)
    if (array.attribute("Name") == name)
      return array;
  file_.fail(diagnostic("It has cells without the array %1", inQuotes(name)));
}

} // namespace viscera::medical_io
