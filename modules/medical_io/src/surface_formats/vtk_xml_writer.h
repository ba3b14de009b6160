#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace viscera::medical_io {

/// How the arrays of a VTK XML file are written behind its header; both are compressed by zlib.
enum class VtkAppended { base64, raw };

/// Writes a file of VTK's XML formats: its elements, then the arrays. In memory until `write`.
class VtkXmlWriter {
public:
  /// `type` is VTK's, as "PolyData".
  VtkXmlWriter(std::string_view type, VtkAppended appended);

  /// Begins an element: its name and attributes, as "Piece NumberOfPoints=\"3\"".
  void open(const std::string& element);
  /// Ends the element that was begun last.
  void close();

  /// Adds numbers, `components` for each point or cell; 1 for lists. O(values).
  template <class Value>
  void array(std::string_view name, const Value* values, std::size_t count, int components) {
    addArray("DataArray type=\"" + typeName<Value>() + "\"", name,
             components == 1 ? std::string() : " NumberOfComponents=\"" + std::to_string(components) + "\"",
             {reinterpret_cast<const char*>(values), count * sizeof(Value)});
  }
  /// Adds a field of one text.
  void text(std::string_view name, const std::string& value);

  /// Ends all elements and writes the file.
  void write(std::ostream& out);

private:
  template <class Value>
  static std::string typeName() {
    static_assert(std::is_arithmetic_v<Value>);
    return (std::is_floating_point_v<Value> ? "Float"
            : std::is_signed_v<Value>       ? "Int"
                                            : "UInt") +
           std::to_string(8 * sizeof(Value));
  }

  void addArray(const std::string& begin, std::string_view name, const std::string& attributes,
                std::string_view bytes);
  void appendPacked(std::string_view bytes);
  std::string indent() const { return std::string(2 * open_.size(), ' '); }

  VtkAppended appended_;
  std::string header_;
  std::string data_;
  std::vector<std::string> open_;
};

/// The value of an attribute with what XML reserves written in its own way.
std::string xmlEscaped(std::string_view text);

} // namespace viscera::medical_io
