#include "label_tables.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"

namespace viscera::medical_io {
namespace {

constexpr std::uintmax_t kLargestTable = 4U << 20U;
constexpr double kLargestChannel = 255;

/// The next word of a line, or what stands in quotes.
std::string_view takePart(std::string_view& line) {
  line = trimmed(line);
  if (!line.starts_with('"'))
    return takeWord(line);
  const std::size_t end = std::min(line.find('"', 1), line.size());
  const std::string_view part = line.substr(1, end - 1);
  line.remove_prefix(std::min(end + 1, line.size()));
  return part;
}

std::optional<Vec3> colorOf(const std::vector<std::string_view>& parts, std::size_t first) {
  Vec3 color;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto channel = first + i < parts.size() ? parseNumber(parts[first + i]) : std::nullopt;
    if (!channel || !(*channel >= 0 && *channel <= kLargestChannel))
      return std::nullopt;
    color[static_cast<int>(i)] = *channel / kLargestChannel;
  }
  return color;
}

/// A line of 3D Slicer's table (5 name R G B A), of ITK-SNAP's (5 R G B a vis mesh "name"), or only "5 name".
std::optional<StatedSegment> segmentOfLine(std::string_view line) {
  std::vector<std::string_view> parts;
  while (!trimmed(line).empty())
    parts.push_back(takePart(line));
  if (parts.size() < 2)
    return std::nullopt;
  const auto label = parseInteger(parts[0]);
  if (!label)
    return std::nullopt;
  StatedSegment segment;
  segment.label = *label;
  if (parts.size() >= 8 && parseNumber(parts[1])) {
    segment.name = parts[7];
    segment.color = colorOf(parts, 1);
  } else {
    segment.name = parts[1];
    segment.color = colorOf(parts, 2);
    std::replace(segment.name.begin(), segment.name.end(), '_', ' ');
  }
  return segment;
}

std::vector<StatedSegment> segmentsOfText(const FileBytes& file) {
  std::vector<StatedSegment> list;
  TextScanner scanner(file, file.view());
  while (scanner.remaining() > 0) {
    const std::string_view line = trimmed(scanner.line());
    if (line.empty() || line.starts_with('#'))
      continue;
    auto segment = segmentOfLine(line);
    if (!segment)
      return {};
    list.push_back(std::move(*segment));
  }
  return list;
}

std::vector<StatedSegment> segmentsOfJson(const FileBytes& file) {
  using nlohmann::json;
  const auto document = parseJson<json>(file.view(), file.name(), kUsualAdvice);
  if (!document.is_object())
    return {};
  const json& labels = document.contains("labels") ? document["labels"] : document;
  std::vector<StatedSegment> list;
  if (!labels.is_object())
    return {};
  for (const auto& [key, value] : labels.items()) {
    const auto number = parseInteger(key);
    if (number && value.is_string())
      list.push_back({*number, 0, value.get<std::string>(), {}});
    else if (!number && value.is_number_integer())
      list.push_back({value.get<std::int64_t>(), 0, key, {}});
  }
  return list;
}

/// The names that the table of a label map may have, the most particular first.
std::vector<std::string> namesFor(const std::filesystem::path& file) {
  const std::string stem = stemOf(file);
  std::vector<std::string> stems = {stem};
  for (const std::string_view ending : {"_seg", "_label", "_labels", "-label"})
    if (stem.size() > ending.size() && stem.ends_with(ending))
      stems.push_back(stem.substr(0, stem.size() - ending.size()));
  std::vector<std::string> names;
  for (const std::string& one : stems)
    for (const char* ending : {".ctbl", ".txt", ".json", "_colors.ctbl", "_colors.txt"})
      names.push_back(one + ending);
  names.insert(names.end(), {"labels.txt", "dataset.json"});
  return names;
}

/// Empty when there is none or several.
std::filesystem::path onlyColorTable(const std::filesystem::path& folder) {
  std::filesystem::path found;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (extensionOf(entry->path()) == ".ctbl") {
      if (!found.empty())
        return {};
      found = entry->path();
    }
  return found;
}

LabelTable tableOf(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size == 0 || size > kLargestTable)
    return {};
  try {
    const FileBytes bytes = readWholeFile(file);
    return {file, extensionOf(file) == ".json" ? segmentsOfJson(bytes) : segmentsOfText(bytes)};
  } catch (const Error&) {
    return {}; // One that cannot be read is none: the label map is good without it.
  }
}

} // namespace

LabelTable findLabelTable(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::vector<std::filesystem::path> candidates;
  for (const std::string& name : namesFor(file))
    candidates.push_back(folder / name);
  candidates.push_back(onlyColorTable(folder));
  for (const std::filesystem::path& candidate : candidates)
    if (LabelTable table = tableOf(candidate); !table.segments.empty())
      return table;
  return {};
}

} // namespace viscera::medical_io
