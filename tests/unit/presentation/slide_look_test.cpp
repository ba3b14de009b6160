#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "session_fixture.h"
#include "viscera/presentation/presenter.h"
#include "viscera/presentation/slice_presenter.h"

namespace viscera::presentation {
namespace {

using nlohmann::json;

Slide cutSlide() {
  SlideLook look;
  look.cut = {true, Vec3::UnitX(), -0.25};
  look.partNames = true;
  look.organs = {{{4}, {false, 1}}, {{7}, {true, 0.3}}};
  return {"Open", {.position = Vec3(0, -500, 20)}, 0.25, look};
}

TEST(SlideLook, ComesBackFromASession) {
  ViewState view;
  view.slides = {cutSlide(), {"Plain", {.position = Vec3(0, 500, 20)}, {}}};
  view.organsSeen = {{{7}, {true, 0.3}}};
  const ViewState back = viewFromJson(toJson(view));
  EXPECT_EQ(back.slides, view.slides);
  EXPECT_FALSE(back.slides[1].look);
  EXPECT_EQ(back.organsSeen, view.organsSeen);
}

TEST(SlideLook, IsNoneInOldSessionsAndWithinBoundsInOddOnes) {
  ViewState view;
  view.slides = {cutSlide()};
  json text = toJson(view);
  json& slide = text["slides"][0];
  slide["look"] = json::parse(
      R"({"cut": {"on": true, "normal": [0, 0, 0], "offset": 5}, "organs": [{"organ": 4, "opacity": 17}]})");
  const Slide odd = viewFromJson(text).slides.at(0);
  ASSERT_TRUE(odd.look);
  EXPECT_EQ(odd.look->cut.offset, 1);
  EXPECT_NEAR(odd.look->cut.normal.norm(), 1, 1e-12);
  EXPECT_FALSE(odd.look->labels || odd.look->partNames);
  EXPECT_EQ(odd.look->organs, (OrgansSeen{{{4}, {true, 1}}}));
  slide.erase("look");
  EXPECT_FALSE(viewFromJson(text).slides.at(0).look);
  EXPECT_TRUE(viewFromJson({{"format", 2}, {"mode", "explore"}}).organsSeen.empty());
}

/// Two balls, one of which a view hides.
struct TwoBalls : tests::BoundSession {
  TwoBalls() {
    undo.perform(document::addOrgans({tests::ball("Small", 12, 2, Vec3(0, 0, 10))}));
    view.organsSeen[organ(0)] = {true, 0.4};
    view.organsSeen[organ(1)] = {false, 1};
    view.organsSeen[{12345}] = {false, 1}; // Of no organ.
  }
  ViewState view;
};

TEST(OrgansSeen, AreDrawnSoAndTheDocumentStaysAsItIs) {
  TwoBalls balls;
  const document::DocumentState before = balls.document.state();
  scene::OrganView view;
  Presenter presenter(view);
  const auto update = [&] {
    presenter.update({balls.document.state(), balls.live, balls.view, balls.registry});
  };
  update();
  EXPECT_DOUBLE_EQ(presenter.actorOf(balls.organ(0))->opacity(), 0.4);
  EXPECT_FALSE(presenter.actorOf(balls.organ(1))->visible());
  balls.view.organsSeen.clear();
  update();
  EXPECT_DOUBLE_EQ(presenter.actorOf(balls.organ(0))->opacity(), 1);
  EXPECT_TRUE(presenter.actorOf(balls.organ(1))->visible());
  EXPECT_TRUE(balls.document.state() == before);
}

TEST(OrgansSeen, HaveTheirContoursOnSlices) {
  TwoBalls balls;
  SlicePresenter slices;
  const auto contours = [&] {
    slices.update({balls.document.state(), balls.live, balls.view}, {{1, 200, 160}});
    return slices.contours(1).size();
  };
  EXPECT_EQ(contours(), 1u);
  balls.view.organsSeen.clear();
  EXPECT_EQ(contours(), 2u);
}

} // namespace
} // namespace viscera::presentation
