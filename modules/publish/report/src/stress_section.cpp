#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "pictures.h"
#include "sections.h"
#include "viscera/core/text.h"
#include "viscera/elasticity/tissues.h"
#include "viscera/live/stress_marks_reader.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/presentation/slice_presenter.h"
#include "words.h"

namespace viscera::report {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr int kBars = 80;
/// Beyond this part of the points the histogram's axis ends: a few extreme places would press it flat.
constexpr double kDrawnPart = 0.998;

std::string nameOf(live::WitnessOrigin origin) {
  switch (origin) {
  case live::WitnessOrigin::surface:
    return said("by TetGen");
  case live::WitnessOrigin::repairedSurface:
    return said("by TetGen, from a repaired copy of the surface");
  case live::WitnessOrigin::grid:
    return said("by a regular grid");
  }
  return {};
}

/// "Volume ratio", "Rotational stress (deg)".
std::string withUnit(const std::string& name, const live::StressMeasure& measure) {
  const std::string unit = inWords(measure.unit());
  return unit.empty() ? name : name + " (" + unit + ")";
}

std::string titleWithUnit(const live::StressMeasure& measure) {
  return withUnit(named(live::describe(measure.quantity).name), measure);
}

/// "liver (E 6.27 kPa), doi:10.1002/jmri.24084".
std::string materialIn(const elasticity::StatedMaterial& material) {
  std::string words = inWords(live::nameOf(material));
  if (!material.tissue.empty())
    words += ", doi:" + std::string(elasticity::tissueNamed(material.tissue).doi);
  return words;
}

/// All quantities that a table has: those of a material only where one is stated.
std::vector<live::StressMeasure> listed(const elasticity::StatedMaterial& material) {
  std::vector<live::StressMeasure> all;
  for (const live::StressQuantityDescription& quantity : live::stressQuantities())
    if (const live::StressMeasure measure(quantity.quantity, material);
        quantity.quantity != live::StressQuantity::folded && measure.known())
      all.push_back(measure);
  return all;
}

std::vector<std::string> row(const std::string& name, const live::StressMeasure& measure,
                             const Values& values, Eigen::Index count) {
  const live::StressQuantityDescription& quantity = live::describe(measure.quantity);
  const live::QuantitySummary summary = live::summaryOf(values, count);
  std::vector<std::string> cells = {withUnit(name, measure)};
  for (const double value :
       {summary.min, summary.percentile5, summary.mean, summary.percentile95, summary.max})
    cells.push_back(fixed(value, quantity.decimals));
  return cells;
}

Table numbers(const live::StressFrame& frame, const elasticity::StatedMaterial& material) {
  Table table;
  table.head = {said("Quantity"), said("Minimum"),         said("5th percentile"),
                said("Mean"),     said("95th percentile"), said("Maximum")};
  table.numbers = {false, true, true, true, true, true};
  Values values;
  const auto add = [&](const deformation::StressMap& map, const live::StressMeasure& measure,
                       const std::string& name) {
    live::quantityOf(map, measure, values);
    table.rows.push_back(row(name, measure, values, frame.mesh->witnesses));
  };
  for (const live::StressMeasure& measure : listed(material))
    add(*frame.map, measure, named(live::describe(measure.quantity).name));
  if (frame.cycle && frame.cycle->peak) {
    const live::StressMeasure angle = live::StressQuantity::rotationalStress;
    add(*frame.cycle->peak, angle,
        said("%1, extreme over a cycle", named(live::describe(angle.quantity).name)));
  }
  return table;
}

int foldedOf(const deformation::StressMap& map, Eigen::Index count) {
  return static_cast<int>((map.volumeRatio.head(count).array() <= 0).count());
}

/// The outline of the bars: a curve that goes up and down at their sides.
scene::PanelCurve outlineOf(const std::vector<double>& sorted, double low, double high) {
  scene::PanelCurve curve{"", curveColor(1), {low}, {0}, 2};
  const double width = (high - low) / kBars;
  for (int bar = 0; bar < kBars; ++bar) {
    const double left = low + bar * width, right = left + width;
    const auto begin = std::lower_bound(sorted.begin(), sorted.end(), left);
    const auto end = bar + 1 < kBars ? std::lower_bound(sorted.begin(), sorted.end(), right)
                                     : std::upper_bound(sorted.begin(), sorted.end(), right);
    const double part = 100.0 * static_cast<double>(end - begin) / static_cast<double>(sorted.size());
    curve.x.insert(curve.x.end(), {left, right});
    curve.y.insert(curve.y.end(), {part, part});
  }
  curve.x.push_back(high);
  curve.y.push_back(0);
  return curve;
}

/// How a quantity is spread over the witness points; nothing when it is the same everywhere.
std::vector<Block> histogram(const live::StressFrame& frame, const live::StressMeasure& which) {
  const live::StressQuantityDescription& quantity = live::describe(which.quantity);
  Values values;
  live::quantityOf(*frame.map, which, values);
  std::vector<double> sorted;
  for (Eigen::Index i = 0; i < frame.mesh->witnesses; ++i)
    if (std::isfinite(values[i]))
      sorted.push_back(values[i]);
  std::sort(sorted.begin(), sorted.end());
  if (sorted.empty())
    return {};
  const auto last = static_cast<std::size_t>(kDrawnPart * static_cast<double>(sorted.size() - 1));
  const double low = quantity.ratio ? sorted[sorted.size() - 1 - last] : 0, high = sorted[last];
  if (!(high - low > 1e-9))
    return {};
  const live::QuantitySummary summary = live::summaryOf(values, frame.mesh->witnesses);
  scene::CurvePanel panel;
  panel.xTitle = titleWithUnit(which);
  panel.yTitle = said("Points (%)");
  panel.xRange = scene::ValueRange{low, high};
  panel.curves = {outlineOf(sorted, low, high)};
  const double top = 1.06 * *std::max_element(panel.curves[0].y.begin(), panel.curves[0].y.end());
  panel.yRange = scene::ValueRange{0, top};
  panel.curves.push_back({said("Mean"), curveColor(5), {summary.mean, summary.mean}, {0, top}, 1.5F});
  panel.curves.push_back({said("95th percentile"),
                          curveColor(0),
                          {summary.percentile95, summary.percentile95},
                          {0, top},
                          1.5F,
                          true});
  panel.legend = true;
  return {chart(panel, said("%1 over the witness points", named(quantity.name)))};
}

/// Mean, 95th percentile and largest over a cycle.
PictureGrid cycleChart(const live::CycleStress& cycle) {
  scene::CurvePanel panel;
  panel.xTitle = said("Time (s)");
  panel.yTitle = said("Rotational stress (deg)");
  panel.legend = true;
  panel.curves = {{said("Maximum"), curveColor(0), {}, {}},
                  {said("95th percentile"), curveColor(3), {}, {}},
                  {said("Mean"), curveColor(1), {}, {}}};
  for (const live::StressSample& sample : cycle.closed()) {
    const double values[] = {sample.statistics.max, sample.statistics.percentile95, sample.statistics.mean};
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
      panel.curves[i].x.push_back(sample.seconds);
      panel.curves[i].y.push_back(kDegrees * values[i]);
    }
  }
  panel.xRange = scene::ValueRange{0, cycle.periodSeconds};
  return chart(panel, said("Over one cycle of the sequence"));
}

/// The pinned probes: where they are in the pose, and what the map says there.
Table probeTable(const live::ReadMarks& marks, const elasticity::StatedMaterial& material) {
  Table table;
  table.head = {said("Probe"), said("Place (mm)")};
  table.numbers = {false, false};
  for (const live::StressMeasure& measure : listed(material)) {
    table.head.push_back(titleWithUnit(measure));
    table.numbers.push_back(true);
  }
  for (const live::ReadProbe& read : marks.probes) {
    const Vec3& place = read.reading.inTissue ? read.reading.now : read.probe.rest;
    std::vector<std::string> cells = {std::to_string(read.probe.number), presentation::formatPlace(place)};
    for (const live::StressMeasure& measure : listed(material)) {
      const double value = live::valueOf(read.reading, measure);
      cells.push_back(!read.reading.inTissue ? said("no tissue")
                      : std::isfinite(value) ? fixed(value, live::describe(measure.quantity).decimals)
                                             : said("folded"));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The quantity along the lines between probes; a curve ends where its line leaves the tissue.
PictureGrid profileChart(const live::ReadMarks& marks, const live::StressMeasure& which) {
  scene::CurvePanel panel;
  panel.xTitle = said("Distance at rest (mm)");
  panel.yTitle = titleWithUnit(which);
  panel.legend = true;
  double length = 0;
  for (std::size_t line = 0; line < marks.profiles.size(); ++line) {
    const live::ReadProfile& read = marks.profiles[line];
    length = std::max(length, read.profile.mm.back());
    bool joined = false, named = false;
    for (std::size_t i = 0; i < read.profile.mm.size(); ++i) {
      const double value = live::valueOf(read.profile.readings[i], which);
      if (std::isfinite(value) && !joined)
        panel.curves.push_back(
            {std::exchange(named, true) ? std::string() : read.name, curveColor(line), {}, {}});
      joined = std::isfinite(value);
      if (!joined)
        continue;
      panel.curves.back().x.push_back(read.profile.mm[i]);
      panel.curves.back().y.push_back(value);
    }
  }
  panel.xRange = scene::ValueRange{0, length};
  return chart(panel, said("Along the straight lines at rest between probes"));
}

} // namespace

Section stressSection(const ReportSource& source, const live::StressFrame& frame, Threads threads) {
  Section section{said("Tissue distortion (rotational stress)"), {}};
  const auto organ = source.state.organ(frame.organ);
  const Eigen::Index count = frame.mesh->witnesses;
  const int folded = foldedOf(*frame.map, count);
  Table facts;
  facts.numbers = {false, false};
  facts.rows = {{said("Organ"), organ ? titleOf(*organ) : std::string()},
                {said("Witness points"), said("%1 in %2 tetrahedra", std::to_string(count),
                                              std::to_string(frame.mesh->tetrahedra.rows())) +
                                             ", " + nameOf(source.stressStatus.origin)},
                {said("Derivatives"), source.stressStatus.closedForm ? said("in closed form (analytic)")
                                                                     : said("by central differences")},
                {said("Folded"), folded == 0 ? said("no point: the tissue is turned inside out nowhere")
                                             : said("%1 of %2 points are turned inside out",
                                                    std::to_string(folded), std::to_string(count))}};
  section.blocks.push_back(Paragraph{said(
      "Rotational stress is the largest angle by which a direction is turned when the tissue is stretched. "
      "It measures distortion and is not a pressure.")});
  section.blocks.push_back(std::move(facts));
  const live::StressMeasure measure = source.view.stress.measure();
  if (measure.material.stated())
    section.blocks.push_back(
        Paragraph{said("Pascals are of a stated material: %1.", materialIn(measure.material))});
  section.blocks.push_back(numbers(frame, measure.material));
  for (const Text& remark : source.stressStatus.remarks)
    section.blocks.push_back(Paragraph{withoutFolders(inWords(remark))});
  if (const Text remark = live::volumeRemark(*frame.map, count); !remark.empty())
    section.blocks.push_back(Paragraph{inWords(remark)});
  section.blocks.push_back(pictureOfStress(source, frame, threads));
  live::StressMarksReader reader;
  const live::ReadMarks marks = reader.read(source.state, frame.organ, frame.mesh, *frame.points, *frame.map);
  if (!marks.probes.empty())
    section.blocks.push_back(probeTable(marks, measure.material));
  if (!marks.profiles.empty() && measure.known())
    section.blocks.push_back(profileChart(marks, measure));
  if (measure.known())
    for (Block& block : histogram(frame, measure))
      section.blocks.push_back(std::move(block));
  if (frame.cycle && frame.cycle->samples.size() > 1)
    section.blocks.push_back(cycleChart(*frame.cycle));
  return section;
}

} // namespace viscera::report
