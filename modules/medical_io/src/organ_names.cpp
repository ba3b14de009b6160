#include "viscera/medical_io/organ_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>

#include "file_bytes.h"
#include "text_scanner.h"

namespace viscera::medical_io {

bool saysNothing(std::string_view name) {
  std::string stem = lowered(name);
  stem.erase(stem.find_last_not_of("0123456789 ._-#()") + 1);
  stem.erase(0, stem.find_first_not_of(" ._-#("));
  static constexpr std::array<std::string_view, 25> kPlainNames = {
      "mesh",  "default",  "object",   "obj",   "model",    "group",     "grp",  "surface", "solid",
      "shape", "unnamed",  "untitled", "node",  "geometry", "scene",     "root", "noname",  "polydata",
      "mtl",   "material", "null",     "block", "part",     "primitive", "none"};
  return stem.empty() || std::find(kPlainNames.begin(), kPlainNames.end(), stem) != kPlainNames.end();
}

std::string comparableName(std::string_view name) {
  std::string text = lowered(trimmed(name));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::vector<std::string> uniqueNames(std::vector<std::string> names, const std::string& stem) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty())
      names[i] = stem + " " + std::to_string(i + 1);
    const std::string base = names[i];
    for (int number = 2; !taken.insert(comparableName(names[i])).second; ++number)
      names[i] = base + " " + std::to_string(number);
  }
  return names;
}

} // namespace viscera::medical_io
