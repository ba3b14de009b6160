#include "window/stress/stress_export.h"

#include <QFileDialog>
#include <QFileInfo>

#include "viscera/live/stress_files.h"
#include "viscera/live/stress_mark_files.h"
#include "window/work/actions.h"
#include "window/work/settings.h"

namespace viscera::app {
namespace {

constexpr const char* kMapActions[] = {"stress.exportMap", "stress.exportPoints"};

} // namespace

StressExport::StressExport(Workspace& workspace, Playback& playback, StressModel& model, Settings& settings,
                           QWidget* window)
    : QObject(window), workspace_(workspace), playback_(playback), model_(model), settings_(settings),
      window_(window) {}

void StressExport::addTo(Actions& actions) {
  const auto add = [&](const char* id, const QString& text, const QString& tip, const QString& title,
                       const QString& name, const QString& filter,
                       void (StressExport::*exporting)(const QString&)) {
    actions.add(id, {text, "export", {}, tip}, [=, this] { choose(title, name, filter, exporting); });
  };
  const QString tables = tr("Comma-separated values (*.csv)");
  add("stress.exportMap", tr("Export stress &map..."),
      tr("Write all quantities at all points inside the organ, for ParaView"), tr("Export stress map"),
      tr("stress.vtu"), tr("VTK solids (*.vtu)"), &StressExport::exportMap);
  add("stress.exportPoints", tr("Export stress at the &points..."),
      tr("Write the values at the witness points as a table"), tr("Export stress at the points"),
      tr("stress.csv"), tables, &StressExport::exportPoints);
  add("stress.exportHistogram", tr("Export &histogram..."),
      tr("Write the distribution of the shown quantity over the witness points"), tr("Export histogram"),
      tr("histogram.csv"), tables, &StressExport::exportHistogram);
  add("stress.exportCurve", tr("Export &curve over the sequence..."),
      tr("Write the rotational stress over one whole cycle of the sequence"), tr("Export curve"),
      tr("curve.csv"), tables, &StressExport::exportCurve);
  add("stress.exportProbes", tr("Export pro&bes..."),
      tr("Write place and values of the pinned probes as a table"), tr("Export probes"), tr("probes.csv"),
      tables, &StressExport::exportProbes);
  add("stress.exportProfiles", tr("Export prof&iles..."),
      tr("Write the values along the lines between probes as a table"), tr("Export profiles"),
      tr("profiles.csv"), tables, &StressExport::exportProfiles);
  const auto ready = [this] {
    return model_.active() && model_.live().status().state == live::StressStatus::State::ready;
  };
  actions.enableWhile({std::begin(kMapActions), std::end(kMapActions)}, ready);
  actions.enableWhile({"stress.exportHistogram"},
                      [this, ready] { return ready() && model_.look().measure().known(); });
  actions.enableWhile({"stress.exportCurve"}, [this, ready] { return ready() && model_.cycle(); });
  actions.enableWhile({"stress.exportProbes"}, [this, ready] { return ready() && model_.hasProbes(); });
  actions.enableWhile({"stress.exportProfiles"}, [this, ready] { return ready() && model_.hasProfiles(); });
  connect(&model_, &StressModel::statusChanged, &actions, &Actions::sync);
  connect(&model_, &StressModel::updated, &actions, &Actions::sync);
  connect(&model_, &StressModel::lookChanged, &actions, &Actions::sync);
  connect(&model_, &StressModel::activeChanged, &actions, &Actions::sync);
  connect(&playback_, &Playback::stateChanged, &actions, &Actions::sync);
}

void StressExport::choose(const QString& title, const QString& name, const QString& filter,
                          void (StressExport::*exporting)(const QString&)) {
  const QString folder = settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString file = QFileDialog::getSaveFileName(window_, title, folder + QLatin1Char('/') + name, filter);
  if (!file.isEmpty())
    (this->*exporting)(file);
}

void StressExport::write(const QString& what, const QString& file, std::function<void(Progress&)> work) {
  workspace_.inBackground<bool>(
      tr("Exporting %1").arg(what), Workspace::slotOf(file),
      [work = std::move(work)](Progress& progress) {
        work(progress);
        return true;
      },
      [this, file](bool) {
        settings_.setValue(kFolderKey, QFileInfo(file).absolutePath());
        workspace_.noteWritten(tr("Written to %1.").arg(QFileInfo(file).fileName()), file);
      });
}

void StressExport::exportMap(const QString& file) {
  write(tr("the stress map"), file,
        [mesh = model_.live().mesh(), posed = model_.live().points(), map = model_.shownMap(),
         material = model_.look().material, path = file.toStdString()](Progress&) {
          live::writeStressSolid(path, *mesh, posed, map, material);
        });
}

void StressExport::exportPoints(const QString& file) {
  write(tr("the stress"), file,
        [mesh = model_.live().mesh(), posed = model_.live().points(), map = model_.shownMap(),
         material = model_.look().material, path = file.toStdString()](Progress&) {
          live::writeStressTable(path, *mesh, posed, map, material);
        });
}

void StressExport::exportHistogram(const QString& file) {
  Values values;
  live::quantityOf(model_.shownMap(), model_.look().measure(), values);
  write(tr("the histogram"), file,
        [values, count = model_.live().mesh()->witnesses, measure = model_.look().measure(),
         path = file.toStdString()](Progress&) {
          live::writeStressHistogram(path, live::histogramOf(values, count, live::kHistogramBars), measure);
        });
}

void StressExport::exportCurve(const QString& file) {
  write(tr("the curve"), file, [cycle = model_.cycle(), path = file.toStdString()](Progress&) {
    live::writeStressCurve(path, cycle->samples);
  });
}

void StressExport::exportProbes(const QString& file) {
  std::vector<live::NamedReading> rows;
  for (const live::ReadProbe& read : model_.marks().probes)
    rows.push_back({std::to_string(read.probe.number), read.reading});
  write(tr("the probes"), file,
        [rows, material = model_.look().material, path = file.toStdString()](Progress&) {
          live::writeStressProbes(path, rows, material);
        });
}

void StressExport::exportProfiles(const QString& file) {
  std::vector<live::NamedProfile> rows;
  for (const live::ReadProfile& read : model_.marks().profiles)
    rows.push_back({read.name, read.profile});
  write(tr("the profiles"), file,
        [rows, material = model_.look().material, path = file.toStdString()](Progress&) {
          live::writeStressProfiles(path, rows, material);
        });
}

} // namespace viscera::app
