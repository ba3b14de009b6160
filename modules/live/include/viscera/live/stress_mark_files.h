#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/live/stress_reading.h"

/// Writes probes and profiles as tables for other programs; `viscera stress` and the window write the same
/// bytes. All are atomic and throw `CannotCreateError`. Where there is no tissue the cells after the place at
/// rest are empty.
namespace viscera::live {

/// The reading of a probe with the probe's name.
struct NamedReading {
  std::string name; ///< "1"
  StressReading reading;
};

/// Comma-separated values, a row a probe: `probe`, its place at rest and in the pose
/// (`rest_x_mm` ... `z_mm`), `RotationalStress_deg`, `VolumeRatio`, `StretchMax`, `StretchMin`, `Folded`.
/// A stated material adds `von_mises_kpa`, `strain_energy_kpa`, `material`.
void writeStressProbes(const std::filesystem::path& file, const std::vector<NamedReading>& probes,
                       const elasticity::StatedMaterial& material = {});

/// A profile under its name.
struct NamedProfile {
  std::string name; ///< "1-2"
  StressProfile profile;
};

/// Comma-separated values, a row a place, one profile after the other: `profile`, `distance_mm` from its
/// beginning at rest, and the columns of a probe.
void writeStressProfiles(const std::filesystem::path& file, const std::vector<NamedProfile>& profiles,
                         const elasticity::StatedMaterial& material = {});

} // namespace viscera::live
