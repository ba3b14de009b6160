#include "plain_format.h"

#include "text_scanner.h"

namespace viscera::medical_io {

RawSurface readPlain(const FileBytes& file) {
  TextScanner scanner(file, file.view());
  // `count` refuses a number that what is left of the file cannot hold, before memory is taken for it.
  const std::uint64_t points = scanner.count("the number of points", 6);
  const std::uint64_t triangles = scanner.count("the number of triangles", 6);
  RawSurface surface;
  for (std::uint64_t i = 0; i < points; ++i) {
    const double x = scanner.number("a coordinate");
    const double y = scanner.number("a coordinate");
    const double z = scanner.number("a coordinate");
    surface.addPoint(x, y, z);
  }
  for (std::uint64_t t = 0; t < triangles; ++t) {
    const std::int64_t a = scanner.integer("a corner");
    const std::int64_t b = scanner.integer("a corner");
    const std::int64_t c = scanner.integer("a corner");
    surface.addTriangle(a, b, c); // `meshOf` looks at the indices, for every format alike.
  }
  return surface;
}

} // namespace viscera::medical_io
