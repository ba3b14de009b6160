#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "file_bytes.h"
#include "raw_surface.h"
#include "surface_formats/vtp_data_array.h"
#include "xml_tree.h"

namespace viscera::medical_io {

/// A VTK XML file of one dataset: its elements, and how its arrays are stored. VTK's expat, base64 and
/// decompressors do the work, but not its readers: those allocate what damaged headers promise and give the
/// part that they could read of a file that was cut off.
class VtkXmlDocument {
public:
  /// `file` outlives this. Throws `DataError` for XML that is not complete.
  explicit VtkXmlDocument(const FileBytes& file);
  VtkXmlDocument(const VtkXmlDocument&) = delete;
  VtkXmlDocument& operator=(const VtkXmlDocument&) = delete;

  const VtpStorage& storage() const { return storage_; }
  /// The dataset that the file says to hold, such as "PolyData"; empty for XML of another kind.
  std::string_view type() const;
  /// The document's element; null when there is none.
  const XmlElement* data() const { return tree_.root.child(type()); }

  /// Takes axes and name from the fields.
  void readFields(RawSurface& raw) const;
  /// The number of elements that an attribute of a piece states; 0 without it. Throws `DataError`.
  std::uint64_t count(const XmlElement& piece, std::string_view key) const;
  /// Appends the coordinates of a piece's points. Throws `DataError`.
  void readPoints(const XmlElement& piece, std::uint64_t points, RawSurface& raw) const;
  /// The array of that name among the cells. Throws `DataError`.
  const XmlElement& cellArray(const XmlElement& cells, std::string_view name) const;

private:
  XmlTree parse();

  const FileBytes& file_;
  VtpStorage storage_;
  XmlTree tree_;
};

} // namespace viscera::medical_io
