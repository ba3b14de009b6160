#include "viscera/lesson/lesson.h"

#include <ostream>

#include <QByteArray>
#include <QCryptographicHash>
#include <QFile>
#include <QLocale>
#include <QMap>

#include "page_json.h"
#include "page_strings.h"
#include "viscera/core/atomic_file.h"

namespace viscera::lesson {
namespace {

QByteArray partOf(const QString& name) {
  QFile file(QStringLiteral(":/viscera/lesson/") + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The script in the order in which its parts need one another. What only an opened heart needs is not in
/// other lessons.
QByteArray scriptOf(bool heart) {
  QByteArray script = "'use strict';\n";
  for (const char* name : {"data", "shape", "picture", heart ? "heart" : "whole", "overlay", "chart",
                           "strain", "panel", "quiz", "main"})
    script += partOf(QString::fromLatin1(name) + QStringLiteral(".js"));
  return script;
}

/// A source of the policy: of the exact bytes between the tags.
QByteArray hashOf(const QByteArray& text) {
  return QCryptographicHash::hash(text, QCryptographicHash::Sha256).toBase64();
}

QByteArray escaped(const std::string& text) {
  return QString::fromStdString(text)
      .toHtmlEscaped()
      .replace(QLatin1Char('\''), QStringLiteral("&#39;"))
      .toUtf8();
}

} // namespace

std::string pageOf(const Lesson& lesson) {
  ArrayPacker packer;
  const std::string json = pageJson(lesson, packer);
  const QByteArray style = partOf(QStringLiteral("page.css")),
                   script = scriptOf(lesson.tissue.has_value() || lesson.conduction.has_value());
  const PageWords words(lesson.plan.language);
  const std::string language = words.said(kLanguageCode);
  const bool toTheLeft = QLocale(QString::fromStdString(language)).textDirection() == Qt::RightToLeft;
  const QMap<QByteArray, QByteArray> values = {
      {"LANGUAGE", QByteArray::fromStdString(language)},
      {"DIRECTION", toTheLeft ? "rtl" : "ltr"},
      {"SCRIPT_HASH", hashOf(script)},
      {"STYLE_HASH", hashOf(style)},
      {"TITLE", escaped(lesson.plan.title)},
      {"FAILURE", escaped(words.pageStrings().at("failure"))},
      {"STYLE", style},
      {"LESSON", QByteArray::fromStdString(json)},
      {"ARRAYS", QByteArray::fromStdString(deflated(packer.bytes())).toBase64()},
      {"SCRIPT", script}};
  // One pass searches no value for names.
  const QList<QByteArray> pieces = partOf(QStringLiteral("page.html")).split('@');
  QByteArray page;
  for (int i = 0; i < pieces.size(); ++i)
    page += i % 2 == 0 ? pieces[i] : values.value(pieces[i]);
  return page.toStdString();
}

void writePage(const std::filesystem::path& file, const Lesson& lesson) {
  const std::string page = pageOf(lesson);
  writeAtomically(file, [&](std::ostream& stream) { stream << page; });
}

} // namespace viscera::lesson
