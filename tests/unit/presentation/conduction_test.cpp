#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "session_fixture.h"
#include "viscera/circulation/signs.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {
namespace {

/// A ball with a line along its side, which the excitation needs 200 ms for.
struct Conduction : testing::Test {
  Conduction() {
    document::NewOrgan heart = tests::ball("Heart");
    geometry::NamedWay way{"Bundle of His", 1.5, Points(3, 3), Values(3)};
    way.points << 30, 0, 0, 28, 10, 0, 22, 20, 0;
    way.reachedMs << 0, 100, 200;
    heart.organ.ways = {way};
    session.undo.perform(document::addOrgans({heart}));
  }

  const std::vector<scene::ConductionLine>& drawn(const std::optional<heart::BeatClock>& clock = {}) {
    Scene scene{session.document.state(), session.live, view, session.registry};
    scene.clock = clock;
    presenter.update(scene);
    return presenter.conduction().lines();
  }

  /// The clock of a beat at rest whose excitation is that far.
  static heart::BeatClock at(double ms) {
    const circulation::Parameters rest;
    heart::BeatClock clock{0, rest.conduction, rest.rate};
    for (clock.seconds = circulation::excitationOf(rest).sinusNode;
         circulation::excitationMs(rest, clock.seconds) < ms;)
      clock.seconds += 1e-4;
    return clock;
  }

  tests::BoundSession session;
  ViewState view;
  scene::OrganView drawnIn;
  Presenter presenter{drawnIn};
};

TEST_F(Conduction, IsDrawnOnlyWhileItIsOn) {
  EXPECT_FALSE(view.conduction) << "off at first";
  EXPECT_TRUE(drawn().empty());
  view.conduction = true;
  ASSERT_EQ(drawn().size(), 1u);
  EXPECT_EQ(drawn()[0].points.rows(), 3);
  EXPECT_EQ(drawn()[0].radiusMm, 1.5);
  EXPECT_EQ(drawn()[0].lit.maxCoeff(), 0) << "no beat is shown";
  view.conduction = false;
  EXPECT_TRUE(drawn().empty());
}

TEST_F(Conduction, LightsUpWhereTheExcitationIs) {
  view.conduction = true;
  const Values early = drawn(at(10))[0].lit;
  EXPECT_GT(early[0], 0.8);
  EXPECT_EQ(early[1], 0);
  const Values half = drawn(at(110))[0].lit;
  EXPECT_GT(half[1], 0.8);
  EXPECT_LT(half[0], half[1]) << "it fades behind the front";
  EXPECT_EQ(half[2], 0);
  EXPECT_LT(drawn(at(500))[0].lit.maxCoeff(), 0.05) << "until the next beat";
}

TEST_F(Conduction, MovesWithItsOrgan) {
  view.conduction = true;
  session.box.runUntil([&] { return session.jobs.idle(); });
  const Points rest = drawn()[0].points;
  session.live.showPose(
      (session.document.rig().restPositions().rowwise() + Eigen::RowVector3d(5, 0, 0)).eval());
  EXPECT_LT((drawn()[0].points - (rest.rowwise() + Eigen::RowVector3d(5, 0, 0))).cwiseAbs().maxCoeff(), 0.05);
}

TEST_F(Conduction, IsLeftOutWhereACutTakesItAway) {
  view.conduction = view.cut.on = true;
  view.cut.normal = -Vec3::UnitX();
  view.cut.offset = 0;
  EXPECT_TRUE(drawn().empty());
  view.cut.normal = Vec3::UnitX();
  EXPECT_EQ(drawn().size(), 1u);
}

TEST_F(Conduction, ComesBackWithASessionAndIsOffInOlderOnes) {
  view.conduction = true;
  EXPECT_TRUE(viewFromJson(toJson(view)).conduction);
  EXPECT_FALSE(view == ViewState());
  EXPECT_FALSE(viewFromJson({{"format", 3}, {"mode", "play"}}).conduction);
  EXPECT_FALSE(viewFromJson({{"format", 1}, {"mode", "play"}}).conduction);
}

} // namespace
} // namespace viscera::presentation
