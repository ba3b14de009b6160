#include "viscera/lesson/lesson_spec.h"

#include <string>
#include <utility>

#include <QFile>

#include <nlohmann/json.hpp>

#include "viscera/core/error.h"
#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"

namespace viscera::lesson {
namespace {

using nlohmann::ordered_json;

PlannedSlide slideFrom(const JsonReader& json, const ordered_json& item, const std::string& place) {
  json.requireObject(item, place);
  PlannedSlide slide;
  slide.title = json.valueOf<std::string>(item, "title", place);
  json.readIfThere(item, "text", place, slide.text);
  json.readIfThere(item, "side", place, slide.side);
  json.readIfThere(item, "phase", place, slide.phase);
  slide.names = true;
  json.readIfThere(item, "names", place, *slide.names);
  json.readIfThere(item, "handles", place, slide.handles);
  json.readIfThere(item, "hidden", place, slide.hidden);
  if (item.contains("position"))
    slide.eye = Eye{json.valueOf<Vec3>(item, "position", place), json.valueOf<Vec3>(item, "focus", place)};
  for (const auto& [key, number] : {std::pair("fraction", &slide.fraction), std::pair("rate", &slide.rate),
                                    std::pair("seeThrough", &slide.seeThrough)})
    if (item.contains(key))
      *number = json.valueOf<double>(item, key, place);
  return slide;
}

LessonSpec specFrom(const JsonReader& json, const ordered_json& tree) {
  LessonSpec spec;
  json.readIfThere(tree, "language", "", spec.language);
  json.readIfThere(tree, "title", "", spec.title);
  json.readIfThere(tree, "notes", "", spec.notes);
  json.readIfThere(tree, "names", "", spec.names);
  json.readIfThere(tree, "rates", "", spec.rates);
  json.readIfThere(tree, "strain", "", spec.strain);
  if (tree.contains("handles"))
    spec.handles = json.valueOf<int>(tree, "handles", "");
  json.eachOf(tree, "labels", "", [&](const ordered_json& item, const std::string& place) {
    json.requireObject(item, place);
    spec.labels.push_back({json.valueOf<std::string>(item, "surface", place),
                           json.valueOf<std::string>(item, "text", place),
                           json.valueOf<Vec3>(item, "at", place)});
  });
  json.eachOf(tree, "slides", "", [&](const ordered_json& item, const std::string& place) {
    spec.slides.push_back(slideFrom(json, item, place));
  });
  return spec;
}

/// The mistake as a text for the author of the file.
Text problemOf(const JsonError& error) {
  if (error.line > 0)
    return diagnostic("It is not complete JSON: the mistake is in line %1", error.line);
  if (!error.missingKey.empty())
    return diagnostic("It does not describe a lesson: \"%1\" is missing", error.missingKey);
  return diagnostic(
      "It does not describe a lesson: a text, a number or a list stands where something else belongs");
}

} // namespace

LessonSpec readSpec(const std::string& text, const std::string& where) {
  const Text advice = misuse("compare it with the example in docs/lessons.md");
  const JsonReader json(where, advice);
  try {
    return specFrom(json, json.parse(text));
  } catch (const JsonError& error) {
    throw DataError(problemOf(error), error.where(), advice);
  }
}

LessonSpec readySpec(const std::string& sequence) {
  QFile file(QStringLiteral(":/viscera/lesson/%1.json").arg(QString::fromStdString(sequence)));
  if (!file.open(QIODevice::ReadOnly))
    return {};
  return readSpec(file.readAll().toStdString(), sequence);
}

} // namespace viscera::lesson
