#pragma once

#include <cstdint>

/// The data that Viscera exchanges with its TetGen worker, in the machine's own byte order: a `Request`, then
/// `points x 3` doubles and `triangles x 3` int32 on the worker's standard input; a `Reply`, then `points x
/// 3` doubles and `tetrahedra x 4` int32 on its standard output. An error is reported by a line on standard
/// error and one of the exit codes. Only this file is shared: the worker links TetGen, but no library of
/// Viscera.
namespace viscera::deformation::tetgen_exchange {

inline constexpr std::uint64_t kMagic = 0x3130'7465'7456'5356; ///< "VSVtet01"

struct Request {
  std::uint64_t magic = kMagic;
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  double maxVolume = 0;       ///< 0: no limit.
  double radiusEdgeRatio = 0; ///< 0: any shape.
};

struct Reply {
  std::uint64_t magic = kMagic;
  std::uint64_t points = 0;
  std::uint64_t tetrahedra = 0;
};

/// Exit codes of the worker.
inline constexpr int kDone = 0;
inline constexpr int kBadRequest = 64;
inline constexpr int kRefused = 65;
inline constexpr int kOutOfMemory = 71;

} // namespace viscera::deformation::tetgen_exchange
