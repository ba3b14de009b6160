#include "viscera/coordinates/handle_checks.h"

#include <string>

#include <Eigen/QR>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

/// Part of the handles' size: nearer is the same place, thinner is flat.
constexpr double kHandleTolerance = 1e-9;

template <int Dim>
void requireDistinct(const PointsOf<Dim>& handles, double tolerance) {
  for (Eigen::Index i = 0; i < handles.rows(); ++i)
    for (Eigen::Index j = i + 1; j < handles.rows(); ++j)
      if ((handles.row(i) - handles.row(j)).norm() <= tolerance)
        throw DataError("two handles are at one place", phrase("handles %1 and %2", i, j),
                        "move or delete one of them");
}

} // namespace

template <int Dim>
void requireUsableHandles(const PointsOf<Dim>& handles) {
  const Eigen::Index count = handles.rows();
  if (count < Dim + 1)
    throw DataError(phrase("only %n {handle|handles}", count), "handles",
                    phrase("at least %1 are needed", Dim + 1));
  for (Eigen::Index i = 0; i < count; ++i)
    if (!handles.row(i).allFinite())
      throw DataError("the position is not finite", phrase("handle %1", i), "place the handle again");

  const PointsOf<Dim> centred = handles.rowwise() - handles.colwise().mean();
  const double size = (handles.colwise().maxCoeff() - handles.colwise().minCoeff()).norm();
  requireDistinct<Dim>(handles, kHandleTolerance * size);
  // The last diagonal entry is about the thickness; unlike a covariance it is not squared, so 1e-9 can be
  // detected.
  const Eigen::ColPivHouseholderQR<PointsOf<Dim>> decomposition(centred);
  if (std::abs(decomposition.matrixQR()(Dim - 1, Dim - 1)) <= kHandleTolerance * size)
    throw DataError(Dim == 3 ? "all handles lie in one plane" : "all handles lie on one line", "handles",
                    Dim == 3 ? "move some off the plane, or add enclosing handles"
                             : "move some off the line");
}

template void requireUsableHandles<2>(const PointsOf<2>&);
template void requireUsableHandles<3>(const PointsOf<3>&);

} // namespace viscera::coordinates
