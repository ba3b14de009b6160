#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "source_files.h"

namespace viscera::house {
namespace {

std::set<std::string> with(std::set<std::string> modules, const std::set<std::string>& more) {
  modules.insert(more.begin(), more.end());
  return modules;
}

/// What each module may include, itself left out. Arrows point downward only.
const std::map<std::string, std::set<std::string>>& allowedModules() {
  static const std::set<std::string> numerical = {"core", "geometry", "coordinates", "deformation",
                                                  "sequences"};
  static const std::set<std::string> documentUses = with(numerical, {"sample_organs", "medical_io"});
  static const std::map<std::string, std::set<std::string>> allowed = {
      {"core", {}},
      {"geometry", {"core"}},
      {"coordinates", {"core", "geometry"}},
      {"deformation", {"core", "geometry", "coordinates"}},
      {"sequences", {"core"}},
      {"plugin", {"core", "geometry", "coordinates"}},
      {"localised_scc", {"core", "geometry", "coordinates", "plugin"}},
      {"sample_organs", numerical},
      {"medical_io", numerical},
      {"scene", numerical},
      {"document", documentUses},
      {"live", with(documentUses, {"document", "plugin"})},
      {"motion", with(documentUses, {"document", "plugin", "live"})},
      {"presentation", with(documentUses, {"document", "plugin", "live", "motion", "scene"})}};
  return allowed;
}

const std::set<std::string> kMayUseVtk = {"sample_organs", "medical_io", "scene"};
const std::set<std::string> kMayUseQt = {"plugin", "localised_scc", "document"};

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

TEST(IncludeArrows, AreSeenWhenTheyPointUpward) {
  EXPECT_FALSE(faultOf("#include \"viscera/coordinates/binding.h\"", "geometry").empty());
  EXPECT_FALSE(faultOf("#include \"viscera/scene/theme.h\"", "document").empty());
  EXPECT_FALSE(faultOf("#  include <vtkPolyData.h>", "deformation").empty());
  EXPECT_FALSE(faultOf("#include <QString>", "core").empty());
  EXPECT_TRUE(faultOf("#include \"viscera/core/arrays.h\"", "geometry").empty());
  EXPECT_TRUE(faultOf("#include <vtkPolyData.h>", "scene").empty());
}

} // namespace viscera::house
