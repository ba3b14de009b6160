#include <set>
#include <sstream>

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include "build_paths.h"
#include "cli_test.h"

namespace viscera::app::cli {

/// The thesis's figures, done again by the real binary.
class CliReproduce : public CliTest {
protected:
  /// One figure or table of the answer, by id.
  static json entry(const json& result, const char* list, const std::string& id) {
    for (const json& one : result[list])
      if (one["id"] == id)
        return one;
    ADD_FAILURE() << "no " << id << " among the " << list;
    return {};
  }
};

TEST_F(CliReproduce, JudgesByWhatItMeasures) {
  const json result =
      runJson({"reproduce", "-o", path("page"), "--only", "3.34", "3.27", "4.4", "table-4.1", "5.4"});
  EXPECT_EQ(result["figures"].size(), 4u);
  EXPECT_EQ(result["tables"].size(), 1u);
  for (const char* list : {"figures", "tables"})
    for (const json& one : result[list]) {
      std::size_t met = 0;
      for (const json& finding : one["findings"])
        met += finding["met"] == true ? 1 : 0;
      const std::size_t all = one["findings"].size();
      ASSERT_GT(all, 0u) << one.dump(2);
      EXPECT_EQ(one["verdict"], met == all ? "holds" : met > 0 ? "differs" : "does not hold") << one["id"];
      EXPECT_EQ(one["because"] == "", met == all) << one["id"];
    }
  EXPECT_EQ(entry(result, "figures", "3.34")["verdict"], "holds") << "determinants jump";
  EXPECT_EQ(entry(result, "figures", "4.4")["verdict"], "holds") << "T-Celestial is smooth";
  // Solved to the end, T-Celestial does not depend on rotation.
  const json table = entry(result, "tables", "4.1");
  EXPECT_EQ(table["verdict"], "differs");
  EXPECT_NE(table["because"].get<std::string>().find("T-Celestial: not rotation invariant"),
            std::string::npos);
}

TEST_F(CliReproduce, WritesAPageThatTakesNothingFromOutside) {
  const json result = runJson({"reproduce", "-o", path("page"), "--only", "3.31", "5.5"});
  const std::string page = contents(result["page"].get<std::string>());
  EXPECT_EQ(page.find("http"), std::string::npos);
  std::set<std::string> named;
  for (const json& figure : result["figures"])
    for (const char* list : {"pictures", "tables"})
      for (const json& file : figure[list]) {
        named.insert(file.get<std::string>());
        EXPECT_NE(page.find("\"" + file.get<std::string>() + "\""), std::string::npos) << file;
      }
  EXPECT_GT(named.size(), 6u);
  std::size_t there = 0;
  for (const auto& file : std::filesystem::directory_iterator(path("page"))) {
    const std::string name = file.path().filename().string();
    there += named.count(name);
    EXPECT_TRUE(named.count(name) == 1 || name == "index.html" || name == "verdicts.md") << name;
    if (file.path().extension() != ".svg")
      continue;
    const auto svg =
        vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.path().c_str()));
    ASSERT_TRUE(svg) << name << " is not XML";
    EXPECT_STREQ(svg->GetName(), "svg");
    EXPECT_EQ(contents(file.path().string()).find("nan"), std::string::npos) << name;
  }
  EXPECT_EQ(there, named.size());
}

TEST_F(CliReproduce, IsTheSameTwiceAndWithAnyNumberOfThreads) {
  runJson({"reproduce", "-o", path("one"), "--only", "3.29", "--threads", "1"});
  runJson({"reproduce", "-o", path("two"), "--only", "3.29", "--threads", "3"});
  for (const char* file : {"figure_3_29.svg", "figure_3_29.csv", "figure_3_29_line.svg"}) {
    EXPECT_FALSE(contents(path("one") + "/" + file).empty()) << file;
    EXPECT_EQ(contents(path("one") + "/" + file), contents(path("two") + "/" + file)) << file;
  }
}

/// The figures that take no time to measure and measure no time.
TEST_F(CliReproduce, FindsWhatTheDocumentationSays) {
  runJson({"reproduce", "-o", path("page"), "--only", "3.14", "3.15", "3.23", "3.27", "3.28", "3.29", "3.31",
           "3.34", "3.36", "4.4", "4.6", "4.11", "5.4", "5.5", "2d"});
  const std::string documentation = contents(VISCERA_SOURCE_DIR "/docs/reproduction.md");
  std::istringstream verdicts(contents(path("page") + "/verdicts.md"));
  int rows = 0;
  for (std::string row; std::getline(verdicts, row); ++rows)
    EXPECT_NE(documentation.find(row + "\n"), std::string::npos) << "docs/reproduction.md should say " << row;
  EXPECT_EQ(rows, 15 + 2);
}

TEST_F(CliReproduce, ShowsInfluenceInThePlane) {
  const json result = runJson({"reproduce", "-o", path("page"), "--only", "2d"});
  const json figure = entry(result, "figures", "2d");
  EXPECT_EQ(figure["pictures"], (json{"figure_2d_convex.svg", "figure_2d_concave.svg"}));
  std::istringstream measures(contents(path("page") + "/figure_2d.csv"));
  std::string row;
  std::getline(measures, row);
  int rows = 0;
  for (; std::getline(measures, row); ++rows) {
    std::vector<std::string> cells;
    std::istringstream line(row);
    for (std::string cell; std::getline(line, cell, ',');)
      cells.push_back(cell);
    ASSERT_EQ(cells.size(), 8u) << row;
    for (const int error : {2, 3, 4}) // Unity, identity, at the handles.
      EXPECT_LT(std::stod(cells[static_cast<std::size_t>(error)]), 1e-9) << row;
    EXPECT_EQ(std::stoi(cells[6]) > 0, cells[0] == "Mean value" && cells[1] == "concave") << row;
  }
  EXPECT_EQ(rows, 2 * 7) << "seven systems in two polygons";
  // A lattice point where the orange handle pulls the wrong way is drawn so.
  EXPECT_NE(contents(path("page") + "/figure_2d_concave.svg").find("#f0a06a"), std::string::npos);
  std::istringstream numbers(contents(path("page") + "/figure_2d_concave.csv"));
  std::getline(numbers, row);
  EXPECT_EQ(row, "x_mm,y_mm,s-celestial,t-celestial,mean-value,lagrange-minimisation,gradient-method,"
                 "determinants-approach,wire-approach");
}

TEST_F(CliReproduce, SaysWhatCanBeDoneAgainAndWhereItCannotWrite) {
  expectFailure({"reproduce", "-o", path("page"), "--only", "9.9"}, kUsage, "3.12");
  expectFailure({"reproduce", "-o", path("page"), "--only", "5.2"}, kUsage, "table-5.2");
  expectFailure({"reproduce"}, kUsage, "--output");
  EXPECT_EQ(files(), 0);
  expectFailure({"reproduce", "-o", put("file", "x") + "/page", "--only", "5.4"}, kCannotCreate, "folder");
}

TEST_F(CliReproduce, WritesNothingWhenInterrupted) {
  options_.interruptAfter = std::chrono::milliseconds(1500);
  EXPECT_EQ(run({"reproduce", "-o", path("page")}).exitCode, kCancelled);
  EXPECT_EQ(files(), 0);
}

} // namespace viscera::app::cli
