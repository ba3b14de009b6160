#include "viscera/lesson/lesson_spec.h"

#include <algorithm>
#include <array>
#include <string>

#include <QFile>

#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::lesson {
namespace {

Vec3 placeFrom(const nlohmann::json& value) {
  const auto numbers = value.get<std::array<double, 3>>();
  return {numbers[0], numbers[1], numbers[2]};
}

PlannedSlide slideFrom(const nlohmann::json& item) {
  PlannedSlide slide;
  slide.title = item.at("title").get<std::string>();
  slide.text = item.value("text", "");
  slide.side = item.value("side", "");
  slide.phase = item.value("phase", "");
  slide.names = item.value("names", true);
  slide.handles = item.value("handles", false);
  slide.hidden = item.value("hidden", std::vector<std::string>());
  if (item.contains("position"))
    slide.eye = Eye{placeFrom(item.at("position")), placeFrom(item.at("focus"))};
  for (const auto& [key, number] : {std::pair("fraction", &slide.fraction), std::pair("rate", &slide.rate),
                                    std::pair("seeThrough", &slide.seeThrough)})
    if (item.contains(key))
      *number = item.at(key).get<double>();
  return slide;
}

LessonSpec specFrom(const nlohmann::json& tree) {
  LessonSpec spec;
  spec.language = tree.value("language", "");
  spec.title = tree.value("title", "");
  spec.notes = tree.value("notes", "");
  spec.names = tree.value("names", std::map<std::string, std::string>());
  spec.rates = tree.value("rates", std::vector<double>());
  if (tree.contains("handles"))
    spec.handles = tree.at("handles").get<int>();
  for (const nlohmann::json& item : tree.value("labels", nlohmann::json::array()))
    spec.labels.push_back({item.at("surface").get<std::string>(), item.at("text").get<std::string>(),
                           placeFrom(item.at("at"))});
  for (const nlohmann::json& item : tree.value("slides", nlohmann::json::array()))
    spec.slides.push_back(slideFrom(item));
  return spec;
}

/// The error of the JSON library as a text for the author of the file.
std::string problemOf(const nlohmann::json::exception& error, const std::string& text) {
  if (const auto* parsing = dynamic_cast<const nlohmann::json::parse_error*>(&error)) {
    const auto read = static_cast<std::ptrdiff_t>(std::min(parsing->byte, text.size()));
    return phrase("It is not complete JSON: the mistake is in line %1",
                  1 + std::count(text.begin(), text.begin() + read, '\n'));
  }
  constexpr int kMissingKey = 403;
  const std::string said = error.what();
  const std::size_t from = said.find('\''), to = said.rfind('\'');
  if (error.id == kMissingKey && to > from)
    return phrase("It does not describe a lesson: \"%1\" is missing", said.substr(from + 1, to - from - 1));
  return "It does not describe a lesson: a text, a number or a list stands where something else belongs";
}

} // namespace

LessonSpec readSpec(const std::string& text, const std::string& where) {
  try {
    return specFrom(nlohmann::json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw DataError(problemOf(error, text), where, "compare it with the example in docs/lessons.md");
  }
}

LessonSpec readySpec(const std::string& sequence) {
  QFile file(QStringLiteral(":/viscera/lesson/%1.json").arg(QString::fromStdString(sequence)));
  if (!file.open(QIODevice::ReadOnly))
    return {};
  return readSpec(file.readAll().toStdString(), sequence);
}

} // namespace viscera::lesson
