#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/coordinates/measure/scene.h"

/// Measures the properties of coordinate systems (identity, positivity, smoothness and others), in the same
/// way for each (thesis, tables 4.1 and 4.2, which list them without numbers).
namespace viscera::coordinates {

/// The measured properties of one coordinate system on one scene. If `refusal` is not empty, the other
/// members are not set.
struct SceneProperties {
  std::string scene;
  Eigen::Index handles = 0;
  Eigen::Index points = 0;
  std::string refusal;            ///< Why the system does not take these handles; else empty.
  double identityError = 0;       ///< max |sum a_i v_i - p|, as a part of the diagonal of the handles' box.
  double unityError = 0;          ///< max |sum a_i - 1|.
  double minWeight = 0;           ///< The smallest coordinate.
  Eigen::Index failures = 0;      ///< Points without coordinates.
  std::optional<double> jump;     ///< The largest, of a coordinate; only along lines.
  std::optional<int> kinks;       ///< Only along lines without a jump.
  double largestKink = 0;         ///< 1/mm.
  std::optional<int> maxima;      ///< The most that one coordinate has; only along lines.
  double rotationChange = 0;      ///< The largest change of a coordinate when everything is turned.
  double handleError = 0;         ///< max |a_j(v_i) - [i = j]| at the handles themselves.
  Eigen::Index handleGaps = 0;    ///< Handles at which, and right beside which, there are no coordinates.
  double nanoseconds = 0;         ///< Of one thread, per point and handle, with all preparations.
  std::vector<std::string> notes; ///< The binding's own.
};

/// The measured properties of one coordinate system on all scenes, and the worst of each.
struct SystemProperties {
  std::string id;
  std::string name;
  std::vector<SceneProperties> scenes;

  /// The worst of scenes that were not refused. Jump, kinks and maxima are empty when no line was measured.
  SceneProperties worst() const;
  Eigen::Index refusals() const;
};

/// A handle is interpolated when its coordinates differ by less than this from 1 and 0.
inline constexpr double kInterpolated = 1e-4;

/// Measures one system on one scene. The text of any exception of the system becomes `refusal`; only
/// `Cancelled` is rethrown. About fifteen bindings. Everything but `nanoseconds` is the same in every run and
/// for any number of threads.
SceneProperties measureOn(const CoordinateSystem& system, const Scene& scene, const BindOptions& options,
                          Progress& progress);

/// A system with the parameters it is measured with.
struct SystemVariant {
  std::shared_ptr<const CoordinateSystem> system;
  ParameterValues parameters;
};

/// Measures every system on every scene, several at a time on `threads`, each with one thread; systems that
/// need tetrahedra, which take seconds to prepare, only on the first line and on scenes without a line. In
/// the order of `variants` and `scenes`. Throws `Cancelled`.
std::vector<SystemProperties> measureSystems(const std::vector<SystemVariant>& variants,
                                             const std::vector<Scene>& scenes, Threads threads,
                                             const Tetrahedraliser& tetrahedralise, Progress& progress);

} // namespace viscera::coordinates
