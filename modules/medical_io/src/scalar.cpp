#include "scalar.h"

#include "file_bytes.h"

namespace viscera::medical_io {
namespace {

template <typename Number>
Number load(const char* data, Scalar scalar, std::endian order) {
  switch (scalar) {
  case Scalar::int8:
    return static_cast<Number>(loadValue<std::int8_t>(data, order));
  case Scalar::uint8:
    return static_cast<Number>(loadValue<std::uint8_t>(data, order));
  case Scalar::int16:
    return static_cast<Number>(loadValue<std::int16_t>(data, order));
  case Scalar::uint16:
    return static_cast<Number>(loadValue<std::uint16_t>(data, order));
  case Scalar::int32:
    return static_cast<Number>(loadValue<std::int32_t>(data, order));
  case Scalar::uint32:
    return static_cast<Number>(loadValue<std::uint32_t>(data, order));
  case Scalar::int64:
    return static_cast<Number>(loadValue<std::int64_t>(data, order));
  case Scalar::uint64:
    return static_cast<Number>(loadValue<std::uint64_t>(data, order));
  case Scalar::float32:
    return static_cast<Number>(loadValue<float>(data, order));
  case Scalar::float64:
    break;
  }
  return static_cast<Number>(loadValue<double>(data, order));
}

} // namespace

std::size_t sizeOf(Scalar scalar) {
  constexpr std::array<std::size_t, 10> kSizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(scalar)];
}

double loadDouble(const char* data, Scalar scalar, std::endian order) {
  return load<double>(data, scalar, order);
}

std::int64_t loadInteger(const char* data, Scalar scalar, std::endian order) {
  return load<std::int64_t>(data, scalar, order);
}

} // namespace viscera::medical_io
