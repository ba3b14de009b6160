#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "cli_test.h"

namespace viscera::app::cli {

/// The columns of the tables that commands write: one scheme of names, that of JSON and Python, small letters
/// with underscores and the unit last. Older columns stay in front of the new ones.
class CliCsv : public CliTest {
protected:
  std::vector<std::string> columnsOf(const std::string& file) const {
    std::istringstream lines(contents(file));
    std::string heading;
    std::getline(lines, heading);
    std::vector<std::string> columns;
    std::istringstream cells(heading);
    for (std::string cell; std::getline(cells, cell, ',');)
      columns.push_back(cell);
    std::string row;
    EXPECT_TRUE(std::getline(lines, row)) << file << " has no row";
    return columns;
  }

  /// "lv_mmHg" as "lv_": units keep their capitals.
  static std::string withoutUnit(std::string column) {
    for (const std::string unit : {"mmHg", "mV"})
      if (column.ends_with('_' + unit))
        column.resize(column.size() - unit.size());
    return column;
  }

  static bool inScheme(const std::string& column) {
    const std::string name = withoutUnit(column);
    return !name.empty() && std::islower(static_cast<unsigned char>(name[0])) &&
           std::all_of(name.begin(), name.end(), [](unsigned char letter) {
             return std::islower(letter) || std::isdigit(letter) || letter == '_';
           });
  }

  /// Every column is in the scheme, or is an older one: then `wanted` has what stands beside it.
  void expectColumns(const std::string& file, const std::set<std::string>& wanted,
                     const std::set<std::string>& older = {}) const {
    const std::vector<std::string> columns = columnsOf(file);
    for (const std::string& column : columns)
      EXPECT_TRUE(inScheme(column) || older.count(column) > 0) << column << " of " << file;
    for (const auto* list : {&wanted, &older})
      for (const std::string& column : *list)
        EXPECT_EQ(std::count(columns.begin(), columns.end(), column), 1) << column << " of " << file;
  }
};

TEST_F(CliCsv, OfStressHasTheNamesOfJson) {
  auto pose = corners(20);
  for (auto& corner : pose)
    corner[0] *= 2;
  const json result = runJson({"stress",        put("cube.off", cubeOff(10)),
                               "--handles",     put("rest.mrk.json", markups(corners(20))),
                               "--pose",        put("pose.mrk.json", markups(pose)),
                               "--witnesses",   "300",
                               "--csv",         path("points.csv"),
                               "--probe",       "1,2,3",
                               "--probes-csv",  path("probes.csv"),
                               "--profile",     "0,0,-5:0,0,5:4",
                               "--profile-csv", path("profile.csv"),
                               "--histogram",   path("histogram.csv")});
  ASSERT_TRUE(result.contains("stressDegrees"));
  const std::set<std::string> values = {"stress_degrees", "volume_ratio", "stretch_max", "stretch_min"};
  const std::set<std::string> older = {"RotationalStress_deg", "VolumeRatio", "StretchMax", "StretchMin",
                                       "Folded"};
  for (const char* file : {"points.csv", "probes.csv", "profile.csv"})
    expectColumns(path(file), values, older);
  expectColumns(path("histogram.csv"), {"points", "percent"});
}

TEST_F(CliCsv, OfMotionAndCirculationHasChambersByTheirKeys) {
  runJson({"play", "heartbeat", "--fps", "5", "--csv", path("beat.csv")});
  expectColumns(path("beat.csv"), {"time_s", "lv_ml", "rv_ml", "la_ml", "ra_ml"});
  runJson({"circulate", "--csv", path("state.csv")});
  expectColumns(path("state.csv"), {"time_s", "lv_mmHg", "lv_ml", "aortic_ml_s", "aortic_open", "ecg_mV"});
}

TEST_F(CliCsv, OfSystemsHasTheNamesOfJson) {
  const json row = runJson(
      {"properties", "--systems", "s-celestial", "--points", "20", "-o", path("table.csv")})["rows"][0];
  ASSERT_TRUE(row.contains("identityError"));
  expectColumns(path("table.csv"), {"system", "identity_error", "unity_error", "min_weight"});
}

} // namespace viscera::app::cli
