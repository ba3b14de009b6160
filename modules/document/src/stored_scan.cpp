#include "stored_scan.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include <Eigen/LU>

#include "stored_bytes.h"

#include "viscera/core/phrase.h"

namespace viscera::document {
namespace {

using medical_io::Scan;
using nlohmann::ordered_json;

constexpr std::int64_t kLongestSide = 1'000'000; ///< Voxels.

template <class Sample>
constexpr const char* kTypeName = "";
template <>
constexpr const char* kTypeName<std::int8_t> = "int8";
template <>
constexpr const char* kTypeName<std::uint8_t> = "uint8";
template <>
constexpr const char* kTypeName<std::int16_t> = "int16";
template <>
constexpr const char* kTypeName<std::uint16_t> = "uint16";
template <>
constexpr const char* kTypeName<std::int32_t> = "int32";
template <>
constexpr const char* kTypeName<std::uint32_t> = "uint32";
template <>
constexpr const char* kTypeName<float> = "float32";

/// Names in the file, by the numbers of `ScanFinding::Kind`.
constexpr std::array<const char*, 10> kKinds = {"missing slice", "doubled slice", "uneven spacing", "tilt",
                                                "order",         "mixed sizes",   "damaged",        "other",
                                                "part read",     "resampled"};

/// Texts that are empty are left out.
constexpr std::pair<const char*, std::string Scan::*> kTexts[] = {{"modality", &Scan::modality},
                                                                  {"unit", &Scan::unit},
                                                                  {"description", &Scan::description},
                                                                  {"space", &Scan::space},
                                                                  {"transferSyntax", &Scan::transferSyntax}};

ordered_json rowsOf(const Eigen::Affine3d& affine) {
  ordered_json rows = ordered_json::array();
  for (int r = 0; r < 3; ++r)
    rows.push_back({affine(r, 0), affine(r, 1), affine(r, 2), affine(r, 3)});
  return rows;
}

class ScanReader {
public:
  ScanReader(JsonReader& reader, const ordered_json& stored, std::string place)
      : reader_(reader), stored_(stored), place_(std::move(place)) {}

  Scan read() {
    reader_.takeObject(stored_,
                       {"size", "type", "indexToLps", "slope", "intercept", "padding", "modality", "unit",
                        "description", "space", "transferSyntax", "phaseTimesMs", "phase", "window",
                        "findings", "samples"},
                       place_);
    readGrid();
    scan_.slope = number("slope");
    scan_.intercept = number("intercept");
    if (stored_.contains("padding"))
      scan_.padding = number("padding");
    for (const auto& [key, member] : kTexts)
      if (stored_.contains(key))
        scan_.*member = reader_.textOf(stored_, key, place_);
    readPhases();
    readWindow();
    readFindings();
    const std::string type = reader_.textOf(stored_, "type", place_);
    if (!readSamples<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t,
                     float>(type))
      reader_.fail(diagnostic("There is no type of samples \"%1\"", type), place_);
    return std::move(scan_);
  }

private:
  std::string at(const char* key) const { return place_ + "." + key; }
  double number(const char* key) const {
    return reader_.numberOf(reader_.field(stored_, key, place_), at(key));
  }

  void readGrid() {
    const ordered_json& size = reader_.listOf(stored_, "size", place_);
    const ordered_json& rows = reader_.listOf(stored_, "indexToLps", place_);
    if (size.size() != 3 || rows.size() != 3)
      reader_.fail(diagnostic("A scan has three axes"), place_);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t count = reader_.wholeOf(size[k], at("size"));
      if (count < 1 || count > kLongestSide)
        reader_.fail(diagnostic("No scan has %1 voxels along an axis", count), at("size"));
      scan_.size[k] = static_cast<int>(count);
      if (!rows[k].is_array() || rows[k].size() != 4)
        reader_.fail(diagnostic("A row has four numbers"), at("indexToLps"));
      for (std::size_t column = 0; column < 4; ++column)
        scan_.indexToLps(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(column)) =
            reader_.numberOf(rows[k][column], at("indexToLps"));
    }
    if (!scan_.indexToLps.linear().fullPivLu().isInvertible())
      reader_.fail(diagnostic("Its axes lie in one plane"), at("indexToLps"));
  }

  void readPhases() {
    if (stored_.contains("phaseTimesMs"))
      for (const ordered_json& time : reader_.listOf(stored_, "phaseTimesMs", place_))
        scan_.phaseTimesMs.push_back(reader_.numberOf(time, at("phaseTimesMs")));
    if (stored_.contains("phase"))
      scan_.phase = static_cast<int>(reader_.wholeOf(stored_.at("phase"), at("phase")));
  }

  void readWindow() {
    if (!stored_.contains("window"))
      return;
    const ordered_json& window = stored_.at("window");
    reader_.takeObject(window, {"level", "width"}, at("window"));
    scan_.window = {reader_.numberOf(reader_.field(window, "level", at("window")), at("window")),
                    reader_.numberOf(reader_.field(window, "width", at("window")), at("window"))};
    if (!(scan_.window->width > 0))
      reader_.fail(diagnostic("The width has to be positive"), at("window"));
  }

  void readFindings() {
    if (!stored_.contains("findings"))
      return;
    for (const ordered_json& item : reader_.listOf(stored_, "findings", place_)) {
      reader_.takeObject(item, {"kind", "sentence"}, at("findings"));
      medical_io::ScanFinding finding;
      const std::string kind = reader_.textOf(item, "kind", at("findings"));
      for (std::size_t k = 0; k < kKinds.size(); ++k)
        if (kind == kKinds[k])
          finding.kind = static_cast<medical_io::ScanFinding::Kind>(k);
      finding.sentence = named(reader_.textOf(item, "sentence", at("findings")));
      scan_.findings.push_back(finding);
    }
  }

  template <class... Types>
  bool readSamples(const std::string& type) {
    return ((type == kTypeName<Types> ? (readSamplesOf<Types>(), true) : false) || ...);
  }

  template <class Sample>
  void readSamplesOf() {
    // No overflow: a side has at most a million voxels, and 10^18 samples of four bytes are 4 * 10^18.
    const auto voxels = static_cast<std::int64_t>(scan_.voxelCount());
    unpack(reader_, stored_, "samples", place_, voxels * std::int64_t{sizeof(Sample)},
           std::to_string(voxels) + " voxels", [this, voxels]() -> void* {
             auto& samples = scan_.samples.emplace<std::vector<Sample>>();
             samples.resize(static_cast<std::size_t>(voxels));
             return samples.data();
           });
  }

  JsonReader& reader_;
  const ordered_json& stored_;
  std::string place_;
  Scan scan_;
};

} // namespace

ordered_json storedScan(const Scan& scan) {
  ordered_json stored{{"size", scan.size}};
  std::string samples;
  std::visit(
      [&]<class Sample>(const std::vector<Sample>& values) {
        stored["type"] = kTypeName<Sample>;
        samples =
            packed({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Sample)}, "a scan");
      },
      scan.samples);
  stored["indexToLps"] = rowsOf(scan.indexToLps);
  stored["slope"] = scan.slope;
  stored["intercept"] = scan.intercept;
  if (scan.padding)
    stored["padding"] = *scan.padding;
  for (const auto& [key, member] : kTexts)
    if (!(scan.*member).empty())
      stored[key] = scan.*member;
  if (!scan.phaseTimesMs.empty())
    stored["phaseTimesMs"] = scan.phaseTimesMs;
  if (scan.phase != 0)
    stored["phase"] = scan.phase;
  if (scan.window)
    stored["window"] = {{"level", scan.window->level}, {"width", scan.window->width}};
  for (const medical_io::ScanFinding& finding : scan.findings)
    stored["findings"].push_back(
        {{"kind", kKinds[static_cast<std::size_t>(finding.kind)]}, {"sentence", finding.sentence}});
  stored["samples"] = std::move(samples);
  return stored;
}

Scan scanFrom(JsonReader& reader, const ordered_json& stored, const std::string& place) {
  return ScanReader(reader, stored, place).read();
}

} // namespace viscera::document
