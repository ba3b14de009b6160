#include <algorithm>
#include <optional>
#include <vector>

#include "pictures.h"
#include "sections.h"
#include "viscera/anatomy/norms.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/strain_reading.h"
#include "viscera/presentation/strain_figure.h"
#include "words.h"

namespace viscera::report {
namespace {

using live::StrainDirection;

bool hasLeftVentricle(const document::DocumentState& state) {
  return std::any_of(state.organs->begin(), state.organs->end(), [](const auto& organ) {
    return anatomy::chamberNamed(organ->name) == anatomy::kLeftVentricle;
  });
}

std::string inLanguage(const std::string& english) {
  return english.empty() ? english : said(english.c_str());
}

/// "GLS -17.2 % at 330 ms (healthy adults -20.6 to -13.4)"
Paragraph peakOf(const presentation::GlobalStrain& global) {
  return {inWords(phrase("%1 %2 % at %3 ms (healthy adults %4 to %5)", global.name,
                         fixed(global.peakPercent, 1), fixed(global.peakMs, 0),
                         fixed(global.healthyPercent.low, 1), fixed(global.healthyPercent.high, 1)))};
}

PictureGrid eyesOf(const live::StrainReading& reading) {
  std::vector<scene::BullsEyeFigure> figures;
  for (const StrainDirection direction :
       {StrainDirection::longitudinal, StrainDirection::circumferential, StrainDirection::radial})
    if (direction != StrainDirection::radial || reading.strain.wall) {
      figures.push_back(presentation::strainBullsEye(reading, direction, live::StrainMoment::peak));
      presentation::translate(figures.back(), inLanguage);
    }
  return bullsEyes(std::move(figures), said("Peak"));
}

} // namespace

Section strainSection(const ReportSource& source, Threads threads, Progress& progress) {
  Section section{said("Strain"), {}};
  if (!source.sequence || !hasLeftVentricle(source.state))
    return section;
  live::MotionRunner runner(source.state, *source.organs, threads);
  runner.setSequence(source.sequence);
  if (!runner.movable())
    return section;
  if (source.ratePerMinute > 0)
    runner.setRatePerMinute(source.ratePerMinute);
  runner.prescribe(source.prescribed);
  std::optional<live::StrainReading> reading;
  try {
    live::MovedOrgans moved = live::movedOrgans(runner, *source.systems, live::kStrainInstants, progress);
    live::addOwnWall(source.state, progress, moved);
    reading = live::readStrain(moved, {}, progress, threads);
  } catch (const DataError& error) { // A heart of another shape is no reason to do without a report.
    section.blocks.push_back(Paragraph{inWords(error.problem()) + "."});
    return section;
  }
  section.blocks.push_back(eyesOf(*reading));
  scene::CurvePanel curves = presentation::strainPanel(*reading);
  presentation::translate(curves, inLanguage);
  section.blocks.push_back(chart(std::move(curves), said("Strain")));
  const auto globals = presentation::globalStrains(*reading);
  for (const presentation::GlobalStrain& global : globals)
    section.blocks.push_back(peakOf(global));
  section.blocks.push_back(Paragraph{said(
      "GLS and GCS are the change of the length of contours of the endocardium, as ultrasound and feature "
      "tracking report it. GRS and the segments are the strain of the material at witness points of the "
      "wall. Shortening is negative. All are against the end of diastole. Values of single segments are "
      "poorly repeated between programs: hatched ones are not to be relied on.")});
  if (!globals.empty()) // GLS, GCS and GRS are of the same people.
    section.blocks.push_back(
        Paragraph{named(globals[0].norm->people) + "; " + named(globals[0].norm->source) + "."});
  for (const Text& warning : reading->warnings)
    section.blocks.push_back(Paragraph{inWords(warning) + "."});
  return section;
}

} // namespace viscera::report
