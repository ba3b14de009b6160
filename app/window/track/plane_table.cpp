#include "window/track/plane_table.h"

#include <QHeaderView>

#include <algorithm>

#include "viscera/live/cine_reading.h"
#include "window/style/language.h"

namespace viscera::app {
namespace {

enum PlaneColumn {
  kPlaneName,
  kPlaneNow,
  kPlaneWeight,
  kPlaneLikeness,
  kPlaneArrives,
  kPlaneApart,
  kPlaneReason,
  kPlaneColumns
};
constexpr int kPlaneRowHeight = 20;

} // namespace

PlaneTable::PlaneTable(MeasuredMotion& measured, QWidget* parent)
    : QTableWidget(0, kPlaneColumns, parent), measured_(measured), theme_(themeOf(ThemeKind::dark)) {
  setObjectName(QStringLiteral("cinePlanes"));
  setAccessibleName(tr("Planes of the images"));
  setHorizontalHeaderLabels({tr("Plane"), tr("in this phase"), tr("weight %"), tr("likeness %"),
                             tr("arrives mm"), tr("apart mm"), tr("over the beat")});
  const QStringList tips = {tr("Series or slice, and what it shows of the heart"),
                            tr("What the plane says of the phase that is shown"),
                            tr("Mean weight of its contours over the beat"),
                            tr("How alike its images are around the wall, over the beat"),
                            tr("How far its tissue arrives from the next labelled surface"),
                            tr("Distance of its tissue from the surfaces"),
                            tr("Why the plane says little")};
  for (int i = 0; i < kPlaneColumns; ++i)
    horizontalHeaderItem(i)->setToolTip(tips[i]);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  horizontalHeader()->setHighlightSections(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(kPlaneRowHeight);
  setShowGrid(false);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  setMinimumHeight(3 * kPlaneRowHeight);
}

void PlaneTable::setTheme(const Theme& theme) {
  theme_ = theme;
  fill();
}

void PlaneTable::fill() {
  const live::CineMotion* found = measured_.images();
  setRowCount(found ? static_cast<int>(found->planes.size()) : 0);
  const std::size_t phase = measured_.phaseNow();
  for (int row = 0; row < rowCount(); ++row)
    fillRow(row, found->planes[static_cast<std::size_t>(row)], phase);
}

void PlaneTable::fillRow(int row, const live::CinePlaneUse& plane, std::size_t phase) {
  const auto here = live::lightOf(plane.states[phase]);
  const QStringList cells = {inWords(plane.source.name.capitalised()),
                             inWords(live::wordsOf(plane, phase)),
                             formatNumber(kPercent * plane.weight, 0),
                             formatNumber(kPercent * plane.likeness, 0),
                             formatNumber(plane.closureMm, 1),
                             formatNumber(plane.apartMm, 2),
                             plane.reason.empty() ? tr("good") : inWords(plane.reason)};
  for (int column = 0; column < kPlaneColumns; ++column) {
    const auto light = column == kPlaneNow ? here : plane.light;
    const bool good = light == tracking::FitLight::good;
    // A sign beside the colour, for colour-blind users.
    const bool marked = !good && (column == kPlaneNow || column == kPlaneReason);
    auto* item = new QTableWidgetItem(marked ? QStringLiteral("! ") + cells[column] : cells[column]);
    const bool number = column != kPlaneName && column != kPlaneNow && column != kPlaneReason;
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    item->setForeground(good                               ? theme_.text
                        : light == tracking::FitLight::red ? theme_.error
                                                           : theme_.warning);
    item->setToolTip(plane.reason.empty() ? QString() : asSentence(plane.reason));
    setItem(row, column, item);
  }
}

SliceVerdict planeVerdict(const MeasuredMotion& measured, const Playback& playback, std::size_t slice) {
  const live::CineMotion* found = measured.images();
  if (!found || !measured.isOfStudy() || !playback.showing())
    return {};
  const auto plane = live::planeOfSlice(*found, slice);
  if (!plane)
    return {MeasuredMotion::tr("Not used for the motion"), tracking::FitLight::good};
  const live::CinePlaneUse& use = found->planes[*plane];
  const std::size_t phase = measured.phaseNow();
  const QString words = inWords(live::wordsOf(use, phase).capitalised());
  const bool estimate = found->estimate && !measured.isLabelled(phase);
  const auto light = live::lightOf(use.states[phase]);
  return {estimate ? MeasuredMotion::tr("Estimate: %1").arg(words) : words,
          estimate && light == tracking::FitLight::good ? tracking::FitLight::amber : light};
}

} // namespace viscera::app
