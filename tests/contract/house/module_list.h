#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "build_paths.h"

/// What the modules' CMakeLists.txt say of them, as `viscera_describe_module`
/// (resources/cmake/VisceraModule.cmake) noted it in the build folder.
namespace viscera::house {

struct Module {
  std::string name;                ///< "heart": of its library, headers and namespace.
  std::string folder;              ///< "motion/heart", below modules/.
  std::string stratum;             ///< "numbers"
  std::set<std::string> uses;      ///< Targets that public headers may include: "Viscera::core".
  std::set<std::string> privately; ///< Targets that sources may include, too.
  std::string about;               ///< What it contains, in one line.
};

struct ModuleList {
  std::vector<Module> modules;      ///< Those that this build has.
  std::vector<std::string> leftOut; ///< Folders of modules that this build leaves out.

  /// The module that a file of the project belongs to, by the longest folder; null for none.
  const Module* ofFile(const std::string& file) const {
    const Module* found = nullptr;
    for (const Module& module : modules)
      if (file.rfind("modules/" + module.folder + "/", 0) == 0 &&
          (!found || module.folder.size() > found->folder.size()))
        found = &module;
    return found;
  }

  const Module* named(const std::string& name) const {
    const auto found = std::find_if(modules.begin(), modules.end(),
                                    [&](const Module& module) { return module.name == name; });
    return found == modules.end() ? nullptr : &*found;
  }
};

/// The strata, from the lowest.
inline const std::vector<std::string> kStrata = {"numbers", "content", "work", "faces"};

inline std::set<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::set<std::string> words;
  for (std::string word; stream >> word;)
    words.insert(word);
  return words;
}

/// Reads the notes, a line a fact: a key, a space, its value.
inline ModuleList readModules(std::istream& notes) {
  ModuleList list;
  for (std::string line; std::getline(notes, line);) {
    const std::size_t space = line.find(' ');
    const std::string key = line.substr(0, space), value = space < line.size() ? line.substr(space + 1) : "";
    if (key == "module")
      list.modules.push_back({value, {}, {}, {}, {}, {}});
    else if (key == "left_out")
      list.leftOut.push_back(value);
    else if (key == "folder")
      list.modules.back().folder = value;
    else if (key == "stratum")
      list.modules.back().stratum = value;
    else if (key == "uses")
      list.modules.back().uses = wordsOf(value);
    else if (key == "privately")
      list.modules.back().privately = wordsOf(value);
    else if (key == "about")
      list.modules.back().about = value;
  }
  return list;
}

inline const ModuleList& modulesOfThisBuild() {
  static const ModuleList list = [] {
    std::ifstream notes(VISCERA_BINARY_DIR "/modules.txt");
    return readModules(notes);
  }();
  return list;
}

/// The modules named in USES or PRIVATELY: "core" for "Viscera::core".
inline std::set<std::string> modulesUsedBy(const Module& module) {
  std::set<std::string> names;
  for (const std::set<std::string>* targets : {&module.uses, &module.privately})
    for (const std::string& target : *targets)
      if (target.rfind("Viscera::", 0) == 0)
        names.insert(target.substr(9));
  return names;
}

} // namespace viscera::house
