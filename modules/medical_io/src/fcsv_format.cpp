#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "handle_formats.h"
#include "space_tag.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::medical_io {
namespace {

/// Cuts a line at its commas; a field in quotation marks may contain some, and doubled marks. A mark within a
/// field, as in 5" probe, is a letter: Slicer 4 wrote labels as they are.
std::vector<std::string> cells(std::string_view line) {
  std::vector<std::string> list(1);
  bool withinQuotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && withinQuotes && i + 1 < line.size() && line[i + 1] == '"')
      list.back() += line[++i];
    else if (c == '"' && withinQuotes)
      withinQuotes = false;
    else if (c == '"' && trimmed(list.back()).empty())
      withinQuotes = true;
    else if (c == ',' && !withinQuotes)
      list.emplace_back();
    else
      list.back() += c;
  }
  return list;
}

using Columns = std::vector<std::string>;

/// What Slicer 4 and 5 write. A status is in no header: their rows have it behind the last named column.
const Columns& slicersColumns() {
  static const Columns kColumns = {"id", "x",   "y",   "z",    "ow",    "ox",   "oy",
                                   "oz", "vis", "sel", "lock", "label", "desc", "associatednodeid"};
  return kColumns;
}

/// What Slicer 3 wrote.
const Columns& oldColumns() {
  static const Columns kColumns = {"label", "x", "y", "z", "sel", "vis"};
  return kColumns;
}

class FcsvReader {
public:
  explicit FcsvReader(const FileBytes& file) : file_(file), scanner_(file, file.view()) {
    group_.name = toUtf8(stemOf(file.file));
  }

  HandleFile run() {
    while (scanner_.remaining() > 0) {
      const std::string_view line = trimmed(scanner_.line());
      if (line.starts_with('#'))
        readComment(trimmed(line.substr(1)));
      else if (!line.empty())
        readRow(line);
    }
    if (listIsLocked_ || listIsHidden_)
      for (HandleRecord& handle : group_.handles) {
        handle.locked = handle.locked || listIsLocked_;
        handle.visible = handle.visible && !listIsHidden_;
      }
    HandleFile result;
    if (!spaceStated_)
      result.warnings.push_back("the file does not state its axes: RAS is assumed, as 3D Slicer does");
    result.groups.push_back(std::move(group_));
    reportUnplaced(result, unplaced_, file_);
    return result;
  }

private:
  void readComment(std::string_view comment) {
    const std::size_t equals = comment.find('=');
    if (equals == comment.npos)
      return;
    const std::string key = lowered(trimmed(comment.substr(0, equals)));
    const std::string_view value = trimmed(comment.substr(equals + 1));
    if (key == "coordinatesystem")
      readSpace(value);
    if (key == "columns") {
      columns_ = cells(value);
      for (std::string& column : columns_)
        column = lowered(trimmed(column));
    }
    readListComment(key, value);
  }

  /// The properties of a list, which Slicer 3 wrote. It draws selected points, as all are by default, in
  /// `selectedColor`, which comes behind `color`.
  void readListComment(const std::string& key, std::string_view value) {
    if (key == "name" && !value.empty())
      group_.name = toUtf8(std::string(value));
    if (key == "locked")
      listIsLocked_ = value == "1";
    if (key == "visibility")
      listIsHidden_ = value == "0";
    if (key != "color" && key != "selectedcolor")
      return;
    const std::vector<std::string> parts = cells(value);
    Vec3 color = group_.color;
    for (std::size_t k = 0; k < 3 && parts.size() == 3; ++k)
      if (const std::optional<double> part = parseNumber(trimmed(parts[k])); part && std::isfinite(*part))
        color[static_cast<Eigen::Index>(k)] = std::clamp(*part, 0.0, 1.0);
    group_.color = color;
  }

  /// Slicer wrote numbers before it wrote names.
  void readSpace(std::string_view value) {
    const std::string space = lowered(value);
    if (space != "lps" && space != "ras" && space != "0" && space != "1")
      scanner_.fail(diagnostic("the coordinate system %1 is not LPS or RAS", inQuotes(value)));
    ras_ = space == "ras" || space == "0";
    spaceStated_ = true;
  }

  /// The columns by the header; without one, by what a row of this length is of.
  const Columns& columnsOf(const std::vector<std::string>& row) const {
    if (!columns_.empty())
      return columns_;
    return row.size() <= oldColumns().size() + 1 ? oldColumns() : slicersColumns();
  }

  std::string cell(const std::vector<std::string>& row, std::string_view column) const {
    const Columns& columns = columnsOf(row);
    const auto found = std::find(columns.begin(), columns.end(), column);
    const auto index = static_cast<std::size_t>(found - columns.begin());
    return found != columns.end() && index < row.size() ? toUtf8(std::string(trimmed(row[index])))
                                                        : std::string();
  }

  /// The status that Slicer 5 writes into a row, also where the header does not list it. Empty: the row has
  /// none.
  std::string statusOf(const std::vector<std::string>& row) const {
    for (const char* name : {"positionstatus", "status"})
      if (std::string status = cell(row, name); !status.empty())
        return status;
    const Columns& stated = columnsOf(row);
    const Columns& usual = slicersColumns();
    const bool slicers =
        stated.size() <= usual.size() && std::equal(stated.begin(), stated.end(), usual.begin());
    return slicers && row.size() > usual.size() ? std::string(trimmed(row[usual.size()])) : std::string();
  }

  double coordinate(const std::vector<std::string>& row, std::string_view column) const {
    const std::string text = cell(row, column);
    const std::optional<double> value = parseNumber(text);
    if (!value || !std::isfinite(*value))
      scanner_.fail(
          diagnostic("expected %2, found %1", inQuotes(text), diagnostic("the coordinate %1", column)));
    return *value;
  }

  void readRow(std::string_view line) {
    const std::vector<std::string> row = cells(line);
    HandleRecord handle;
    handle.label = cell(row, "label");
    if (!isPlaced(statusOf(row))) {
      unplaced_.push_back(handle.label.empty() ? cell(row, "id") : handle.label);
      return;
    }
    const double x = coordinate(row, "x");
    const double y = coordinate(row, "y");
    handle.position = Vec3(x, y, coordinate(row, "z"));
    if (ras_)
      handle.position = lpsFromRas(handle.position);
    handle.description = cell(row, "desc");
    handle.visible = cell(row, "vis") != "0";
    handle.locked = cell(row, "lock") == "1";
    group_.handles.push_back(std::move(handle));
  }

  const FileBytes& file_;
  TextScanner scanner_;
  HandleGroupRecord group_;
  Columns columns_; ///< Lower case; empty: the file has no header of them.
  std::vector<std::string> unplaced_;
  bool ras_ = true; ///< Unless the file says otherwise: files of Slicer 3 do not, and are.
  bool spaceStated_ = false;
  bool listIsLocked_ = false;
  bool listIsHidden_ = false;
};

/// Quoted where the table needs it; a line break would end the row.
std::string quotedText(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }, ' ');
  if (text.find_first_of(",\"") == text.npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void writeRow(std::ostream& out, const HandleRecord& handle, std::size_t number, Space space) {
  const Vec3 place = space == Space::ras ? lpsFromRas(handle.position) : handle.position;
  out << "Viscera_" << number << ',' << exactNumber(place.x()) << ',' << exactNumber(place.y()) << ','
      << exactNumber(place.z()) << ",0,0,0,1," << (handle.visible ? 1 : 0) << ",1," << (handle.locked ? 1 : 0)
      << ',' << quotedText(handle.label) << ',' << quotedText(handle.description) << ",\n";
}

} // namespace

void writeFcsv(std::ostream& out, const HandleFile& handles, Space space) {
  out << "# Markups fiducial file version = 5.0\n# CoordinateSystem = " << spaceName(space)
      << "\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
  std::unordered_map<std::string, Vec3> known; // A handle of several groups has one label and one place.
  std::size_t number = 0;
  for (const HandleGroupRecord& group : handles.groups)
    for (const HandleRecord& handle : group.handles) {
      const auto [entry, isNew] = known.try_emplace(handle.label, handle.position);
      if (isNew || entry->second != handle.position)
        writeRow(out, handle, ++number, space);
    }
}

HandleFile readFcsv(const FileBytes& file) {
  return FcsvReader(file).run();
}

} // namespace viscera::medical_io
