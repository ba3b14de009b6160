#include "window/organs/explore_page.h"

#include <QAction>
#include <QDate>
#include <QFileInfo>
#include <QGridLayout>
#include <QLocale>
#include <QPushButton>

#include <algorithm>

#include "viscera/document/scan_fit.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/study_item.h"
#include "viscera/presentation/presenter.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

bool haveSameSurfaces(const document::OrganList& a, const document::OrganList& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one->mesh == other->mesh && one->name == other->name;
  });
}

/// "9001 cine: short axis, 25 phases in 829 ms, pixels of 1.41 mm, 6 mm thick".
QString lineOf(const document::StudySeries& series) {
  const QString name =
      (QString::number(series.number) + QLatin1Char(' ') + text(series.description)).trimmed();
  QString line = name + QStringLiteral(": ") + inWords(medical_io::nameOf(series.plane));
  line += QStringLiteral(", ") +
          (series.phases == series.phasesInCycle
               ? ExplorePage::tr("%n phases", nullptr, static_cast<int>(series.phases))
               : ExplorePage::tr("%1 of %2 phases").arg(series.phases).arg(series.phasesInCycle));
  if (series.intervalSeconds > 0)
    line += ExplorePage::tr(" in %1 ms").arg(formatNumber(kMsPerSecond * series.intervalSeconds, 0));
  line += ExplorePage::tr(", pixels of %1 mm").arg(formatDigits(series.spacingMm, 3));
  if (series.thicknessMm > 0)
    line += ExplorePage::tr(", %1 mm thick").arg(formatDigits(series.thicknessMm, 3));
  return line;
}

} // namespace

ExplorePage::ExplorePage(Workspace& workspace, const Actions& actions, QWidget* cut, QWidget* measurements,
                         QWidget* parts, QWidget* parent)
    : Page(parent), workspace_(workspace) {
  addSection(tr("View from"));
  add(makeViews(actions));
  addButton(actions["view.focus"]);
  cutSection_ = addSection(tr("Cut"));
  add(cut);
  addSection(tr("Measure"));
  add(measurements);
  partsSection_ = addSection(tr("Parts"));
  add(parts);
  addSection(tr("Show"));
  for (const char* id : {"view.handles", "view.ghost", "view.cube", "view.scale", "view.measurements"})
    addCheck(actions[id]);
  organSection_ = addSection(tr("Organ"));
  name_ = addFact(tr("Name"));
  name_->setObjectName(QStringLiteral("exploreOrgan"));
  volume_ = addFact(tr("Rest volume"));
  size_ = addFact(tr("Size"));
  triangles_ = addFact(tr("Triangles"));
  surface_ = addFact(tr("Surface"));
  file_ = addFact(tr("File"));
  warnings_ = addRemark(QString());
  warnings_->setObjectName(QStringLiteral("exploreRemarks"));
  scanSection_ = addSection(tr("Scan"));
  scanName_ = addFact(tr("Name"));
  scanVoxels_ = addFact(tr("Voxels"));
  scanSpacing_ = addFact(tr("Spacing"));
  scanFile_ = addFact(tr("File"));
  scanRemarks_ = addRemark(QString());
  scanRemarks_->setObjectName(QStringLiteral("scanRemarks"));
  studySection_ = addSection(tr("Cine study"));
  studyName_ = addFact(tr("Name"));
  studyDate_ = addFact(tr("Date"));
  studySeries_ = addRemark(QString());
  studySeries_->setObjectName(QStringLiteral("studySeries"));
  finish();
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      sync();
    if (change.organs() || change.scan() || change.study())
      syncSections();
    if (change.scan() || (change.organs() && !haveSameSurfaces(*change.before.organs, *change.after.organs)))
      syncScan();
    if (change.study())
      syncStudy();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  sync();
  syncScan();
  syncStudy();
  syncSections();
}

/// Only sections about what is open are there.
void ExplorePage::syncSections() {
  const document::OrganList& organs = workspace_.document().organs();
  const auto hasParts = [](const auto& organ) { return !organ->places.empty(); };
  setSectionShown(cutSection_, !organs.empty());
  setSectionShown(partsSection_, std::any_of(organs.begin(), organs.end(), hasParts));
  setSectionShown(organSection_, !organs.empty());
  setSectionShown(scanSection_, workspace_.state().scan != nullptr);
  setSectionShown(studySection_, workspace_.state().study != nullptr);
}

QWidget* ExplorePage::makeViews(const Actions& actions) {
  auto* box = new QWidget(this);
  auto* grid = makeLayout<QGridLayout>(box, 4);
  int index = 0;
  for (const char* id :
       {"view.anterior", "view.posterior", "view.left", "view.right", "view.superior", "view.inferior"}) {
    QAction* action = actions[id];
    auto* button = new QPushButton(action->iconText(), box);
    button->setToolTip(action->toolTip());
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    grid->addWidget(button, index / 2, index % 2);
    ++index;
  }
  return box;
}

void ExplorePage::sync() {
  const auto organ = workspace_.describedOrgan();
  const bool several = !organ && !workspace_.document().organs().empty();
  const QString none = QStringLiteral("-");
  name_->setText(organ ? inWords(presentation::labelOf(*organ)) : several ? tr("none selected") : none);
  volume_->setText(organ && organ->closed() ? formatMilliliters(organ->restVolumeMm3 / kMm3PerMl) : none);
  triangles_->setText(organ ? locale().toString(static_cast<int>(organ->mesh->triangles.rows())) : none);
  surface_->setText(!organ            ? none
                    : organ->closed() ? tr("closed")
                                      : tr("open, %n edges", nullptr, organ->boundaryEdges));
  file_->setText(organ && !organ->file.empty() ? QFileInfo(text(organ->file.string())).fileName() : none);
  file_->setToolTip(organ ? text(organ->file.string()) : QString());
  size_->setText(none);
  if (organ) {
    const Bounds bounds = boundsOf(organ->mesh->points);
    const Vec3 size = bounds.high - bounds.low;
    size_->setText(tr("%1 x %2 x %3 mm")
                       .arg(formatNumber(size.x(), 0))
                       .arg(formatNumber(size.y(), 0))
                       .arg(formatNumber(size.z(), 0)));
  }
  QStringList lines;
  if (several)
    lines.push_back(tr("Select an organ in the view or in the list to read about it."));
  if (organ)
    for (const Text& warning : organ->warnings)
      lines.push_back(inWords(warning));
  warnings_->setText(lines.join(QLatin1Char('\n')));
  warnings_->setVisible(!lines.isEmpty());
}

/// How many phases a scan has, how long its cycle is, and what is odd about them.
QString ExplorePage::phasesLineOf(const medical_io::ScanOverTime& time) {
  const auto all = static_cast<int>(time.phasesInCycle());
  QStringList lines(time.periodSeconds > 0
                        ? tr("%n phases in %1 s", nullptr, all).arg(formatNumber(time.periodSeconds, 3))
                        : tr("%n phases", nullptr, all));
  for (const Text& finding : time.findings)
    lines << asSentence(finding);
  return lines.join(QLatin1Char('\n'));
}

void ExplorePage::syncScan() {
  const auto item = workspace_.state().scan;
  const QString none = QStringLiteral("-");
  for (QLabel* fact : {scanName_, scanVoxels_, scanSpacing_, scanFile_})
    fact->setText(none);
  QStringList lines;
  if (item) {
    const medical_io::Scan& scan = *item->scan;
    const Vec3 spacing = scan.spacing();
    scanName_->setText(text(item->name));
    scanVoxels_->setText(tr("%1 x %2 x %3").arg(scan.size[0]).arg(scan.size[1]).arg(scan.size[2]));
    scanSpacing_->setText(tr("%1 x %2 x %3 mm")
                              .arg(formatDigits(spacing.x(), 3))
                              .arg(formatDigits(spacing.y(), 3))
                              .arg(formatDigits(spacing.z(), 3)));
    if (!item->file.empty())
      scanFile_->setText(QFileInfo(text(item->file.string())).fileName());
    scanFile_->setToolTip(text(item->file.string()));
    if (item->time)
      lines << phasesLineOf(*item->time);
    for (const medical_io::ScanFinding& finding : scan.findings)
      lines << asSentence(finding.sentence);
    for (const Text& sentence : document::scanFit(workspace_.state()))
      lines << asSentence(sentence);
  }
  scanRemarks_->setText(lines.join(QLatin1Char('\n')));
  scanRemarks_->setVisible(!lines.isEmpty());
}

/// A line for each series, then what is missing or damaged.
void ExplorePage::syncStudy() {
  const auto item = workspace_.state().study;
  if (!item)
    return;
  const medical_io::CineStudy& study = *item->study;
  studyName_->setText(text(item->name));
  studyName_->setToolTip(text(item->place.string()));
  const QDate date = QDate::fromString(text(study.date), QStringLiteral("yyyyMMdd"));
  studyDate_->setText(date.isValid() ? QLocale().toString(date, QLocale::ShortFormat) : QStringLiteral("-"));
  QStringList lines;
  for (const document::StudySeries& series : document::seriesOf(study))
    lines << lineOf(series);
  for (const Text& finding : study.findings)
    lines << asSentence(finding);
  studySeries_->setText(lines.join(QLatin1Char('\n')));
}

} // namespace viscera::app
