#pragma once

namespace viscera::coordinates {

/// Width in bits of the SIMD vectors with which the inner loops of this process compute: 512, 256, or 128 for
/// all that is less. The processor's, or the environment variable VISCERA_VECTOR_BITS where that is smaller;
/// the same for the whole run. Results of different widths differ in the last digits: processes on different
/// machines that are to agree on every bit need the same width. For any thread.
int vectorBits();

} // namespace viscera::coordinates
