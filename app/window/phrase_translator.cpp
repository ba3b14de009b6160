#include "window/phrase_translator.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>
#include <numeric>

#include "viscera/core/phrase.h"

namespace viscera::app {
namespace {

constexpr const char* kContext = "viscera::presentation"; ///< In the files of translations.
constexpr const char* kMessages = "viscera::messages";
constexpr QLatin1Char kQuote('"');
constexpr const char* kQuoted = "\"%1\"";   ///< How the language quotes; no text is made of it.
constexpr int kPlaceOfNumber = 0;           ///< The place of `%n`, which is also the first part.
constexpr qulonglong kSurelySeveral = 1000; ///< Larger numbers have the plural of this one.

const QRegularExpression& place() {
  static const QRegularExpression expression(QStringLiteral("%([n1-9])"));
  return expression;
}

int placeOf(const QString& sign) {
  return sign == QLatin1String("n") ? kPlaceOfNumber : sign.toInt();
}

QString capitalised(QString text) {
  if (!text.isEmpty())
    text[0] = text[0].toUpper();
  return text;
}

} // namespace

void PhraseTranslator::readPatterns(const QString& file) {
  QFile device(file);
  if (!device.open(QIODevice::ReadOnly))
    return;
  QXmlStreamReader xml(&device);
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement || xml.name() != QLatin1String("source"))
      continue;
    const QString source = xml.readElementText();
    if (!source.contains(place()) || source == QLatin1String(kQuoted))
      continue;
    forms_.push_back(formOf(source, true));
    if (Form several = formOf(source, false); several.literals != forms_.back().literals)
      forms_.push_back(std::move(several));
  }
  const auto letters = [](const Form& form) {
    return std::accumulate(form.literals.begin(), form.literals.end(), 0,
                           [](int sum, const QString& literal) { return sum + literal.size(); });
  };
  std::stable_sort(forms_.begin(), forms_.end(),
                   [&](const Form& a, const Form& b) { return letters(a) > letters(b); });
}

PhraseTranslator::Form PhraseTranslator::formOf(const QString& source, bool one) {
  static const QRegularExpression choice(QStringLiteral(R"(\{([^{}|]*)\|([^{}|]*)\})"));
  Form form{source, one, false, {}, {}};
  QString text = source;
  text.replace(choice, one ? QStringLiteral("\\1") : QStringLiteral("\\2"));
  int from = 0;
  for (auto places = place().globalMatch(text); places.hasNext();) {
    const QRegularExpressionMatch found = places.next();
    form.literals.push_back(text.mid(from, found.capturedStart() - from));
    form.places.push_back(placeOf(found.captured(1)));
    from = found.capturedEnd();
  }
  form.literals.push_back(text.mid(from));
  form.joins = std::none_of(form.literals.begin(), form.literals.end(), [](const QString& literal) {
    return std::any_of(literal.begin(), literal.end(), [](QChar sign) { return sign.isLetter(); });
  });
  return form;
}

std::optional<QStringList> PhraseTranslator::partsIn(const QString& text, const Form& form) {
  const QStringList& literals = form.literals;
  if (!text.startsWith(literals.front()) || !text.endsWith(literals.back()))
    return std::nullopt;
  QStringList parts;
  int from = literals.front().size();
  for (std::size_t i = 0; i < form.places.size(); ++i) {
    const QString& next = literals[static_cast<int>(i) + 1];
    const bool last = i + 1 == form.places.size();
    const int end = last ? text.size() - next.size() : text.indexOf(next, from + 1);
    if (end <= from)
      return std::nullopt;
    parts.push_back(text.mid(from, end - from));
    bool number = false;
    const qulonglong value = parts.back().toULongLong(&number);
    if (form.places[i] == kPlaceOfNumber && (!number || form.one != (value == 1)))
      return std::nullopt;
    from = end + next.size();
  }
  return from == text.size() ? std::optional(parts) : std::nullopt;
}

QString PhraseTranslator::made(const Form& form, const QStringList& parts) const {
  int number = form.one ? 1 : 2;
  for (int i = 0; i < parts.size(); ++i)
    if (form.places[static_cast<std::size_t>(i)] == kPlaceOfNumber)
      number = static_cast<int>(std::min(parts[i].toULongLong(), kSurelySeveral));
  const QString pattern = QTranslator::translate(kContext, form.source.toUtf8().constData(), nullptr, number);
  QString text;
  int from = 0;
  for (auto places = place().globalMatch(pattern); places.hasNext();) {
    const QRegularExpressionMatch found = places.next();
    text += pattern.midRef(from, found.capturedStart() - from);
    from = found.capturedEnd();
    const int wanted = placeOf(found.captured(1));
    const auto at = std::find(form.places.begin(), form.places.end(), wanted);
    if (at != form.places.end())
      text += inWords(parts[static_cast<int>(at - form.places.begin())]);
    else if (wanted == kPlaceOfNumber)
      text += QString::number(number);
  }
  return text + pattern.midRef(from);
}

bool PhraseTranslator::addPlugin(const QString& file) {
  auto plugin = std::make_unique<QTranslator>();
  if (!plugin->load(file))
    return false;
  plugins_.push_back(std::move(plugin));
  return true;
}

QString PhraseTranslator::exactly(const char* text, int n) const {
  QString found = QTranslator::translate(kContext, text, nullptr, n);
  for (std::size_t i = 0; found.isEmpty() && i < plugins_.size(); ++i)
    found = plugins_[i]->translate(kContext, text, nullptr, n);
  return found;
}

QString PhraseTranslator::numbered(const std::string& text) const {
  const std::size_t end = numberAtEnd(text);
  const QString name = end < text.size() ? exactly(text.substr(0, end).c_str()) : QString();
  return name.isEmpty() ? QString() : name + QString::fromStdString(text.substr(end));
}

QString PhraseTranslator::ofTwoNames(const QString& text) const {
  static const QLatin1String between(": ");
  const int end = text.indexOf(between);
  if (end < 0)
    return {};
  const QString pattern = exactly((text.left(end) + QStringLiteral(": %1")).toUtf8().constData());
  const QString second = text.mid(end + between.size());
  const QString translated = exactly(second.toUtf8().constData());
  return pattern.isEmpty() ? QString() : pattern.arg(translated.isEmpty() ? second : translated);
}

QString PhraseTranslator::translateWhole(const QString& text) const {
  // The texts of errors always begin with a capital letter (viscera/core/error.h).
  QString small = text;
  small[0] = small[0].toLower();
  if (const QString exact = exactly(text.toUtf8().constData()); !exact.isEmpty())
    return exact;
  if (const QString exact = exactly(small.toUtf8().constData()); !exact.isEmpty())
    return capitalised(exact);
  for (const bool joined : {false, true})
    for (const Form& form : forms_) {
      if (form.joins != joined)
        continue;
      if (const auto parts = partsIn(text, form))
        return made(form, *parts);
      if (const auto parts = partsIn(small, form))
        return capitalised(made(form, *parts));
    }
  return {};
}

QString PhraseTranslator::inWords(const QString& text) const {
  // "face" is a word of PLY.
  if (text.size() > 2 && text.startsWith(kQuote) && text.indexOf(kQuote, 1) == text.size() - 1)
    return QTranslator::translate(kContext, kQuoted).arg(text.mid(1, text.size() - 2));
  static const QRegularExpression number(QStringLiteral(R"(^-?\d+\.\d+$)"));
  if (number.match(text).hasMatch())
    return QString(text).replace(QLatin1Char('.'), QLocale().decimalPoint());
  QString found = translate(kMessages, text.toUtf8().constData());
  if (found.isEmpty())
    found = numbered(text.toStdString());
  return found.isEmpty() ? text : found;
}

QString PhraseTranslator::translate(const char* context, const char* source, const char* disambiguation,
                                    int n) const {
  if (context && source && qstrcmp(context, kContext) == 0) {
    QString name = exactly(source, n);
    if (name.isEmpty())
      name = numbered(source);
    return name.isEmpty() ? ofTwoNames(QString::fromUtf8(source)) : name;
  }
  const QString exact = QTranslator::translate(context, source, disambiguation, n);
  if (!exact.isEmpty() || !context || !source || qstrcmp(context, kMessages) != 0)
    return exact;
  const QString text = QString::fromUtf8(source);
  if (text.isEmpty())
    return {};
  return translateWhole(text);
}

QString messageInWords(const std::string& text) {
  return text.empty() ? QString() : QCoreApplication::translate(kMessages, text.c_str());
}

} // namespace viscera::app
