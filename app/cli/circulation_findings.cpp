#include "cli/circulation_findings.h"

#include <ostream>

#include "cli/listing.h"
#include "viscera/core/atomic_file.h"

namespace viscera::app::cli {
namespace {

using circulation::ChamberIndices;
using circulation::Compartment;
using circulation::Indices;

/// Digits that a number of a table is written with: more than the integration is exact to.
constexpr int kDigits = 9;

constexpr double kMsPerS = 1000;

nlohmann::ordered_json chamberJson(const ChamberIndices& c) {
  return {{"endDiastolicVolumeMl", c.edvMl},
          {"endSystolicVolumeMl", c.esvMl},
          {"strokeVolumeMl", c.svMl},
          {"ejectionFraction", c.ef},
          {"edvMl", c.edvMl}, // The names before those of every command.
          {"esvMl", c.esvMl},
          {"svMl", c.svMl},
          {"ef", c.ef},
          {"edpMmHg", c.edpMmHg},
          {"meanMmHg", c.meanMmHg},
          {"highestMmHg", c.highestMmHg},
          {"dpdtMax", c.dpdtMax},
          {"strokeWorkJ", c.strokeWorkJ},
          {"strokeWorkByEnergyJ", c.strokeWorkByEnergyJ}};
}

nlohmann::ordered_json arteryJson(const circulation::ArteryIndices& a) {
  return {{"systolic", a.systolic}, {"diastolic", a.diastolic}, {"mean", a.mean}};
}

std::string chamberText(const ChamberIndices& c) {
  return fixed(c.esvMl, 1) + " to " + fixed(c.edvMl, 1) + " ml, EF " + fixed(c.ef, 2) + ", mean " +
         fixed(c.meanMmHg, 1) + " mmHg";
}

std::string arteryText(const circulation::ArteryIndices& a) {
  return fixed(a.systolic, 0) + " / " + fixed(a.diastolic, 0) + " mmHg, mean " + fixed(a.mean, 0);
}

} // namespace

nlohmann::ordered_json circulationJson(const Indices& indices) {
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < circulation::kChambers; ++i)
    json[circulation::nameOf(static_cast<Compartment>(i))] = chamberJson(indices.chambers[i]);
  json["aorta"] = arteryJson(indices.aorta);
  json["pulmonaryArtery"] = arteryJson(indices.pulmonaryArtery);
  json["cardiacOutputLPerMinute"] = indices.cardiacOutputLMin;
  json["cardiacOutputLMin"] = indices.cardiacOutputLMin;
  json["forwardStrokeMl"] = indices.forwardStrokeMl;
  json["mitralRegurgitationMl"] = indices.mitralRegurgitationMl;
  json["mitralRegurgitantFraction"] = indices.mitralRegurgitantFraction;
  json["aorticRegurgitationMl"] = indices.aorticRegurgitationMl;
  json["aorticMeanGradientMmHg"] = indices.aorticMeanGradient;
  json["aorticPeakGradientMmHg"] = indices.aorticPeakGradient;
  json["mitralMeanGradientMmHg"] = indices.mitralMeanGradient;
  json["isovolumicContractionMs"] = kMsPerS * indices.isovolumicContractionSeconds;
  json["ejectionMs"] = kMsPerS * indices.ejectionSeconds;
  json["isovolumicRelaxationMs"] = kMsPerS * indices.isovolumicRelaxationSeconds;
  json["relaxationMs"] = kMsPerS * indices.relaxationSeconds;
  json["ejectionSeconds"] = indices.ejectionSeconds;
  json["relaxationSeconds"] = indices.relaxationSeconds;
  json["arterialElastance"] = indices.arterialElastance;
  json["couplingRatio"] = indices.couplingRatio;
  for (std::size_t i = 0; i < circulation::kValves; ++i) {
    nlohmann::ordered_json& valve = json["valves"][circulation::nameOf(static_cast<circulation::Valve>(i))];
    if (const auto& times = indices.valves[i])
      valve = {{"opensSeconds", times->opens}, {"shutsSeconds", times->shuts}};
  }
  return json;
}

std::string circulationText(const Indices& indices) {
  const ChamberIndices& lv = indices.of(Compartment::lv);
  Listing listing;
  listing.add("left ventricle", chamberText(lv))
      .add("", "end-diastolic " + fixed(lv.edpMmHg, 1) + " mmHg, dP/dt " + fixed(lv.dpdtMax, 0) +
                   " mmHg/s, work " + fixed(lv.strokeWorkJ, 2) + " J")
      .add("right ventricle", chamberText(indices.of(Compartment::rv)))
      .add("left atrium", chamberText(indices.of(Compartment::la)))
      .add("right atrium", chamberText(indices.of(Compartment::ra)))
      .add("aorta", arteryText(indices.aorta))
      .add("pulmonary artery", arteryText(indices.pulmonaryArtery))
      .add("cardiac output", fixed(indices.cardiacOutputLMin, 2) + " l/min, " +
                                 fixed(indices.forwardStrokeMl, 1) + " ml a beat")
      .add("left valves", "isovolumic contraction " + fixed(1000 * indices.isovolumicContractionSeconds, 0) +
                              " ms, ejection " + fixed(1000 * indices.ejectionSeconds, 0) +
                              " ms, isovolumic relaxation " +
                              fixed(1000 * indices.isovolumicRelaxationSeconds, 0) + " ms")
      .add("Ea / Ees", fixed(indices.couplingRatio, 2))
      .add("aortic valve", "mean gradient " + fixed(indices.aorticMeanGradient, 1) + " mmHg, " +
                               fixed(indices.aorticRegurgitationMl, 1) + " ml back")
      .add("mitral valve", "mean gradient " + fixed(indices.mitralMeanGradient, 1) + " mmHg, " +
                               fixed(indices.mitralRegurgitationMl, 1) + " ml back");
  return listing.text();
}

nlohmann::ordered_json responseJson(const circulation::ResponsePoint& point) {
  nlohmann::ordered_json row = {{"value", point.value}};
  row.update(circulationJson(point.indices));
  return row;
}

presentation::ShownCirculation shownOf(const Text& name, const circulation::Parameters& parameters,
                                       const circulation::PeriodicState& state) {
  return {name, parameters, state.beat, circulation::indicesOf(parameters, state.beat)};
}

void writeCurves(const std::filesystem::path& file, const std::vector<circulation::NamedCurve>& curves) {
  writeAtomically(file, [&](std::ostream& out) {
    for (std::size_t i = 0; i < curves.size(); ++i)
      out << (i > 0 ? "," : "") << curves[i].name;
    out << "\n";
    for (std::size_t row = 0; row < curves.front().values.size(); ++row) {
      for (std::size_t i = 0; i < curves.size(); ++i)
        out << (i > 0 ? "," : "") << significant(curves[i].values[row], kDigits);
      out << "\n";
    }
  });
}

} // namespace viscera::app::cli
