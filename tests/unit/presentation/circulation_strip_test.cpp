#include "viscera/presentation/circulation_figure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "viscera/circulation/curves.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"
#include "viscera/heart/cardiac_times.h"

namespace viscera::presentation {
namespace {

using circulation::Compartment;
using scene::CurvePanel;

const ShownCirculation& shownAtRest() {
  static const ShownCirculation shown = [] {
    Progress progress;
    ShownCirculation found;
    found.name = "Rest";
    found.parameters = circulation::scenarioParameters("rest");
    found.beat = circulation::findPeriodicState(found.parameters, progress).beat;
    found.indices = circulation::indicesOf(found.parameters, found.beat);
    return found;
  }();
  return shown;
}

std::vector<CurvePanel> stripWith(const HeartSigns& signs, double typeScale = 1) {
  return circulationStrip(shownAtRest(), nullptr, {1200, 320, typeScale, signs});
}

std::size_t overTime(const std::vector<CurvePanel>& panels) {
  return static_cast<std::size_t>(
      std::count_if(panels.begin(), panels.end(), [](const CurvePanel& panel) { return panel.cursor; }));
}

TEST(CirculationStrip, HasWhatIsChosenAndTheRestTakesTheRoom) {
  const std::vector<CurvePanel> all = stripWith({});
  ASSERT_EQ(all.size(), 7u);
  EXPECT_EQ(overTime(all), 5u);
  const std::vector<CurvePanel> signs = stripWith({.pressures = false, .loops = false});
  ASSERT_EQ(signs.size(), 3u) << "valves, electrocardiogram, sounds";
  EXPECT_EQ(overTime(signs), 3u);
  EXPECT_GT(signs[0].top - signs[0].bottom, 1.5 * (all[1].top - all[1].bottom));
  EXPECT_GT(signs[0].right, 0.95) << "no loops beside them";
  const std::vector<CurvePanel> loops =
      stripWith({.pressures = false, .ecg = false, .valves = false, .sounds = false});
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(overTime(loops), 0u);
  EXPECT_LT(loops[0].left, 0.1);
  EXPECT_TRUE(stripWith({false, false, false, false, false}).empty());
}

TEST(CirculationStrip, HasItsTimeAndTheNamesOfTheSoundsInWhateverIsLowest) {
  for (const HeartSigns& signs :
       {HeartSigns{}, HeartSigns{.sounds = false}, HeartSigns{.ecg = false, .sounds = false},
        HeartSigns{.pressures = false, .ecg = false, .valves = false}}) {
    const std::vector<CurvePanel> panels = stripWith(signs);
    const std::size_t rows = overTime(panels);
    std::size_t named = 0;
    for (std::size_t i = 0; i < rows; ++i) {
      EXPECT_EQ(panels[i].xLabels, i + 1 == rows) << i;
      EXPECT_EQ(panels[i].xTitle.empty(), i + 1 != rows) << i;
      named += !panels[i].marks.empty() && panels[i].marks.front().text == "S1";
    }
    EXPECT_EQ(named, 1u);
  }
}

TEST(CirculationStrip, LeavesRoomForLargerType) {
  const std::vector<CurvePanel> usual = stripWith({}), large = stripWith({}, 1.5);
  for (std::size_t i = 0; i < usual.size(); ++i)
    EXPECT_GT(large[i].left, usual[i].left - 1e-12) << i;
  EXPECT_NEAR(large.front().left, 1.5 * usual.front().left, 1e-12);
  EXPECT_NEAR(large[4].bottom, 1.5 * usual[4].bottom, 1e-12);
  EXPECT_NEAR(stripTypeScale(900, 280), 1, 1e-12);
  EXPECT_EQ(stripTypeScale(4000, 4000), scene::kLectureTypeScale);
  EXPECT_LT(stripTypeScale(400, 280), 1) << "as small as the width wants it";
}

TEST(CirculationStrip, MarksTheInstantInEveryPanelWhereItsCurveIs) {
  const ShownCirculation& shown = shownAtRest();
  const std::vector<CurvePanel> panels = stripWith({});
  const std::size_t first = circulation::firstDrawn(shown.parameters, shown.beat, heart::kBeforeAtria);
  const std::size_t count = shown.beat.time.size() - 1;
  for (const double fraction : {0.0, 0.3, 0.8, 1.0}) {
    const scene::InstantMarks marks = instantMarks(panels, shown, fraction);
    ASSERT_EQ(marks.lines.size(), 5u);
    ASSERT_EQ(marks.rings.size(), 2u);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(marks.lines[i].x, panels[i].left + fraction * (panels[i].right - panels[i].left), 1e-12);
      EXPECT_EQ(marks.lines[i].low, panels[i].bottom);
      EXPECT_EQ(marks.lines[i].high, panels[i].top);
    }
    const std::size_t sample =
        (first + static_cast<std::size_t>(std::lround(fraction * static_cast<double>(count)))) % count;
    for (std::size_t i = 0; i < 2; ++i) {
      const CurvePanel& loop = panels[5 + i];
      const Compartment ventricle = i == 0 ? Compartment::lv : Compartment::rv;
      const double volume = loop.xRange->low + (marks.rings[i].x - loop.left) / (loop.right - loop.left) *
                                                   (loop.xRange->high - loop.xRange->low);
      EXPECT_NEAR(volume, shown.beat.volumeOf(ventricle)[sample], 1e-6) << fraction;
    }
  }
}

} // namespace
} // namespace viscera::presentation
