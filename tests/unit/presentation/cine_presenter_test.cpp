#include "viscera/presentation/cine_presenter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "drawn_study.h"
#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/study_item.h"
#include "viscera/presentation/cine_view.h"
#include "viscera/presentation/presenter.h"

namespace viscera::presentation {
namespace {

using medical_io::CineStudy;

TEST(CineView, ProposesShortAxisFourAndTwoChambers) {
  const CineStudy study = tests::drawnStudy(tests::ballAndPhase);
  EXPECT_EQ(cineSlices(study, {}), (std::array<std::size_t, 3>{1, 4, 3}));
  CineLook look;
  look.slices = {2, -1, 99};
  EXPECT_EQ(cineSlices(study, look), (std::array<std::size_t, 3>{2, 4, 3})) << "there is no slice 99";
  CineStudy stack = study;
  stack.slices.resize(3);
  EXPECT_EQ(cineSlices(stack, {}), (std::array<std::size_t, 3>{1, 0, 2}));
  stack.slices.resize(1);
  stack.stacks.clear();
  EXPECT_EQ(cineSlices(stack, {}), (std::array<std::size_t, 3>{0, 0, 0}));
}

TEST(CineView, StepsThroughTheStackAndThroughTheLongAxes) {
  const CineStudy study = tests::drawnStudy(tests::ballAndPhase);
  EXPECT_EQ(cineStepped(study, 1, 1), 2u);
  EXPECT_EQ(cineStepped(study, 1, 5), 2u) << "it stops at the end";
  EXPECT_EQ(cineStepped(study, 1, -1), 0u);
  EXPECT_EQ(cineStepped(study, 3, 1), 4u);
  EXPECT_EQ(cineStepped(study, 3, -1), 3u);
}

TEST(CineView, MatchesPhasesByTheFractionOfEachSlicesOwnCycle) {
  CineStudy study = tests::drawnStudy(tests::ballAndPhase);
  medical_io::CineSlice& slice = study.slices[0];
  EXPECT_EQ(cinePhase(slice, 0.26), 2u);
  EXPECT_EQ(cinePhase(slice, 0.97), 0u) << "around the end of the cycle";
  slice.interval = 1.6; // Twice as long, and the same part of it.
  EXPECT_EQ(cinePhase(slice, 0.26), 2u);
  slice.fractions.erase(slice.fractions.begin() + 2);
  slice.missing = {0.25};
  EXPECT_FALSE(cinePhase(slice, 0.26)) << "nothing stands in for a missing picture";
  EXPECT_EQ(cinePhase(slice, 0.37), 2u);
  EXPECT_DOUBLE_EQ(cineStep(slice, 0.13, 1), 0.25) << "it counts the missing one";
  EXPECT_DOUBLE_EQ(cineStep(slice, 0.875, 1), 0);
  EXPECT_DOUBLE_EQ(cineStep(slice, 0, -1), 0.875);
  EXPECT_DOUBLE_EQ(cineSeconds(study), 0.8);
  EXPECT_DOUBLE_EQ(cineAdvanced(0.75, 0.4, 0.8, true), 0.25);
  EXPECT_DOUBLE_EQ(cineAdvanced(0.75, 0.4, 0.8, false), 1);
}

TEST(CineView, SamplesItsOwnPlaneAndNothingBesideIt) {
  const CineStudy study = tests::drawnStudy([](const Vec3& place, double) { return place.x(); });
  const medical_io::CineGeometry& geometry = study.slices[4].geometry;
  const medical_io::SliceFrame frame = cineFrame(geometry, {}, 200, 100);
  medical_io::ValueImage values;
  sampleCine(*study.slices[4].image(0), geometry, frame, true, values);
  const auto at = [&](const Vec3& place) {
    const Eigen::Vector2d pixel = frame.pixelOf(place);
    return values.values[std::size_t(std::lround(pixel.y()) * 200 + std::lround(pixel.x()))];
  };
  EXPECT_NEAR(at(Vec3(31, 0, 10)), 31, 1);
  EXPECT_NEAR(at(Vec3(-40, 0, -40)), -40, 1);
  EXPECT_TRUE(std::isnan(values.values.front())) << "beside the picture";
  EXPECT_EQ(cineEdges(frame), (std::array<std::string, 4>{"R", "L", "I", "S"}));
  const geometry::Plane plane = cinePlane(geometry);
  EXPECT_LT((plane.normal - frame.plane().normal).norm(), 1e-12);
}

TEST(CineView, NamesEdgesOfObliquePlanesByTwoLetters) {
  medical_io::SliceFrame frame;
  frame.right = Vec3(1, 1, 0);
  frame.up = Vec3(0.1, -0.1, 1);
  EXPECT_EQ(cineEdges(frame), (std::array<std::string, 4>{"RA", "LP", "I", "S"}));
}

TEST(CineView, FindsLevelAndWidthInAllSlicesThatCanBeRead) {
  CineStudy study = tests::drawnStudy([](const Vec3& place, double) { return place.x(); });
  study.slices[0].image = [](std::size_t) -> std::shared_ptr<const medical_io::CineImage> {
    throw DataError("cut short");
  };
  const medical_io::ValueWindow window = cineWindow(study);
  EXPECT_NEAR(window.level, 0, 2);
  EXPECT_NEAR(window.width, 126, 8);
}

/// A ball of 30 mm with ten handles, and a study in which it is bright.
struct StudiedBall : tests::BoundSession {
  ViewState view;
  CinePresenter cine;

  StudiedBall() {
    CineStudy study = tests::drawnStudy(tests::ballAndPhase);
    study.slices[4].fractions.erase(study.slices[4].fractions.begin() + 3);
    study.slices[4].missing = {0.375};
    undo.perform(document::openStudy(document::studyItem(std::move(study), "/ball")));
    update();
  }
  void update() {
    cine.update({document.state(), live, view}, {{0, 200, 160}, {1, 200, 160}, {2, 120, 160}});
  }
  std::vector<scene::SliceLine> contours(int pane) const {
    std::vector<scene::SliceLine> closed;
    for (const scene::SliceLine& line : cine.picture(pane).lines)
      if (line.closed)
        closed.push_back(line);
    return closed;
  }
};

TEST(CinePresenter, DrawsTheContourWhereTheImageTurnsDark) {
  StudiedBall ball;
  for (int pane = 0; pane < 3; ++pane) {
    const std::vector<scene::SliceLine> contours = ball.contours(pane);
    ASSERT_EQ(contours.size(), 1u);
    const medical_io::SliceFrame& frame = ball.cine.frame(pane);
    for (const Eigen::Vector2d& point : contours.front().points) {
      const Vec3 place = frame.at(point.x(), point.y());
      const auto value = [&](double part) {
        return ball.cine.read(pane, frame.pixelOf(part * place)).value.value_or(-1);
      };
      EXPECT_GT(value(0.85), 90);
      EXPECT_LT(value(1.15), 10);
    }
  }
  EXPECT_EQ(ball.cine.picture(0).title, "short axis 2 of 3  phase 1 of 8");
  EXPECT_EQ(ball.cine.picture(1).title, "4-chamber  phase 1 of 8");
}

TEST(CinePresenter, ShowsThePhaseOfTheInstantAndSaysWhatIsMissing) {
  StudiedBall ball;
  ball.view.scan.cine.fraction = 0.375;
  ball.update();
  EXPECT_EQ(ball.cine.phase(0), 3u);
  const medical_io::SliceFrame& frame = ball.cine.frame(0);
  EXPECT_EQ(ball.cine.read(0, frame.pixelOf(Vec3::Zero())).value, 103);
  EXPECT_FALSE(ball.cine.phase(1));
  EXPECT_TRUE(ball.cine.picture(1).grey.empty());
  EXPECT_EQ(ball.cine.picture(1).note, "The picture of this phase is missing");
  EXPECT_EQ(ball.contours(1).size(), 1u) << "contours need no picture";
  ball.view.scan.cine.fraction = 0.5;
  ball.update();
  EXPECT_FALSE(ball.cine.picture(1).grey.empty());
  EXPECT_NE(ball.cine.picture(1).note, "The picture of this phase is missing");
}

TEST(CinePresenter, HasTheHandlesAndDistancesOfItsOwnPlanes) {
  StudiedBall ball;
  EXPECT_TRUE(ball.cine.picture(1).marks.empty()) << "they are not shown";
  ball.view.shown.handles = ball.view.shown.movable = true;
  ball.update();
  const Eigen::Vector2d top = ball.cine.frame(1).pixelOf(Vec3(0, 0, 40)); // Of the plane with four chambers.
  EXPECT_EQ(ball.cine.handleAt(1, top + Eigen::Vector2d(2, 1), 8), 8);
  EXPECT_EQ(ball.cine.handleAt(1, top + Eigen::Vector2d(30, 0), 8), -1);
  document::MeasuredPoint from, to;
  from.rest = Vec3(-10, 0, 5);
  to.rest = Vec3(10, 0, 5);
  ball.undo.perform(document::addMeasurement({from, to}));
  ball.update();
  ASSERT_EQ(ball.cine.picture(1).texts.size(), 1u);
  EXPECT_EQ(ball.cine.picture(1).texts[0].words, "Distance 1: 20.0 mm");
  const auto mark = ball.cine.measuredAt(1, ball.cine.frame(1).pixelOf(to.rest), 3);
  ASSERT_TRUE(mark);
  EXPECT_EQ(*mark, (scene::MeasurementGlyphs::Mark{0, 1}));
  EXPECT_TRUE(ball.cine.picture(0).texts.empty()) << "5 mm beside the middle of the short axis";
}

TEST(CinePresenter, FollowsTheOrgansWhileTheyAreDragged) {
  StudiedBall ball;
  ball.undo.perform(document::moveHandles({ball.handle(8)}, tests::row(0, 0, 60)));
  ball.update();
  const auto lines = ball.contours(1);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].thin && !lines[1].thin) << "at rest, and posed";
  const auto top = [](const scene::SliceLine& line) {
    return std::max_element(line.points.begin(), line.points.end(),
                            [](const auto& a, const auto& b) { return a.y() < b.y(); })
        ->y();
  };
  EXPECT_GT(top(lines[1]), top(lines[0]) + 1);
  ball.view.scan.contours = false;
  ball.update();
  EXPECT_TRUE(ball.contours(1).empty());
}

TEST(CinePresenter, ShowsTheChosenSliceAndWhereTheOthersCut) {
  StudiedBall ball;
  ball.view.scan.cine.slices[0] = 2;
  ball.update();
  EXPECT_EQ(ball.cine.slice(0), 2u);
  EXPECT_NEAR(ball.cine.frame(0).plane().origin.z(), 20, 1e-9);
  // In the plane with four chambers the short axis is a line at its height.
  const scene::SliceLine& line = ball.cine.picture(1).lines.front();
  ASSERT_EQ(line.points.size(), 2u);
  for (const Eigen::Vector2d& point : line.points)
    EXPECT_NEAR(ball.cine.frame(1).at(point.x(), point.y()).z(), 20, 1e-6);
}

TEST(CinePresenter, FindsAContourAndDrawsTheOneThatIsBent) {
  StudiedBall ball;
  const medical_io::SliceFrame& frame = ball.cine.frame(0);
  const auto place = ball.cine.contourAt(0, frame.pixelOf(Vec3(30.5, 0, 0)), 5);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->organ, ball.organ());
  EXPECT_NEAR(place->place.norm(), 30, 0.5);
  EXPECT_FALSE(ball.cine.contourAt(0, frame.pixelOf(Vec3::Zero()), 5)) << "too far from it";
  const geometry::PlaneCut cut = ball.cine.cut(0, ball.organ());
  ASSERT_EQ(cut.lines(), 1u);
  EXPECT_EQ(ball.cine.cut(0, document::OrganId{999}).lines(), 0u);
  ball.cine.setBent(BentContour{0, ball.organ(), 1.1 * cut.points, true});
  ball.update();
  const auto lines = ball.contours(0);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].thin && !lines[1].thin) << "its own, and the bent one";
  EXPECT_NEAR(frame.at(lines[1].points[0].x(), lines[1].points[0].y()).norm(), 33, 0.5);
  EXPECT_EQ(ball.contours(1).size(), 1u) << "in its pane only";
  ball.cine.setBent(std::nullopt);
  ball.update();
  EXPECT_EQ(ball.contours(0).size(), 1u);
}

TEST(CinePresenter, IsRefusedWithoutAStudy) {
  tests::BoundSession session;
  ViewState view;
  CinePresenter cine;
  EXPECT_THROW(cine.update({session.document.state(), session.live, view}, {{0, 20, 20}}), UsageError);
}

TEST(CineLook, ComesBackWithTheView) {
  ViewState view;
  EXPECT_FALSE(toJson(view).at("scan").contains("cine"));
  view.scan.cine.slices = {2, -1, 4};
  view.scan.cine.fraction = 0.25;
  EXPECT_EQ(viewFromJson(toJson(view)), view);
}

} // namespace
} // namespace viscera::presentation
