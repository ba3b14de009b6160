#pragma once

namespace viscera {

/// sysexits.h: an internal error.
inline constexpr int kInternalError = 70;

} // namespace viscera
