#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

#include <QDate>
#include <QLocale>

#include "pictures.h"
#include "sections.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"
#include "viscera/document/axes_commands.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/tables.h"
#include "viscera/geometry/volume.h"
#include "viscera/presentation/presenter.h"
#include "words.h"

namespace viscera::report {
namespace {

constexpr double kMm2PerCm2 = 100;
constexpr double kSeparateMl = 10; ///< Smaller volumes have one digit more.

std::string milliliters(double value) {
  return fixed(value, std::abs(value) < kSeparateMl ? 2 : 1);
}

Vec3 swatchOf(const document::Organ& organ) {
  if (organ.look.vertexColors && organ.mesh->colors.rows() > 0)
    return organ.mesh->colors.cast<double>().colwise().mean().transpose() / 255.0;
  return presentation::shownColor(organ.look.color);
}

std::string poseOf(const ReportSource& source) {
  if (source.state.rig->handles.empty())
    return said("none: the organs are as in their files");
  const Points rest = source.state.rig->restPositions();
  const Points& pose = source.organs->shownPose();
  const bool same = pose.rows() != rest.rows() || pose == rest;
  const auto moved = same ? 0 : ((pose - rest).rowwise().squaredNorm().array() > 0).count();
  std::string text = std::to_string(rest.rows());
  if (!source.state.rig->groups.empty())
    text += " " + said("in %1 groups", std::to_string(source.state.rig->groups.size()));
  return text + ", " + (moved == 0 ? said("at rest") : said("%1 of them moved", std::to_string(moved)));
}

/// The name of the window's sliders: "Locality" has a translation, the command line's "locality" has none.
std::string parameterName(const std::string& id) {
  std::string title = id;
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  const std::string translated = named(title);
  return translated == title ? id : translated;
}

std::string systemOf(const ReportSource& source) {
  const document::SystemChoice& choice = *source.state.system;
  std::string text = choice.id;
  std::vector<coordinates::Parameter> known;
  try {
    const auto system = source.systems->find(choice.id);
    text = named(system->name());
    known = system->parameters();
  } catch (const Error&) {
    // A plugin that is not here: its id is all that is known.
  }
  for (const auto& [name, value] : choice.parameters.all()) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&id = name](const auto& parameter) { return parameter.name == id; });
    text += ", " + (found == known.end() ? name : parameterName(found->name)) + " " + significant(value, 4);
  }
  return text;
}

/// A date of DICOM as people of the language write it.
std::string readableDate(const std::string& date) {
  const QDate known = QDate::fromString(QString::fromStdString(date), QStringLiteral("yyyyMMdd"));
  return known.isValid() ? QLocale().toString(known, QLocale::LongFormat).toStdString() : date;
}

/// Adds whose scan it is, and of when, where its file says that.
void addPatient(const ReportSource& source, Table& table) {
  if (!source.state.scan)
    return;
  const medical_io::Scan& scan = *source.state.scan->scan;
  if (!scan.patientName.empty())
    table.rows.push_back({said("Patient"), scan.patientName});
  if (!scan.studyDate.empty())
    table.rows.push_back({said("Study date"), readableDate(scan.studyDate)});
}

Table summary(const ReportSource& source) {
  const auto& organs = *source.state.organs;
  const auto shown =
      std::count_if(organs.begin(), organs.end(), [](const auto& organ) { return organ->look.visible; });
  std::string count = std::to_string(organs.size());
  if (shown != static_cast<std::ptrdiff_t>(organs.size()))
    count += ", " + said("%1 of them shown", std::to_string(shown));
  Table table;
  table.numbers = {false, false};
  addPatient(source, table);
  if (!source.file.empty())
    table.rows.push_back({said("File"), std::filesystem::path(source.file).filename().string()});
  table.rows.push_back({said("Organs"), count});
  table.rows.push_back({said("Handles"), poseOf(source)});
  if (!source.state.rig->handles.empty())
    table.rows.push_back({said("Coordinates"), systemOf(source)});
  const presentation::ViewState& view = source.view;
  if (view.playing && view.playing->shown && source.sequence)
    table.rows.push_back({said("Instant"), said("%1, at %2 of its cycle", inWords(source.sequence->name()),
                                                fixed(100 * view.playing->fraction, 1) + " %")});
  return table;
}

std::vector<std::string> volumeRow(const ReportSource& source, const document::Organ& organ) {
  std::string name = titleOf(organ);
  if (!organ.look.visible)
    name += " " + said("(hidden)");
  const Points& points = *source.organs->sharedPoints(organ.id);
  const std::string area = fixed(geometry::area(points, organ.mesh->triangles) / kMm2PerCm2, 1);
  if (!organ.closed())
    return {name, said("open"), said("open"), "-", "-", "-", area};
  const double rest = organ.restVolumeMm3 / kMm3PerMl;
  const double now = geometry::volume(points, organ.mesh->triangles) / kMm3PerMl;
  const double percent = rest != 0 ? 100 * (now - rest) / rest : 0;
  return {name,
          milliliters(rest),
          milliliters(now),
          signedNumber(now - rest, std::abs(now - rest) < kSeparateMl ? 2 : 1),
          signedNumber(percent, 1),
          organ.volumeLocked ? said("locked") : "-",
          area};
}

Section volumes(const ReportSource& source) {
  Table table;
  table.head = {
      said("Organ"), said("Rest shape (ml)"),     said("Now (ml)"), said("Change (ml)"), said("Change (%)"),
      said("Lock"),  said("Surface (cm\xC2\xB2)")};
  table.numbers = {false, true, true, true, true, true, true};
  bool open = false;
  for (const auto& organ : *source.state.organs) {
    table.rows.push_back(volumeRow(source, *organ));
    table.swatches.push_back(swatchOf(*organ));
    open = open || !organ->closed();
  }
  Section section{said("Volumes"), {std::move(table)}};
  if (open)
    section.blocks.push_back(Paragraph{said("Open: the surface has holes and holds no volume.")});
  return section;
}

std::string kindWord(document::MeasurementKind kind) {
  switch (kind) {
  case document::MeasurementKind::distance:
    return said("distance");
  case document::MeasurementKind::angle:
    return said("angle");
  case document::MeasurementKind::rectangle:
    return said("mean in a rectangle");
  case document::MeasurementKind::gap:
    return said("shortest distance");
  case document::MeasurementKind::sphere:
    break;
  }
  return said("mean in a sphere");
}

/// The name, and of a part of the scan how its values spread.
std::string rowTitle(const document::MeasurementRow& row) {
  const std::string spread = presentation::describeSpread(row.measurement, row.values, row.unit,
                                                          [](const char* text) { return said(text); });
  return spread.empty() ? row.measurement.name : row.measurement.name + " (" + spread + ")";
}

/// The titles of the organs that a measurement lies on, which it knows by their names.
std::string titlesOf(const std::set<std::string>& names, const document::OrganList& organs) {
  std::string titles;
  for (const std::string& name : names) {
    const auto organ =
        std::find_if(organs.begin(), organs.end(), [&](const auto& one) { return one->name == name; });
    titles += (titles.empty() ? "" : ", ") + (organ == organs.end() ? name : titleOf(**organ));
  }
  return titles;
}

Section measurements(const ReportSource& source) {
  Section section{said("Measurements"), {}};
  const auto rows = document::measurementRows(
      source.state,
      [&](document::OrganId organ) -> const Points& { return *source.organs->sharedPoints(organ); },
      source.tissue);
  Table table;
  table.head = {said("Name"),       said("Kind"), said("Measured on"),
                said("Rest shape"), said("Now"),  said("Change")};
  table.numbers = {false, false, false, true, true, true};
  for (const document::MeasurementRow& row : rows) {
    const auto kind = row.measurement.kind;
    const bool region = document::isRegion(kind);
    std::set<std::string> organs(row.organs.begin(), row.organs.end());
    organs.erase(std::string());
    const std::string on = region ? said("the scan") : titlesOf(organs, *source.state.organs);
    table.rows.push_back({rowTitle(row), kindWord(kind), on.empty() ? "-" : on,
                          presentation::formatMeasured(kind, row.values.rest, row.unit),
                          presentation::formatMeasured(kind, row.values.now, row.unit),
                          region ? "-" : signedNumber(row.values.now - row.values.rest, 1)});
  }
  if (!table.rows.empty())
    section.blocks.push_back(std::move(table));
  return section;
}

std::string originOf(const document::Organ& organ) {
  if (!organ.origin.sample.empty()) {
    const std::size_t at = organ.origin.sample.find('@');
    return said("sample organ \"%1\", %2 resolution", organ.origin.sample.substr(0, at),
                named(at == std::string::npos ? "medium" : organ.origin.sample.substr(at + 1)));
  }
  return organ.file.empty() ? said("made in the program") : organ.file.filename().string();
}

/// The remark on an organ's file, without its folder.
std::string remarksOf(const document::Organ& organ) {
  std::string text;
  for (const Text& remark : organ.warnings) {
    std::string warning = inWords(remark);
    if (const std::string path = organ.file.string(); !path.empty())
      for (std::size_t at = 0; (at = warning.find(path, at)) != std::string::npos;)
        warning.replace(at, path.size(), organ.file.filename().string());
    text += (text.empty() ? "" : "; ") + withoutFolders(warning);
  }
  return text.empty() ? said("none") : text;
}

Section files(const ReportSource& source) {
  Table table;
  table.head = {said("Organ"), said("Source"), said("Findings and repairs"), said("Vertices"),
                said("Triangles")};
  table.numbers = {false, false, false, true, true};
  for (const auto& organ : *source.state.organs)
    table.rows.push_back({titleOf(*organ), originOf(*organ), remarksOf(*organ),
                          std::to_string(organ->mesh->points.rows()),
                          std::to_string(organ->mesh->triangles.rows())});
  Section section{said("Files and what was done to them"), {std::move(table)}};
  for (const Text& note : source.notes)
    section.blocks.push_back(Paragraph{withoutFolders(inWords(note))});
  for (const Text& doubt : document::doubtsAboutPatient(*source.state.organs))
    section.blocks.push_back(Paragraph{inWords(phrase("All organs together: %1.", doubt))});
  section.blocks.push_back(Paragraph{
      said("All lengths are in millimetres, all volumes in millilitres; positions are in the patient's axes "
           "LPS (to the left, to the back, to the head). Viscera is a program for teaching and "
           "research, not a medical device.")});
  return section;
}

/// What the organs are: the first one's name where it says that. Files of a series are often called after the
/// patient alone; chambers among them tell that it is a heart.
std::string subjectOf(const document::OrganList& organs) {
  const std::string label = titleOf(*organs.front());
  const bool says = anatomy::partNamed(organs.front()->name).has_value();
  const bool heart = std::any_of(organs.begin(), organs.end(), [](const auto& organ) {
    return anatomy::chamberNamed(organ->name).has_value();
  });
  return says || !heart ? label : said("Heart") + " (" + label + ")";
}

} // namespace

int Report::pictures() const {
  int count = 0;
  for (const Section& section : sections)
    for (const Block& block : section.blocks)
      if (const auto* grid = std::get_if<PictureGrid>(&block))
        count += static_cast<int>(grid->pictures.size());
  return count;
}

Report makeReport(const ReportSource& source, Threads threads, Progress& progress) {
  if (source.state.organs->empty())
    throw UsageError("There is no organ to report on", source.file, "open one first");
  const auto step = [&](double part, const char* what) {
    progress.throwIfCancelled();
    progress.report(part, what);
  };
  Report report;
  report.title = source.title.empty() ? subjectOf(*source.state.organs) : source.title;
  const std::string date = source.date.empty()
                               ? QLocale().toString(QDate::currentDate(), QLocale::LongFormat).toStdString()
                               : source.date;
  report.made = said("Made by Viscera %1 on %2", VISCERA_VERSION, date);
  step(0, "drawing");
  Section first{{}, {summary(source)}};
  first.blocks.push_back(pictureAsSeen(source, threads));
  first.blocks.push_back(picturesOfSides(source, threads, progress));
  report.sections.push_back(std::move(first));
  step(0.4, "measuring");
  report.sections.push_back(volumes(source));
  report.sections.push_back(measurements(source));
  if (source.stress)
    if (const live::StressFrame& frame = source.stress->at(source.organs->shownPose());
        frame.organ && frame.map)
      report.sections.push_back(stressSection(source, frame, threads));
  step(0.6, "going through the cycle");
  if (source.sequence)
    report.sections.push_back(motionSection(source, threads, progress));
  step(0.8, "strain");
  report.sections.push_back(strainSection(source, threads, progress));
  report.sections.push_back(files(source));
  std::erase_if(report.sections, [](const Section& section) { return section.blocks.empty(); });
  step(1, "done");
  return report;
}

} // namespace viscera::report
