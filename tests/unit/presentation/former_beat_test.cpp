#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "build_paths.h"
#include "viscera/circulation/curves.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/core/error.h"
#include "viscera/core/progress.h"
#include "viscera/document/session_file.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/volume_curve.h"

namespace viscera::presentation {
namespace {

using heart::CardiacCycle;
using nlohmann::json;

document::SessionContents sessionOf(const std::string& name) {
  Progress quiet;
  return document::readSession(VISCERA_SOURCE_DIR "/tests/unit/presentation/sessions/" + name,
                               sample_organs::standardLibrary(), quiet)
      .contents;
}

ViewState viewOf(const document::SessionContents& session) {
  return viewFromJson(session.view, *session.state.circulation);
}

double fractionOf(const ViewState& view, const std::string& caption) {
  for (const Slide& slide : view.slides)
    if (slide.caption == caption)
      return slide.fraction.value_or(-1);
  ADD_FAILURE() << caption;
  return -1;
}

/// How far apart two instants of a cycle are.
double apart(double a, double b) {
  return std::abs(a - b - std::round(a - b));
}

TEST(FormerBeat, OfTheTextbookOpensAtTheInstantsItWasSavedAt) {
  const ViewState view = viewOf(sessionOf("textbook_format_2.viscera"));
  const heart::CardiacBeat beat = CardiacCycle().beat(75);
  const double cycle = beat.times().cycle;
  EXPECT_LT(apart(fractionOf(view, "Atria begin to contract"), heart::kBeforeAtria / cycle), 1e-9);
  EXPECT_LT(apart(fractionOf(view, "Aortic valve shuts"), beat.left().outletShuts / cycle), 1e-9);
  ASSERT_TRUE(view.playing);
  EXPECT_LT(apart(view.playing->fraction, beat.left().outletShuts / cycle), 1e-9);
  EXPECT_NEAR(beat.at(view.playing->fraction * cycle).volumes.leftMl, CardiacCycle::kEndSystole.leftMl, 1e-6);
  const double late = fractionOf(view, "Just before the next beat"); // It lies in the next one now.
  EXPECT_LT(apart(late, 0.975 + heart::kBeforeAtria / cycle), 1e-9);
  EXPECT_LT(late, 0.1);
}

TEST(FormerBeat, OfACirculationOpensAtTheInstantsItWasSavedAt) {
  const document::SessionContents session = sessionOf("circulation_format_2.viscera");
  ASSERT_TRUE(session.state.circulation->drives);
  const circulation::Parameters& parameters = session.state.circulation->parameters;
  Progress quiet;
  const circulation::PeriodicState found = circulation::findPeriodicState(parameters, quiet);
  ASSERT_TRUE(found.converged);
  const auto samples = static_cast<double>(found.beat.time.size() - 1);
  const auto first =
      static_cast<double>(circulation::firstDrawn(parameters, found.beat, heart::kBeforeAtria));
  const ViewState view = viewOf(session);
  // Curves of a beat begin with the ventricles' contraction, drawings with their sample `first`.
  EXPECT_LT(apart(fractionOf(view, "Ventricles begin to contract"), (samples - first) / samples), 1e-9);
  EXPECT_LT(apart(view.playing->fraction, 0.25 + (samples - first) / samples), 1e-9);
  // The same session is another one where the textbook's beat moves the heart.
  document::CirculationChoice textbook = *session.state.circulation;
  textbook.drives = false;
  EXPECT_GT(apart(viewFromJson(session.view, textbook).playing->fraction, view.playing->fraction), 0.1);
}

TEST(FormerBeat, APrescribedVolumeGoesWithItsInstants) {
  const document::SessionContents session = sessionOf("textbook_format_2.viscera");
  json before = session.view;
  const auto old = before["playing"]["prescribed"]["curve"].get<std::vector<std::array<double, 2>>>();
  const ViewState view = viewOf(session);
  ASSERT_TRUE(view.playing && view.playing->prescribed);
  const sequences::Curve was = sequences::volumeCurve(old);
  const sequences::Curve is = sequences::volumeCurve(view.playing->prescribed->curve);
  const double earlier = heart::kBeforeAtria * 75 / 60;
  for (double at = 0; at < 1; at += 0.05)
    EXPECT_NEAR(is.at(std::fmod(at + earlier, 1)), was.at(at), 1e-6) << at;
}

TEST(FormerBeat, IsReadOnceAndComesBackAsItIs) {
  const document::SessionContents session = sessionOf("circulation_format_2.viscera");
  const ViewState view = viewOf(session);
  EXPECT_EQ(viewFromJson(toJson(view), *session.state.circulation), view);
}

TEST(FormerBeat, OnlyAHeartbeatIsMoved) {
  const document::SessionContents session = sessionOf("textbook_format_2.viscera");
  const json saved = session.view;
  const auto fractions = [&](const json& view) {
    const ViewState read = viewFromJson(view);
    return std::pair(read.playing->fraction, *read.slides.at(1).fraction);
  };
  const double was = saved["playing"]["fraction"];
  json other = saved;
  other["motions"][0]["recipe"]["sequence"] = "breathing";
  EXPECT_EQ(fractions(other), std::pair(was, was));
  other = saved;
  other["playing"]["motion"] = -1; // The keys of the document.
  EXPECT_EQ(fractions(other), std::pair(was, was));
  other = saved;
  other["format"] = 3;
  EXPECT_EQ(fractions(other), std::pair(was, was));
  other = saved;
  other.erase("format"); // Format 1.
  EXPECT_EQ(fractions(other), fractions(saved));
  EXPECT_NE(fractions(saved).first, was);
}

TEST(FormerBeat, ThatNeverLeftItsBeginningStaysThere) {
  const document::SessionContents session = sessionOf("textbook_format_2.viscera");
  json view = session.view;
  view["playing"]["fraction"] = 0;
  view["playing"]["shown"] = false;
  EXPECT_EQ(viewFromJson(view).playing->fraction, 0);
  view["playing"]["shown"] = true;
  EXPECT_NEAR(viewFromJson(view).playing->fraction, heart::kBeforeAtria * 75 / 60, 1e-12);
}

TEST(FormerBeat, ACurveThatIsNoneIsStillRefused) {
  const document::SessionContents session = sessionOf("textbook_format_2.viscera");
  json view = session.view;
  view["playing"]["prescribed"]["curve"] = {{-0.5, 100}, {0.5, 60}};
  EXPECT_THROW(sequences::volumeCurve(viewFromJson(view).playing->prescribed->curve), DataError);
}

/// Sessions of format 1 that the program of that time wrote.
TEST(FormerBeat, OfFormat1IsMovedToo) {
  Progress quiet;
  const auto session =
      document::readSession(VISCERA_SOURCE_DIR "/tests/gui/sessions/explore_handles_shown_posed.viscera",
                            sample_organs::standardLibrary(), quiet);
  json view = session.contents.view;
  view["motions"] = {{{"organ", 1}, {"recipe", {{"sequence", "heartbeat"}, {"resolution", "low"}}}}};
  view["playing"] = {{"motion", 0}, {"fraction", 0.33}, {"ratePerMinute", 75}, {"shown", true}};
  EXPECT_NEAR(viewFromJson(view).playing->fraction, 0.33 + heart::kBeforeAtria * 75 / 60, 1e-12);
}

} // namespace
} // namespace viscera::presentation
