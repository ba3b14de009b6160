#include "viscera/circulation/readings.h"

#include <cmath>

#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::circulation {
namespace {

using enum Compartment;

constexpr double kPercent = 100;
constexpr double kMilliseconds = 1000;

} // namespace

const std::vector<Reading>& readings() {
  using I = const Indices&;
  static const std::vector<Reading> all = {
      {"Ejection fraction", "%", 0, [](I i) { return kPercent * i.of(lv).ef; }, "lv.ef"},
      {"Stroke volume", "ml", 0, [](I i) { return i.of(lv).svMl; }, "lv.sv"},
      {"Cardiac output", "l/min", 1, [](I i) { return i.cardiacOutputLMin; }, "heart.output"},
      {"LV end-diastolic", "ml", 0, [](I i) { return i.of(lv).edvMl; }, "lv.edv"},
      {"LV end-systolic", "ml", 0, [](I i) { return i.of(lv).esvMl; }, "lv.esv"},
      {"RV end-diastolic", "ml", 0, [](I i) { return i.of(rv).edvMl; }, "rv.edv"},
      {"RV end-systolic", "ml", 0, [](I i) { return i.of(rv).esvMl; }, "rv.esv"},
      {"RV ejection fraction", "%", 0, [](I i) { return kPercent * i.of(rv).ef; }, "rv.ef"},
      {"Aorta, systolic", "mmHg", 0, [](I i) { return i.aorta.systolic; }, "aorta.systolic"},
      {"Aorta, diastolic", "mmHg", 0, [](I i) { return i.aorta.diastolic; }, "aorta.diastolic"},
      {"Aorta, mean", "mmHg", 0, [](I i) { return i.aorta.mean; }, "aorta.mean"},
      {"Pulmonary artery, systolic", "mmHg", 0, [](I i) { return i.pulmonaryArtery.systolic; },
       "pulmonary.systolic"},
      {"Pulmonary artery, mean", "mmHg", 0, [](I i) { return i.pulmonaryArtery.mean; }, "pulmonary.mean"},
      {"Left atrium, mean", "mmHg", 0, [](I i) { return i.of(la).meanMmHg; }, "la.mean"},
      {"Right atrium, mean", "mmHg", 0, [](I i) { return i.of(ra).meanMmHg; }, "ra.mean"},
      {"LV end-diastolic pressure", "mmHg", 0, [](I i) { return i.of(lv).edpMmHg; }, "lv.edp"},
      {"LV dP/dt, largest", "mmHg/s", 0, [](I i) { return i.of(lv).dpdtMax; }, "lv.dpdt"},
      {"Isovolumic contraction", "ms", 0, [](I i) { return kMilliseconds * i.isovolumicContractionSeconds; },
       "lv.ivct"},
      {"Ejection time", "ms", 0, [](I i) { return kMilliseconds * i.ejectionSeconds; }, "lv.ejection"},
      {"Isovolumic relaxation", "ms", 0, [](I i) { return kMilliseconds * i.isovolumicRelaxationSeconds; },
       "lv.ivrt"},
      {"LV stroke work", "J", 2, [](I i) { return i.of(lv).strokeWorkJ; }, ""},
      {"RV stroke work", "J", 2, [](I i) { return i.of(rv).strokeWorkJ; }, ""},
      {"Arterial elastance Ea", "mmHg/ml", 2, [](I i) { return i.arterialElastance; }, ""},
      {"Coupling Ea/Ees", "", 2, [](I i) { return i.couplingRatio; }, "lv.coupling"},
      {"Aortic gradient, mean", "mmHg", 0, [](I i) { return i.aorticMeanGradient; }, "aortic.gradient"},
      {"Mitral regurgitation", "%", 0, [](I i) { return kPercent * i.mitralRegurgitantFraction; },
       "mitral.regurgitation"},
  };
  return all;
}

std::optional<NormalValues> normalOf(const Reading& reading, const anatomy::Person& person) {
  if (reading.norm.empty())
    return std::nullopt;
  const anatomy::Norm& norm = anatomy::norm(reading.norm);
  const anatomy::Range range = anatomy::rangeOf(norm, person);
  return NormalValues{range.low, range.high, norm.source, anatomy::meaningOf(norm, person), norm.people};
}

Text rangeText(const NormalValues& normal, int decimals) {
  if (!std::isfinite(normal.high))
    return phrase("from %1", inFixed(normal.low, decimals));
  if (!std::isfinite(normal.low))
    return phrase("up to %1", inFixed(normal.high, decimals));
  return phrase("%1 - %2", inFixed(normal.low, decimals), inFixed(normal.high, decimals));
}

} // namespace viscera::circulation
