#include "surface_formats/vtk_xml_writer.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <new>
#include <ostream>

#include <zlib.h>

#include "file_bytes.h"
#include "viscera/core/base64.h"

namespace viscera::medical_io {
namespace {

static_assert(std::endian::native == std::endian::little, "the headers say so");

/// VTK's own size.
constexpr std::size_t kBlock = std::size_t{1} << 15U;

} // namespace

std::string xmlEscaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

VtkXmlWriter::VtkXmlWriter(std::string_view type, VtkAppended appended)
    : appended_(appended), header_("<?xml version=\"1.0\"?>\n") {
  open("VTKFile type=\"" + std::string(type) +
       "\" version=\"0.1\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
       "compressor=\"vtkZLibDataCompressor\"");
  open(std::string(type));
}

void VtkXmlWriter::open(const std::string& element) {
  header_ += indent() + "<" + element + ">\n";
  open_.push_back(element.substr(0, element.find(' ')));
}

void VtkXmlWriter::close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  header_ += indent() + "</" + name + ">\n";
}

void VtkXmlWriter::text(std::string_view name, const std::string& value) {
  addArray("Array type=\"String\"", name, " NumberOfTuples=\"1\"", {value.c_str(), value.size() + 1});
}

void VtkXmlWriter::addArray(const std::string& begin, std::string_view name, const std::string& attributes,
                            std::string_view bytes) {
  header_ += indent() + "<" + begin + " Name=\"" + xmlEscaped(name) + "\"" + attributes +
             " format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>\n";
  appendPacked(bytes);
}

/// Numbers of blocks, of a block's bytes and of the last one's unless it is full, then each block's packed
/// size; behind them the blocks.
void VtkXmlWriter::appendPacked(std::string_view bytes) {
  std::string sizes, packed;
  for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
    const std::string_view block = bytes.substr(at, kBlock);
    const std::size_t begin = packed.size();
    auto size = compressBound(static_cast<uLong>(block.size()));
    packed.resize(begin + size);
    if (compress(reinterpret_cast<Bytef*>(packed.data() + begin), &size,
                 reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size())) != Z_OK)
      throw std::bad_alloc();
    packed.resize(begin + size);
    appendValue(sizes, static_cast<std::uint32_t>(size));
  }
  std::string head;
  appendValue(head, static_cast<std::uint32_t>((bytes.size() + kBlock - 1) / kBlock));
  appendValue(head, static_cast<std::uint32_t>(kBlock));
  appendValue(head, static_cast<std::uint32_t>(bytes.size() % kBlock));
  head += sizes;
  data_ += appended_ == VtkAppended::raw ? head + packed : base64Of(head) + base64Of(packed);
}

void VtkXmlWriter::write(std::ostream& out) {
  while (open_.size() > 1)
    close();
  out << header_ << "  <AppendedData encoding=\"" << (appended_ == VtkAppended::raw ? "raw" : "base64")
      << "\">\n   _" << data_ << "\n  </AppendedData>\n</VTKFile>\n";
}

} // namespace viscera::medical_io
