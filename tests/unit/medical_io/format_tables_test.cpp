#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "viscera/medical_io/file_kind.h"

/// The pages list the formats that the program reads.
namespace viscera::medical_io {
namespace {

constexpr std::pair<FileKind, const char*> kKinds[] = {{FileKind::surface, "organs"},
                                                       {FileKind::labelMap, "label maps and scans"},
                                                       {FileKind::handles, "handles"},
                                                       {FileKind::sequence, "sequences"},
                                                       {FileKind::session, "sessions"}};

/// A row for each format.
std::string longTable() {
  std::string table = "| files | format | endings | also written |\n|---|---|---|---|\n";
  for (const auto& [kind, title] : kKinds)
    for (const FileFormat& format : fileFormats()) {
      if (format.kind != kind)
        continue;
      table += std::string("| ") + title + " | " + format.name + " |";
      for (const std::string& ending : format.endings)
        table += " `" + ending + "`";
      table += std::string(" | ") + (format.written ? "yes" : "no") + " |\n";
    }
  return table;
}

/// A row for each kind.
std::string shortTable() {
  std::string table = "| files | formats |\n|---|---|\n";
  for (const auto& [kind, title] : kKinds) {
    std::string names;
    for (const FileFormat& format : fileFormats())
      if (format.kind == kind)
        names += (names.empty() ? "" : ", ") + format.name + (format.written ? "*" : "");
    table += std::string("| ") + title + " | " + names + " |\n";
  }
  return table;
}

/// VISCERA_UPDATE_PAGES=1 writes the table into the page, which has it between two comments.
void expectOnPage(const std::string& page, const std::string& table) {
  const std::string file = VISCERA_SOURCE_DIR "/" + page;
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string begin = "<!-- formats, made by test_medical_io: VISCERA_UPDATE_PAGES=1 -->\n";
  const std::size_t from = text.find(begin), end = text.find("<!-- end of formats -->\n");
  ASSERT_TRUE(from != std::string::npos && end != std::string::npos && from < end) << page;
  const std::size_t first = from + begin.size();
  if (std::getenv("VISCERA_UPDATE_PAGES")) {
    text.replace(first, end - first, table);
    std::ofstream(file, std::ios::binary) << text;
  } else {
    EXPECT_EQ(text.substr(first, end - first), table)
        << "VISCERA_UPDATE_PAGES=1 test_medical_io --gtest_filter=FormatTables.* writes it";
  }
}

TEST(FormatTables, OfThePagesAreTheProgramsOwn) {
  expectOnPage("README.md", shortTable());
  expectOnPage("docs/file_formats.md", longTable());
}

} // namespace
} // namespace viscera::medical_io
