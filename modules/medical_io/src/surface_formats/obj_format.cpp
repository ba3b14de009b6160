#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

#include "space_tag.h"
#include "surface_formats.h"
#include "surface_formats/obj_materials.h"
#include "surface_parts.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

// Own reader: VTK's keeps single precision, knows neither comments nor vertex colours, and splits corners at
// texture seams, which opens a closed surface.
namespace viscera::medical_io {
namespace {

/// Words of the format that say nothing about the shape.
constexpr std::array<std::string_view, 10> kIgnored = {"vt",         "vn",        "s",   "usemap", "maplib",
                                                       "shadow_obj", "trace_obj", "lod", "bevel",  "vp"};
constexpr std::array<std::string_view, 4> kNotSurface = {"p", "l", "curv", "surf"};

class ObjReader {
public:
  explicit ObjReader(const FileBytes& file) : scanner_(file, file.view()), materials_(file.file) {}

  RawSurface run() {
    while (scanner_.remaining() > 0)
      readLine(scanner_.line());
    finishColors();
    finishParts();
    scanner_.finishCommas(raw_.warnings);
    if (thin_ > 0)
      raw_.warnings.push_back(phrase("%n {face|faces} of fewer than three corners left out", thin_));
    if (other_ > 0)
      raw_.warnings.push_back(
          phrase("%n {line|lines} with points, curves or free-form surfaces ignored", other_));
    return std::move(raw_);
  }

private:
  template <typename List>
  static bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
  }

  void readLine(std::string_view line) {
    // A backslash at its end continues a line.
    if (line.ends_with('\\')) {
      joined_ = line;
      while (joined_.ends_with('\\') && scanner_.remaining() > 0) {
        joined_.back() = ' ';
        joined_ += scanner_.line();
      }
      line = joined_;
    }
    const std::string_view word = takeWord(line);
    if (word == "v")
      readVertex(withoutComment(line));
    else if (word == "f" || word == "fo")
      readFace(withoutComment(line));
    else if (word == "o")
      now_.object = nameFrom(line);
    else if (word == "g")
      now_.group = nameFrom(line);
    else if (word == "usemtl")
      now_.material = nameFrom(line);
    else if (word == "mtllib")
      materials_.addFile(nameFrom(line));
    else if (word.starts_with('#'))
      readComment(std::string(word) + std::string(line));
    else if (contains(kNotSurface, word))
      ++other_;
    else if (!word.empty() && !contains(kIgnored, word))
      readUnknown(word);
  }

  static std::string_view withoutComment(std::string_view line) { return line.substr(0, line.find('#')); }

  void readVertex(std::string_view line) {
    std::array<double, 7> values{};
    std::size_t count = 0;
    for (std::string_view word = takeWord(line); !word.empty() && count < values.size();
         word = takeWord(line)) {
      values[count++] = scanner_.coordinateFrom(word, "a coordinate");
    }
    if (count < 3)
      scanner_.fail(diagnostic("a point has fewer than three coordinates"));
    raw_.addPoint(values[0], values[1], values[2]);
    if (count >= 6)
      colors_.insert(colors_.end(), values.begin() + 3, values.begin() + 6);
  }

  void readFace(std::string_view line) {
    const std::size_t first = raw_.corners.size();
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      const auto number = parseInteger(word.substr(0, word.find('/')));
      const auto points = static_cast<std::int64_t>(raw_.pointCount());
      if (!number || *number == 0)
        scanner_.fail(diagnostic("expected %2, found %1", inQuotes(word), "a point's number"));
      // Negative numbers count back from the last point so far.
      const std::int64_t corner = *number > 0 ? *number - 1 : points + *number;
      if (corner < 0)
        scanner_.fail(
            diagnostic("a face refers to point %1, but there are only %2 before it", *number, points));
      raw_.corners.push_back(corner);
    }
    if (raw_.corners.size() == first)
      scanner_.fail(diagnostic("a face has no corners"));
    if (raw_.corners.size() - first < 3) { // Some programs write lines so.
      raw_.corners.resize(first);
      ++thin_;
      return;
    }
    if (runs_.empty() || !(runs_.back() == now_)) {
      now_.first = raw_.polygonCount();
      runs_.push_back(now_);
    }
    raw_.endPolygon();
  }

  static std::string nameFrom(std::string_view line) {
    const std::string_view name = trimmed(line);
    return name == "default" || name == "(null)" ? std::string() : std::string(name);
  }

  /// Faces one after the other that have the same names.
  struct Run {
    std::string object, group, material;
    std::size_t first = 0; ///< Face.
    bool operator==(const Run& other) const {
      return object == other.object && group == other.group && material == other.material;
    }
  };

  bool differ(std::string Run::*name) const {
    return std::any_of(runs_.begin(), runs_.end(),
                       [&](const Run& run) { return run.*name != runs_.front().*name; });
  }

  /// Parts are the objects if there are several, else the groups, else the materials. A name that comes back
  /// continues its part.
  void finishParts() {
    if (runs_.empty())
      return;
    const bool objects = differ(&Run::object);
    const bool groups = !objects && differ(&Run::group);
    const Run& start = runs_.front();
    if (!objects)
      raw_.name = !start.object.empty() || groups ? start.object : start.group;
    PartList parts;
    std::map<std::uint32_t, std::string> materialOf;
    for (const Run& run : runs_) {
      const std::uint32_t part = parts.named(objects ? run.object : groups ? run.group : run.material);
      const auto [found, isNew] = materialOf.try_emplace(part, run.material);
      if (!isNew && found->second != run.material)
        found->second.clear();
      parts.begin(part, run.first);
    }
    if (std::any_of(runs_.begin(), runs_.end(), [](const Run& run) { return !run.material.empty(); }))
      materials_.read(raw_.warnings);
    for (const auto& [part, material] : materialOf)
      materials_.giveTo(parts.at(part), material);
    parts.moveTo(raw_);
  }

  void readComment(std::string_view comment) {
    if (!raw_.space)
      raw_.space = findSpace(comment, raw_.warnings);
  }

  void readUnknown(std::string_view word) {
    const bool text = std::all_of(word.begin(), word.end(), [](char c) { return c > ' ' && c <= '~'; });
    if (!text || raw_.pointCount() == 0)
      scanner_.fail(diagnostic("%1 is not a statement of an OBJ file", inQuotes(word)));
    ++other_;
  }

  /// Colours go from 0 to 1, in some programs to 255.
  void finishColors() {
    if (colors_.size() != raw_.coordinates.size() || colors_.empty())
      return;
    const double top = *std::max_element(colors_.begin(), colors_.end());
    const double scale = top > 1.0 ? 1.0 : 255.0;
    raw_.colors.reserve(colors_.size());
    for (const double value : colors_)
      raw_.colors.push_back(static_cast<std::uint8_t>(
          value >= 0 ? std::min(std::lround(std::min(value, 256.0) * scale), 255L) : 0));
  }

  TextScanner scanner_;
  RawSurface raw_;
  std::string joined_;
  std::vector<double> colors_;
  ObjMaterials materials_;
  Run now_;
  std::vector<Run> runs_;
  std::uint64_t thin_ = 0;
  std::uint64_t other_ = 0;
};

} // namespace

RawSurface readObj(const FileBytes& file) {
  return ObjReader(file).run();
}

void writeObj(std::ostream& out, const geometry::TriangleMesh& mesh, const WriteSurface& options) {
  std::string text = "# " + writtenComment(options) + "\n";
  const std::string name = nameInComment(writtenComment(options));
  if (!name.empty())
    text += "o " + name + "\n";
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    text += 'v';
    for (int axis = 0; axis < 3; ++axis)
      appendNumber(text += ' ', mesh.points(v, axis));
    for (int k = 0; k < 3 && mesh.colors.rows() > 0; ++k)
      appendNumber(text += ' ', static_cast<double>(mesh.colors(v, k)) / 255.0);
    text += '\n';
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += 'f';
    for (int k = 0; k < 3; ++k)
      appendNumber(text += ' ', std::int64_t{mesh.triangles(t, k)} + 1);
    text += '\n';
  }
  out << text;
}

} // namespace viscera::medical_io
