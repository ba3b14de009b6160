#include "window/track/residual_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStackedLayout>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "viscera/anatomy/part.h"
#include "viscera/live/cine_reading.h"
#include "window/style/language.h"
#include "window/track/plane_table.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

enum ResidualColumn {
  kPhase,
  kSource,
  kPhaseTime,
  kMeanDistance,
  kP95Distance,
  kLargestDistance,
  kMeasuredVolume,
  kFreeVolume,
  kFittedVolume,
  kWallVolume,
  kDice,
  kFlippedTriangles,
  kFoldedTriangles,
  kFitSteps,
  kResidualColumns
};
constexpr int kPhaseRowHeight = 20;
constexpr int kShownPhases = 4;
constexpr int kAll = -1, kCompared = -2, kPlanes = -3;

enum DifferenceColumn { kComparedWhat, kComparedBefore, kComparedNow, kDifference, kDifferenceColumns };

/// One number of a cavity that two series are compared by.
struct Compared {
  const char* name;
  const char* unit;
  int digits;
  double scale;
  double heart::CardiacIndices::*value;
};
const Compared kCompareds[] = {{QT_TRANSLATE_NOOP("viscera::app::ResidualTable", "largest volume"), "ml", 1,
                                1, &heart::CardiacIndices::endDiastolicMl},
                               {QT_TRANSLATE_NOOP("viscera::app::ResidualTable", "smallest volume"), "ml", 1,
                                1, &heart::CardiacIndices::endSystolicMl},
                               {QT_TRANSLATE_NOOP("viscera::app::ResidualTable", "stroke volume"), "ml", 1, 1,
                                &heart::CardiacIndices::strokeVolumeMl},
                               {QT_TRANSLATE_NOOP("viscera::app::ResidualTable", "ejection fraction"), "%", 1,
                                kPercent, &heart::CardiacIndices::ejectionFraction},
                               {QT_TRANSLATE_NOOP("viscera::app::ResidualTable", "cardiac output"), "l/min",
                                2, 1, &heart::CardiacIndices::cardiacOutputLPerMinute}};

/// Sets the properties that both tables have in common.
void makePlain(QTableWidget& table) {
  // Narrower columns would cut headings and numbers; a scroll bar comes where they have no room.
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table.horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setMinimumSectionSize(kPhaseRowHeight);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(kPhaseRowHeight);
  table.setShowGrid(false);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setMinimumHeight(3 * kPhaseRowHeight);
}

} // namespace

ResidualTable::ResidualTable(MeasuredMotion& measured, Playback& playback, QWidget* parent)
    : QWidget(parent), measured_(measured), playback_(playback), surfaces_(new QComboBox(this)),
      summary_(new ElidedLabel(this)), stack_(new QStackedLayout),
      table_(new QTableWidget(0, kResidualColumns, this)),
      differences_(new QTableWidget(0, kDifferenceColumns, this)), planes_(new PlaneTable(measured, this)),
      theme_(themeOf(ThemeKind::dark)) {
  auto* column = makeLayout<QVBoxLayout>(this, 4, {0, 4, 0, 0});
  column->addWidget(makeHead());
  makeTable();
  stack_->addWidget(table_);
  stack_->addWidget(differences_);
  stack_->addWidget(planes_);
  column->addLayout(stack_, 1);
  connect(&measured, &MeasuredMotion::changed, this, &ResidualTable::rebuild);
  connect(&playback, &Playback::advanced, this, &ResidualTable::markPhase);
  connect(&playback, &Playback::stateChanged, this, &ResidualTable::markPhase);
  connect(surfaces_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ResidualTable::fill);
  rebuild();
}

QSize ResidualTable::sizeHint() const {
  return {QWidget::sizeHint().width(), (kShownPhases + 3) * kPhaseRowHeight};
}

QWidget* ResidualTable::makeHead() {
  auto* head = new QWidget(this);
  auto* row = makeLayout<QHBoxLayout>(head, 12);
  surfaces_->setObjectName(QStringLiteral("residualSurface"));
  surfaces_->setAccessibleName(tr("Surface whose fit is shown"));
  row->addWidget(surfaces_);
  auto* ghost = new QCheckBox(tr("Measured surface"), head);
  ghost->setObjectName(QStringLiteral("measuredGhost"));
  ghost->setChecked(measured_.ghostShown());
  connect(ghost, &QCheckBox::toggled, &measured_, &MeasuredMotion::setGhostShown);
  row->addWidget(ghost);
  auto* distances = new QCheckBox(tr("Distances"), head);
  distances->setObjectName(QStringLiteral("measuredDistances"));
  distances->setChecked(measured_.distancesShown());
  connect(distances, &QCheckBox::toggled, &measured_, &MeasuredMotion::setDistancesShown);
  row->addWidget(distances);
  // Glass over the colours would change them.
  connect(ghost, &QCheckBox::toggled, distances, [distances](bool on) {
    if (on)
      distances->setChecked(false);
  });
  connect(distances, &QCheckBox::toggled, ghost, [ghost](bool on) {
    if (on)
      ghost->setChecked(false);
  });
  ghost_ = ghost;
  distances_ = distances;
  summary_->setObjectName(QStringLiteral("muted"));
  row->addWidget(summary_, 1);
  return head;
}

void ResidualTable::makeTable() {
  table_->setObjectName(QStringLiteral("residuals"));
  table_->setAccessibleName(tr("Fit of the motion, phase by phase"));
  table_->setHorizontalHeaderLabels({tr("Phase"), tr("from"), tr("ms"), tr("mean mm"), tr("95 % mm"),
                                     tr("max mm"), tr("measured ml"), tr("unconstrained ml"), tr("fitted ml"),
                                     tr("wall ml"), tr("Dice"), tr("flipped"), tr("folded"), tr("steps")});
  const QStringList tips = {
      tr("A mark shows that the phase needs attention; the row's tooltip gives the reason"),
      tr("Whether the phase has labels, or was found in the images"),
      tr("Time of the phase"),
      tr("Distance of the fitted surface from the measured surface, weighted by area"),
      tr("95 % of the area lies within this distance"),
      tr("The largest distance"),
      tr("Volume that was measured"),
      tr("Volume of the fit before it is brought to the measured volume"),
      tr("Volume of the fit"),
      tr("Volume of the wall as a check: muscle hardly changes it. More than 10 % beyond the labelled phases "
         "needs attention"),
      tr("Dice coefficient of the voxels; 1 if all agree"),
      tr("Triangles that face the wrong way"),
      tr("Places in the tissue that are folded"),
      tr("Steps that the fit took")};
  for (int i = 0; i < kResidualColumns; ++i)
    table_->horizontalHeaderItem(i)->setToolTip(tips[i]);
  makePlain(*table_);
  makePlain(*differences_);
  differences_->setObjectName(QStringLiteral("seriesDifferences"));
  differences_->setAccessibleName(tr("Differences from the previous series"));
  differences_->setHorizontalHeaderLabels({QString(), tr("before"), tr("now"), tr("difference")});
  differences_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  connect(table_, &QTableWidget::cellClicked, this,
          [this](int row, int) { measured_.showPhase(static_cast<std::size_t>(row)); });
}

void ResidualTable::setTheme(const Theme& theme) {
  theme_ = theme;
  planes_->setTheme(theme);
  fill();
}

int ResidualTable::surface() const {
  return surfaces_->currentData().toInt();
}

void ResidualTable::rebuild() {
  {
    const QSignalBlocker quiet(surfaces_);
    surfaces_->clear();
    const MeasuredMotion::Found* found = measured_.present();
    const std::size_t count = found ? found->motion->sequence.organs.size() : 0;
    if (count > 1)
      surfaces_->addItem(tr("All surfaces"), kAll);
    for (std::size_t i = 0; i < count; ++i) {
      const QString name = text(found->motion->sequence.organs[i].name);
      surfaces_->addItem(shortenedName(name, *surfaces_), static_cast<int>(i));
      surfaces_->setItemData(surfaces_->count() - 1, name, Qt::ToolTipRole);
    }
    if (measured_.images())
      surfaces_->addItem(tr("Planes of the images"), kPlanes);
    if (found && measured_.before())
      surfaces_->addItem(tr("Compared with the previous series"), kCompared);
  }
  fill();
}

void ResidualTable::fill() {
  const MeasuredMotion::Found* found = measured_.present();
  syncSwitches();
  table_->setRowCount(found ? static_cast<int>(found->motion->phases.size()) : 0);
  summary_->setFullText({});
  if (!found)
    return;
  const live::PatientMotion& motion = *found->motion;
  fillDifferences();
  planesOf_ = measured_.phaseNow();
  planes_->fill();
  stack_->setCurrentWidget(surface() == kCompared ? static_cast<QWidget*>(differences_)
                           : surface() == kPlanes ? planes_
                                                  : table_);
  table_->setColumnHidden(kSource, !measured_.images());
  table_->setColumnHidden(kWallVolume, motion.tissueMl.empty());
  const bool one = surface() >= 0;
  for (const int column : {kMeasuredVolume, kFreeVolume, kFittedVolume, kFlippedTriangles})
    table_->setColumnHidden(column, !one);
  table_->setColumnHidden(kDice, !motion.phases.front().quality.dice);
  for (int row = 0; row < table_->rowCount(); ++row)
    fillRow(row, motion.phases[static_cast<std::size_t>(row)]);
  summary_->setFullText(summary().join(QStringLiteral("; ")));
  markPhase();
}

/// Ejection fractions and tissue in one line; an estimate begins with that word.
QStringList ResidualTable::summary() const {
  const live::PatientMotion& motion = *measured_.present()->motion;
  QStringList parts;
  if (measured_.isEstimate())
    parts.push_back(tr("Estimate from the labels of one phase"));
  for (const auto& [name, indices] : motion.indices)
    parts.push_back((measured_.isEstimate() ? tr("%1: about EF %2 %, %3 to %4 ml, %5 l/min")
                                            : tr("%1: EF %2 %, %3 to %4 ml, %5 l/min"))
                        .arg(text(name))
                        .arg(formatNumber(kPercent * indices.ejectionFraction, 1))
                        .arg(formatNumber(indices.endDiastolicMl, 1))
                        .arg(formatNumber(indices.endSystolicMl, 1))
                        .arg(formatNumber(indices.cardiacOutputLPerMinute, 1)));
  if (!motion.tissueMl.empty()) {
    const auto [low, high] = std::minmax_element(motion.tissueMl.begin(), motion.tissueMl.end());
    parts.push_back(tr("tissue %1 to %2 ml").arg(formatNumber(*low, 1)).arg(formatNumber(*high, 1)));
  }
  return parts;
}

/// "10 ES" at the labelled, or of an estimate the emptiest, end of systole.
QString ResidualTable::phaseName(std::size_t phase) const {
  const QString number = QString::number(phase + 1);
  const live::CineMotion* images = measured_.images();
  if (!images)
    return number;
  if (phase == images->endDiastole)
    return tr("%1 ED").arg(number);
  return phase == (images->estimate ? images->emptiest : images->endSystole) ? tr("%1 ES").arg(number)
                                                                             : number;
}

/// A right ventricle has a volume only where a label tells it.
QString ResidualTable::volume(std::size_t phase, double ml) const {
  if (!measured_.isEstimate() || measured_.isLabelled(phase))
    return formatNumber(ml, 1);
  const bool right =
      surface() >= 0 &&
      anatomy::chamberKey(measured_.present()->series->names[static_cast<std::size_t>(surface())]) == "rv";
  return right ? QString::fromUtf8("\u2013") : QString::fromUtf8("\u2248 ") + formatNumber(ml, 1);
}

QStringList ResidualTable::reasonsOf(std::size_t phase) const {
  const live::PatientMotion& motion = *measured_.present()->motion;
  QStringList reasons;
  if (measured_.isEstimate() && !measured_.isLabelled(phase))
    reasons.push_back(tr("An estimate: this phase has no labels, and only one has some."));
  for (const Text& reason : motion.phases[phase].verdict.reasons)
    reasons.push_back(asSentence(reason));
  if (const auto wall = live::wallAt(motion, measured_.images(), phase); wall && !wall->reason.empty())
    if (const QString reason = asSentence(wall->reason); !reasons.contains(reason))
      reasons.push_back(reason);
  return reasons;
}

/// A session has the numbers, and not the surfaces.
void ResidualTable::syncSwitches() {
  const QString tip = tr("A session does not keep the measured surfaces. To see them, find the motion again: "
                         "Sequence > Motion from a series");
  const bool known = measured_.surfacesKnown();
  ghost_->setEnabled(known);
  ghost_->setToolTip(known ? tr("Show the measured surfaces of the nearest phase, translucent") : tip);
  distances_->setEnabled(known);
  distances_->setToolTip(
      known ? tr("Colour the organs by their distance from the measured surfaces of the nearest phase")
            : tip);
}

void ResidualTable::fillRow(int row, const live::TrackedPhase& phase) {
  const tracking::PhaseQuality& all = phase.quality;
  tracking::SurfaceQuality own{all.meanMm, all.p95Mm, all.maxMm, 0, 0, 0, all.dice, 0};
  if (surface() >= 0)
    own = all.surfaces[static_cast<std::size_t>(surface())];
  const auto number = [](double value, int digits) { return formatNumber(value, digits); };
  const auto index = static_cast<std::size_t>(row);
  const auto wall = live::wallAt(*measured_.present()->motion, measured_.images(), index);
  const auto light = std::max(phase.verdict.light, wall ? wall->light : tracking::FitLight::good);
  const bool good = light == tracking::FitLight::good;
  const bool red = light == tracking::FitLight::red;
  // A sign beside the colour, for colour-blind users.
  const QString sign = good ? QString() : red ? QString::fromUtf8(" \u2715") : QStringLiteral(" !");
  const QStringList cells = {phaseName(index) + sign,
                             measured_.isLabelled(index) ? tr("labels") : tr("images"),
                             number(kMsPerSecond * phase.seconds, 0),
                             number(own.meanMm, 2),
                             number(own.p95Mm, 2),
                             number(own.maxMm, 1),
                             volume(index, own.measuredMl),
                             volume(index, own.freeMl),
                             volume(index, own.fittedMl),
                             wall ? number(wall->ml, 1) : QString(),
                             own.dice ? number(*own.dice, 3) : QString(),
                             QString::number(own.flipped),
                             QString::number(all.folded),
                             QString::number(all.steps)};
  const QStringList reasons = reasonsOf(index);
  for (int column = 0; column < kResidualColumns; ++column) {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setForeground(good ? theme_.text : red ? theme_.error : theme_.warning);
    item->setToolTip(reasons.join(QLatin1Char('\n')));
    table_->setItem(row, column, item);
  }
}

/// Cavity by cavity what the two series have; a cavity that only one of them has is left out.
void ResidualTable::fillDifferences() {
  differences_->setRowCount(0);
  const MeasuredMotion::Found* before = measured_.before();
  if (!measured_.present() || !before)
    return;
  const auto& names = measured_.present()->series->names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto other = measured_.surfaceBefore(i);
    const auto now = measured_.present()->motion->indices.find(names[i]);
    const auto then =
        other ? before->motion->indices.find(before->series->names[*other]) : before->motion->indices.end();
    if (now == measured_.present()->motion->indices.end() || then == before->motion->indices.end())
      continue;
    for (const Compared& compared : kCompareds) {
      const double was = compared.scale * then->second.*compared.value;
      const double is = compared.scale * now->second.*compared.value;
      const auto number = [&](double value) { return formatNumber(value, compared.digits); };
      const QStringList cells = {
          tr("%1, %2 (%3)").arg(text(names[i]), tr(compared.name), QLatin1String(compared.unit)), number(was),
          number(is), (is >= was ? QStringLiteral("+") : QString()) + number(is - was)};
      const int row = differences_->rowCount();
      differences_->insertRow(row);
      for (int column = 0; column < kDifferenceColumns; ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setTextAlignment((column == kComparedWhat ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        item->setForeground(theme_.text);
        differences_->setItem(row, column, item);
      }
    }
  }
}

void ResidualTable::markPhase() {
  if (!isVisible() || !measured_.present())
    return;
  if (surface() == kPlanes && planesOf_ != measured_.phaseNow()) {
    planesOf_ = measured_.phaseNow();
    planes_->fill();
  }
  const int row = static_cast<int>(measured_.phaseNow());
  if (row == table_->currentRow() || row >= table_->rowCount())
    return;
  table_->selectRow(row);
  table_->scrollToItem(table_->item(row, kPhase));
}

} // namespace viscera::app
