#include "viscera/anatomy/norms.h"

#include <set>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::anatomy {
namespace {

TEST(Norms, EveryRowHasANameAPeopleASourceAndARange) {
  std::set<std::string> ids;
  for (const Norm& norm : norms()) {
    EXPECT_TRUE(ids.insert(norm.id).second) << norm.id << " is there twice";
    EXPECT_FALSE(norm.subject.empty() || norm.quantity.empty() || norm.people.empty()) << norm.id;
    EXPECT_NE(norm.source.find("doi 10."), std::string::npos) << norm.id << ": " << norm.source;
    for (const Sex sex : {Sex::either, Sex::women, Sex::men})
      for (const double surface : {0.0, kSmallestBodySurfaceM2, kLargestBodySurfaceM2}) {
        const Range range = rangeOf(norm, {sex, surface});
        EXPECT_TRUE(range.low < range.high || norm.kind == Kind::averages) << norm.id;
        EXPECT_FALSE(meaningOf(norm, {sex, surface}).empty());
      }
  }
}

TEST(Norms, SourcesOfVolumesBeginWithAShortNameThatFitsIntoAChart) {
  for (const Norm& norm : norms()) {
    if (norm.unit != "ml")
      continue;
    const std::string name = norm.source.substr(0, norm.source.find(", doi"));
    EXPECT_LT(name.size(), 40U) << norm.id << ": " << name;
    EXPECT_EQ(name.find("doi"), std::string::npos) << norm.id << ": " << name;
  }
}

TEST(Norms, OfEitherSexReachFromTheLowerToTheUpperBoundOfTwoDeviations) {
  const Norm& fraction = norm("lv.ef");
  EXPECT_DOUBLE_EQ(rangeOf(fraction).low, 58 - 2 * 5);
  EXPECT_DOUBLE_EQ(rangeOf(fraction).high, 61 + 2 * 5);
  EXPECT_DOUBLE_EQ(rangeOf(fraction, {Sex::women, 0}).low, 51);
  EXPECT_DOUBLE_EQ(rangeOf(fraction, {Sex::men, 0}).high, 68);
  EXPECT_EQ(meaningOf(fraction, {Sex::men, 0}).english(), "men, mean +- 2 standard deviations");
}

TEST(Norms, OfAPersonOfKnownSizeAreThoseASquareMetre) {
  const Norm& volume = norm("lv.edv");
  const Range small = rangeOf(volume, {Sex::women, 1.5});
  EXPECT_DOUBLE_EQ(small.low, 1.5 * (74 - 2 * 12));
  EXPECT_DOUBLE_EQ(small.high, 1.5 * (74 + 2 * 12));
  EXPECT_NE(meaningOf(volume, {Sex::women, 1.5}).english().find("1.50 m2"), std::string::npos);
  const Norm& fraction = norm("lv.ef");
  EXPECT_EQ(rangeOf(fraction, {Sex::women, 1.5}).low, rangeOf(fraction, {Sex::women, 0}).low)
      << "an ejection fraction knows no size";
}

/// Means and deviations, absolute and a square metre, are of the same people.
TEST(Norms, AbsoluteAndIndexedValuesAgreeOnTheBodiesTheyWereMeasuredIn) {
  for (const Norm& norm : norms())
    if (norm.knowsSize()) {
      EXPECT_NEAR(norm.women->mean / norm.womenPerM2->mean, 1.68, 0.05) << norm.id;
      EXPECT_NEAR(norm.men->mean / norm.menPerM2->mean, 1.95, 0.05) << norm.id;
    }
}

/// UK Biobank's limits of what is normal, the widest of its three age groups, as others quote the paper's
/// tables of men and women: people of all ages together spread a little less.
struct QuotedLimits {
  const char* id;
  Range women, men, womenPerM2, menPerM2;
};

TEST(Norms, OfVentriclesLieWithinTheLimitsThatOthersQuoteOfTheSamePeople) {
  const QuotedLimits all[] = {{"lv.edv", {80, 175}, {93, 232}, {50, 101}, {52, 117}},
                              {"lv.esv", {25, 73}, {34, 103}, {16, 43}, {19, 52}},
                              {"lv.sv", {47, 110}, {49, 140}, {29, 63}, {28, 70}},
                              {"rv.edv", {83, 192}, {99, 260}, {51, 110}, {55, 128}},
                              {"rv.esv", {26, 95}, {34, 135}, {16, 55}, {19, 67}},
                              {"rv.sv", {47, 107}, {54, 140}, {29, 61}, {30, 69}}};
  const auto check = [](const std::string& what, const Measured& measured, const Range& limits) {
    const double low = measured.mean - 2 * measured.deviation, high = measured.mean + 2 * measured.deviation;
    EXPECT_GE(low, limits.low - 1) << what;
    EXPECT_LE(high, limits.high + 1) << what;
    EXPECT_GE(high - low, 0.8 * (limits.high - limits.low)) << what;
  };
  for (const QuotedLimits& quoted : all) {
    const Norm& row = norm(quoted.id);
    check(row.id + ", women", *row.women, quoted.women);
    check(row.id + ", men", *row.men, quoted.men);
    check(row.id + ", women a square metre", *row.womenPerM2, quoted.womenPerM2);
    check(row.id + ", men a square metre", *row.menPerM2, quoted.menPerM2);
  }
}

/// What a ventricle holds, less what it keeps, is what it ejects.
TEST(Norms, OfAVentricleAddUp) {
  for (const char* side : {"lv", "rv"}) {
    const std::string id = side;
    const Norm &full = norm(id + ".edv"), &empty = norm(id + ".esv"), &stroke = norm(id + ".sv");
    EXPECT_NEAR(full.women->mean - empty.women->mean, stroke.women->mean, 1.1) << side;
    EXPECT_NEAR(full.men->mean - empty.men->mean, stroke.men->mean, 1.1) << side;
    EXPECT_NEAR(100 * stroke.women->mean / full.women->mean, norm(id + ".ef").women->mean, 1.1) << side;
    EXPECT_NEAR(100 * stroke.men->mean / full.men->mean, norm(id + ".ef").men->mean, 1.1) << side;
  }
}

/// What lies between is no disease yet, and not healthy either.
TEST(Norms, BoundsOfDiseasesLieOutsideTheHealthyRangeAndAreCited) {
  std::size_t bounds = 0;
  for (const Norm& row : norms())
    for (const DiseaseLimit& limit : row.disease) {
      ++bounds;
      const Range healthy = rangeOf(row);
      // Two deviations above the mean pressure of healthy lungs lie half a mmHg above the guideline's bound.
      constexpr double kOverlap = 1;
      EXPECT_TRUE(limit.above ? limit.bound > healthy.high - kOverlap : limit.bound < healthy.low)
          << row.id << ": " << limit.name;
      EXPECT_NE(limit.source.find("doi 10."), std::string::npos) << row.id << ": " << limit.name;
      EXPECT_FALSE(limit.name.empty()) << row.id;
    }
  EXPECT_GE(bounds, 9u);
  EXPECT_LE(rangeOf(norm("aortic.gradient")).high, 5) << "20 mmHg is a moderate stenosis";
  EXPECT_LE(rangeOf(norm("mitral.regurgitation")).high, 5) << "30 % is moderate";
}

TEST(Norms, WhatIsTaughtInExerciseAndOfTimesIsCited) {
  std::size_t rows = 0;
  for (const Norm& row : norms())
    if (row.id.rfind("exercise.", 0) == 0 || row.unit == "ms" || !row.disease.empty()) {
      ++rows;
      EXPECT_NE(row.source.find("doi 10."), std::string::npos) << row.id;
    }
  EXPECT_GE(rows, 10u);
}

TEST(Norms, PressuresThatFillTheLeftHeartAreThoseOfTheCitedPeople) {
  const Norm &wedge = norm("la.mean"), &filling = norm("lv.edp");
  EXPECT_NE(wedge.source.find("doi 10.1183/16000617.0062-2015"), std::string::npos)
      << "the range is its table's";
  EXPECT_EQ(rangeOf(wedge).low, 4);
  EXPECT_EQ(rangeOf(wedge).high, 12);
  EXPECT_NE(filling.source.find("doi 10.1161/01.CIR.44.6.1072"), std::string::npos)
      << "the range is that of its normal ventricles";
  EXPECT_EQ(rangeOf(filling).low, 5);
  EXPECT_EQ(rangeOf(filling).high, 12);
}

TEST(Norms, AnUnknownRowIsSaidSo) {
  EXPECT_THROW(norm("lv.nonsense"), UsageError);
}

TEST(Norms, SexesAreReadFromWhatFilesCallThem) {
  for (const Sex sex : {Sex::either, Sex::women, Sex::men})
    EXPECT_EQ(sexFromId(idOf(sex)), sex);
  EXPECT_EQ(sexFromId("nonsense"), Sex::either);
}

} // namespace
} // namespace viscera::anatomy
