#include "phantom_json.h"

#include "viscera/phantom/tissue.h"

namespace viscera::phantom {
namespace {

using nlohmann::ordered_json;

constexpr double kMsPerSecond = 1000;

ordered_json listOf(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

ordered_json tissueTable() {
  ordered_json table = ordered_json::array();
  for (const Tissue& tissue : tissues())
    table.push_back({{"name", tissue.name},
                     {"label", tissue.label},
                     {"hounsfield", tissue.hounsfield},
                     {"t1Ms", tissue.t1Ms},
                     {"t2Ms", tissue.t2Ms},
                     {"protons", tissue.protons},
                     {"signal", steadyStateSignal(tissue)},
                     {"still", tissue.still},
                     {"source", tissue.source}});
  return table;
}

std::string nameOf(Contrast::Noise noise) {
  return noise == Contrast::Noise::none ? "none" : noise == Contrast::Noise::rician ? "rician" : "gaussian";
}

} // namespace

ordered_json headOf(const PhantomOptions& options, const PhantomMotion& motion) {
  ordered_json json = {{"kind", "viscera phantom"},
                       {"space", "LPS"},
                       {"unit", "mm"},
                       {"modality", nameOf(options.modality)},
                       {"heartbeat", options.motion.heartbeat},
                       {"breathing", options.motion.breathing},
                       {"seed", options.seed},
                       {"spacingMm", listOf(options.spacing)},
                       {"noise", {{"kind", nameOf(options.noise)}, {"deviation", options.deviation}}},
                       {"periodMs", kMsPerSecond * motion.periodSeconds()}};
  if (options.motion.heartbeat) {
    json["ratePerMinute"] = motion.beatsPerMinute();
    json["endSystoleMs"] = kMsPerSecond * motion.endSystoleSeconds();
  }
  if (options.motion.breathing)
    json["breathsPerMinute"] = options.motion.breathsPerMinute;
  json["tissues"] = tissueTable();
  return json;
}

ordered_json jsonOf(const StudyPlane& plane) {
  const Eigen::Affine3d& places = plane.grid.indexToLps;
  return {{"name", plane.name},
          {"description", plane.description},
          {"originMm", listOf(places.translation())},
          {"rowMm", listOf(places.linear().col(0))},
          {"columnMm", listOf(places.linear().col(1))},
          {"normalMm", listOf(places.linear().col(2))},
          {"shiftMm", listOf(plane.shift)}};
}

ordered_json jsonOf(const PhantomPhase& phase, const PhantomBody& body, const PhantomMotion& motion,
                    const WallPoints& wall) {
  ordered_json json = {{"timeMs", kMsPerSecond * phase.seconds},
                       {"beatFraction", phase.beatFraction},
                       {"inspiration", phase.inspiration},
                       {"volumesMl", phase.volumesMl}};
  std::vector<Vec3> places;
  for (const Landmark& landmark : body.landmarks)
    places.push_back(landmark.at);
  const Points moved = motion.moved(pointsOf(places));
  for (std::size_t l = 0; l < body.landmarks.size(); ++l)
    json["landmarks"][body.landmarks[l].name] = listOf(moved.row(static_cast<Eigen::Index>(l)).transpose());
  constexpr double kPercent = 100;
  const WallStrain strain = wall.strainAt(motion);
  json["strainPercent"] = {{"longitudinal", kPercent * strain.longitudinal},
                           {"circumferential", kPercent * strain.circumferential},
                           {"radial", kPercent * strain.radial}};
  return json;
}

} // namespace viscera::phantom
