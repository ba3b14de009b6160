#include "cli/stress_marks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/listing.h"
#include "cli/positions.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

constexpr const char* kProbe = "--probe";
constexpr const char* kProfile = "--profile";
/// Part of the mesh's diagonal: a place on the skin counts as tissue in spite of rounding.
constexpr double kOnSkin = 1e-9;

/// The values at a point; null if it lies in no tissue.
ordered_json jsonOf(const live::StressReading& reading, const elasticity::StatedMaterial& material) {
  const auto known = [&](const ordered_json& value) {
    return reading.inTissue ? value : ordered_json(nullptr);
  };
  ordered_json json = {
      {"restMm", numbersJson(reading.rest)},           {"inTissue", reading.inTissue},
      {"positionMm", known(numbersJson(reading.now))}, {"stressDegrees", known(reading.stressDegrees)},
      {"volumeRatio", known(reading.volumeRatio)},     {"stretchMax", known(reading.stretchMax)},
      {"stretchMin", known(reading.stretchMin)},       {"folded", known(reading.folded)}};
  if (material.stated())
    for (const auto& [key, quantity] : {std::pair("vonMisesKpa", live::StressQuantity::vonMises),
                                        std::pair("strainEnergyKpa", live::StressQuantity::energy)}) {
      const double value = live::valueOf(reading, {quantity, material});
      json[key] = std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
    }
  return json;
}

std::string inWords(const live::StressReading& reading, const elasticity::StatedMaterial& material) {
  if (!reading.inTissue)
    return "outside the tissue";
  if (reading.folded)
    return "folded";
  std::string pascals;
  if (material.stated()) {
    const live::StressMeasure vonMises(live::StressQuantity::vonMises, material);
    pascals =
        ", von Mises stress " + fixed(live::valueOf(reading, vonMises), 3) + ' ' + vonMises.unit().english();
  }
  return fixed(reading.stressDegrees, 2) + " deg, volume ratio " + fixed(reading.volumeRatio, 3) +
         ", stretch " + fixed(reading.stretchMin, 3) + " to " + fixed(reading.stretchMax, 3) + pascals;
}

} // namespace

void StressMarkOptions::addTo(CLI::App& options) {
  options
      .add_option(kProbe, probes_,
                  "A point of the tissue at which to print values, at rest in mm, LPS; may be repeated")
      ->type_name("X,Y,Z")
      ->expected(1)
      ->take_all();
  options.add_option("--probes-csv", probesFile_, "The values at the probes as a table")->type_name("FILE");
  options
      .add_option(
          kProfile, profiles_,
          "A straight line through the organ at rest along which to print values, at N points (101); may "
          "be repeated")
      ->type_name("X,Y,Z:X,Y,Z[:N]")
      ->expected(1)
      ->take_all();
  options.add_option("--profile-csv", profilesFile_, "The values along the lines as a table")
      ->type_name("FILE");
}

StressMarkOptions::Line StressMarkOptions::lineOf(const std::string& text) {
  const auto first = text.find(':');
  if (first == std::string::npos)
    throw UsageError("It is not a line X,Y,Z:X,Y,Z in mm", std::string(kProfile) + " " + text,
                     "for instance --profile 0,-40,310:20,-40,310");
  const auto second = text.find(':', first + 1);
  Line line;
  line.from = positionOf(text.substr(0, first), kProfile);
  line.to =
      positionOf(text.substr(first + 1, second == std::string::npos ? second : second - first - 1), kProfile);
  if (line.from == line.to)
    throw UsageError("A line needs two places", std::string(kProfile) + " " + text);
  if (second == std::string::npos)
    return line;
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data() + second + 1, end, line.count);
  if (error != std::errc() || next != end || line.count < 2 || line.count > live::kMostProfilePoints)
    throw UsageError(phrase("A line has from 2 to %1 points", live::kMostProfilePoints),
                     std::string(kProfile) + " " + text);
  return line;
}

void StressMarkOptions::check() const {
  for (const std::string& text : probes_)
    positionOf(text, kProbe);
  for (const std::string& text : profiles_)
    lineOf(text);
  if (probes_.empty() && !probesFile_.empty())
    throw UsageError("There is no probe to write a table of", "--probes-csv", "add --probe X,Y,Z");
  if (profiles_.empty() && !profilesFile_.empty())
    throw UsageError("There is no profile to write a table of", "--profile-csv", "add --profile X,Y,Z:X,Y,Z");
}

std::vector<Vec3> StressMarkOptions::probePlaces() const {
  std::vector<Vec3> places;
  for (const std::string& text : probes_)
    places.push_back(positionOf(text, kProbe));
  return places;
}

void StressMarkOptions::readProbes(const std::shared_ptr<const deformation::WitnessMesh>& mesh,
                                   const Points& posed, const deformation::StressMap& map,
                                   const elasticity::StatedMaterial& material, Outcome& outcome) const {
  const live::TissuePoints points(mesh, pointsOf(probePlaces()), live::probeReach(*mesh));
  const std::vector<live::StressReading> readings = points.read(posed, map);
  std::vector<live::NamedReading> rows;
  Listing listing;
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::string name = std::to_string(i + 1);
    ordered_json item = {{"number", i + 1}};
    item.update(jsonOf(readings[i], material));
    list.push_back(std::move(item));
    listing.add("probe " + name, inWords(readings[i], material));
    if (!readings[i].inTissue)
      outcome.warnings.push_back(phrase("Probe %1 lies %2 mm outside the tissue", name,
                                        fixed(points.distance(static_cast<Eigen::Index>(i)), 1)));
    rows.push_back({name, readings[i]});
  }
  outcome.json["probes"] = std::move(list);
  outcome.text += listing.text();
  if (probesFile_.empty())
    return;
  live::writeStressProbes(probesFile_, rows, material);
  outcome.json["probesCsv"] = probesFile_;
}

void StressMarkOptions::readProfiles(const std::shared_ptr<const deformation::WitnessMesh>& mesh,
                                     const Points& posed, const deformation::StressMap& map,
                                     const elasticity::StatedMaterial& material, Outcome& outcome) const {
  std::vector<live::NamedProfile> rows;
  Listing listing;
  ordered_json list = ordered_json::array();
  for (const std::string& text : profiles_) {
    const Line line = lineOf(text);
    const live::TissuePoints points(mesh, live::placesAlong(line.from, line.to, line.count),
                                    kOnSkin * boundsOf(mesh->points).diagonal());
    const std::string name = std::to_string(rows.size() + 1);
    rows.push_back({name, live::profileOf(points.read(posed, map))});
    const live::StressProfile& profile = rows.back().profile;
    ordered_json places = ordered_json::array();
    double largest = -1;
    int inside = 0;
    for (std::size_t i = 0; i < profile.mm.size(); ++i) {
      ordered_json item = {{"distanceMm", profile.mm[i]}};
      item.update(jsonOf(profile.readings[i], material));
      places.push_back(std::move(item));
      inside += profile.readings[i].inTissue;
      if (const double value = live::valueOf(profile.readings[i], live::StressQuantity::rotationalStress);
          std::isfinite(value))
        largest = std::max(largest, value);
    }
    list.push_back({{"lengthMm", profile.mm.back()}, {"points", std::move(places)}});
    listing.add("profile " + name, fixed(profile.mm.back(), 1) + " mm, " + std::to_string(inside) + " of " +
                                       std::to_string(profile.mm.size()) + " points in the tissue" +
                                       (largest < 0 ? "" : ", at most " + fixed(largest, 2) + " deg"));
  }
  outcome.json["profiles"] = std::move(list);
  outcome.text += listing.text();
  if (profilesFile_.empty())
    return;
  live::writeStressProfiles(profilesFile_, rows, material);
  outcome.json["profileCsv"] = profilesFile_;
}

void StressMarkOptions::read(const std::shared_ptr<const deformation::WitnessMesh>& mesh, const Points& posed,
                             const deformation::StressMap& map, const elasticity::StatedMaterial& material,
                             Outcome& outcome) const {
  if (!probes_.empty())
    readProbes(mesh, posed, map, material, outcome);
  if (!profiles_.empty())
    readProfiles(mesh, posed, map, material, outcome);
}

} // namespace viscera::app::cli
