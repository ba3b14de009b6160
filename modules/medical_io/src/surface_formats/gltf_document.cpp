#include "surface_formats/gltf_document.h"

#include <algorithm>
#include <array>
#include <optional>

#include "byte_cursor.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

struct ComponentType {
  Scalar scalar;
  double largest; ///< Divisor of normalised integers; 0 for floats.
};

constexpr std::array<std::pair<std::uint64_t, ComponentType>, 6> kComponentTypes = {
    {{5120, {Scalar::int8, 127}},
     {5121, {Scalar::uint8, 255}},
     {5122, {Scalar::int16, 32767}},
     {5123, {Scalar::uint16, 65535}},
     {5125, {Scalar::uint32, 4294967295.0}},
     {5126, {Scalar::float32, 0}}}};

constexpr std::array<std::pair<std::string_view, std::size_t>, 7> kComponents = {
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};

/// How the names of extensions begin that change how a surface looks, but not what shape it has. With
/// quantization, accessors have types that are read anyway.
constexpr std::array<std::string_view, 14> kHarmless = {
    "KHR_materials",   "KHR_texture", "KHR_mesh_quantization", "KHR_lights",           "KHR_xmp",
    "EXT_texture",     "EXT_lights",  "EXT_materials",         "MSFT_texture",         "MSFT_packing",
    "ADOBE_materials", "KHR_audio",   "KHR_techniques_webgl",  "KHR_animation_pointer"};

constexpr std::string_view kDraco = "KHR_draco_mesh_compression";
/// Extensions that store points in compressed form.
constexpr std::array<std::string_view, 3> kCompressions = {kDraco, "EXT_meshopt_compression",
                                                           "KHR_meshopt_compression"};

/// The extension of an object that has one of these names; null when it has none.
const nlohmann::json* extensionIn(const nlohmann::json& object, std::string_view name) {
  const auto extensions = object.is_object() ? object.find("extensions") : object.end();
  if (!object.is_object() || extensions == object.end() || !extensions->is_object())
    return nullptr;
  const auto found = extensions->find(std::string(name));
  return found == extensions->end() ? nullptr : &*found;
}

/// Whether a buffer stands for what is unpacked of others, and so has no data in the file.
bool isFallback(const nlohmann::json& buffer) {
  for (const std::string_view name : kCompressions)
    if (const nlohmann::json* extension = extensionIn(buffer, name))
      return extension->is_object() && extension->value("fallback", nlohmann::json(false)) == true;
  return false;
}

/// "%20" becomes a space.
std::string decodedUri(std::string_view uri) {
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      const std::size_t value = std::string_view("0123456789abcdef").find(lowered(uri.substr(at, 1)));
      return value == std::string_view::npos ? -1 : static_cast<int>(value);
    };
    if (uri[i] == '%' && i + 2 < uri.size() && digit(i + 1) >= 0 && digit(i + 2) >= 0) {
      result += static_cast<char>(16 * digit(i + 1) + digit(i + 2));
      i += 2;
    } else {
      result += uri[i];
    }
  }
  return result;
}

} // namespace

GltfDocument::GltfDocument(const FileBytes& file) : file_(file) {
  if (file.view().starts_with("glTF"))
    parseGlb();
  else
    parseJson(file.view());
  requireUnderstood();
  loadBuffers();
}

void GltfDocument::parseGlb() {
  ByteCursor cursor(file_, file_.view(), std::endian::little);
  cursor.takeBytes(4, "the header");
  const auto version = cursor.take<std::uint32_t>("the header");
  if (version != 2)
    file_.fail(phrase("It is glTF version %1, but only 2 can be read", version), "export it as glTF 2.0");
  const std::uint64_t length = cursor.take<std::uint32_t>("the header");
  if (length > file_.bytes.size())
    file_.fail(
        diagnostic("the file is cut off: it should have %1 bytes, but has %2", length, file_.bytes.size()));
  if (length < file_.bytes.size())
    warnings_.push_back(phrase("%n {byte|bytes} after the end ignored", file_.bytes.size() - length));
  const auto jsonLength = cursor.take<std::uint32_t>("the first chunk's header");
  if (cursor.take<std::uint32_t>("the first chunk's header") != kJsonChunk)
    file_.fail(diagnostic("its first chunk is not JSON: the file is damaged"));
  parseJson(cursor.takeBytes(jsonLength, "the JSON chunk"));
  while (cursor.remaining() >= 8 && !hasBinary_) {
    const auto chunkLength = cursor.take<std::uint32_t>("a chunk's header");
    const auto type = cursor.take<std::uint32_t>("a chunk's header");
    const std::string_view chunk = cursor.takeBytes(chunkLength, "a chunk");
    if (type != kBinaryChunk)
      continue;
    binary_ = chunk;
    hasBinary_ = true;
  }
}

void GltfDocument::parseJson(std::string_view text) {
  json_ = viscera::parseJson<Json>(text, file_.name(), kUsualAdvice);
  if (!json_.is_object())
    file_.fail(diagnostic("its JSON is not an object: it is not a glTF file"));
}

void GltfDocument::requireUnderstood() const {
  const auto asset = json_.find("asset");
  if (asset == json_.end() || !asset->is_object())
    file_.fail(diagnostic("its JSON has no \"asset\": it is not a glTF file"));
  if (!textIn(*asset, "version").starts_with("2."))
    file_.fail(phrase("It is glTF version %1, but only 2 can be read", inQuotes(textIn(*asset, "version"))),
               "export it as glTF 2.0");
  const auto required = json_.find("extensionsRequired");
  if (required == json_.end() || !required->is_array())
    return;
  for (const Json& extension : *required) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : std::string();
    if (std::find(kCompressions.begin(), kCompressions.end(), name) != kCompressions.end())
      failAsCompressed(name);
    const bool harmless = std::any_of(kHarmless.begin(), kHarmless.end(),
                                      [&](std::string_view prefix) { return name.starts_with(prefix); });
    if (!harmless)
      file_.fail(phrase("It needs the glTF extension %1, which Viscera does not know", inQuotes(name)),
                 "export it as STL, OBJ, PLY or GLB");
  }
}

void GltfDocument::failAsCompressed(std::string_view extension) const {
  file_.fail(phrase("Its geometry is compressed (%1), which Viscera does not read", std::string(extension)),
             "export it without compression (in Blender: leave out Data > Compression), or as STL or PLY");
}

void GltfDocument::requireUncompressed(const Json& primitive) const {
  if (extensionIn(primitive, kDraco) == nullptr)
    return;
  // Beside the compressed points there may be plain ones, for programs that cannot unpack.
  const Json& points = entry("accessors", whole(primitive.at("attributes"), "POSITION"));
  if (!points.contains("bufferView"))
    failAsCompressed(kDraco);
}

void GltfDocument::loadBuffers() {
  const auto list = json_.find("buffers");
  if (list == json_.end() || !list->is_array())
    return;
  // Reserved, so that the views stay valid.
  loaded_.reserve(list->size());
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Json& buffer = (*list)[i];
    if (!buffer.is_object())
      fail(diagnostic("buffer %1 is not a JSON object", i));
    const std::string uri = textIn(buffer, "uri");
    if (uri.empty() && i == 0 && hasBinary_) {
      buffers_.push_back(binary_);
    } else if (uri.empty() && isFallback(buffer)) {
      buffers_.emplace_back();
      continue;
    } else if (uri.empty()) {
      fail(diagnostic("buffer %1 has no data", i));
    } else {
      loaded_.push_back(loadUri(uri));
      buffers_.push_back(loaded_.back());
    }
    const std::uint64_t length = whole(buffer, "byteLength");
    if (length > buffers_.back().size())
      fail(diagnostic("the file is cut off: buffer %1 should have %2 bytes, but has %3", i, length,
                      buffers_.back().size()));
  }
}

std::string GltfDocument::loadUri(const std::string& uri) const {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(";base64,");
    const std::optional<std::string> bytes =
        comma == uri.npos ? std::nullopt : decodeBase64(std::string_view(uri).substr(comma + 8));
    if (!bytes)
      fail(diagnostic("a buffer within the file is not valid base64"));
    return *bytes;
  }
  const std::filesystem::path relative = decodedUri(uri);
  if (uri.find("://") != uri.npos || relative.is_absolute())
    fail(phrase("a buffer is at %1, but only files beside it are read", inQuotes(uri)));
  try {
    return readWholeFile(file_.file.parent_path() / relative).bytes;
  } catch (const Error& error) {
    fail(diagnostic("its buffer %1 cannot be read: %2", inQuotes(relative.string()), error.problem()));
  }
}

const GltfDocument::Json& GltfDocument::entry(const char* list, std::uint64_t index) const {
  const auto found = json_.find(list);
  const std::size_t size = found != json_.end() && found->is_array() ? found->size() : 0;
  if (index >= size || !(*found)[static_cast<std::size_t>(index)].is_object())
    fail(
        diagnostic("It refers to number %1 of \"%2\", but there are %3 (counted from 0)", index, list, size));
  return (*found)[static_cast<std::size_t>(index)];
}

std::uint64_t GltfDocument::whole(const Json& object, const char* key, std::uint64_t otherwise) const {
  const auto found = object.find(key);
  if (found == object.end())
    return otherwise;
  // Not printed: a damaged file may have put a document of any depth there.
  if (!found->is_number_unsigned())
    fail(diagnostic("\"%1\" is not a whole number from 0 on", key));
  return found->get<std::uint64_t>();
}

std::uint64_t GltfDocument::whole(const Json& object, const char* key) const {
  if (!object.contains(key))
    fail(diagnostic("\"%1\" is missing", key));
  return whole(object, key, 0);
}

GltfDocument::View GltfDocument::view(std::uint64_t accessor) const {
  const Json& json = entry("accessors", accessor);
  if (json.contains("sparse") || !json.contains("bufferView"))
    fail(diagnostic("accessor %1 is sparse, which Viscera does not read", accessor));

  View result;
  const auto type = lookUp(kComponentTypes, whole(json, "componentType"));
  const auto components = lookUp(kComponents, textIn(json, "type"));
  if (!type || !components)
    fail(diagnostic("accessor %1 has an unknown type", accessor));
  result.scalar = type->scalar;
  result.components = *components;
  const auto normalized = json.find("normalized");
  if (normalized != json.end() && normalized->is_boolean() && normalized->get<bool>() && type->largest > 0)
    result.largest = type->largest;

  const Json& bufferView = entry("bufferViews", whole(json, "bufferView"));
  result.data = dataOf(bufferView, whole(json, "byteOffset", 0), accessor);
  const std::size_t elementBytes = sizeOf(type->scalar) * result.components;
  const std::uint64_t stride = whole(bufferView, "byteStride", elementBytes);
  const std::uint64_t count = whole(json, "count");
  const bool fits = count == 0 || (elementBytes <= result.data.size() &&
                                   saturatedProduct(count - 1, stride) <= result.data.size() - elementBytes);
  if (stride < elementBytes || !fits)
    fail(diagnostic("accessor %1 should have %2 elements, more than its buffer holds", accessor, count));
  result.stride = static_cast<std::size_t>(stride);
  result.count = static_cast<std::size_t>(count);
  return result;
}

std::string_view GltfDocument::dataOf(const Json& bufferView, std::uint64_t offset,
                                      std::uint64_t accessor) const {
  const std::uint64_t buffer = whole(bufferView, "buffer");
  if (buffer >= buffers_.size())
    fail(diagnostic("accessor %1 refers to buffer %2, but there are %3", accessor, buffer, buffers_.size()));
  const std::string_view bytes = buffers_[static_cast<std::size_t>(buffer)];
  for (const std::string_view name : kCompressions)
    if (bytes.empty() && extensionIn(bufferView, name) != nullptr)
      failAsCompressed(name);
  const std::uint64_t begin = whole(bufferView, "byteOffset", 0);
  const std::uint64_t length = whole(bufferView, "byteLength");
  if (begin > bytes.size() || length > bytes.size() - begin || offset > length)
    fail(diagnostic("accessor %1 lies behind the end of its buffer: the file is cut off or damaged",
                    accessor));
  return bytes.substr(static_cast<std::size_t>(begin + offset), static_cast<std::size_t>(length - offset));
}

std::vector<double> GltfDocument::numbers(std::uint64_t accessor, std::size_t& components) const {
  const View data = view(accessor);
  components = data.components;
  std::vector<double> values;
  values.reserve(data.count * data.components);
  for (std::size_t i = 0; i < data.count; ++i)
    for (std::size_t k = 0; k < data.components; ++k) {
      const char* at = data.data.data() + i * data.stride + k * sizeOf(data.scalar);
      const double value = loadDouble(at, data.scalar, std::endian::little);
      values.push_back(data.largest > 0 ? std::max(value / data.largest, -1.0) : value);
    }
  return values;
}

std::vector<std::int64_t> GltfDocument::indices(std::uint64_t accessor) const {
  const View data = view(accessor);
  if (data.components != 1 || !isWhole(data.scalar))
    fail(diagnostic("accessor %1 should hold point numbers", accessor));
  std::vector<std::int64_t> values;
  values.reserve(data.count);
  for (std::size_t i = 0; i < data.count; ++i)
    values.push_back(loadInteger(data.data.data() + i * data.stride, data.scalar, std::endian::little));
  return values;
}

} // namespace viscera::medical_io
