#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Texts for a user, as values: a pattern in English with its parts, which can be translated.
///
/// The numerical modules make texts without any translation. The window translates a text by its pattern and
/// by its parts (app/window/style/language.h); the command line and Python print it in English.
///
///     const Text step = phrase("Open %1", named("Liver")); // In German "Leber öffnen".
///
/// `%1` to `%9` stand for the parts in their order. `%n` is the first part as a number, and chooses between
/// the forms in braces: the first for 1, the second for any other. Each pattern stands as one literal, which
/// the test `Phrases` finds in the sources and looks up in resources/translations/names_*.ts.
namespace viscera {

struct Wording;

/// A text for a user: a small immutable tree whose copies share their memory. What it is made from tells
/// whether it has a translation:
///
///   Text("it has no volume")               // A literal is a message, and has a translation.
///   phrase("Open %1", file.string())       // So has a pattern; its parts are texts themselves.
///   Text(file.filename().string())         // A `std::string` is verbatim, in every language.
///   named(organ.name)                      // The translation of a name, where the name has one.
///   inFixed(volumeMl, 1), 17               // Numbers have the decimal mark of the language.
///   diagnostic("the header has %1 bytes", 3) // Stays in English, behind "The file cannot be read: %1".
///   misuse("there is no view %1", name)      // The same behind "Internal error: %1".
///
/// Copies are cheap and never throw. Every function is safe from any thread.
class Text {
public:
  Text() = default;
  /// A message: a literal of the sources.
  Text(const char* message);
  /// Verbatim: the name of a file, what the system says.
  Text(std::string verbatim);
  Text(std::integral auto number) : Text(Kind::number, std::to_string(number), {}) {}

  bool empty() const { return node_ == nullptr; }
  /// What the command line prints, and files keep. O(length).
  std::string english() const;
  /// The text with a capital letter first, as a sentence begins.
  Text capitalised() const;

  /// A text taken apart, as a file keeps it.
  struct Pieces {
    std::string kind;        ///< "message", "verbatim", "name", "number", "list", "sentence", ...
    std::string words;       ///< The pattern, the verbatim text, the name or the digits.
    std::vector<Text> parts; ///< Of patterns and lists; a sentence has one.
  };
  /// An empty text is verbatim without words.
  Pieces pieces() const;
  /// The text of such pieces. Nothing for an unknown kind, and for a sentence that has not one part.
  static std::optional<Text> of(Pieces pieces);

  /// Whether both were made from the same patterns and parts. O(length).
  friend bool operator==(const Text& a, const Text& b);

private:
  enum class Kind { message, verbatim, name, number, list, diagnostic, misuse, sentence };
  struct Node;
  class Speaker;

  Text(Kind kind, std::string words, std::vector<Text> parts);

  friend Text phraseOf(const char* pattern, std::vector<Text> parts);
  friend Text diagnosticOf(const char* pattern, std::vector<Text> parts);
  friend Text misuseOf(const char* pattern, std::vector<Text> parts);
  friend Text named(std::string_view name);
  friend Text inFixed(double value, int digits);
  friend Text inDigits(double value, int digits);
  friend Text listOf(std::vector<Text> texts);
  friend std::string inWords(const Text& text, const Wording& language);

  std::shared_ptr<const Node> node_; ///< Null: empty.
};

/// Prints the English text.
std::ostream& operator<<(std::ostream& out, const Text& text);

/// A text is English in JSON: nlohmann's library finds this function.
template <class Json>
void to_json(Json& json, const Text& text) {
  json = text.english();
}

/// The English texts of a list.
std::vector<std::string> inEnglish(const std::vector<Text>& texts);

Text phraseOf(const char* pattern, std::vector<Text> parts);
Text diagnosticOf(const char* pattern, std::vector<Text> parts);
Text misuseOf(const char* pattern, std::vector<Text> parts);

/// A pattern with its parts. A place that has no part stays as it is.
template <class... Parts>
Text phrase(const char* pattern, const Parts&... parts) {
  return phraseOf(pattern, {Text(parts)...});
}

/// A part of a text that stays in English: a text, a number, or a piece of a file.
template <class Part>
Text englishPart(const Part& part) {
  if constexpr (std::is_same_v<Part, std::string_view>)
    return Text(std::string(part));
  else
    return Text(part);
}

/// What is wrong with the contents of a damaged file, for the developer of the program that wrote it. It
/// has no translation: the window shows it in English behind one translated sentence; as a part of another
/// sentence, and after the first of a text, without it.
template <class... Parts>
Text diagnostic(const char* pattern, const Parts&... parts) {
  return diagnosticOf(pattern, {englishPart(parts)...});
}

/// What a caller did wrong: a name that does not exist, arrays of different sizes. The command line and
/// Python can ask for such things, and say so in English; the window offers what there is, so that it shows
/// this text only when the program is at fault: in English, behind one translated sentence, as a diagnostic.
template <class... Parts>
Text misuse(const char* pattern, const Parts&... parts) {
  return misuseOf(pattern, {englishPart(parts)...});
}

/// The name of a thing (a handle, a phase, a coordinate system, an organ): translated where the language has
/// a translation of exactly this name, or of the name before a number ("Septum 12"); else verbatim.
Text named(std::string_view name);

/// A number with that many digits behind the decimal mark: "83.4".
Text inFixed(double value, int digits);
/// A number with that many significant digits: "0.25".
Text inDigits(double value, int digits = 3);

/// The texts with ", " between them.
Text listOf(std::vector<Text> texts);

/// How a language says texts.
struct Wording {
  /// The translation of an English pattern; where the pattern has a number, the form for `number`, which may
  /// already stand in the place of %n. Empty, or the pattern itself: there is none.
  std::function<std::string(const std::string& pattern, std::optional<int> number)> translate;
  std::string decimalMark = ".";
};

/// A text in a language, UTF-8. What has no translation is English. O(length) and one look-up for each
/// pattern and name.
std::string inWords(const Text& text, const Wording& language);

/// The index at which the trailing number of a name begins, with the space before it: 6 in "Septum 12", 8 in
/// "Vertebra L1", else the name's size. Such a name is translated without its number. O(n); from any thread.
std::size_t numberAtEnd(std::string_view name);

} // namespace viscera
