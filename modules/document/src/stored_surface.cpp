#include "stored_surface.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string_view>

#include <QByteArray>
#include <QCryptographicHash>
#include <zlib.h>

#include "viscera/core/error.h"

namespace viscera::document {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "session files hold little-endian numbers");

constexpr std::int64_t kLargest = std::numeric_limits<int>::max() / 2;   ///< Bytes; base64 makes them more.
constexpr std::size_t kMostAtOnce = std::numeric_limits<int>::max() / 2; ///< To hash: Qt counts in int.
/// zlib cannot make less of anything.
constexpr std::int64_t kMostCompression = 1032;
/// Coordinates hardly compress: more effort costs five times as long and saves a few per cent.
constexpr int kEffort = Z_BEST_SPEED;

template <class Array>
std::string_view bytesOf(const Array& array) {
  return {reinterpret_cast<const char*>(array.data()),
          static_cast<std::size_t>(array.size()) * sizeof(*array.data())};
}

std::string packed(std::string_view bytes) {
  if (static_cast<std::int64_t>(bytes.size()) > kLargest)
    throw CannotCreateError("a surface of more than 1 GB cannot be kept in a session file", {},
                            "save the organ as a surface file first");
  uLongf size = compressBound(bytes.size());
  QByteArray compressed(static_cast<int>(size), Qt::Uninitialized);
  compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
            bytes.size(), kEffort);
  compressed.resize(static_cast<int>(size));
  return compressed.toBase64().toStdString();
}

/// Fills `array`, whose size is what the file says, from its text.
template <class Array>
void unpack(const JsonReader& reader, const ordered_json& stored, const char* key, std::int64_t rows,
            const std::string& place, Array& array) {
  const std::string text = reader.textOf(stored, key, place);
  const std::string where = place + "." + key;
  if (static_cast<std::int64_t>(text.size()) > std::numeric_limits<int>::max())
    reader.fail("It is too long", where);
  const auto decoded =
      QByteArray::fromBase64Encoding(QByteArray::fromRawData(text.data(), static_cast<int>(text.size())),
                                     QByteArray::Base64Encoding | QByteArray::AbortOnBase64DecodingErrors);
  if (!decoded)
    reader.fail("It is no base64", where);
  const QByteArray& compressed = decoded.decoded;
  constexpr std::int64_t kRow = 3 * sizeof(*array.data());
  if (rows > compressed.size() * kMostCompression / kRow)
    reader.fail("It holds less than " + std::to_string(rows) + " rows", where);
  array.resize(static_cast<Eigen::Index>(rows), 3);
  uLongf size = static_cast<uLongf>(rows * kRow);
  const int outcome = uncompress(reinterpret_cast<Bytef*>(array.data()), &size,
                                 reinterpret_cast<const Bytef*>(compressed.constData()),
                                 static_cast<uLong>(compressed.size()));
  if (outcome != Z_OK || size != static_cast<uLongf>(rows * kRow))
    reader.fail("It is damaged: it does not hold " + std::to_string(rows) + " rows", where);
}

} // namespace

std::string surfaceHash(const geometry::TriangleMesh& mesh) {
  QCryptographicHash hash(QCryptographicHash::Sha256);
  for (std::string_view bytes : {bytesOf(mesh.points), bytesOf(mesh.triangles), bytesOf(mesh.colors)})
    for (; !bytes.empty(); bytes.remove_prefix(std::min(kMostAtOnce, bytes.size())))
      hash.addData(bytes.data(), static_cast<int>(std::min(kMostAtOnce, bytes.size())));
  return hash.result().toHex().toStdString();
}

ordered_json storedSurface(const geometry::TriangleMesh& mesh) {
  ordered_json stored{{"vertices", mesh.points.rows()},
                      {"triangles", mesh.triangles.rows()},
                      {"points", packed(bytesOf(mesh.points))},
                      {"indices", packed(bytesOf(mesh.triangles))}};
  if (mesh.colors.rows() > 0)
    stored["colors"] = packed(bytesOf(mesh.colors));
  return stored;
}

geometry::TriangleMesh surfaceFrom(JsonReader& reader, const ordered_json& stored, const std::string& place) {
  reader.takeObject(stored, {"vertices", "triangles", "points", "indices", "colors"}, place);
  const std::int64_t vertices = reader.wholeOf(reader.field(stored, "vertices", place), place + ".vertices");
  const std::int64_t triangles =
      reader.wholeOf(reader.field(stored, "triangles", place), place + ".triangles");
  geometry::TriangleMesh mesh;
  unpack(reader, stored, "points", vertices, place, mesh.points);
  unpack(reader, stored, "indices", triangles, place, mesh.triangles);
  if (stored.contains("colors"))
    unpack(reader, stored, "colors", vertices, place, mesh.colors);
  return mesh;
}

} // namespace viscera::document
