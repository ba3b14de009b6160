#include "words.h"

#include <cctype>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QString>

#include "viscera/core/text.h"
#include "viscera/presentation/presenter.h"

namespace viscera::report {
namespace {

/// The context of resources/translations/names_*.ts.
constexpr const char* kNames = "viscera::presentation";

} // namespace

std::string said(const char* text) {
  return QCoreApplication::translate(kNames, text).toStdString();
}

std::string said(const char* text, const std::string& first, const std::string& second) {
  // Both at once, so that no value is searched for places.
  const QString form = QCoreApplication::translate(kNames, text);
  if (!form.contains(QLatin1String("%2")))
    return form.arg(QString::fromStdString(first)).toStdString();
  return form.arg(QString::fromStdString(first), QString::fromStdString(second)).toStdString();
}

std::string named(const std::string& name) {
  return inWords(viscera::named(name));
}

std::string inWords(const Text& text) {
  const auto translate = [](const std::string& pattern, std::optional<int> number) {
    return QCoreApplication::translate(kNames, pattern.c_str(), nullptr, number.value_or(-1)).toStdString();
  };
  return viscera::inWords(text, {translate, QString(QLocale().decimalPoint()).toStdString()});
}

std::string signedNumber(double value, int digits) {
  const bool shows = std::abs(value) * std::pow(10, digits) >= 0.5;
  return (shows && value > 0 ? "+" : "") + fixed(shows ? value : 0.0, digits);
}

std::string withoutFolders(const std::string& text) {
  // A path begins a word or a quotation, and each of its folders ends with a slash. Blanks may be in a
  // folder's name but not before the first slash of a relative path: there they are words of the sentence.
  static const QRegularExpression folders(QStringLiteral(
      R"re((?<![\w./\\])(?:~|\.{1,2}|[A-Za-z]:|file:/{0,2})?[/\\](?!\s)(?:[^/\\\n"'<>|:;]*[/\\])*)re"));
  return QString::fromStdString(text).remove(folders).toStdString();
}

std::string titleOf(const document::Organ& organ) {
  std::string title = presentation::labelOf(organ, [](const char* text) { return said(text); });
  if (!title.empty())
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

} // namespace viscera::report
