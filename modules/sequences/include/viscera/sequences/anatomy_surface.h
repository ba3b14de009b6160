#pragma once

#include <functional>

#include "viscera/core/arrays.h"

namespace viscera::sequences {

/// The surface of an organ or of a part of it as a function of the point (mm, LPS): negative inside, about
/// the distance in mm near the surface. May be asked from several threads.
using AnatomySurface = std::function<double(const Vec3& point)>;

} // namespace viscera::sequences
