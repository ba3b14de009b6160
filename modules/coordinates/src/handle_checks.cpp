#include "viscera/coordinates/handle_checks.h"

#include <string>

#include <Eigen/QR>

#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

/// Of the handles' size: nearer is the same place, thinner is flat.
constexpr double kRelativeTolerance = 1e-9;

template <int Dim>
void requireDistinct(const PointsOf<Dim>& handles, double tolerance) {
  for (Eigen::Index i = 0; i < handles.rows(); ++i)
    for (Eigen::Index j = i + 1; j < handles.rows(); ++j)
      if ((handles.row(i) - handles.row(j)).norm() <= tolerance)
        throw DataError("two handles are at one place",
                        "handles " + std::to_string(i) + " and " + std::to_string(j),
                        "move or delete one of them");
}

} // namespace

template <int Dim>
void requireUsableHandles(const PointsOf<Dim>& handles) {
  const Eigen::Index count = handles.rows();
  if (count < Dim + 1)
    throw DataError("only " + std::to_string(count) + " handles", "handles",
                    "at least " + std::to_string(Dim + 1) + " are needed");
  for (Eigen::Index i = 0; i < count; ++i)
    if (!handles.row(i).allFinite())
      throw DataError("the position is not finite", "handle " + std::to_string(i), "place the handle again");

  const PointsOf<Dim> centred = handles.rowwise() - handles.colwise().mean();
  const double size = (handles.colwise().maxCoeff() - handles.colwise().minCoeff()).norm();
  requireDistinct<Dim>(handles, kRelativeTolerance * size);
  // The last diagonal entry is about the thickness; unlike a covariance it is not squared, so 1e-9 can be
  // told.
  const Eigen::ColPivHouseholderQR<PointsOf<Dim>> decomposition(centred);
  if (std::abs(decomposition.matrixQR()(Dim - 1, Dim - 1)) <= kRelativeTolerance * size)
    throw DataError(Dim == 3 ? "all handles lie in one plane" : "all handles lie on one line", "handles",
                    Dim == 3 ? "move some off the plane, or add enclosing handles"
                             : "move some off the line");
}

template void requireUsableHandles<2>(const PointsOf<2>&);
template void requireUsableHandles<3>(const PointsOf<3>&);

} // namespace viscera::coordinates
