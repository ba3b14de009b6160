#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "module_list.h"

namespace viscera::house {
namespace {

const std::string kPage = VISCERA_SOURCE_DIR "/docs/architecture.md";
const std::string kBegin = "<!-- modules, made by test_house: VISCERA_UPDATE_PAGES=1 -->\n";
const std::string kEnd = "<!-- end of modules -->\n";

std::string contentsOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The table of all modules, the highest first.
std::string tableOf(const ModuleList& list) {
  std::ostringstream table;
  table << "| stratum | module | what it contains | uses |\n|---|---|---|---|\n";
  for (auto stratum = kStrata.rbegin(); stratum != kStrata.rend(); ++stratum)
    for (auto module = list.modules.rbegin(); module != list.modules.rend(); ++module) {
      if (module->stratum != *stratum)
        continue;
      table << "| " << *stratum << " | `" << module->folder << "` | " << module->about << " |";
      for (const std::string& used : modulesUsedBy(*module))
        table << ' ' << used;
      table << " |\n";
    }
  return table.str();
}

} // namespace

TEST(ModuleTable, OfTheDocumentationIsTheOneOfCMake) {
  const ModuleList& list = modulesOfThisBuild();
  if (!list.leftOut.empty())
    GTEST_SKIP() << "this build leaves out " << list.leftOut.front() << " and " << list.leftOut.size() - 1
                 << " more";
  std::string page = contentsOf(kPage);
  const std::size_t begin = page.find(kBegin), end = page.find(kEnd);
  ASSERT_TRUE(begin != std::string::npos && end != std::string::npos && begin < end) << kBegin << kEnd;
  const std::size_t from = begin + kBegin.size();
  if (std::getenv("VISCERA_UPDATE_PAGES")) {
    page.replace(from, end - from, tableOf(list));
    std::ofstream(kPage, std::ios::binary) << page;
  } else {
    EXPECT_EQ(page.substr(from, end - from), tableOf(list))
        << "VISCERA_UPDATE_PAGES=1 test_house --gtest_filter=ModuleTable.* writes it";
  }
}

} // namespace viscera::house
