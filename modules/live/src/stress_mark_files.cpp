#include "viscera/live/stress_mark_files.h"

#include <ostream>

#include "tissue_columns.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/text.h"

namespace viscera::live {
namespace {

constexpr int kMarkDigits = 9;
constexpr const char* kColumns = "rest_x_mm,rest_y_mm,rest_z_mm,x_mm,y_mm,z_mm,RotationalStress_deg,"
                                 "VolumeRatio,StretchMax,StretchMin,Folded,stress_degrees,volume_ratio,"
                                 "stretch_max,stretch_min";

void writeCells(std::ostream& stream, const StressReading& reading,
                const elasticity::StatedMaterial& material) {
  for (const double value : reading.rest)
    stream << significant(value, kMarkDigits) << ',';
  const double values[] = {reading.now.x(),     reading.now.y(),    reading.now.z(),   reading.stressDegrees,
                           reading.volumeRatio, reading.stretchMax, reading.stretchMin};
  for (const double value : values)
    stream << (reading.inTissue ? significant(value, kMarkDigits) : std::string()) << ',';
  if (reading.inTissue)
    stream << (reading.folded ? 1 : 0);
  // Once more under the names that JSON and Python have.
  for (const double value :
       {reading.stressDegrees, reading.volumeRatio, reading.stretchMax, reading.stretchMin})
    stream << ',' << (reading.inTissue ? significant(value, kMarkDigits) : std::string());
  stream << tissueCells(valueOf(reading, {StressQuantity::vonMises, material}),
                        valueOf(reading, {StressQuantity::energy, material}), kMarkDigits, material)
         << '\n';
}

} // namespace

void writeStressProbes(const std::filesystem::path& file, const std::vector<NamedReading>& probes,
                       const elasticity::StatedMaterial& material) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "probe," << kColumns << tissueHead(material) << '\n';
    for (const NamedReading& probe : probes) {
      stream << csvField(probe.name) << ',';
      writeCells(stream, probe.reading, material);
    }
  });
}

void writeStressProfiles(const std::filesystem::path& file, const std::vector<NamedProfile>& profiles,
                         const elasticity::StatedMaterial& material) {
  writeAtomically(file, [&](std::ostream& stream) {
    stream << "profile,distance_mm," << kColumns << tissueHead(material) << '\n';
    for (const auto& [name, profile] : profiles)
      for (std::size_t i = 0; i < profile.mm.size(); ++i) {
        stream << csvField(name) << ',' << significant(profile.mm[i], kMarkDigits) << ',';
        writeCells(stream, profile.readings[i], material);
      }
  });
}

} // namespace viscera::live
