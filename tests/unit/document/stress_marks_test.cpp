#include "viscera/document/stress_mark_commands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "session_scene.h"
#include "viscera/document/organ_commands.h"

namespace viscera::document {
namespace {

using nlohmann::json;
using viscera::tests::TemporaryFolder;

class StressMarksTest : public testing::Test {
protected:
  void SetUp() override {
    for (const char* name : {"Ball", "Other"})
      session_.undo.perform(addOrgans({tests::ball(name, 20)}));
    ball_ = (*session_.document.state().organs)[0]->id;
    other_ = (*session_.document.state().organs)[1]->id;
  }
  StressProbeId pin(OrganId organ, const Vec3& rest = Vec3::Zero()) {
    session_.undo.perform(addStressProbe(organ, rest));
    return marks().probes.back().id;
  }
  const StressMarks& marks() const { return session_.document.stressMarks(); }
  /// The session with `edit` made in its text, read back.
  OpenedSession reread(const std::function<void(json&)>& edit) {
    SessionContents contents;
    contents.state = session_.document.state();
    contents.embedSurfaces = true;
    tests::write(folder_ / "a.viscera", contents);
    json root = json::parse(tests::contentsOf(folder_ / "a.viscera"));
    edit(root["stressMarks"]);
    return tests::readBack(folder_.put("b.viscera", root.dump()));
  }

  TemporaryFolder folder_;
  tests::Session session_;
  OrganId ball_, other_;
};

TEST_F(StressMarksTest, AreNumberedAndUndone) {
  const auto first = pin(ball_, {1, 2, 3});
  pin(ball_);
  EXPECT_EQ(marks().probes[0].rest, Vec3(1, 2, 3));
  EXPECT_EQ(marks().probes[1].number, 2);
  session_.undo.perform(removeStressProbes({first}));
  EXPECT_EQ(marks().probes.size(), 1U);
  pin(other_);
  EXPECT_EQ(marks().probes[1].number, 1) << "the first number that is free";
  session_.undo.undo();
  session_.undo.undo();
  ASSERT_EQ(marks().probes.size(), 2U);
  EXPECT_EQ(marks().probes[0].id, first);
}

TEST_F(StressMarksTest, ALineJoinsTwoProbesOfOneOrganAndGoesWithThem) {
  const auto a = pin(ball_), b = pin(ball_, {5, 0, 0}), c = pin(other_);
  session_.undo.perform(addStressLine(b, a));
  ASSERT_EQ(marks().lines.size(), 1U);
  EXPECT_EQ(marks().nameOf(marks().lines[0]), "2-1");
  EXPECT_THROW(session_.undo.perform(addStressLine(a, b)), UsageError) << "it is there already";
  EXPECT_THROW(session_.undo.perform(addStressLine(a, a)), UsageError);
  EXPECT_THROW(session_.undo.perform(addStressLine(a, c)), UsageError);
  EXPECT_THROW(session_.undo.perform(addStressLine(a, {99})), UsageError);
  session_.undo.perform(removeStressProbes({a}));
  EXPECT_TRUE(marks().lines.empty());
  session_.undo.undo();
  session_.undo.perform(removeStressLines({marks().lines[0].id}));
  EXPECT_EQ(marks().probes.size(), 3U);
  session_.undo.perform(removeAllStressMarks());
  EXPECT_TRUE(marks().empty());
}

TEST_F(StressMarksTest, RefuseWhatIsNoPlaceInNoOrgan) {
  EXPECT_THROW(session_.undo.perform(addStressProbe({99}, Vec3::Zero())), UsageError);
  EXPECT_THROW(session_.undo.perform(addStressProbe(ball_, {NAN, 0, 0})), DataError);
  EXPECT_THROW(session_.undo.perform(removeStressProbes({{99}})), UsageError);
  EXPECT_TRUE(marks().empty());
}

TEST_F(StressMarksTest, ComeBackWithASession) {
  const auto a = pin(ball_, {1.0 / 3, 2, 3}), b = pin(ball_);
  session_.undo.perform(addStressLine(a, b));
  EXPECT_EQ(*reread([](json&) {}).contents.state.stressMarks, marks());
}

TEST_F(StressMarksTest, OfADamagedSessionAreRefusedWithTheirPlace) {
  const auto a = pin(ball_), b = pin(ball_);
  session_.undo.perform(addStressLine(a, b));
  const auto refused = [this](const std::function<void(json&)>& edit, const std::string& said) {
    try {
      reread(edit);
      ADD_FAILURE() << "taken: " << said;
    } catch (const DataError& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  };
  refused([](json& marks) { marks["probes"][1]["number"] = 1; }, "wo stress probes have this number");
  refused([](json& marks) { marks["probes"][0]["organ"] = marks["probes"][1]["organ"] = 999; },
          "here is no organ 999");
  refused([](json& marks) { marks["probes"][1]["id"] = marks["probes"][0]["id"]; }, "comes twice");
  refused([](json& marks) { marks["lines"][0]["to"] = marks["lines"][0]["from"]; }, "does not join two");
  refused([](json& marks) { marks["lines"][0]["to"] = 999; }, "does not join two");
  refused([](json& marks) { marks["probes"][0].erase("rest"); }, "rest");
}

TEST_F(StressMarksTest, GoWithTheirOrganAndComeBackWithIt) {
  const auto a = pin(other_), b = pin(other_, {1, 0, 0});
  pin(ball_);
  session_.undo.perform(addStressLine(a, b));
  session_.undo.perform(removeOrgans({other_}));
  ASSERT_EQ(marks().probes.size(), 1U);
  EXPECT_EQ(marks().probes[0].number, 3);
  EXPECT_TRUE(marks().lines.empty());
  session_.undo.undo();
  EXPECT_EQ(marks().probes.size(), 3U);
  EXPECT_EQ(marks().lines.size(), 1U);
  session_.undo.perform(removeAllOrgans());
  EXPECT_TRUE(marks().empty());
  session_.undo.undo();
  EXPECT_EQ(marks().probes.size(), 3U);
}

} // namespace
} // namespace viscera::document
