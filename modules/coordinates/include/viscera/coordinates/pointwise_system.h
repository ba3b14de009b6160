#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {

/// Computes the coordinates of single points for one set of handles, with data prepared for that set.
/// Immutable; called from several threads.
class PointSolver {
public:
  virtual ~PointSolver() = default;

  /// The lift that extends a pose before it is summed; null for most systems. If there is one, `weights` and
  /// `gradients` below have as many rows as a lifted pose, and the traits promise closed-form gradients.
  virtual std::shared_ptr<const PoseLift> lift() const { return {}; }

  /// Sentences for the user in the report of the binding.
  virtual std::vector<Text> notes() const { return {}; }

  /// Fills `weights` (one for each handle, set to zero before) with the coordinates of `point`, mm; false
  /// where the system has none.
  virtual bool solve(const Vec3& point, Values& weights) const = 0;

  /// Solves as `solve`, and fills `gradients` (`handles x 3`, zero before, 1/mm) with the derivatives;
  /// false where the coordinates have none, such as at a corner of the cage. Only called if the system's
  /// traits promise a closed form.
  virtual bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const;
};

/// A base for coordinate systems that compute each point independently, so that a subclass only implements
/// the formula. This class handles threads, cancelling, failures, the binding and its report.
class PointwiseSystem : public DescribedSystem {
public:
  /// Prepares the data that do not depend on the point. `parameters` are within their ranges, the handles
  /// usable (`requireUsableHandles`). Throws `DataError` for handles or a cage that this system cannot use.
  using Prepare = std::function<std::unique_ptr<const PointSolver>(const HandleSet& handles,
                                                                   const ParameterValues& parameters)>;
  /// Serves systems whose coordinates of one point depend on the other points that are bound with it, and
  /// those that take long or need tetrahedra. Throws as `Prepare`, and `Cancelled`.
  using PrepareFor = std::function<std::shared_ptr<const PointSolver>(
      const HandleSet& handles, const Points& points, const BindOptions& options, Progress& progress)>;

  PointwiseSystem(SystemDescription description, PrepareFor prepare)
      : DescribedSystem(std::move(description)), prepare_(std::move(prepare)) {}
  PointwiseSystem(SystemDescription description, Prepare prepare);

  std::unique_ptr<Binding> bind(const HandleSet& handles, const Points& points, const BindOptions& options,
                                Progress& progress) const override;
  /// The solver's derivatives where the traits promise a closed form, else central differences.
  CoordinateGradients gradients(const HandleSet& handles, const Points& points, const BindOptions& options,
                                Progress& progress) const override;

private:
  std::shared_ptr<const PointSolver> solverFor(const HandleSet& handles, const Points& points,
                                               const BindOptions& options, Progress& progress) const;

  PrepareFor prepare_;
};

} // namespace viscera::coordinates
