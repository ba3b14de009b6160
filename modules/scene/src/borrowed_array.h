#pragma once

#include <vtkType.h>

namespace viscera::scene {

/// Lets a VTK array look at `count` numbers that it neither copies nor frees. VTK's interface is not const.
template <typename Array, typename Number>
void look(Array* array, const Number* data, vtkIdType count) {
  array->SetArray(const_cast<Number*>(data), count, /*save=*/1);
  array->Modified();
}

} // namespace viscera::scene
