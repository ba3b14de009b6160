#include "stored_bytes.h"

#include <bit>
#include <limits>
#include <new>
#include <optional>

#include <zlib.h>

#include "viscera/core/base64.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::document {
namespace {

static_assert(std::endian::native == std::endian::little, "session files hold little-endian numbers");

constexpr std::int64_t kLargest = std::numeric_limits<int>::max() / 2; ///< Bytes; base64 makes them more.
/// zlib cannot make less of anything.
constexpr std::int64_t kMostCompression = 1032;
/// Coordinates hardly compress: more effort costs five times as long and saves a few per cent.
constexpr int kEffort = Z_BEST_SPEED;

} // namespace

std::string packed(std::string_view bytes, const char* what) {
  if (static_cast<std::int64_t>(bytes.size()) > kLargest)
    throw CannotCreateError(phrase("%1 of more than 1 GB cannot be kept in a session file", what), {},
                            "save it as a file of its own first");
  uLongf size = compressBound(bytes.size());
  std::string compressed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), kEffort) != Z_OK)
    throw std::bad_alloc();
  compressed.resize(size);
  return base64Of(compressed);
}

void unpack(const JsonReader& reader, const nlohmann::ordered_json& stored, const char* key,
            const std::string& place, std::int64_t bytes, const std::string& holds,
            const std::function<void*()>& reserve) {
  const std::string where = place + "." + key;
  const nlohmann::ordered_json& value = reader.field(stored, key, place);
  if (!value.is_string() || value.get_ref<const std::string&>().empty())
    reader.fail(diagnostic("It has to be a text"), where);
  const auto& text = value.get_ref<const std::string&>(); // Not copied: it may be a gigabyte.
  if (static_cast<std::int64_t>(text.size()) > std::numeric_limits<int>::max())
    reader.fail(diagnostic("It is too long"), where);
  const std::optional<std::string> compressed = bytesOfBase64(text);
  if (!compressed)
    reader.fail(diagnostic("It is not base64"), where);
  if (bytes / kMostCompression > static_cast<std::int64_t>(compressed->size()))
    reader.fail(diagnostic("It holds less than %1", holds), where);
  auto size = static_cast<uLongf>(bytes);
  const int outcome =
      uncompress(static_cast<Bytef*>(reserve()), &size, reinterpret_cast<const Bytef*>(compressed->data()),
                 static_cast<uLong>(compressed->size()));
  if (outcome == Z_MEM_ERROR)
    throw std::bad_alloc();
  if (outcome != Z_OK || size != static_cast<uLongf>(bytes))
    reader.fail(diagnostic("It is damaged: it does not hold %1", holds), where);
}

} // namespace viscera::document
