#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <vtkImageData.h>

#include "shapes.h"
#include "view_fixture.h"
#include "viscera/scene/legend.h"
#include "viscera/scene/organ_view.h"
#include "viscera/scene/picture.h"

#include "view_furniture.h"

namespace viscera::scene {
namespace {

TEST(Legend, TicksAreFewRoundInsideTheRangeAndToldApartByTheirLabels) {
  for (const double low : {-1e6, -37.2, -0.001, 0.0, 1e-9, 0.3, 99.0, 12345.0})
    for (double span = 1e-7; span < 1e7; span *= 3.7) {
      if (span < 1e-6 * std::abs(low))
        continue; // Finer than a label of sensible length can tell.
      const ValueRange range{low, low + span};
      const auto ticks = niceTicks(range);
      ASSERT_GE(ticks.size(), 2U) << low << " + " << span;
      ASSERT_LE(ticks.size(), 6U);
      const double step = ticks[1] - ticks[0];
      std::set<std::string> labels;
      for (const double tick : ticks) {
        EXPECT_GE(tick, range.low - 1e-6 * span);
        EXPECT_LE(tick, range.high + 1e-6 * span);
        EXPECT_NEAR(tick / step, std::round(tick / step), 1e-3);
        labels.insert(tickLabel(tick, step));
      }
      EXPECT_EQ(labels.size(), ticks.size()) << low << " + " << span;
      const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
      EXPECT_TRUE(std::abs(mantissa - 1) < 1e-3 || std::abs(mantissa - 2) < 1e-3 ||
                  std::abs(mantissa - 5) < 1e-3)
          << step;
    }
}

TEST(Legend, TicksOfUsualRangesAreTheUsualOnes) {
  EXPECT_EQ(niceTicks({0, 1}), (std::vector<double>{0, 0.2, 2 * 0.2, 3 * 0.2, 4 * 0.2, 1}));
  EXPECT_EQ(niceTicks({-1, 1}).size(), 5U);
  EXPECT_EQ(niceTicks({3, 3}).size(), 1U);
}

TEST(Legend, LabelsHaveJustTheDigitsNeeded) {
  EXPECT_EQ(tickLabel(0.2, 0.2), "0.2");
  EXPECT_EQ(tickLabel(0.25, 0.05), "0.25");
  EXPECT_EQ(tickLabel(-3, 1), "-3");
  EXPECT_EQ(tickLabel(150, 50), "150");
  EXPECT_EQ(tickLabel(0, 0.1), "0.0");
  EXPECT_EQ(tickLabel(0.25, 0.05, ','), "0,25") << "as German writes it";
}

TEST(Legend, LogarithmicTicksAreThoseOfDecadesAndAreWrittenAsSuch) {
  const auto labels = [](double low, double high) { return tickLabels(niceTicks({low, high, true})); };
  using Labels = std::vector<std::string>;
  EXPECT_EQ(labels(0.5, 20), (Labels{"0.5", "1", "2", "5", "10", "20"}));
  EXPECT_EQ(labels(0.05, 45), (Labels{"0.1", "0.3", "1", "3", "10", "30"}));
  EXPECT_EQ(labels(0.01, 1000), (Labels{"0.01", "0.1", "1", "10", "100", "1000"}));
  EXPECT_EQ(labels(0.5, 2), (Labels{"0.5", "1", "2"}));
  EXPECT_EQ(labels(1 / 1.2, 1.2), (Labels{"0.9", "1.0", "1.1", "1.2"}));
  EXPECT_LE(labels(1e-9, 1e9).size(), 6U);
  EXPECT_EQ(tickLabels(niceTicks({0, 1})), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
}

TEST(Legend, CanBeReadOverWhatLiesBehindIt) {
  for (const Theme& theme : {darkTheme(), lightTheme()}) {
    tests::ViewInWindow window(400, 300);
    window.view.setTheme(theme);
    window.addOrgan(tests::sphere(4, 60))->setColor(theme.text); // As its own letters.
    window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-20), Vec3::Constant(20)});
    window.view.setScaleBarShown(false);
    const auto picture = [&window] {
      window.render();
      return grabPicture(window.surface.window());
    };
    const auto without = picture();
    window.view.legend().show("Stress", "deg", viridis(), {0, 1});
    const auto with = picture();
    int covered = 0; // Where the numbers stand.
    for (int y = 60; y < 240; ++y)
      for (int x = 344; x < 370; ++x) {
        const auto at = [&](vtkImageData* seen) {
          return *static_cast<const unsigned char*>(seen->GetScalarPointer(x, y, 0));
        };
        const double panel = 255 * theme.panel.x();
        covered += std::abs(at(with) - panel) < 0.6 * std::abs(at(without) - panel);
      }
    EXPECT_GT(covered, 200) << (theme.dark ? "dark" : "light");
  }
}

/// Whether the legend draws anything between two heights of a view without organs, as parts of its height.
bool drawsBetween(tests::ViewInWindow& window, double bottom, double top, const std::string& mark = {}) {
  const auto picture = [&](bool shown) {
    shown ? window.view.legend().show("Rotational stress", "deg", viridis(), {0, 1})
          : window.view.legend().hide();
    window.view.legend().setMark(shown ? mark : std::string(), {1, 0, 1});
    window.render();
    return grabPicture(window.surface.window());
  };
  window.view.setScaleBarShown(false);
  window.view.setOrientationCubeShown(false);
  const auto with = picture(true), without = picture(false);
  const int* size = with->GetDimensions();
  const auto* one = static_cast<const unsigned char*>(with->GetScalarPointer());
  const auto* other = static_cast<const unsigned char*>(without->GetScalarPointer());
  const int row = 3 * size[0];
  const int first = static_cast<int>(bottom * size[1]) * row, last = static_cast<int>(top * size[1]) * row;
  return !std::equal(one + first, one + last, other + first);
}

TEST(Legend, LiesAlongTheUpperEdgeOfANarrowViewAndStandsAtTheRightOfOthers) {
  for (const double ratio : {1.0, 2.0}) {
    const auto pixels = [ratio](int logical) { return static_cast<int>(ratio * logical); };
    tests::ViewInWindow narrow(pixels(270), pixels(400), ratio);
    EXPECT_TRUE(drawsBetween(narrow, 1 - kLevelLegend / 400, 1)) << ratio;
    EXPECT_FALSE(drawsBetween(narrow, 0, 1 - kLevelLegend / 400)) << ratio;
    EXPECT_TRUE(drawsBetween(narrow, 1 - kLevelMarkedLegend / 400, 1 - kLevelLegend / 400, "folded"));
    EXPECT_FALSE(drawsBetween(narrow, 0, 1 - kLevelMarkedLegend / 400, "folded")) << ratio;
    tests::ViewInWindow wide(pixels(500), pixels(400), ratio);
    EXPECT_TRUE(drawsBetween(wide, 0.25, 0.5)) << ratio;
  }
}

/// How many pixels of a part of the view another decimal mark changes.
int changedByMark(double left, double right, double bottom, double top,
                  const std::function<void(OrganView&)>& show) {
  tests::ViewInWindow window(400, 300);
  window.addOrgan(tests::sphere(4, 60));
  window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-0.35), Vec3::Constant(0.35)});
  const auto picture = [&] {
    show(window.view);
    window.render();
    return grabPicture(window.surface.window());
  };
  const auto point = picture();
  window.view.setDecimalMark(',');
  const auto comma = picture();
  int changed = 0;
  for (int y = static_cast<int>(300 * bottom); y < static_cast<int>(300 * top); ++y)
    for (int x = static_cast<int>(400 * left); x < static_cast<int>(400 * right); ++x)
      changed += *static_cast<const unsigned char*>(point->GetScalarPointer(x, y, 0)) !=
                 *static_cast<const unsigned char*>(comma->GetScalarPointer(x, y, 0));
  return changed;
}

TEST(Legend, AndTheScaleBarWriteDecimalsWithTheMarkOfTheLanguage) {
  const int legend = changedByMark(0.75, 1, 0.15, 1, [](OrganView& view) {
    view.setScaleBarShown(false);
    view.legend().show("Stress", "deg", viridis(), {0, 1});
  });
  EXPECT_GT(legend, 0);
  EXPECT_LT(legend, 300) << "nothing but the marks";
  const int bar = changedByMark(0, 1, 0, 0.15, [](OrganView& view) { view.setScaleBarShown(true); });
  EXPECT_GT(bar, 0) << "of 0.5 mm";
  EXPECT_LT(bar, 100);
}

} // namespace
} // namespace viscera::scene
