#include "viscera/live/taught_quantities.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

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

std::ptrdiff_t rowsOf(const std::vector<TaughtQuantity>& rows, const std::string& id) {
  return std::count_if(rows.begin(), rows.end(),
                       [&](const TaughtQuantity& row) { return row.norm->id == id; });
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
  // Of the textbook's beat and of the circulation at rest.
  for (const char* id : {"lv.ivct", "lv.ejection", "lv.ivrt", "heart.output"})
    EXPECT_EQ(rowsOf(rows, id), 2) << id;
  for (const char* id : {"exercise.systolic", "exercise.la", "exercise.a", "exercise.gradient",
                         "aortic.gradient", "mitral.regurgitation"})
    EXPECT_EQ(rowsOf(rows, id), 1) << id;
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
