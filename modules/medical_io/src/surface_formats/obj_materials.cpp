#include "surface_formats/obj_materials.h"

#include <algorithm>
#include <set>

#include "file_bytes.h"
#include "text_scanner.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kTitleBytes = 200;

/// A number from 0 to 1, with a decimal point or comma.
std::optional<double> fractionFrom(std::string_view word) {
  std::string english(word);
  std::replace(english.begin(), english.end(), ',', '.');
  const std::optional<double> value = parseNumber(english);
  if (!value || !(*value >= 0))
    return std::nullopt;
  return std::min(*value, 1.0);
}

/// Beside the OBJ file, whatever folder of another machine is named.
std::filesystem::path beside(const std::filesystem::path& obj, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::filesystem::path relative = name;
  if (relative.is_absolute() || name.find(':') != name.npos)
    relative = relative.filename();
  return obj.parent_path() / relative;
}

bool isThere(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

} // namespace

std::vector<std::filesystem::path> ObjMaterials::filesOf(const std::string& names) const {
  const std::filesystem::path whole = beside(obj_, names);
  std::vector<std::filesystem::path> files;
  std::string_view rest = names;
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest))
    files.push_back(beside(obj_, std::string(word)));
  const bool allThere = files.size() > 1 && std::all_of(files.begin(), files.end(), isThere);
  return isThere(whole) || !allThere ? std::vector{whole} : files;
}

void ObjMaterials::read(std::vector<Text>& warnings) {
  std::set<std::filesystem::path> done;
  for (const std::string& names : named_)
    for (const std::filesystem::path& file : filesOf(names)) {
      if (names.empty() || !done.insert(file).second)
        continue;
      try {
        readFile(file);
      } catch (const Error& error) {
        warnings.push_back(
            phrase("the colours in %1 are missing: %2", file.filename().string(), error.problem()));
      }
    }
}

void ObjMaterials::readFile(const std::filesystem::path& file) {
  const FileBytes bytes = readBeginOfFile(file, kMostHeaderBytes);
  TextScanner scanner(bytes, bytes.view());
  const bool byVtk =
      lowered(bytes.view().substr(0, kTitleBytes)).find("visualization toolkit") != std::string::npos;
  Material* current = nullptr;
  while (scanner.remaining() > 0)
    readStatement(scanner.line(), byVtk, current);
}

void ObjMaterials::readStatement(std::string_view line, bool byVtk, Material*& current) {
  const std::string word = lowered(takeWord(line));
  if (word == "newmtl") {
    current = &materials_[std::string(trimmed(line))];
  } else if (current != nullptr && word == "kd") {
    const auto red = fractionFrom(takeWord(line));
    const auto green = fractionFrom(takeWord(line));
    const auto blue = fractionFrom(takeWord(line));
    if (red) // One number is a grey.
      current->color = Vec3(*red, green.value_or(*red), blue.value_or(green.value_or(*red)));
  } else if (current != nullptr && (word == "d" || word == "tr")) {
    std::string_view number = takeWord(line);
    if (number == "-halo")
      number = takeWord(line);
    // VTK, and so 3D Slicer, writes the opacity as Tr.
    (word == "d" || byVtk ? current->opacity : current->transparency) = fractionFrom(number);
  }
}

void ObjMaterials::giveTo(RawPart& part, const std::string& material) const {
  part.material = material;
  const auto found = materials_.find(material);
  if (found == materials_.end())
    return;
  const Material& look = found->second;
  part.color = look.color;
  const double opacity = look.opacity.value_or(1 - look.transparency.value_or(0));
  // Programs differ in what 0 means; a surface that cannot be seen is never meant.
  part.opacity = opacity > 0 ? opacity : 1;
}

} // namespace viscera::medical_io
