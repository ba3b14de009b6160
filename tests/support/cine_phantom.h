#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "shapes.h"
#include "viscera/geometry/volume.h"
#include "viscera/tracking/cine_fit.h"
#include "viscera/tracking/surface_distance.h"

/// A beating shell of muscle around blood whose motion is known in full, as the images of a cine study.
namespace viscera::tests {

/// Defects of the images.
struct CineFaults {
  double noise = 10;    ///< Deviation of grey values; blood has 300 and muscle 100.
  double breathMm = 3;  ///< How far each plane's content lies aside, in its plane.
  bool longAxis = true; ///< Whether there are long-axis planes.
};

class CinePhantom {
public:
  static constexpr std::size_t kPhases = 10, kSystole = 4;
  static constexpr double kOuterMm = 40, kCavityMm = 25, kTwist = 0.25;

  /// Ejection is fast in its middle, and filling has a plateau: neither straight nor a cosine.
  static double squeeze(std::size_t phase) {
    static constexpr double kSqueeze[kPhases] = {0, 0.08, 0.4, 0.88, 1, 0.72, 0.38, 0.3, 0.27, 0.15};
    return kSqueeze[phase];
  }
  /// What is neither at the end of diastole nor of systole: the whole moves aside, mm.
  static Vec3 sway(std::size_t phase) {
    const double part = phase < kSystole ? static_cast<double>(phase) / kSystole
                                         : static_cast<double>(phase - kSystole) / (kPhases - kSystole);
    return std::sin(std::numbers::pi * part) * Vec3(1.5, -1, 2);
  }

  /// Where tissue is in a phase that is at `rest` in the first.
  static Vec3 at(const Vec3& rest, std::size_t phase) {
    const auto [across, along] = scales(rest.norm(), squeeze(phase));
    return turned(Vec3(across * rest[0], across * rest[1], along * rest[2]), turn(rest[2], phase)) +
           sway(phase);
  }
  /// The other way.
  static Vec3 restOf(const Vec3& point, std::size_t phase) {
    const Vec3 place = point - sway(phase);
    Vec3 rest = place;
    for (int round = 0; round < 20; ++round) {
      const auto [across, along] = scales(rest.norm(), squeeze(phase));
      rest = Vec3(place[0] / across, place[1] / across, place[2] / along);
    }
    return turned(rest, -turn(rest[2], phase));
  }

  /// "outer" (0) or "cavity" (1) in a phase.
  static geometry::TriangleMesh surface(std::size_t which, std::size_t phase) {
    geometry::TriangleMesh mesh = sphere(3, which == 0 ? kOuterMm : kCavityMm);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
      mesh.points.row(v) = at(mesh.points.row(v).transpose(), phase).transpose();
    return mesh;
  }
  static double volumeMl(std::size_t which, std::size_t phase) {
    const geometry::TriangleMesh mesh = surface(which, phase);
    return geometry::volume(mesh.points, mesh.triangles) / kMm3PerMl;
  }

  static tracking::LabelledPhase labelled(std::size_t phase) {
    tracking::LabelledPhase label;
    label.phase = phase;
    label.targets.volumesMl.resize(2);
    for (std::size_t which = 0; which < 2; ++which) {
      label.targets.distances.push_back(std::make_shared<const tracking::MeshDistance>(
          std::make_shared<const geometry::TriangleMesh>(surface(which, phase))));
      label.targets.volumesMl[static_cast<Eigen::Index>(which)] = volumeMl(which, phase);
    }
    return label;
  }

  static tracking::MotionRig rig() {
    const std::vector<geometry::TriangleMesh> rest = {surface(0, 0), surface(1, 0)};
    const Points handles = tracking::placeMotionHandles(rest, 0, {.handles = 60}).rest;
    Progress progress;
    return tracking::MotionRig(rest, handles, 3, tracking::softnessFor(handles, 8, 1.5), progress);
  }

  /// Four short-axis slices 16 mm apart, and three long-axis ones.
  static std::vector<tracking::CinePlane> planes(const CineFaults& faults = {}) {
    std::vector<tracking::CinePlane> planes;
    std::mt19937 random(3);
    for (int slice = 0; slice < 4; ++slice)
      planes.push_back(plane("short " + std::to_string(slice + 1), Vec3(0, 0, 16 * slice - 24), Vec3::UnitX(),
                             Vec3::UnitY(), faults, random));
    for (int view = 0; view < 3 && faults.longAxis; ++view) {
      const double turn = std::numbers::pi / 3 * view;
      planes.push_back(plane("long " + std::to_string(view + 1), Vec3::Zero(),
                             Vec3(std::cos(turn), std::sin(turn), 0), Vec3::UnitZ(), faults, random));
    }
    return planes;
  }

private:
  static constexpr int kPixels = 64;
  static constexpr double kPixelMm = 1.6;

  struct Scales {
    double across, along;
  };
  /// The cavity's wall becomes much narrower, the outside hardly, what is around them not.
  static Scales scales(double radius, double squeeze) {
    const double wall = std::clamp((radius - kCavityMm) / (kOuterMm - kCavityMm), 0.0, 1.0);
    const double around = std::clamp((70 - radius) / (70 - kOuterMm), 0.0, 1.0);
    return {1 - around * squeeze * (0.3 - 0.24 * wall), 1 - around * squeeze * (0.1 - 0.02 * wall)};
  }
  static double turn(double height, std::size_t phase) {
    return kTwist * squeeze(phase) * std::clamp(height / kOuterMm, -1.0, 1.0);
  }
  static Vec3 turned(const Vec3& place, double angle) {
    return {std::cos(angle) * place[0] - std::sin(angle) * place[1],
            std::sin(angle) * place[0] + std::cos(angle) * place[1], place[2]};
  }
  /// Waves that are fixed to the tissue.
  static double texture(const Vec3& rest) {
    return std::sin(0.45 * rest[0] + 0.2 * rest[1]) + std::sin(0.4 * rest[1] - 0.3 * rest[2] + 1) +
           std::sin(0.5 * rest[2] + 0.25 * rest[0] + 2);
  }
  /// Grey values change over half a pixel at a wall.
  static double grey(const Vec3& rest) {
    const double radius = rest.norm();
    const auto step = [&](double wall) { return 1 / (1 + std::exp((wall - radius) / 0.5)); };
    return 300 - 200 * step(kCavityMm) + 100 * step(kOuterMm) + 15 * texture(rest);
  }
  static tracking::CinePlane plane(const std::string& name, const Vec3& middle, const Vec3& alongRow,
                                   const Vec3& alongColumn, const CineFaults& faults, std::mt19937& random) {
    tracking::CinePlane plane{name, middle, alongRow, alongColumn, {kPixelMm, kPixelMm}, {}, {}};
    plane.origin -= 0.5 * (kPixels - 1) * kPixelMm * (alongRow + alongColumn);
    std::uniform_real_distribution<double> any(0, 2 * std::numbers::pi);
    std::normal_distribution<double> noise(0, faults.noise);
    const double way = any(random);
    const Vec3 breath = faults.breathMm * (std::cos(way) * alongRow + std::sin(way) * alongColumn);
    for (std::size_t phase = 0; phase < kPhases; ++phase) {
      tracking::CineImage& image = plane.images.emplace_back(kPixels, kPixels);
      plane.fractions.push_back(static_cast<double>(phase) / kPhases);
      for (int row = 0; row < kPixels; ++row)
        for (int column = 0; column < kPixels; ++column) {
          const Vec3 place = plane.origin + kPixelMm * (column * alongRow + row * alongColumn) - breath;
          image(row, column) = static_cast<float>(grey(restOf(place, phase)) + noise(random));
        }
    }
    return plane;
  }
};

} // namespace viscera::tests
