#include "viscera/document/organ_table.h"

#include <iomanip>
#include <locale>
#include <ostream>

#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"
#include "viscera/geometry/volume.h"

namespace viscera::document {
namespace {

constexpr double kMm2PerCm2 = 100;

void writeRow(std::ostream& out, const PosedOrgan& posed) {
  const Organ& organ = *posed.organ;
  const Triangles& triangles = organ.mesh->triangles;
  out << csvField(organ.name) << ',' << posed.points.rows() << ',' << triangles.rows() << ','
      << (organ.closed() ? "yes" : "no") << ',';
  if (organ.closed()) {
    const double rest = organ.restVolumeMm3 / kMm3PerMl;
    const double now = geometry::volume(posed.points, triangles) / kMm3PerMl;
    out << rest << ',' << now << ',' << now - rest << ',' << 100 * (now - rest) / rest << ',';
  } else {
    out << ",,,,";
  }
  const Bounds box = boundsOf(posed.points);
  const Vec3 size = box.high - box.low;
  out << geometry::area(posed.points, triangles) / kMm2PerCm2 << ',' << size.x() << ',' << size.y() << ','
      << size.z() << ',' << (posed.points - organ.mesh->points).rowwise().norm().maxCoeff() << '\n';
}

} // namespace

void writeOrganTable(const std::filesystem::path& file, const std::vector<PosedOrgan>& organs) {
  writeAtomically(file, [&](std::ostream& out) {
    out.imbue(std::locale::classic());
    out << "name,vertices,triangles,closed,rest_ml,volume_ml,change_ml,change_percent,area_cm2,size_x_mm,"
           "size_y_mm,size_z_mm,largest_displacement_mm\n"
        << std::fixed << std::setprecision(6);
    for (const PosedOrgan& organ : organs)
      writeRow(out, organ);
  });
}

} // namespace viscera::document
