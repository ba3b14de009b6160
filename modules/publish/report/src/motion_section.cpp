#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pictures.h"
#include "sections.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"
#include "viscera/heart/clinical_numbers.h"
#include "viscera/heart/heart_numbers.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/session_motion.h"
#include "words.h"

namespace viscera::report {
namespace {

constexpr std::size_t kMostCurves = 8; ///< More on one pair of axes are unreadable.

std::string capital(std::string text) {
  if (!text.empty())
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// One organ whose volume is reported.
struct Line {
  std::shared_ptr<const document::Organ> organ;
  std::vector<double> milliliters;
  std::vector<heart::NormalRange> ranges;

  bool ejects() const {
    return std::any_of(ranges.begin(), ranges.end(), [](const heart::NormalRange& range) {
      return range.quantity == heart::NormalRange::Quantity::endDiastolicMl;
    });
  }
};

std::vector<Line> linesOf(const document::DocumentState& state, const live::CycleCurves& curves,
                          const anatomy::Person& person) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < state.organs->size(); ++i) {
    const auto& organ = (*state.organs)[i];
    if (organ->closed() && organ->look.tracked)
      lines.push_back({organ, curves.milliliters[i], heart::normalRanges(organ->name, person)});
  }
  return lines;
}

PictureGrid volumeChart(std::vector<Line> lines, const live::CycleCurves& curves, double period) {
  // Beside what is in them, walls would press the curves of ventricles flat.
  if (std::any_of(lines.begin(), lines.end(), [](const Line& line) { return line.ejects(); }))
    std::erase_if(lines, [](const Line& line) { return !line.ejects(); });
  const std::size_t all = lines.size();
  lines.resize(std::min(all, kMostCurves));
  scene::CurvePanel panel;
  panel.xTitle = said("Time (s)");
  panel.yTitle = said("Volume (ml)");
  panel.xRange = scene::ValueRange{0, period};
  panel.legend = true;
  std::vector<double> seconds;
  for (const double fraction : curves.fractions)
    seconds.push_back(fraction * period);
  for (const Line& line : lines)
    panel.curves.push_back(
        {titleOf(*line.organ), curveColor(panel.curves.size()), seconds, line.milliliters, 2.2F});
  std::string caption = said("Volumes over one cycle, each instant computed");
  if (all > lines.size())
    caption += "; " + said("the first %1 of %2 organs", std::to_string(lines.size()), std::to_string(all));
  return chart(panel, caption);
}

Table volumeTable(const std::vector<Line>& lines) {
  Table table;
  table.head = {said("Organ"), said("Rest shape (ml)"), said("Smallest (ml)"), said("Largest (ml)"),
                said("Change (%)")};
  table.numbers = {false, true, true, true, true};
  for (const Line& line : lines) {
    const auto [low, high] = std::minmax_element(line.milliliters.begin(), line.milliliters.end());
    table.rows.push_back({titleOf(*line.organ), fixed(line.organ->restVolumeMm3 / kMm3PerMl, 1),
                          fixed(*low, 1), fixed(*high, 1), fixed(100 * (*high - *low) / *high, 1)});
  }
  return table;
}

std::string ejectionRange(const Line& line) {
  for (const heart::NormalRange& range : line.ranges)
    if (range.quantity == heart::NormalRange::Quantity::ejectionPercent)
      return fixed(range.low, 0) + "-" + fixed(range.high, 0) + " %";
  return "-";
}

/// The table of ventricles; without rows when there is none.
Table indicesTable(const std::vector<Line>& lines, const live::CycleCurves& curves,
                   const heart::ChosenEnds& chosen, double rate) {
  Table table;
  table.head = {said("Ventricle"),          said("EDV (ml)"), said("ESV (ml)"),
                said("Stroke volume (ml)"), said("EF (%)"),   said("EF of healthy people"),
                said("Output (l/min)")};
  table.numbers = {false, true, true, true, true, true, true};
  for (const Line& line : lines) {
    const bool positive = *std::min_element(line.milliliters.begin(), line.milliliters.end()) > 0;
    if (!line.ejects() || !positive)
      continue;
    const heart::CardiacIndices indices =
        heart::cardiacIndicesAt(heart::cycleEnds(curves.fractions, line.milliliters, chosen),
                                curves.fractions, line.milliliters, rate);
    table.rows.push_back({titleOf(*line.organ), fixed(indices.endDiastolicMl, 1),
                          fixed(indices.endSystolicMl, 1), fixed(indices.strokeVolumeMl, 1),
                          fixed(100 * indices.ejectionFraction, 1), ejectionRange(line),
                          fixed(indices.cardiacOutputLPerMinute, 2)});
  }
  return table;
}

/// The same for each square metre of body surface, and the mass of the muscle; without rows when neither is
/// known.
Table indexedTable(const std::vector<Line>& lines, const live::CycleCurves& curves,
                   const presentation::ViewState& view, double rate) {
  Table table;
  table.head = {said("Ventricle"), said("Number"), said("Value"), said("Per m2 of body surface")};
  table.numbers = {false, false, true, true};
  std::vector<std::pair<std::string, double>> organs;
  for (const Line& line : lines)
    organs.emplace_back(line.organ->name, line.organ->restVolumeMm3 / kMm3PerMl);
  const std::optional<double> muscle = heart::muscleGrams(organs);
  for (const Line& line : lines) {
    const bool positive = *std::min_element(line.milliliters.begin(), line.milliliters.end()) > 0;
    if (!line.ejects() || !positive)
      continue;
    const bool left = anatomy::chamberNamed(line.organ->name) == anatomy::kLeftVentricle;
    const heart::CycleEnds ends = heart::cycleEnds(curves.fractions, line.milliliters, view.cycleEnds);
    for (const heart::HeartNumber& number :
         heart::heartNumbers(heart::cardiacIndicesAt(ends, curves.fractions, line.milliliters, rate),
                             left ? muscle : std::nullopt, view.person.bodySurfaceM2))
      if (number.perM2 || number.id == "mass")
        table.rows.push_back({titleOf(*line.organ), inWords(number.name),
                              fixed(number.value, number.digits) + ' ' + number.unit,
                              number.perM2 ? fixed(*number.perM2, number.digits) : "-"});
  }
  return table;
}

/// Keys have no names that say more than their numbers: their count and their ends are enough.
std::string phasesOf(const sequences::Sequence& sequence, double rate) {
  if (const std::vector<double> keys = sequence.keys(); !keys.empty()) {
    const double scale = sequence.standardRatePerMinute() / rate;
    return inWords(phrase("%n {key|keys}", keys.size())) + ", " +
           said("the first at %1 s, the last at %2 s", fixed(scale * keys.front(), 3),
                fixed(scale * keys.back(), 3));
  }
  std::string text;
  for (const sequences::Phase& phase : sequence.phases(rate))
    text += (text.empty() ? "" : ", ") + inWords(phase.name) + ' ' + fixed(60 / rate * phase.begin, 3) + "-" +
            fixed(60 / rate * phase.end, 3) + " s";
  return text.empty() ? "-" : text;
}

/// Puts organs back into the pose that they were in, whatever happens meanwhile.
class PoseKept {
public:
  explicit PoseKept(live::PosedOrgans& organs) : organs_(organs), pose_(organs.shownPose()) {}
  PoseKept(const PoseKept&) = delete;
  PoseKept& operator=(const PoseKept&) = delete;
  ~PoseKept() { organs_.showPose(pose_); }

private:
  live::PosedOrgans& organs_;
  Points pose_;
};

} // namespace

Section motionSection(const ReportSource& source, Threads threads, Progress& progress) {
  Section section{said("Motion"), {}};
  live::MotionRunner runner(source.state, *source.organs, threads);
  runner.setSequence(source.sequence);
  if (!runner.movable())
    return section;
  if (source.ratePerMinute > 0)
    runner.setRatePerMinute(source.ratePerMinute);
  runner.prescribe(source.prescribed);
  const PoseKept kept(*source.organs);
  const live::CycleCurves curves = live::measureCycle(runner, progress);
  const double rate = runner.ratePerMinute();
  Table facts;
  facts.numbers = {false, false};
  facts.rows = {{said("Sequence"), inWords(source.sequence->name())},
                {said("Rate"), said("%1 a minute, one cycle takes %2 s", significant(rate, 4),
                                    fixed(runner.periodSeconds(), 3))},
                {said("Phases"), phasesOf(*source.sequence, rate)}};
  if (source.prescribed)
    if (const auto organ = source.state.organ(source.prescribed->organ))
      facts.rows.push_back({said("Prescribed"), said("the volume of %1", titleOf(*organ))});
  if (const Text unsuited =
          live::unsuitedMotion(source.state, presentation::motionOf(source.view), *source.sequence);
      !unsuited.empty())
    section.blocks.push_back(Paragraph{inWords(unsuited) + "."}); // Before every number.
  section.blocks.push_back(std::move(facts));
  if (!curves.obstacle.empty())
    section.blocks.push_back(Paragraph{said("A volume could not be kept: %1", inWords(curves.obstacle))});
  const std::vector<Line> lines = linesOf(source.state, curves, source.view.person);
  if (lines.empty())
    return section;
  section.blocks.push_back(volumeChart(lines, curves, runner.periodSeconds()));
  section.blocks.push_back(volumeTable(lines));
  // Chosen ends are those of a measured motion, which is a sequence of keys.
  presentation::ViewState view = source.view;
  if (source.sequence->keys().empty())
    view.cycleEnds = {};
  Table indices = indicesTable(lines, curves, view.cycleEnds, rate);
  if (indices.rows.empty())
    return section;
  section.blocks.push_back(std::move(indices));
  if (Table indexed = indexedTable(lines, curves, view, rate); !indexed.rows.empty())
    section.blocks.push_back(std::move(indexed));
  for (const Line& line : lines)
    for (const heart::NormalRange& range : line.ranges)
      if (range.quantity == heart::NormalRange::Quantity::ejectionPercent)
        section.blocks.push_back(Paragraph{capital(named(range.name)) + ": " + inWords(range.meaning) + "; " +
                                           named(range.people) + "; " + named(range.source) + "."});
  return section;
}

} // namespace viscera::report
