#pragma once

namespace viscera::coordinates {

/// The width in bits of the SIMD vectors in the inner loops of this process: 512, 256, or 128 for anything
/// narrower. It is that of the processor, or the environment variable VISCERA_VECTOR_BITS if that is smaller,
/// and constant for the whole run. Results of different widths differ in the last digits: processes on
/// different machines need the same width to agree in every bit. For any thread.
int vectorBits();

} // namespace viscera::coordinates
