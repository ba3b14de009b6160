#include "viscera/thesis/measured_scenes.h"

#include <sstream>

#include <QFile>

#include "viscera/core/error.h"
#include "viscera/deformation/group_handles.h"
#include "viscera/deformation/place_handles.h"

namespace viscera::thesis {
namespace {

constexpr double kHalfLine = 50; ///< mm
constexpr int kGroups = 3;

} // namespace

coordinates::Scene lineScene(int handles) {
  const QString name = QStringLiteral(":/viscera/lines/line_%1.fcsv").arg(handles, 2, 10, QLatin1Char('0'));
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly))
    throw UsageError("there is no such line", std::to_string(handles) + " handles");
  std::istringstream table(file.readAll().toStdString());
  coordinates::Scene scene;
  scene.name = "line, " + std::to_string(handles) + " handles";
  scene.handles = coordinates::handlesOfTable(table, name.toStdString());
  scene.line = coordinates::Line{Vec3(-kHalfLine, 0, 0), Vec3(kHalfLine, 0, 0)};
  return scene;
}

std::shared_ptr<const geometry::TriangleMesh>
outerSurface(const std::string& organ, const sample_organs::SampleLibrary& samples, Progress& progress) {
  const std::size_t at = organ.find('@');
  return sample_organs::sampleOrgan(samples, organ.substr(0, at),
                                    sample_organs::resolutionFromName(organ.substr(at + 1)), progress)
      .surfaces.front()
      .mesh;
}

coordinates::Scene organScene(const std::string& organ, int handles, int points,
                              const sample_organs::SampleLibrary& samples, Progress& progress) {
  const auto surface = outerSurface(organ + "@low", samples, progress);
  deformation::Placement placement;
  placement.count = handles;
  const Points placed = deformation::placeHandles(*surface, placement);
  const auto grouping = deformation::groupsAlongAxis(placed, surface->points, kGroups);
  coordinates::Scene scene;
  scene.name = organ;
  scene.handles.positions.resize(placed.rows() + grouping.added.rows(), 3);
  scene.handles.positions << placed, grouping.added;
  scene.handles.groups = grouping.groups;
  const Eigen::Index vertices = surface->points.rows(), taken = std::min<Eigen::Index>(points, vertices);
  scene.points.resize(taken, 3);
  for (Eigen::Index i = 0; i < taken; ++i)
    scene.points.row(i) = surface->points.row(i * vertices / taken);
  return scene;
}

} // namespace viscera::thesis
