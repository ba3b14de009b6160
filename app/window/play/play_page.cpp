#include "window/play/play_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>
#include <cmath>

#include "viscera/anatomy/part.h"
#include "viscera/circulation/patient_fit.h"
#include "viscera/document/circulation_commands.h"
#include "window/circulation/circulation_box.h"
#include "window/key_sequence/fit_box.h"
#include "window/key_sequence/key_box.h"
#include "window/play/curve_box.h"
#include "window/play/heart_numbers_box.h"
#include "window/play/sequence_list.h"
#include "window/style/language.h"
#include "window/view/view_area.h"
#include "window/view/view_model.h"

namespace viscera::app {
namespace {

enum CavityColumn {
  kCavityName,
  kCavityLargest,
  kCavitySmallest,
  kCavityStroke,
  kCavityFraction,
  kCavityColumns
};

QString nothing() {
  return QStringLiteral("-");
}

} // namespace

PlayPage::PlayPage(const ModeParts& parts, PlayMode& mode, const Actions& actions, QWidget* parent)
    : Page(parent), playback_(parts.playback), volumes_(parts.volumes), mode_(mode), view_(parts.view) {
  makeMotion(parts, actions);
  makeCirculation(parts, actions);
  addSection(tr("Appearance"));
  addCheck(actions["view.seeThrough"]);
  addCheck(actions["play.valves"]);
  addCheck(actions["view.labels"]);
  addCheck(actions["play.strain"]);
  addCheck(actions["play.strainOnOrgan"]);
  addButton(actions["play.compare"]);
  addButton(actions["play.compareFiles"]);
  makeTable();
  add(new HeartNumbersBox(parts, mode.measured(), this));
  makePatientCirculation(parts.workspace);
  makeRecording(parts.settings);
  makeOwnMotions(parts);
  finish();
  connect(&playback_, &Playback::stateChanged, this, &PlayPage::syncState);
  connect(&volumes_, &VolumeMonitor::shown, this, &PlayPage::syncPhase);
  connect(&playback_, &Playback::stillPoseChanged, this, &PlayPage::syncPhase);
  connect(&volumes_, &VolumeMonitor::updated, this, &PlayPage::syncTable);
  connect(&volumes_, &VolumeMonitor::linesChanged, this, &PlayPage::syncTable);
  connect(&view_, &ViewModel::changed, this, &PlayPage::syncIndices);
  syncState();
  syncTable();
}

void PlayPage::makeMotion(const ModeParts& parts, const Actions& actions) {
  addSection(tr("Sequence"));
  auto* list = new SequenceList(parts.workspace, playback_, this);
  add(list);
  offer_ = new FitOffer(parts.workspace, this);
  add(offer_);
  connect(list, &SequenceList::sequenceChosen, this, [this](const QString& id) {
    if (mode_.replacesOrgans(id))
      return offer_->ask(id);
    offer_->hide();
    mode_.chooseSequence(id);
  });
  connect(offer_, &FitOffer::sampleChosen, &mode_, &PlayMode::chooseSequence);
  rate_ = addFact(tr("Rate"));
  phase_ = addFact(tr("Phase"));
  phase_->setObjectName(QStringLiteral("playPhase"));
  addCheck(actions["play.loop"]);
  addButton(actions["play.motionFromSeries"]);
}

void PlayPage::makeCirculation(const ModeParts& parts, const Actions& actions) {
  QWidget* head = addSection(tr("Source of the motion"));
  auto* box = new CirculationBox(parts.workspace, playback_, mode_.circulation(), actions, this);
  add(box);
  connect(box, &CirculationBox::scenarioChosen, &mode_, &PlayMode::chooseScenario);
  connect(box, &CirculationBox::heartChosen, &mode_, &PlayMode::playSampleHeart);
  const auto sync = [this, &workspace = parts.workspace, head, box] {
    const bool wanted =
        mode_.circulation().on() || mode_.hasSampleHeart() || workspace.document().organs().empty();
    head->setVisible(wanted);
    box->setVisible(wanted);
  };
  connect(&playback_, &Playback::stateChanged, this, sync);
  connect(&mode_.circulation(), &CirculationModel::changed, this, sync);
  subscription_ = parts.workspace.onChange([sync](const document::Change&) { sync(); });
  sync();
}

void PlayPage::makeTable() {
  cycleHead_ = addSection(tr("During one cycle"));
  table_ = new QTableWidget(0, kCavityColumns, this);
  table_->setObjectName(QStringLiteral("cycleTable"));
  table_->setHorizontalHeaderLabels({QString(), tr("max"), tr("min"), tr("SV"), tr("EF")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kCavityName, QHeaderView::Stretch);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->hide();
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setToolTip(tr("Volumes in ml. SV is the stroke volume, EF the ejection fraction."));
  add(table_);
  fraction_ = addFact(tr("Ejection fraction"));
  fraction_->setObjectName(QStringLiteral("ejectionFraction"));
  stroke_ = addFact(tr("Stroke volume"));
  output_ = addFact(tr("Cardiac output"));
  output_->setObjectName(QStringLiteral("cardiacOutput"));
  for (const heart::WallMotionRange& range : heart::wallMotionRanges()) {
    walls_.push_back(addFact(inWords(range.name)));
    walls_.back()->setObjectName(QStringLiteral("wall%1").arg(QLatin1String(range.name)));
  }
  normal_ = addRemark(QString());
  normal_->setObjectName(QStringLiteral("normalRanges"));
}

/// The volumes of a heart that keeps its own motion choose the circulation.
void PlayPage::makePatientCirculation(Workspace& workspace) {
  patient_ = new QPushButton(tr("Circulation of this heart"), this);
  patient_->setObjectName(QStringLiteral("patientCirculation"));
  patient_->setToolTip(
      tr("Finds pressures, loops and sounds for the volume and the ejection fraction of this left "
         "ventricle. The organ keeps its own motion."));
  add(patient_);
  patientFit_ = addRemark(QString());
  patientFit_->setObjectName(QStringLiteral("patientCirculationFit"));
  patient_->hide();
  patientFit_->hide();
  connect(patient_, &QAbstractButton::clicked, this, [this, &workspace] {
    if (!ventricle_)
      return;
    workspace.inBackground<circulation::PatientFit>(
        tr("Circulation of this heart"), "patient",
        [heart = circulation::MeasuredVentricle{ventricle_->endDiastolicMl, ventricle_->ejectionFraction,
                                                playback_.player().ratePerMinute(), 0}](Progress& progress) {
          return circulation::fitToVentricle(heart, progress);
        },
        [this, &workspace](const circulation::PatientFit& fit) {
          if (!workspace.perform(
                  document::takeCirculation(tr("Circulation of this heart").toStdString(), fit.parameters)))
            return;
          patientFit_->setText(asSentence(fit.remark()));
          syncPatientCirculation();
        });
  });
}

void PlayPage::syncPatientCirculation() {
  const auto isLeft = [](const VolumeMonitor::Line& line) {
    return line.side == 0 && anatomy::partNamed(line.label) == anatomy::kLeftVentricle;
  };
  const auto& lines = volumes_.lines();
  ventricle_.reset();
  for (std::size_t line = 0; line < lines.size() && !ventricle_ && !mode_.hasSampleHeart(); ++line)
    if (isLeft(lines[line]))
      ventricle_ = volumes_.indices(line);
  patient_->setVisible(ventricle_.has_value());
  patientFit_->setVisible(ventricle_ && mode_.circulation().on() && mode_.circulation().choice().fitted &&
                          !patientFit_->text().isEmpty());
}

void PlayPage::makeRecording(Settings& settings) {
  record_ = new MovieBox(settings, this);
  addFolded(tr("Record a movie"), record_, true);
  MovieRecorder& recorder = mode_.recorder();
  connect(record_, &MovieBox::recordRequested, &mode_, &PlayMode::record);
  connect(record_, &MovieBox::cancelRequested, &recorder, &MovieRecorder::cancel);
  connect(&recorder, &MovieRecorder::stateChanged, this,
          [this, &recorder] { record_->setRunning(recorder.running()); });
}

void PlayPage::makeOwnMotions(const ModeParts& parts) {
  auto* curve = new CurveBox(parts.workspace, playback_, parts.settings, this);
  addFolded(tr("Prescribe a volume"), curve, false);
  auto* keys = new KeyBox(parts.workspace, playback_, mode_.keySequence(), parts.settings, this);
  addFolded(tr("Key sequence"), keys, false);
  auto* fit = new FitBox(parts.workspace, playback_, parts.picture, *parts.area.view(), this);
  addFolded(tr("Fit a sequence to an organ"), fit, false);
  connect(offer_, &FitOffer::fitChosen, fit, &FitBox::fit);
}

void PlayPage::syncState() {
  const live::Player& player = playback_.player();
  const sequences::Sequence* sequence = playback_.sequence();
  rate_->setText(sequence ? tr("%1 / min, one cycle %2 s")
                                .arg(formatNumber(player.ratePerMinute(), 0))
                                .arg(formatNumber(player.periodSeconds(), 2))
                          : nothing());
  cycleHead_->setVisible(sequence != nullptr);
  table_->setVisible(sequence != nullptr); // A row of each organ would only push away what follows.
  syncPhase();
  syncIndices(); // Normal ranges belong to the motion.
  syncWalls();
  record_->setName(
      sequence
          ? QStringLiteral("%1_%2").arg(text(sequence->id())).arg(formatNumber(player.ratePerMinute(), 0))
          : QString());
}

void PlayPage::syncPhase() {
  phase_->setText(!playback_.sequence() ? nothing()
                  : playback_.showing() ? inWords(playback_.player().phase())
                                        : playback_.stillPose());
}

void PlayPage::fillRow(std::size_t line) {
  const VolumeMonitor::Line& shown = volumes_.lines()[line];
  const auto range = volumes_.range(line);
  const auto indices = volumes_.indices(line);
  // An estimate is marked at each of its numbers.
  const QString about = volumes_.isEstimate(line) ? QString::fromUtf8("\u2248 ") : QString();
  const auto number = [&about](bool known, double value) {
    return known ? about + formatNumber(value, 1) : nothing();
  };
  const QStringList cells = {
      volumes_.nameOf(shown), number(range.has_value(), range ? range->high : 0),
      number(range.has_value(), range ? range->low : 0),
      number(indices.has_value(), indices ? indices->strokeVolumeMl : 0),
      indices ? about + tr("%1 %").arg(formatNumber(kPercent * indices->ejectionFraction, 0)) : nothing()};
  for (int column = 0; column < kCavityColumns; ++column) {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setTextAlignment((column == kCavityName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (column == kCavityName) // The column has what the numbers leave.
      item->setToolTip(cells[column]);
    else if (!about.isEmpty())
      item->setToolTip(tr("An estimate: only one phase of the images has labels"));
    table_->setItem(static_cast<int>(line), column, item);
  }
}

void PlayPage::syncTable() {
  const auto& lines = volumes_.lines();
  if (!isVisible() && table_->rowCount() == static_cast<int>(lines.size()))
    return;
  table_->setRowCount(static_cast<int>(lines.size()));
  for (std::size_t line = 0; line < lines.size(); ++line)
    fillRow(line);
  const bool cavities = std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.cavity; });
  for (const int column : {kCavityStroke, kCavityFraction})
    table_->setColumnHidden(column, !cavities);
  syncIndices();
  syncWalls();
  int height = table_->horizontalHeader()->height() + 2;
  for (int row = 0; row < table_->rowCount(); ++row)
    height += table_->rowHeight(row);
  table_->setFixedHeight(height);
}

/// Measured on the surfaces of the sample heart; beside the number the normal range.
void PlayPage::syncWalls() {
  const auto wall = volumes_.wall();
  const auto& ranges = heart::wallMotionRanges();
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const heart::WallMotionRange& range = ranges[i];
    setFactShown(walls_[i], wall || !fraction_->isHidden());
    walls_[i]->setText(wall ? tr("%1 %2 (%3\u2013%4)")
                                  .arg(formatNumber((*wall).*range.value, 1))
                                  .arg(inWords(range.unit))
                                  .arg(formatNumber(range.low, 0))
                                  .arg(formatNumber(range.high, 0))
                            : nothing());
    walls_[i]->setToolTip(tr("%1, measured on the surfaces. Healthy adults: %2")
                              .arg(inWords(range.about), inWords(range.source)));
  }
}

/// Shows the left ventricle, which drives the body; else the first cavity.
void PlayPage::syncIndices() {
  const auto& lines = volumes_.lines();
  std::size_t best = lines.size();
  for (std::size_t line = 0; line < lines.size(); ++line)
    if (lines[line].cavity && lines[line].side == 0 &&
        (best == lines.size() || anatomy::partNamed(lines[line].label) == anatomy::kLeftVentricle))
      best = line;
  const auto indices = best < lines.size() ? volumes_.indices(best) : std::nullopt;
  syncPatientCirculation();
  for (QLabel* fact : {fraction_, stroke_, output_})
    setFactShown(fact, playback_.sequence() && best < lines.size());
  const auto said = [estimate = best < lines.size() && volumes_.isEstimate(best)](const QString& number) {
    return estimate ? tr("%1 (estimate)").arg(number) : number;
  };
  fraction_->setText(indices ? said(tr("%1 %").arg(formatNumber(kPercent * indices->ejectionFraction, 1)))
                             : nothing());
  stroke_->setText(indices ? said(tr("%1 ml").arg(formatNumber(indices->strokeVolumeMl, 1))) : nothing());
  output_->setText(indices ? said(tr("%1 l/min").arg(formatNumber(indices->cardiacOutputLPerMinute, 1)))
                           : nothing());
  QStringList normal;
  QStringList sources;
  if (best < lines.size())
    for (const heart::NormalRange& range : volumes_.normals(best, view_.state().person)) {
      const bool percent = range.quantity == heart::NormalRange::Quantity::ejectionPercent;
      normal.push_back(tr("%1 %2\u2013%3 %4")
                           .arg(inWords(range.name))
                           .arg(formatNumber(range.low, 0))
                           .arg(formatNumber(range.high, 0))
                           .arg(percent ? tr("%") : tr("ml")));
      sources.push_back(tr("%1: %2; %3")
                            .arg(inWords(range.name),
                                 QStringLiteral("%1; %2").arg(inWords(range.meaning), inWords(range.people)),
                                 inWords(range.source)));
    }
  normal_->setText(normal.isEmpty() ? QString()
                                    : tr("Normal for %1: %2.").arg(lines[best].name, normal.join(tr(", "))));
  normal_->setToolTip(sources.join(QLatin1Char('\n')));
  normal_->setVisible(!normal.isEmpty());
}

} // namespace viscera::app
