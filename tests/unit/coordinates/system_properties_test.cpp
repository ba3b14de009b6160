#include "viscera/coordinates/measure/system_properties.h"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "line_measures.h"
#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

Scene line(int handles, int parts = 100) {
  Scene scene;
  scene.name = "line";
  scene.handles = tests::handlesAroundLine(handles);
  scene.line = Line{tests::kLineFrom, tests::kLineTo};
  scene.parts = parts;
  return scene;
}

SceneProperties measure(const std::string& id, const Scene& scene, const tests::Choices& choices = {}) {
  Progress progress;
  const auto system = tests::builtIn(id);
  return measureOn(*system, scene, tests::optionsFor(*system, choices), progress);
}

/// Refuses everything, in one of the ways in which a plugin may.
class Refusing : public CoordinateSystem {
public:
  std::string id() const override { return "refusing"; }
  std::string name() const override { return "Refusing"; }
  std::string summary() const override { return "For tests"; }
  Traits traits() const override { return {}; }
  std::vector<Parameter> parameters() const override { return {}; }
  std::unique_ptr<Binding> bind(const HandleSet& handles, const Points&, const BindOptions&,
                                Progress&) const override {
    if (handles.positions.rows() == 9)
      throw DataError("Nine are not enough", "handles");
    throw 42;
  }
};

TEST(SystemProperties, KnowTheGoodOnes) {
  for (const char* id : {"s-celestial", "t-celestial"}) {
    const SceneProperties found = measure(id, line(15));
    EXPECT_EQ(found.refusal, "");
    EXPECT_EQ(found.points, 101);
    EXPECT_LT(found.identityError, 1e-12);
    EXPECT_LT(found.unityError, 1e-12);
    EXPECT_GT(found.minWeight, 0);
    EXPECT_EQ(found.jump, 0.0);
    EXPECT_EQ(found.kinks, 0);
    EXPECT_LT(found.rotationChange, 1e-9);
    EXPECT_LT(found.handleError, kInterpolated);
    EXPECT_EQ(found.handleGaps, 0);
    EXPECT_GT(found.nanoseconds, 0);
  }
}

TEST(SystemProperties, SeeWhatIsNotKept) {
  EXPECT_GT(measure("s-celestial", line(9), {{"softness", "5"}}).handleError, 0.1);
  EXPECT_GT(measure("mean-value", line(9)).handleError, 0.5) << "a handle inside the cage has no influence";
  EXPECT_GT(measure("positive-mean-value", line(9, 20)).rotationChange, 1e-6) << "its rays do not turn";
  EXPECT_LT(
      measure("lagrange-minimisation", line(9), {{"positivity", "free"}, {"target", "inverse-distance"}})
          .minWeight,
      -1e-3);
  const SceneProperties jumping = measure("determinants-approach", line(9));
  EXPECT_GT(jumping.jump, 1e-3);
  EXPECT_FALSE(jumping.kinks.has_value());
  EXPECT_GT(measure("wire-approach", line(15)).failures, 10);
}

TEST(SystemProperties, OfPointsSayNothingAboutJumps) {
  const SceneProperties found = measure("s-celestial", cloudScene(200));
  EXPECT_EQ(found.points, 200);
  EXPECT_EQ(found.failures, 0);
  EXPECT_LT(found.identityError, 1e-12);
  EXPECT_FALSE(found.jump.has_value());
  EXPECT_FALSE(found.maxima.has_value());
}

TEST(SystemProperties, BearSystemsThatRefuse) {
  const std::vector<SystemVariant> variants = {{std::make_shared<Refusing>(), {}},
                                               {tests::builtIn("mean-value"), {}}};
  Progress progress;
  const auto all = measureSystems(variants, {line(9), line(10)}, {}, {}, progress);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].id, "refusing");
  EXPECT_EQ(all[0].refusals(), 2);
  EXPECT_THAT(all[0].scenes[0].refusal, testing::HasSubstr("Nine are not enough"));
  EXPECT_NE(all[0].scenes[1].refusal, "");
  EXPECT_EQ(all[0].worst().points, 0);
  EXPECT_EQ(all[1].refusals(), 0);
  EXPECT_EQ(all[1].worst().points, 202);
}

TEST(SystemProperties, AreTheSameWithAnyNumberOfThreadsButForTheTime) {
  std::vector<SystemVariant> variants;
  for (const char* id : {"s-celestial", "c-celestial", "determinants-approach", "lagrange-minimisation"})
    variants.push_back({tests::builtIn(id), {}});
  Progress progress;
  const std::vector<Scene> scenes = {line(9), cloudScene(50)};
  const auto one = measureSystems(variants, scenes, {1}, {}, progress);
  const auto three = measureSystems(variants, scenes, {3}, {}, progress);
  for (std::size_t i = 0; i < variants.size(); ++i)
    for (std::size_t j = 0; j < scenes.size(); ++j) {
      const SceneProperties &a = one[i].scenes[j], &b = three[i].scenes[j];
      EXPECT_EQ(a.identityError, b.identityError);
      EXPECT_EQ(a.minWeight, b.minWeight);
      EXPECT_EQ(a.jump, b.jump);
      EXPECT_EQ(a.kinks, b.kinks);
      EXPECT_EQ(a.largestKink, b.largestKink);
      EXPECT_EQ(a.rotationChange, b.rotationChange);
      EXPECT_EQ(a.handleError, b.handleError);
      EXPECT_EQ(a.failures, b.failures);
    }
}

TEST(SystemProperties, CanBeCancelledInTheMiddle) {
  Progress* running = nullptr;
  Progress progress([&](double fraction, const Text&) {
    if (fraction > 0.2)
      running->cancel();
  });
  running = &progress;
  const std::vector<SystemVariant> variants(4, {tests::builtIn("s-celestial"), {}});
  EXPECT_THROW(measureSystems(variants, {line(9), line(10)}, {2}, {}, progress), Cancelled);
}

TEST(HandleTable, IsRefusedByLineWhenItIsNone) {
  std::istringstream table("# columns = id,x,y,z\n1,2,3,4,0\n2,here,3,4\n");
  try {
    handlesOfTable(table, "t.fcsv");
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("t.fcsv, line 3"));
  }
}

TEST(Line, SagsInTheMiddleOnly) {
  const Line line{Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 3)};
  EXPECT_EQ(line.at(0), Vec3(-1, 0, 0));
  EXPECT_EQ(line.at(0.5), Vec3(0, 0, 3));
  EXPECT_EQ(line.at(1), Vec3(1, 0, 0));
}

} // namespace
} // namespace viscera::coordinates
