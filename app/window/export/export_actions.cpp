#include "window/export/export_actions.h"

#include <QFileDialog>
#include <QFileInfo>

#include <map>

#include "viscera/deformation/inverse_displacements.h"
#include "viscera/document/tables.h"
#include "viscera/medical_io/displacement_file.h"
#include "viscera/medical_io/surface_file.h"
#include "window/work/actions.h"
#include "window/work/settings.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr int kCellsAlongDiagonal = 60;

} // namespace

ExportActions::ExportActions(Workspace& workspace, Settings& settings, QWidget* window)
    : QObject(window), workspace_(workspace), settings_(settings), window_(window) {}

void ExportActions::addTo(Actions& actions) {
  actions.add("export.organs",
              {tr("Export all &organs..."),
               "export",
               {},
               tr("Write all visible organs into one file, with names and colours")},
              [this] {
                choose(tr("Export all organs"), tr("organs.glb"),
                       tr("glTF scenes (*.glb);;3MF models for printing (*.3mf)"),
                       &ExportActions::exportOrgans);
              });
  actions.add("export.displacements",
              {tr("Export &displacements..."),
               "export",
               {},
               tr("Write the current organ at rest, with the displacement of every vertex")},
              [this] {
                choose(tr("Export displacements"), tr("displacements.vtp"), tr("VTK surfaces (*.vtp)"),
                       &ExportActions::exportDisplacements);
              });
  actions.add("export.transform",
              {tr("Export displacement &field..."),
               "export",
               {},
               tr("Write the displacement of the space around the current organ, for 3D Slicer and ITK")},
              [this] {
                choose(tr("Export displacement field"), tr("field.nrrd"),
                       tr("Displacement fields (*.nrrd *.mha)"), &ExportActions::exportTransform);
              });
  actions.add("export.table",
              {tr("Export &table of volumes..."), "chart", {}, tr("Write volumes and sizes of all organs")},
              [this] {
                choose(tr("Export table of volumes"), tr("volumes.csv"), tr("Comma-separated values (*.csv)"),
                       &ExportActions::exportTable);
              });
  actions.add("export.measurements",
              {tr("Export &measurements..."), "export", {}, tr("Write all measured distances and angles")},
              [this] {
                if (workspace_.document().measurements().empty())
                  return workspace_.note(
                      tr("Nothing is measured yet. Measure a distance (D) or an angle (A) first."), 6);
                choose(tr("Export measurements"), tr("measurements.csv"),
                       tr("Comma-separated values (*.csv)"), &ExportActions::exportMeasurements);
              });
}

void ExportActions::choose(const QString& title, const QString& name, const QString& filter,
                           void (ExportActions::*exporting)(const QString&)) {
  if (workspace_.document().organs().empty())
    return workspace_.note(tr("There is no organ to export. Open one first."), 6);
  const QString folder = settings_.folder(kFolderKey, QStandardPaths::DocumentsLocation);
  const QString file = QFileDialog::getSaveFileName(window_, title, folder + QLatin1Char('/') + name, filter);
  if (!file.isEmpty())
    (this->*exporting)(file);
}

void ExportActions::write(const QString& what, const QString& file, std::function<QString(Progress&)> work) {
  workspace_.inBackground<QString>(tr("Exporting %1").arg(what), Workspace::slotOf(file), std::move(work),
                                   [this, file](const QString& remark) {
                                     settings_.setValue(kFolderKey, QFileInfo(file).absolutePath());
                                     const QString said = tr("Written to %1.").arg(file);
                                     workspace_.note(remark.isEmpty() ? said
                                                                      : said + QLatin1Char(' ') + remark);
                                   });
}

void ExportActions::exportOrgans(const QString& file) {
  std::vector<medical_io::NamedSurface> surfaces;
  std::map<document::OrganId, int> places;
  for (const auto& organ : workspace_.document().organs()) {
    if (!organ->look.visible)
      continue;
    auto mesh = std::make_shared<geometry::TriangleMesh>(*organ->mesh);
    mesh->points = workspace_.live().points(organ->id);
    if (!organ->look.vertexColors)
      mesh->colors.resize(0, 3);
    const auto outer = places.find(organ->parent);
    places[organ->id] = static_cast<int>(surfaces.size());
    surfaces.push_back({std::move(mesh), organ->name, organ->look.color, organ->look.opacity,
                        outer == places.end() ? -1 : outer->second});
  }
  write(tr("all organs"), file, [surfaces = std::move(surfaces), path = file.toStdString()](Progress&) {
    medical_io::writeSurfaces(path, surfaces);
    return QString();
  });
}

void ExportActions::exportDisplacements(const QString& file) {
  const auto organ = workspace_.currentOrgan();
  if (!organ)
    return;
  write(text(organ->name), file,
        [organ, path = file.toStdString(), moved = workspace_.live().points(organ->id)](Progress&) {
          medical_io::writeDisplacements(path, *organ->mesh, moved, organ->name);
          return QString();
        });
}

void ExportActions::exportTransform(const QString& file) {
  const auto organ = workspace_.currentOrgan();
  const document::Document& document = workspace_.document();
  if (!organ || !workspace_.guarded([&] { workspace_.registry().find(document.system().id); }))
    return;
  const double spacing = boundsOf(organ->mesh->points).diagonal() / kCellsAlongDiagonal;
  const deformation::GridOptions grid =
      deformation::gridAround(organ->mesh->points, workspace_.live().points(organ->id), spacing);
  write(text(organ->name), file,
        [system = workspace_.registry().find(document.system().id),
         options = coordinates::BindOptions{document.system().parameters, {}},
         handles = document::handleSet(document.rig()), pose = workspace_.live().shownPose(), grid,
         path = file.toStdString()](Progress& progress) {
          const deformation::DisplacementGrid field =
              deformation::inverseDisplacements(*system, handles, pose, options, grid, progress);
          medical_io::writeTransform(path, field);
          return field.unreached == 0 ? QString()
                                      : tr("The rest position of %n points of the field is uncertain.",
                                           nullptr, static_cast<int>(field.unreached));
        });
}

void ExportActions::exportTable(const QString& file) {
  std::vector<document::PosedOrgan> organs;
  for (const auto& organ : workspace_.document().organs())
    organs.push_back({organ, workspace_.live().points(organ->id)});
  write(tr("table of volumes"), file, [organs = std::move(organs), path = file.toStdString()](Progress&) {
    document::writeOrganTable(path, organs);
    return QString();
  });
}

void ExportActions::exportMeasurements(const QString& file) {
  auto rows = document::measurementRows(
      workspace_.state(),
      [this](document::OrganId organ) -> const Points& { return workspace_.live().points(organ); },
      live::tissueMotionOf(workspace_.warp()));
  write(tr("measurements"), file, [rows = std::move(rows), path = file.toStdString()](Progress&) {
    document::writeMeasurementTable(path, rows);
    return QString();
  });
}

} // namespace viscera::app
