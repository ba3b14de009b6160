#include "viscera/circulation/readings.h"

#include <cmath>

#include "viscera/core/text.h"

namespace viscera::circulation {
namespace {

using enum Compartment;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPercent = 100;

constexpr auto kBiobank =
    "Petersen 2017, doi 10.1186/s12968-017-0327-9: mean +- 2 standard deviations, men and women";
constexpr auto kOxford = "Hudsmith 2005, doi 10.1080/10976640500295516: mean +- 1 standard deviation, "
                         "women's lower and men's upper bound";
constexpr auto kPressures =
    "Whelton 2018, doi 10.1161/HYP.0000000000000065: normal is below 120/80; the lower "
    "bound is customary";
constexpr auto kPulmonary = "Kovacs 2009, doi 10.1183/09031936.00145608: mean +- 2 standard deviations";
constexpr auto kCustomary = "customary at the bedside";
constexpr auto kCoupling =
    "between the most efficient (0.5) and the most powerful coupling (1): Burkhoff and Sagawa 1986, "
    "doi 10.1152/ajpregu.1986.250.6.R1021";
constexpr auto kStenosis =
    "Baumgartner 2017, doi 10.1016/j.echo.2017.02.009: even mild stenosis stays below 20 mmHg";
constexpr auto kRegurgitation = "Zoghbi 2017, doi 10.1016/j.echo.2017.01.007: mild is below 30 %";

} // namespace

const std::vector<Reading>& readings() {
  using I = const Indices&;
  static const std::vector<Reading> all = {
      {"Ejection fraction", "%", 0, [](I i) { return kPercent * i.of(lv).ef; },
       NormalValues{48, 71, kBiobank}},
      {"Stroke volume", "ml", 0, [](I i) { return i.of(lv).svMl; }, NormalValues{50, 100, kCustomary}},
      {"Cardiac output", "l/min", 1, [](I i) { return i.cardiacOutputLMin; }, NormalValues{4, 8, kCustomary}},
      {"LV end-diastolic", "ml", 0, [](I i) { return i.of(lv).edvMl; }, NormalValues{109, 189, kOxford}},
      {"LV end-systolic", "ml", 0, [](I i) { return i.of(lv).esvMl; }, NormalValues{30, 66, kOxford}},
      {"RV end-diastolic", "ml", 0, [](I i) { return i.of(rv).edvMl; }, NormalValues{113, 223, kOxford}},
      {"Aorta, systolic", "mmHg", 0, [](I i) { return i.aorta.systolic; }, NormalValues{90, 120, kPressures}},
      {"Aorta, diastolic", "mmHg", 0, [](I i) { return i.aorta.diastolic; },
       NormalValues{60, 80, kPressures}},
      {"Aorta, mean", "mmHg", 0, [](I i) { return i.aorta.mean; }, NormalValues{70, 100, kCustomary}},
      {"Pulmonary artery, systolic", "mmHg", 0, [](I i) { return i.pulmonaryArtery.systolic; },
       NormalValues{15, 30, kCustomary}},
      {"Pulmonary artery, mean", "mmHg", 0, [](I i) { return i.pulmonaryArtery.mean; },
       NormalValues{7.4, 20.6, kPulmonary}},
      {"Left atrium, mean", "mmHg", 0, [](I i) { return i.of(la).meanMmHg; },
       NormalValues{4, 12, kCustomary}},
      {"Right atrium, mean", "mmHg", 0, [](I i) { return i.of(ra).meanMmHg; },
       NormalValues{2, 6, kCustomary}},
      {"LV end-diastolic pressure", "mmHg", 0, [](I i) { return i.of(lv).edpMmHg; },
       NormalValues{4, 12, kCustomary}},
      {"LV dP/dt, largest", "mmHg/s", 0, [](I i) { return i.of(lv).dpdtMax; },
       NormalValues{1200, kInfinity, kCustomary}},
      {"LV stroke work", "J", 2, [](I i) { return i.of(lv).strokeWorkJ; }, {}},
      {"RV stroke work", "J", 2, [](I i) { return i.of(rv).strokeWorkJ; }, {}},
      {"Arterial elastance Ea", "mmHg/ml", 2, [](I i) { return i.arterialElastance; }, {}},
      {"Coupling Ea/Ees", "", 2, [](I i) { return i.couplingRatio; }, NormalValues{0.5, 1, kCoupling}},
      {"Aortic gradient, mean", "mmHg", 0, [](I i) { return i.aorticMeanGradient; },
       NormalValues{-kInfinity, 20, kStenosis}},
      {"Mitral regurgitation", "%", 0, [](I i) { return kPercent * i.mitralRegurgitantFraction; },
       NormalValues{-kInfinity, 30, kRegurgitation}},
  };
  return all;
}

std::string rangeText(const NormalValues& normal, int decimals) {
  if (!std::isfinite(normal.high))
    return "from " + fixed(normal.low, decimals);
  if (!std::isfinite(normal.low))
    return "up to " + fixed(normal.high, decimals);
  return fixed(normal.low, decimals) + " - " + fixed(normal.high, decimals);
}

} // namespace viscera::circulation
