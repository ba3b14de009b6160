#include "window/play/heart_numbers_box.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>
#include <optional>
#include <ostream>

#include "viscera/core/atomic_file.h"
#include "viscera/document/study_item.h"
#include "viscera/live/cine_reading.h"
#include "window/style/language.h"
#include "window/view/view_model.h"
#include "window/widgets/flow_layout.h"
#include "window/widgets/new_file.h"
#include "window/widgets/ready_made.h"
#include "window/work/settings.h"

namespace viscera::app {
namespace {

enum HeartNumberColumn { kNumberName, kNumberValue, kNumberPerM2, kNumberColumns };
constexpr int kNumberRowHeight = 20;
constexpr double kSameSurface = 0.006; ///< m2; a box rounds it to two decimals.

} // namespace

HeartNumbersBox::HeartNumbersBox(const ModeParts& parts, const MeasuredMotion& measured, QWidget* parent)
    : QWidget(parent), workspace_(parts.workspace), playback_(parts.playback), volumes_(parts.volumes),
      view_(parts.view), settings_(parts.settings), measured_(measured), ends_(makeRemark(QString(), this)),
      about_(makeRemark(QString(), this)), table_(new QTableWidget(0, kNumberColumns, this)) {
  auto* column = makeLayout<QVBoxLayout>(this, 4);
  column->addWidget(ends_);
  about_->setObjectName(QStringLiteral("heartNumbersAbout"));
  column->addWidget(about_);
  table_->setObjectName(QStringLiteral("heartNumbers"));
  table_->setAccessibleName(tr("Numbers of the measured heart"));
  table_->setHorizontalHeaderLabels({QString(), tr("value"), tr("per m\u00b2")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kNumberRowHeight);
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  column->addWidget(table_);
  column->addWidget(makeButtons());
  connect(&volumes_, &VolumeMonitor::updated, this, &HeartNumbersBox::syncIfNew);
  connect(&volumes_, &VolumeMonitor::linesChanged, this, &HeartNumbersBox::sync);
  connect(&view_, &ViewModel::changed, this, &HeartNumbersBox::syncIfNew);
  connect(&playback_, &Playback::stateChanged, this, &HeartNumbersBox::sync);
  connect(&measured, &MeasuredMotion::changed, this, &HeartNumbersBox::sync);
  connect(&measured, &MeasuredMotion::found, this, [this] { // Ends of another motion say nothing about it.
    view_.change([](presentation::ViewState& state) { state.cycleEnds = {}; });
  });
  sync();
}

QWidget* HeartNumbersBox::makeButtons() {
  auto* box = new QWidget(this);
  auto* row = makeLayout<QVBoxLayout>(box, 4);
  const auto add = [&](const QString& name, const QString& tip, auto clicked) {
    auto* button = new QPushButton(name, box);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, clicked);
    row->addWidget(button);
  };
  const auto choose = [this](std::optional<double> heart::ChosenEnds::*end) {
    const double here = playback_.player().fraction();
    view_.change([&](presentation::ViewState& state) { state.cycleEnds.*end = here; });
  };
  add(tr("End of diastole here"), tr("The present instant is the end of diastole (ED)"),
      [choose] { choose(&heart::ChosenEnds::diastole); });
  add(tr("End of systole here"), tr("The present instant is the end of systole (ES)"),
      [choose] { choose(&heart::ChosenEnds::systole); });
  add(tr("Find both ends"), tr("ED is where the volume is largest, ES where it is smallest"),
      [this] { view_.change([](presentation::ViewState& state) { state.cycleEnds = {}; }); });
  add(tr("Height and weight..."), tr("Body surface area by Mosteller, for numbers per square metre"),
      [this] { askForSize(); });
  add(tr("Save as CSV..."), tr("Write these numbers into a table"), [this] { chooseAndWriteCsv(); });
  return box;
}

HeartNumbersBox::Ventricles HeartNumbersBox::ventricles() const {
  Ventricles all;
  const presentation::ViewState& view = view_.state();
  for (std::size_t line = 0; line < volumes_.lines().size(); ++line) {
    const VolumeMonitor::Line& one = volumes_.lines()[line];
    if (one.side != 0 || !one.cavity || !measured_.surfaceOf(one.organ))
      continue;
    auto numbers = volumes_.numbers(line, view.cycleEnds, view.person.bodySurfaceM2);
    if (!numbers.empty()) // A table says at each number that it is an estimate.
      all.emplace_back(volumes_.isEstimate(line) ? tr("%1 (estimate)").arg(inWords(one.label)).toStdString()
                                                 : one.label,
                       std::move(numbers));
  }
  return all;
}

void HeartNumbersBox::syncIfNew() {
  const presentation::ViewState& view = view_.state();
  if (madeOf_ != volumes_.cycles() || !(madeWith_ == view.cycleEnds) || !(madeFor_ == view.person))
    sync();
}

void HeartNumbersBox::sync() {
  madeOf_ = volumes_.cycles();
  madeWith_ = view_.state().cycleEnds;
  madeFor_ = view_.state().person;
  Ventricles all;
  workspace_.guarded([&] { all = ventricles(); });
  setVisible(!all.empty());
  table_->setRowCount(0);
  for (const auto& [organ, numbers] : all)
    for (const heart::HeartNumber& number : numbers) {
      const int row = table_->rowCount();
      table_->insertRow(row);
      const QStringList cells = {tr("%1: %2").arg(inWords(organ), inWords(number.name)),
                                 formatNumber(number.value, number.digits) + QLatin1Char(' ') +
                                     text(number.unit),
                                 number.perM2 ? formatNumber(*number.perM2, number.digits) : QString()};
      for (int column = 0; column < kNumberColumns; ++column)
        table_->setItem(row, column, new QTableWidgetItem(cells[column]));
    }
  table_->setColumnHidden(kNumberPerM2, view_.state().person.bodySurfaceM2 <= 0);
  table_->setFixedHeight((table_->rowCount() + 2) * kNumberRowHeight);
  QStringList about;
  if (measured_.isEstimate())
    about.push_back(
        tr("Estimates: only one phase of the images has labels. Of a right ventricle there are no "
           "numbers then."));
  if (const QString person = personText(); !person.isEmpty())
    about.push_back(person);
  about_->setText(about.join(QLatin1Char('\n')));
  about_->setVisible(!about.isEmpty());
  const auto line = volumes_.measuredLine();
  const auto ends = line ? volumes_.ends(*line, view_.state().cycleEnds) : std::nullopt;
  if (ends)
    ends_->setText(tr("ED at %1 % of the cycle, ES at %2 %")
                       .arg(formatNumber(kPercent * ends->diastole, 0))
                       .arg(formatNumber(kPercent * ends->systole, 0)));
}

/// Where the body surface comes from, as long as it is that of the images.
QString HeartNumbersBox::personText() const {
  const auto& item = workspace_.state().study;
  const double surface = view_.state().person.bodySurfaceM2;
  const auto stated = item ? live::statedBodySurface(*item->study) : std::nullopt;
  if (!stated || std::abs(*stated - surface) > kSameSurface)
    return {};
  return tr("Body surface %1 m\u00b2 from the images: %2 cm, %3 kg")
      .arg(formatNumber(surface, 2))
      .arg(formatNumber(item->study->heightCm, 0))
      .arg(formatNumber(item->study->weightKg, 1));
}

void HeartNumbersBox::askForSize() {
  bool given = false;
  const double height =
      QInputDialog::getDouble(this, tr("Body surface"), tr("Height in cm"), 170, 30, 250, 0, &given);
  if (!given)
    return;
  const double weight =
      QInputDialog::getDouble(this, tr("Body surface"), tr("Weight in kg"), 70, 1, 400, 1, &given);
  if (!given)
    return;
  const double surface = heart::bodySurfaceM2(height, weight);
  if (surface < anatomy::kSmallestBodySurfaceM2 || surface > anatomy::kLargestBodySurfaceM2)
    return workspace_.note(tr("A body surface area of %1 m\u00b2 is not that of an adult: nothing is indexed")
                               .arg(formatNumber(surface, 2)));
  view_.change([surface](presentation::ViewState& state) { state.person.bodySurfaceM2 = surface; });
}

void HeartNumbersBox::chooseAndWriteCsv() {
  const QString file =
      asNewFile(this,
                QFileDialog::getSaveFileName(this, tr("Save the heart's numbers"),
                                             settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation),
                                             tr("Table (*.csv)")),
                {QStringLiteral(".csv")});
  if (!file.isEmpty())
    writeCsv(file);
}

void HeartNumbersBox::writeCsv(const QString& file) {
  const std::string csv = heart::heartNumbersCsv(ventricles());
  if (workspace_.guarded(
          [&] { writeAtomically(file.toStdString(), [&](std::ostream& out) { out << csv; }); }))
    workspace_.noteWritten(tr("The heart's numbers are in %1").arg(QFileInfo(file).fileName()), file);
}

} // namespace viscera::app
