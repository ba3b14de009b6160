#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "module_list.h"
#include "source_files.h"

namespace viscera::house {
namespace {

/// Includes from the command line, or from what both use, to the window that are still there. Nothing may be
/// added.
const std::set<std::pair<std::string, std::string>> kKnownExceptions = {};

/// Modules below faces that are there to be loaded by Qt.
const std::set<std::string> kOfQt = {"plugin", "localised_scc_plugin"};

/// What `line` of `file` includes although command line and window do not know each other; else empty. Only
/// `app/main.cpp` knows both.
std::string strangerIn(const std::string& line, const std::string& file) {
  static const std::regex apps(R"re(^\s*#\s*include\s*"((cli|window)/[^"]*)")re");
  std::smatch match;
  if (file == "app/main.cpp" || !std::regex_search(line, match, apps))
    return {};
  return file.rfind("app/" + match[2].str() + "/", 0) == 0 ? std::string() : match[1].str();
}

/// The namespaces that a file may open: the name of a module whose folder it lies in. The window's is the
/// program's own.
std::set<std::string> namespacesOf(const std::string& file, const ModuleList& list) {
  if (file.rfind("modules/", 0) != 0)
    return {file.rfind("app/cli/", 0) == 0 ? "viscera::app::cli" : "viscera::app"};
  std::set<std::string> names;
  for (const Module& module : list.modules)
    if (file.rfind("modules/" + module.folder + "/", 0) == 0)
      names.insert(module.name == "core" ? "viscera" : "viscera::" + module.name);
  return names;
}

/// Whether `line` opens a namespace that is neither the one of `file`'s folder nor within it.
bool opensAnother(const std::string& line, const std::string& file, const ModuleList& list) {
  static const std::regex opened(R"(^namespace (viscera[\w:]*) \{)");
  std::smatch match;
  if (!std::regex_search(line, match, opened))
    return false;
  const std::string found = match[1];
  const std::set<std::string> wanted = namespacesOf(file, list);
  return std::none_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
    return found == name || (name != "viscera" && found.rfind(name + "::", 0) == 0);
  });
}

/// Whether the namespace that line `at` opens holds nothing but the forward declaration of a class: a pointer
/// to it needs no include.
bool declaresOneClass(const std::vector<std::string>& lines, std::size_t at) {
  static const std::regex declared(R"(^class \w+;$)");
  return at + 2 < lines.size() && std::regex_match(lines[at + 1], declared) && lines[at + 2].starts_with('}');
}

/// What an include line asks for, as the beginning of a target's name: "Viscera::core", "VTK::", "Qt5::";
/// empty for what needs no module.
std::string targetOf(const std::string& line) {
  static const std::regex ours(R"(^\s*#\s*include\s*[<"]viscera/(\w+)/)");
  static const std::regex vtk(R"(^\s*#\s*include\s*[<"]vtk[A-Z])");
  static const std::regex qt(R"(^\s*#\s*include\s*[<"]Qt?[A-Z])");
  std::smatch match;
  if (line.find("include") == std::string::npos)
    return {};
  if (std::regex_search(line, match, ours))
    return "Viscera::" + match[1].str();
  if (std::regex_search(line, vtk))
    return "VTK::";
  return std::regex_search(line, qt) ? "Qt5::" : "";
}

bool leadsToVtkOrQt(const std::string& line) {
  const std::string target = targetOf(line);
  return target == "VTK::" || target == "Qt5::";
}

/// Whether targets hold `wanted`, or one of VTK's or Qt's.
bool holds(const std::set<std::string>& targets, const std::string& wanted) {
  return std::any_of(targets.begin(), targets.end(), [&](const std::string& target) {
    return wanted.back() == ':' ? target.rfind(wanted, 0) == 0 : target == wanted;
  });
}

bool isPublic(const std::string& file) {
  return file.find("/include/viscera/") != std::string::npos;
}

/// The fault of a line that includes `target`; empty for none.
std::string faultOf(const std::string& target, bool inPublicHeader, const Module& module) {
  if (target.empty() || target == "Viscera::" + module.name || holds(module.uses, target))
    return {};
  if (!holds(module.privately, target))
    return "includes " + target + ", which stands neither in its USES nor in its PRIVATELY";
  return inPublicHeader ? "includes " + target + " in a public header, so it belongs into USES" : "";
}

/// The targets that a module includes, each with whether a public header does.
std::map<std::string, bool> includedBy(const Module& module, const ModuleList& list) {
  std::map<std::string, bool> included;
  for (const std::filesystem::path& file : sourcesUnder("modules/" + module.folder))
    if (list.ofFile(shortName(file)) == &module)
      for (const std::string& line : linesOf(file))
        if (const std::string target = targetOf(line); !target.empty())
          included[target] |= isPublic(shortName(file));
  return included;
}

/// The faults of a module's lists, where they promise more than its files include.
std::string superfluousIn(const Module& module, const std::map<std::string, bool>& included) {
  std::ostringstream faults;
  const auto check = [&](const std::set<std::string>& targets, bool publicly) {
    std::set<std::string> wanted;
    for (const std::string& target : targets)
      for (const std::string prefix : {"Viscera::", "VTK::", "Qt5::"})
        if (target.rfind(prefix, 0) == 0)
          wanted.insert(prefix == "Viscera::" ? target : prefix);
    for (const std::string& target : wanted)
      if (!included.contains(target))
        faults << module.name << " lists " << target << " and includes nothing of it\n";
      else if (publicly && !included.at(target))
        faults << module.name << " has " << target << " in USES, but only its sources include it\n";
  };
  check(module.uses, true);
  check(module.privately, false);
  return faults.str();
}

int heightOf(const Module& module) {
  return static_cast<int>(std::find(kStrata.begin(), kStrata.end(), module.stratum) - kStrata.begin());
}

/// The faults of the arrows themselves: to a higher stratum, to what is not known, or in a circle.
std::string upwardIn(const ModuleList& list) {
  std::ostringstream faults;
  std::set<std::string> done;
  for (const std::string& folder : list.leftOut)
    done.insert(std::filesystem::path(folder).filename().string());
  for (bool grows = true; grows;) {
    const std::size_t before = done.size();
    for (const Module& module : list.modules) {
      const std::set<std::string> used = modulesUsedBy(module);
      if (std::includes(done.begin(), done.end(), used.begin(), used.end()))
        done.insert(module.name);
    }
    grows = done.size() > before;
  }
  for (const Module& module : list.modules) {
    if (!done.contains(module.name))
      faults << module.name << " uses itself through others, or an unknown module\n";
    for (const std::string& name : modulesUsedBy(module))
      if (const Module* used = list.named(name); used && heightOf(*used) > heightOf(module))
        faults << module.name << " (" << module.stratum << ") uses " << name << " (" << used->stratum
               << ")\n";
  }
  return faults.str();
}

/// The folder of a file of the window, as "slices"; empty for what lies in the window's own folder.
std::string windowFolder(const std::string& file) {
  const std::string inside = file.substr(file.find("window/") + 7);
  const std::size_t slash = inside.find('/');
  return slash == std::string::npos ? std::string() : inside.substr(0, slash);
}

/// The folders of the window from which includes lead to other folders and back.
std::set<std::string> inCircles(std::map<std::string, std::set<std::string>> arrows) {
  // A folder that leads nowhere, or to such folders alone, is in no circle.
  for (bool shrinks = true; shrinks;) {
    shrinks = false;
    for (auto folder = arrows.begin(); folder != arrows.end();) {
      std::erase_if(folder->second, [&](const std::string& other) { return !arrows.contains(other); });
      const bool ends = folder->second.empty();
      folder = ends ? arrows.erase(folder) : std::next(folder);
      shrinks |= ends;
    }
  }
  std::set<std::string> left;
  for (const auto& [folder, others] : arrows)
    left.insert(folder);
  return left;
}

ModuleList madeOf(const std::string& notes) {
  std::istringstream stream(notes);
  return readModules(stream);
}

} // namespace

TEST(IncludeArrows, AreListedInCMakeForEveryInclude) {
  const ModuleList& list = modulesOfThisBuild();
  int files = 0;
  for (const Module& module : list.modules)
    for (const std::filesystem::path& file : sourcesUnder("modules/" + module.folder)) {
      if (list.ofFile(shortName(file)) != &module)
        continue;
      ++files;
      for (const std::string& line : linesOf(file)) {
        const std::string fault = faultOf(targetOf(line), isPublic(shortName(file)), module);
        EXPECT_TRUE(fault.empty()) << shortName(file) << ": " << module.name << " " << fault << ": " << line;
      }
    }
  EXPECT_GT(files, 100);
}

TEST(IncludeArrows, AreAllNeeded) {
  for (const Module& module : modulesOfThisBuild().modules)
    if (!sourcesUnder("modules/" + module.folder).empty()) {
      EXPECT_EQ(superfluousIn(module, includedBy(module, modulesOfThisBuild())), "");
    }
}

TEST(IncludeArrows, PointDownwardInEveryModule) {
  EXPECT_EQ(upwardIn(modulesOfThisBuild()), "");
}

TEST(IncludeArrows, BelowFacesLeadNeitherToVtkNorToQt) {
  const ModuleList& list = modulesOfThisBuild();
  int files = 0;
  for (const Module& module : list.modules) {
    if (module.stratum == "faces" || kOfQt.contains(module.name))
      continue;
    for (const std::set<std::string>& targets : {module.uses, module.privately})
      EXPECT_FALSE(holds(targets, "VTK::") || holds(targets, "Qt5::")) << module.name;
    for (const std::filesystem::path& file : sourcesUnder("modules/" + module.folder))
      if (list.ofFile(shortName(file)) == &module) {
        ++files;
        for (const std::string& line : linesOf(file))
          EXPECT_FALSE(leadsToVtkOrQt(line)) << shortName(file) << ": " << line;
      }
  }
  EXPECT_GT(files, 100);
}

TEST(IncludeArrows, ToVtkAndQtAreSeen) {
  EXPECT_TRUE(leadsToVtkOrQt("#include <vtkNew.h>"));
  EXPECT_TRUE(leadsToVtkOrQt("# include \"QString\""));
  EXPECT_TRUE(leadsToVtkOrQt("#include <QtCore/QFile>"));
  EXPECT_FALSE(leadsToVtkOrQt("#include \"surface_formats/vtk_xml_document.h\""));
  EXPECT_FALSE(leadsToVtkOrQt("#include \"viscera/core/error.h\""));
}

TEST(IncludeArrows, KnowEveryModule) {
  const ModuleList& list = modulesOfThisBuild();
  const std::filesystem::path root = std::filesystem::path(VISCERA_SOURCE_DIR) / "modules";
  const auto known = [&](const std::string& file) {
    return list.ofFile(file) ||
           std::any_of(list.leftOut.begin(), list.leftOut.end(), [&](const std::string& folder) {
             return file.rfind("modules/" + folder + "/", 0) == 0;
           });
  };
  for (const std::filesystem::path& file : sourcesUnder("modules"))
    EXPECT_TRUE(known(shortName(file))) << shortName(file) << " belongs to no module that CMake knows";
}

TEST(IncludeArrows, DoNotLeadFromCommandLineToWindowNorBack) {
  std::set<std::pair<std::string, std::string>> met;
  for (const std::filesystem::path& file : sourcesUnder("app"))
    for (const std::string& line : linesOf(file))
      if (const std::string found = strangerIn(line, shortName(file)); !found.empty()) {
        met.emplace(shortName(file), found);
        EXPECT_TRUE(kKnownExceptions.count({shortName(file), found}))
            << shortName(file) << " includes " << found << ": what both need belongs into a module";
      }
  EXPECT_EQ(met, kKnownExceptions) << "an exception that is no longer needed goes from the list";
}

TEST(IncludeArrows, OfTheWindowsFoldersLeadInNoCircle) {
  static const std::regex ours(R"re(^\s*#\s*include\s*"(window/[^"]*)")re");
  std::map<std::string, std::set<std::string>> arrows;
  for (const std::filesystem::path& file : sourcesUnder("app/window")) {
    std::set<std::string>& others = arrows[windowFolder(shortName(file))];
    std::smatch match;
    for (const std::string& line : linesOf(file))
      if (std::regex_search(line, match, ours) && windowFolder(match[1]) != windowFolder(shortName(file)))
        others.insert(windowFolder(match[1]));
  }
  EXPECT_GT(arrows.size(), 15u);
  EXPECT_EQ(inCircles(arrows), std::set<std::string>()) << "these lead to another folder and back, or there";
  EXPECT_EQ(inCircles({{"a", {"b"}}, {"b", {"a", "c"}}, {"c", {}}}), (std::set<std::string>{"a", "b"}));
}

TEST(Namespaces, EqualFolders) {
  const ModuleList& list = modulesOfThisBuild();
  for (const std::string folder : {"app", "modules"})
    for (const std::filesystem::path& file : sourcesUnder(folder)) {
      if (folder == "modules" && !list.ofFile(shortName(file)))
        continue; // Of a module that this build leaves out.
      const std::vector<std::string> lines = linesOf(file);
      for (std::size_t i = 0; i < lines.size(); ++i)
        EXPECT_FALSE(opensAnother(lines[i], shortName(file), list) && !declaresOneClass(lines, i))
            << shortName(file) << ": " << lines[i];
    }
}

TEST(Namespaces, OfAnotherFolderAreSeen) {
  const ModuleList list = madeOf("module core\nfolder core\nmodule live\nfolder live\nmodule heart\n"
                                 "folder motion/heart\nmodule live_plugin\nfolder live/plugin\n");
  EXPECT_TRUE(opensAnother("namespace viscera::document {", "modules/live/src/a.cpp", list));
  EXPECT_TRUE(opensAnother("namespace viscera {", "modules/live/src/a.cpp", list));
  EXPECT_TRUE(opensAnother("namespace viscera::live {", "modules/motion/heart/src/a.h", list));
  EXPECT_TRUE(opensAnother("namespace viscera::app {", "app/cli/a.h", list));
  EXPECT_TRUE(opensAnother("namespace viscera::app::cli {", "modules/live/src/a.h", list));
  EXPECT_FALSE(opensAnother("namespace viscera::live::edit {", "modules/live/src/a.cpp", list));
  EXPECT_FALSE(opensAnother("namespace viscera::live {", "modules/live/plugin/a.cpp", list));
  EXPECT_FALSE(opensAnother("namespace viscera {", "modules/core/src/a.cpp", list));
  EXPECT_TRUE(declaresOneClass({"namespace viscera::heart {", "class Heart;", "}"}, 0));
  EXPECT_FALSE(declaresOneClass({"namespace viscera::heart {", "class Heart {", "};", "}"}, 0));
  EXPECT_FALSE(declaresOneClass({"namespace viscera::heart {", "class Heart;", "class Valve;", "}"}, 0));
}

TEST(IncludeArrows, AreSeenWhereCMakeDoesNotListThem) {
  const ModuleList list = madeOf("module scene\nfolder scene\nstratum faces\nuses Viscera::core\n"
                                 "privately Viscera::geometry VTK::RenderingCore\n");
  const Module& scene = *list.named("scene");
  const auto fault = [&](const std::string& line, bool inPublicHeader) {
    return faultOf(targetOf(line), inPublicHeader, scene);
  };
  EXPECT_EQ(fault("#include \"viscera/core/arrays.h\"", true), "");
  EXPECT_EQ(fault("#include \"viscera/scene/theme.h\"", true), "");
  EXPECT_EQ(fault("#include \"viscera/geometry/volume.h\"", false), "");
  EXPECT_NE(fault("#include \"viscera/geometry/volume.h\"", true), "");
  EXPECT_NE(fault("#include \"viscera/document/ids.h\"", false), "");
  EXPECT_EQ(fault("#  include <vtkActor.h>", false), "");
  EXPECT_NE(fault("#  include <vtkActor.h>", true), "");
  EXPECT_NE(fault("#include <QString>", false), "");
  EXPECT_NE(fault("#include <QtPlugin>", false), "");
  EXPECT_EQ(strangerIn("#include \"window/mode.h\"", "app/cli/stage.cpp"), "window/mode.h");
  EXPECT_EQ(strangerIn("#include \"cli/stage.h\"", "app/window/mode.cpp"), "cli/stage.h");
  EXPECT_EQ(strangerIn("#include \"window/style/language.h\"", "app/signs/beat.cpp"),
            "window/style/language.h");
  EXPECT_EQ(strangerIn("#include \"cli/stage.h\"", "app/camera_json.cpp"), "cli/stage.h");
  EXPECT_TRUE(strangerIn("#include \"window/mode.h\"", "app/window/work/actions.cpp").empty());
}

TEST(IncludeArrows, AreSeenWhereCMakeListsTooMany) {
  const ModuleList list = madeOf(
      "module scene\nuses Viscera::core Viscera::geometry\nprivately VTK::RenderingCore Threads::Threads\n");
  EXPECT_EQ(superfluousIn(list.modules[0],
                          {{"Viscera::core", true}, {"Viscera::geometry", true}, {"VTK::", false}}),
            "");
  EXPECT_NE(superfluousIn(list.modules[0],
                          {{"Viscera::core", true}, {"Viscera::geometry", false}, {"VTK::", false}}),
            "");
  EXPECT_NE(superfluousIn(list.modules[0], {{"Viscera::core", true}, {"Viscera::geometry", true}}), "");
}

TEST(IncludeArrows, AreSeenWhenTheyPointUpwardOrInACircle) {
  const std::string core = "module core\nstratum numbers\n";
  EXPECT_EQ(upwardIn(madeOf(core + "module live\nstratum work\nuses Viscera::core\n")), "");
  EXPECT_NE(upwardIn(madeOf(core + "module live\nstratum work\nuses Viscera::scene\n"
                                   "module scene\nstratum faces\nprivately Viscera::core\n")),
            "");
  EXPECT_NE(
      upwardIn(madeOf("module a\nstratum work\nuses Viscera::b\nmodule b\nstratum work\nuses Viscera::a\n")),
      "");
  EXPECT_NE(upwardIn(madeOf("module a\nstratum work\nuses Viscera::gone\n")), "");
}

} // namespace viscera::house
