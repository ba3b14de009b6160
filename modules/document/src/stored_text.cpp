#include "viscera/document/stored_text.h"

#include <optional>
#include <utility>

namespace viscera::document {
namespace {

using nlohmann::ordered_json;

ordered_json storedText(const Text& text) {
  const Text::Pieces pieces = text.pieces();
  ordered_json stored = {{"kind", pieces.kind}};
  if (!pieces.words.empty())
    stored["words"] = pieces.words;
  if (!pieces.parts.empty())
    stored["parts"] = storedTexts(pieces.parts);
  return stored;
}

Text textFrom(JsonReader& reader, const ordered_json& stored, const std::string& place) {
  reader.takeObject(stored, {"kind", "words", "parts"}, place);
  Text::Pieces pieces;
  pieces.kind = reader.valueOf<std::string>(stored, "kind", place);
  reader.readIfThere(stored, "words", place, pieces.words);
  if (stored.contains("parts"))
    pieces.parts = textsFrom(reader, stored.at("parts"), JsonReader::inside(place, "parts"));
  std::optional<Text> text = Text::of(std::move(pieces));
  if (!text)
    reader.fail(diagnostic("It is no text of a known kind"), place);
  return *std::move(text);
}

} // namespace

ordered_json storedTexts(const std::vector<Text>& texts) {
  ordered_json list = ordered_json::array();
  for (const Text& text : texts)
    list.push_back(storedText(text));
  return list;
}

std::vector<Text> textsFrom(JsonReader& reader, const ordered_json& stored, const std::string& place) {
  reader.requireList(stored, place);
  std::vector<Text> texts;
  for (std::size_t i = 0; i < stored.size(); ++i)
    texts.push_back(textFrom(reader, stored[i], JsonReader::at(place, i)));
  return texts;
}

} // namespace viscera::document
