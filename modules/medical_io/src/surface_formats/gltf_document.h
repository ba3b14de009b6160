#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "file_bytes.h"
#include "scalar.h"

#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// A glTF 2.0 file: gives access to its JSON, its buffers, and the numbers in them. Every index and size is
/// checked. All members throw `DataError` for damaged files.
class GltfDocument {
public:
  using Json = nlohmann::json;

  /// Parses a GLB or the JSON of a GLTF and loads its buffers: the binary chunk, data URIs, and files beside
  /// it. `file` outlives the document.
  explicit GltfDocument(const FileBytes& file);

  const Json& json() const { return json_; }
  const std::vector<Text>& warnings() const { return warnings_; }

  /// Entry `index` of the top-level array `list`.
  const Json& entry(const char* list, std::uint64_t index) const;
  /// The member of an object that is a whole number not below 0; `otherwise` when it is absent.
  std::uint64_t whole(const Json& object, const char* key, std::uint64_t otherwise) const;
  /// The same for a member that has to be there.
  std::uint64_t whole(const Json& object, const char* key) const;

  /// An accessor's numbers, element by element, normalised integers as fractions. `components` gets how many
  /// an element has.
  std::vector<double> numbers(std::uint64_t accessor, std::size_t& components) const;
  /// A scalar accessor of whole numbers.
  std::vector<std::int64_t> indices(std::uint64_t accessor) const;

  /// Throws for a primitive whose points are only in compressed form.
  void requireUncompressed(const Json& primitive) const;

  [[noreturn]] void fail(const Text& problem) const { file_.fail(problem); }

private:
  struct View {
    std::string_view data;
    std::size_t stride = 0;
    std::size_t count = 0;
    std::size_t components = 0;
    Scalar scalar = Scalar::float32;
    double largest = 0; ///< Divisor of normalised integers; 0: they are not normalised.
  };

  void parseGlb();
  void parseJson(std::string_view text);
  void requireUnderstood() const;
  [[noreturn]] void failAsCompressed(std::string_view extension) const;
  void loadBuffers();
  std::string loadUri(const std::string& uri) const;
  View view(std::uint64_t accessor) const;
  std::string_view dataOf(const Json& bufferView, std::uint64_t offset, std::uint64_t accessor) const;

  const FileBytes& file_;
  Json json_;
  std::string_view binary_;
  bool hasBinary_ = false;
  std::vector<std::string> loaded_;       ///< Buffers that are not in the file itself.
  std::vector<std::string_view> buffers_; ///< All buffers.
  std::vector<Text> warnings_;
};

} // namespace viscera::medical_io
