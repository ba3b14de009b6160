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

/// Cuts a line at its commas; a field in quotation marks may contain some, and doubled marks.
std::vector<std::string> cells(std::string_view line) {
  std::vector<std::string> list(1);
  bool withinQuotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && withinQuotes && i + 1 < line.size() && line[i + 1] == '"')
      list.back() += line[++i];
    else if (c == '"')
      withinQuotes = !withinQuotes;
    else if (c == ',' && !withinQuotes)
      list.emplace_back();
    else
      list.back() += c;
  }
  return list;
}

class FcsvReader {
public:
  explicit FcsvReader(const FileBytes& file) : scanner_(file, file.view()) {
    group_.name = toUtf8(stemOf(file.file));
    columns_ = {"id", "x", "y", "z", "ow", "ox", "oy", "oz", "vis", "sel", "lock", "label", "desc"};
  }

  HandleFile run() {
    while (scanner_.remaining() > 0) {
      const std::string_view line = trimmed(scanner_.line());
      if (line.starts_with('#'))
        readComment(trimmed(line.substr(1)));
      else if (!line.empty())
        readRow(line);
    }
    HandleFile result;
    if (!spaceStated_)
      result.warnings.push_back("the file does not state its axes: LPS is assumed");
    result.groups.push_back(std::move(group_));
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
  }

  /// Slicer wrote numbers before it wrote names.
  void readSpace(std::string_view value) {
    if (value != "LPS" && value != "RAS" && value != "0" && value != "1")
      scanner_.fail(diagnostic("the coordinate system %1 is not LPS or RAS", inQuotes(value)));
    ras_ = value == "RAS" || value == "0";
    spaceStated_ = true;
  }

  std::string cell(const std::vector<std::string>& row, std::string_view column) const {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    const auto index = static_cast<std::size_t>(found - columns_.begin());
    return index < row.size() ? toUtf8(std::string(trimmed(row[index]))) : std::string();
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
    const double x = coordinate(row, "x");
    const double y = coordinate(row, "y");
    handle.position = Vec3(x, y, coordinate(row, "z"));
    if (ras_)
      handle.position = lpsFromRas(handle.position);
    handle.label = cell(row, "label");
    handle.description = cell(row, "desc");
    handle.visible = cell(row, "vis") != "0";
    handle.locked = cell(row, "lock") == "1";
    group_.handles.push_back(std::move(handle));
  }

  TextScanner scanner_;
  HandleGroupRecord group_;
  std::vector<std::string> columns_;
  bool ras_ = false;
  bool spaceStated_ = false;
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
