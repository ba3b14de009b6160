#include "stored_surface.h"

#include <cstdint>
#include <string_view>

#include "sha256.h"
#include "stored_bytes.h"
#include "viscera/core/phrase.h"

namespace viscera::document {
namespace {

using nlohmann::ordered_json;

template <class Array>
std::string_view rawBytes(const Array& array) {
  return {reinterpret_cast<const char*>(array.data()),
          static_cast<std::size_t>(array.size()) * sizeof(*array.data())};
}

std::string packedArray(std::string_view bytes) {
  return packed(bytes, "a surface");
}

/// Fills `array`, whose size is what the file says, from its text.
template <class Array>
void unpackRows(const JsonReader& reader, const ordered_json& stored, const char* key, std::int64_t rows,
                const std::string& place, Array& array) {
  constexpr std::int64_t kRow = 3 * sizeof(*array.data());
  unpack(reader, stored, key, place, rows * kRow, std::to_string(rows) + " rows", [&array, rows]() -> void* {
    array.resize(static_cast<Eigen::Index>(rows), 3);
    return array.data();
  });
}

} // namespace

std::string surfaceHash(const geometry::TriangleMesh& mesh) {
  Sha256 hash;
  for (const std::string_view bytes :
       {rawBytes(mesh.points), rawBytes(mesh.triangles), rawBytes(mesh.colors)})
    hash.add(bytes);
  return hash.hex();
}

ordered_json storedSurface(const geometry::TriangleMesh& mesh) {
  ordered_json stored{{"vertices", mesh.points.rows()},
                      {"triangles", mesh.triangles.rows()},
                      {"points", packedArray(rawBytes(mesh.points))},
                      {"indices", packedArray(rawBytes(mesh.triangles))}};
  if (mesh.colors.rows() > 0)
    stored["colors"] = packedArray(rawBytes(mesh.colors));
  return stored;
}

geometry::TriangleMesh surfaceFrom(JsonReader& reader, const ordered_json& stored, const std::string& place) {
  reader.takeObject(stored, {"vertices", "triangles", "points", "indices", "colors"}, place);
  const std::int64_t vertices = reader.wholeOf(reader.field(stored, "vertices", place), place + ".vertices");
  const std::int64_t triangles =
      reader.wholeOf(reader.field(stored, "triangles", place), place + ".triangles");
  geometry::TriangleMesh mesh;
  unpackRows(reader, stored, "points", vertices, place, mesh.points);
  unpackRows(reader, stored, "indices", triangles, place, mesh.triangles);
  if (stored.contains("colors"))
    unpackRows(reader, stored, "colors", vertices, place, mesh.colors);
  return mesh;
}

} // namespace viscera::document
