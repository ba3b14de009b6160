#include "viscera/live/taught_quantities.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "sequence_scene.h"

namespace viscera::live {
namespace {

const char* const kPage = VISCERA_SOURCE_DIR "/docs/reference_values.md";

std::string contents(const char* file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Measures anew everything that docs/reference_values.md says. VISCERA_UPDATE_PAGES=1 writes it there.
TEST(TaughtQuantities, AreAsTheDocumentationSaysAndWithinTheirRangesOrSayWhyNot) {
  Progress progress;
  const std::vector<TaughtQuantity> rows = taughtQuantities(tests::cachedLibrary(), progress);
  EXPECT_GE(rows.size(), 35u);
  for (const TaughtQuantity& row : rows) {
    const bool within = anatomy::rangeOf(*row.norm).holds(row.here);
    EXPECT_TRUE(within || !row.remark.empty()) << row.norm->id << " in " << row.where << ": " << row.here;
  }
  const std::string table = markdownTable(rows);
  std::string page = contents(kPage);
  if (std::getenv("VISCERA_UPDATE_PAGES")) {
    const std::size_t begin = page.find("| quantity |"), end = page.find("\n\n", begin);
    page.replace(begin, end - begin + 1, table);
    std::ofstream(kPage, std::ios::binary) << page;
  }
  EXPECT_NE(page.find(table), std::string::npos) << "viscera reference --markdown gives another table:\n"
                                                 << table;
}

} // namespace
} // namespace viscera::live
