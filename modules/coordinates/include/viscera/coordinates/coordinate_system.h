#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "viscera/coordinates/binding.h"
#include "viscera/coordinates/handle_set.h"
#include "viscera/coordinates/parameters.h"
#include "viscera/coordinates/pose_lift.h"
#include "viscera/coordinates/space_layout.h"
#include "viscera/coordinates/tetrahedraliser.h"
#include "viscera/core/progress.h"

namespace viscera::coordinates {

/// The properties of a coordinate system, such as positive or exact, that lists and badges show.
struct Traits {
  bool needsCage = false;          ///< Needs `HandleSet::cage`.
  bool needsTetrahedra = false;    ///< Needs `BindOptions::tetrahedralise`, and takes seconds to prepare.
  bool positive = false;           ///< No coordinate is ever negative.
  bool interpolates = false;       ///< A point at a handle follows it exactly.
  bool closedFormGradient = false; ///< `CoordinateGradients` without differences.
  bool usesGroups = false;         ///< Uses `HandleSet::groups`.
  bool rotationInvariant = true;   ///< Turning handles and points together changes nothing but rounding.
  bool everywhere = true;          ///< Finds coordinates at every point inside the hull (or the cage).
  bool continuous = true;          ///< No coordinate jumps.
  bool smooth = true;              ///< No derivative of a coordinate jumps, but at handles and on the cage.
  bool affine = true; ///< `p = sum a_i v_i` by the handles alone, so that any affine motion is followed.
};

/// The derivatives of the coordinates at points: `values` is `(points * handles) x 3`, row `p * handles + i`
/// holds the gradient of coordinate i at point p, 1/mm. Rows of points in `failures` are zero.
struct CoordinateGradients {
  Points values;
  std::vector<int> failures;
  bool closedForm = false; ///< False: central differences.
  /// Where a pose is lifted before it is summed, `values` has as many rows a point as a lifted pose.
  std::shared_ptr<const PoseLift> lift;
};

/// The options of a binding that are not geometry: parameter values, threads, and others.
struct BindOptions {
  ParameterValues parameters;
  Threads threads;
  /// The mesher for systems with the trait `needsTetrahedra`; empty: they throw a `UsageError`. The module
  /// `deformation` provides TetGen's.
  Tetrahedraliser tetrahedralise = {};
  /// Coordinates that would take more memory are kept in single precision by the systems that can (the
  /// point-based ones): half of it, and 1e-7 of the handles' size for the identity, which the report
  /// measures.
  std::size_t mostBytesInDoubles = std::size_t{512} << 20;
};

/// The interface of all coordinate systems: it binds points to handles, which means that it computes their
/// coordinates. Results depend on the arguments alone; every member may be called from several threads.
///
///     Progress progress;
///     const auto binding = system->bind(handles, mesh.points, {}, progress);
///     Points points;
///     binding->deform(pose, points);
class CoordinateSystem {
public:
  virtual ~CoordinateSystem() = default;

  virtual std::string id() const = 0;      ///< As on the command line: "s-celestial".
  virtual std::string name() const = 0;    ///< As in the window: "S-Celestial".
  virtual std::string summary() const = 0; ///< One line for a user.
  virtual Traits traits() const = 0;
  virtual std::vector<Parameter> parameters() const = 0;

  /// Computes the coordinates of `points` (`n x 3`). Points without coordinates, such as those outside the
  /// handles' hull, are listed in the report's failures. Throws `DataError` for handles that no point could
  /// use (fewer than four, all in one plane, two at one place, not finite), `UsageError` for a parameter out
  /// of range, `Cancelled`.
  virtual std::unique_ptr<Binding> bind(const HandleSet& handles, const Points& points,
                                        const BindOptions& options, Progress& progress) const = 0;

  /// Derivatives of the coordinates at `points`. The standard implementation takes central differences of
  /// `bind` at a step of 1e-5 of the handles' size; systems with a closed form override it.
  virtual CoordinateGradients gradients(const HandleSet& handles, const Points& points,
                                        const BindOptions& options, Progress& progress) const;

  /// How the system divides the space around these handles, without any points: quick enough to follow a
  /// handle that is dragged. The standard one is empty. Throws as `bind` does for handles and parameters.
  virtual SpaceLayout layout(const HandleSet& handles, const ParameterValues& parameters) const;
};

/// Id, name, summary, traits and parameters of a coordinate system.
struct SystemDescription {
  std::string id;
  std::string name;
  std::string summary;
  Traits traits = {};
  std::vector<Parameter> parameters = {};
};

/// A base for coordinate systems that returns the description given to its constructor.
class DescribedSystem : public CoordinateSystem {
public:
  explicit DescribedSystem(SystemDescription description) : description_(std::move(description)) {}
  std::string id() const final { return description_.id; }
  std::string name() const final { return description_.name; }
  std::string summary() const final { return description_.summary; }
  Traits traits() const final { return description_.traits; }
  std::vector<Parameter> parameters() const final { return description_.parameters; }

private:
  SystemDescription description_;
};

} // namespace viscera::coordinates
