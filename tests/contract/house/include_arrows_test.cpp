#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "source_files.h"

namespace viscera::house {
namespace {

std::set<std::string> with(std::set<std::string> modules, const std::set<std::string>& more) {
  modules.insert(more.begin(), more.end());
  return modules;
}

/// What each module may include, itself left out. Arrows point downward only.
const std::map<std::string, std::set<std::string>>& allowedModules() {
  static const std::set<std::string> numerical = {"core",        "norms",     "geometry",   "coordinates",
                                                  "deformation", "sequences", "circulation"};
  static const std::set<std::string> documentUses =
      with(numerical, {"sample_organs", "medical_io", "slices"});
  static const std::map<std::string, std::set<std::string>> allowed = {
      {"core", {}},
      {"norms", {"core"}},
      {"geometry", {"core"}},
      {"coordinates", {"core", "geometry"}},
      {"deformation", {"core", "geometry", "coordinates"}},
      {"tracking", {"core", "geometry", "coordinates", "deformation"}},
      {"sequences", {"core", "norms"}},
      {"circulation", {"core", "norms"}},
      {"plugin", {"core", "geometry", "coordinates"}},
      {"localised_scc", {"core", "geometry", "coordinates", "plugin"}},
      {"contour", {"core", "geometry"}},
      {"sample_organs", with(numerical, {"contour"})},
      {"medical_io", with(numerical, {"contour"})},
      {"slices", {"core", "geometry", "medical_io"}},
      {"scene", numerical},
      {"paraview_plugin", {}},
      {"vtk_filters", {"core", "geometry", "coordinates", "deformation"}},
      {"reproduction", with(numerical, {"plugin", "sample_organs"})},
      {"document", documentUses},
      {"live", with(documentUses, {"document", "plugin"})},
      {"motion", with(documentUses, {"tracking", "document", "plugin", "live"})},
      {"presentation", with(documentUses, {"document", "plugin", "live", "motion", "scene"})},
      {"lesson", with(documentUses, {"document", "plugin", "live", "motion", "scene", "presentation"})},
      {"report", with(documentUses, {"document", "plugin", "live", "motion", "scene", "presentation"})},
      {"python", with(documentUses, {"document", "plugin", "live", "motion", "localised_scc"})}};
  return allowed;
}

const std::set<std::string> kMayUseVtk = {"contour", "medical_io", "scene", "presentation", "vtk_filters"};
const std::set<std::string> kMayUseQt = {"plugin",       "localised_scc", "document",
                                         "reproduction", "lesson",        "report"};

/// Includes from the command line, or from what both use, to the window that are still there. Nothing may be
/// added.
const std::set<std::pair<std::string, std::string>> kKnownExceptions = {};

/// What `line` of `file` includes although command line and window do not know each other; else empty. Only
/// `app/main.cpp` knows both.
std::string strangerIn(const std::string& line, const std::string& file) {
  static const std::regex apps(R"re(^\s*#\s*include\s*"((cli|window)/[^"]*)")re");
  std::smatch match;
  if (file == "app/main.cpp" || !std::regex_search(line, match, apps))
    return {};
  return file.rfind("app/" + match[2].str() + "/", 0) == 0 ? std::string() : match[1].str();
}

/// The namespace that the files of a folder open. The window's is the program's own.
std::string namespaceOf(const std::string& file) {
  static const std::regex module(R"(^modules/(\w+)/)");
  std::smatch match;
  if (std::regex_search(file, match, module))
    return match[1] == "core" ? "viscera" : "viscera::" + match[1].str();
  return file.rfind("app/cli/", 0) == 0 ? "viscera::app::cli" : "viscera::app";
}

/// Whether `line` opens a namespace that is neither the one of `file`'s folder nor within it.
bool opensAnother(const std::string& line, const std::string& file) {
  static const std::regex opened(R"(^namespace (viscera[\w:]*) \{)");
  std::smatch match;
  if (!std::regex_search(line, match, opened))
    return false;
  const std::string wanted = namespaceOf(file), found = match[1];
  return found != wanted && (wanted == "viscera" || found.rfind(wanted + "::", 0) != 0);
}

/// The faults of one include line of `module`; empty for none.
std::string faultOf(const std::string& line, const std::string& module) {
  static const std::regex ours(R"(^\s*#\s*include\s*[<"]viscera/(\w+)/)");
  static const std::regex vtk(R"(^\s*#\s*include\s*[<"]vtk)");
  static const std::regex qt(R"(^\s*#\s*include\s*[<"]Q[A-Z])");
  std::smatch match;
  if (std::regex_search(line, match, ours) && match[1] != module &&
      allowedModules().at(module).count(match[1]) == 0)
    return "may not use " + match[1].str();
  if (std::regex_search(line, vtk) && kMayUseVtk.count(module) == 0)
    return "may not use VTK";
  if (std::regex_search(line, qt) && kMayUseQt.count(module) == 0)
    return "may not use Qt";
  return {};
}

} // namespace

TEST(IncludeArrows, PointDownwardInEveryModule) {
  int files = 0;
  for (const auto& [module, allowed] : allowedModules()) {
    for (const std::filesystem::path& file : sourcesUnder("modules/" + module)) {
      ++files;
      for (const std::string& line : linesOf(file)) {
        const std::string fault = faultOf(line, module);
        EXPECT_TRUE(fault.empty()) << shortName(file) << ": " << module << " " << fault << ": " << line;
      }
    }
  }
  EXPECT_GT(files, 0);
}

TEST(IncludeArrows, KnowEveryModule) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(VISCERA_SOURCE_DIR) / "modules"))
    if (entry.is_directory()) {
      EXPECT_TRUE(allowedModules().count(entry.path().filename().string()) == 1)
          << entry.path().filename() << " has no row in the table of this test";
    }
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

TEST(Namespaces, EqualFolders) {
  for (const std::string folder : {"app", "modules"})
    for (const std::filesystem::path& file : sourcesUnder(folder))
      for (const std::string& line : linesOf(file))
        EXPECT_FALSE(opensAnother(line, shortName(file))) << shortName(file) << ": " << line;
}

TEST(Namespaces, OfAnotherFolderAreSeen) {
  EXPECT_TRUE(opensAnother("namespace viscera::document {", "modules/live/src/a.cpp"));
  EXPECT_TRUE(opensAnother("namespace viscera {", "modules/live/src/a.cpp"));
  EXPECT_TRUE(opensAnother("namespace viscera::app {", "app/cli/a.h"));
  EXPECT_TRUE(opensAnother("namespace viscera::app::cli {", "modules/reproduction/src/a.h"));
  EXPECT_FALSE(opensAnother("namespace viscera::document::edit {", "modules/document/src/a.cpp"));
  EXPECT_FALSE(opensAnother("namespace viscera {", "modules/core/src/a.cpp"));
}

TEST(IncludeArrows, AreSeenWhenTheyPointUpward) {
  EXPECT_FALSE(faultOf("#include \"viscera/coordinates/binding.h\"", "geometry").empty());
  EXPECT_FALSE(faultOf("#include \"viscera/scene/theme.h\"", "document").empty());
  EXPECT_FALSE(faultOf("#  include <vtkPolyData.h>", "deformation").empty());
  EXPECT_FALSE(faultOf("#include <QString>", "core").empty());
  EXPECT_TRUE(faultOf("#include \"viscera/core/arrays.h\"", "geometry").empty());
  EXPECT_TRUE(faultOf("#include <vtkPolyData.h>", "scene").empty());
  EXPECT_EQ(strangerIn("#include \"window/mode.h\"", "app/cli/stage.cpp"), "window/mode.h");
  EXPECT_EQ(strangerIn("#include \"cli/stage.h\"", "app/window/mode.cpp"), "cli/stage.h");
  EXPECT_EQ(strangerIn("#include \"cli/stage.h\"", "app/camera_json.cpp"), "cli/stage.h");
  EXPECT_TRUE(strangerIn("#include \"window/mode.h\"", "app/window/actions.cpp").empty());
}

} // namespace viscera::house
