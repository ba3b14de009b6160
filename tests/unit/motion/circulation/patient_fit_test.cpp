#include "viscera/circulation/patient_fit.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::circulation {
namespace {

PatientFit fitted(double edvMl, double ef, double rate = 72, double pressure = 0) {
  Progress quiet;
  return fitToVentricle({edvMl, ef, rate, pressure}, quiet);
}

void expectInRange(const Parameters& parameters) {
  EXPECT_NO_THROW(checkParameters(parameters));
}

TEST(PatientFit, MeetsVolumeAndEjectionFractionOfHealthyAndFailingHearts) {
  const double edvs[] = {95, 131, 180, 240};
  const double efs[] = {0.66, 0.58, 0.42, 0.25};
  for (std::size_t i = 0; i < std::size(edvs); ++i) {
    const PatientFit fit = fitted(edvs[i], efs[i], 60 + 8.0 * static_cast<double>(i));
    EXPECT_TRUE(fit.met()) << fit.remark();
    EXPECT_NEAR(fit.indices.of(Compartment::lv).edvMl, edvs[i], 0.5);
    EXPECT_NEAR(fit.indices.of(Compartment::lv).ef, efs[i], 0.002);
    EXPECT_TRUE(fit.atLimit.empty());
    EXPECT_TRUE(fit.state.converged);
    expectInRange(fit.parameters);
  }
}

TEST(PatientFit, OfTheHeartAtRestIsThatAtRest) {
  Progress quiet;
  const Parameters rest;
  const Indices indices = indicesOf(rest, findPeriodicState(rest, quiet).beat);
  const ChamberIndices& lv = indices.of(Compartment::lv);
  const PatientFit fit = fitted(lv.edvMl, lv.ef, rest.rate);
  EXPECT_NEAR(fit.parameters.lv.ees / rest.lv.ees, 1, 0.01);
  EXPECT_NEAR(fit.parameters.stressedVolume / rest.stressedVolume, 1, 0.01);
  EXPECT_NEAR(fit.parameters.systemic.resistance / rest.systemic.resistance, 1, 0.01);
}

TEST(PatientFit, MeetsAPressureThatWasMeasured) {
  const PatientFit fit = fitted(150, 0.5, 80, 110);
  EXPECT_TRUE(fit.met()) << fit.remark();
  EXPECT_NEAR(fit.indices.aorta.mean, 110, 0.5);
}

TEST(PatientFit, FailingHeartIsWeakerAndFillsAtAHigherPressureThanAHealthyOne) {
  const PatientFit healthy = fitted(131, 0.58), failing = fitted(240, 0.25);
  EXPECT_LT(failing.parameters.lv.ees, 0.5 * healthy.parameters.lv.ees);
  EXPECT_GT(failing.indices.of(Compartment::la).meanMmHg, healthy.indices.of(Compartment::la).meanMmHg);
}

TEST(PatientFit, SaysWhatWouldHaveToLeaveItsRange) {
  const PatientFit fit = fitted(35, 0.1, 40); // 0.14 l a minute: no resistance keeps up a pressure.
  EXPECT_FALSE(fit.met());
  expectInRange(fit.parameters);
  EXPECT_NE(std::find(fit.atLimit.begin(), fit.atLimit.end(), "systemicResistance"), fit.atLimit.end());
  EXPECT_NE(fit.remark().english().find("systemicResistance"), std::string::npos);
}

TEST(PatientFit, RefusesWhatIsNoMeasurement) {
  EXPECT_THROW(fitted(130, 58), UsageError); // Per cent.
  EXPECT_THROW(fitted(0.13, 0.58), UsageError);
  EXPECT_THROW(fitted(130, 0.58, 10), UsageError);
  EXPECT_THROW(fitted(130, 0.58, 72, 12), UsageError); // kPa.
  EXPECT_THROW(fitted(std::nan(""), 0.58), UsageError);
}

} // namespace
} // namespace viscera::circulation
