#pragma once

#include <QLocale>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/phrase.h"

class QTranslator;

namespace viscera::app {

/// A language of the window.
struct Language {
  QString code; ///< Of ISO 639, such as "de"; also the name of its file in resources/translations.
  QString name; ///< In the language itself: "Deutsch".
};

/// All languages of the window, English first.
const std::vector<Language>& languages();

/// The code of the language that was chosen; when none was, or one that is not there, that of the system;
/// when that is not there either, English.
QString languageFor(const QString& chosen, const QLocale& system);

/// How a language writes numbers and dates. Without marks between thousands: "1.500", typed in German, is one
/// and a half here.
QLocale localeOf(const QString& code);

/// Sets the language of texts, numbers and dates as long as the object lives. Made before the window, whose
/// texts stay as they were made.
///
///     const InstalledLanguage language(languageFor(settings.value("window/language").toString(),
///     QLocale::system()));
class InstalledLanguage {
public:
  explicit InstalledLanguage(const QString& code);
  ~InstalledLanguage();
  InstalledLanguage(const InstalledLanguage&) = delete;
  InstalledLanguage& operator=(const InstalledLanguage&) = delete;

  /// Adds the texts that plugins bring: of each file in the registry, `example.so`, those of `example_de.qm`
  /// beside it, where that is there (docs/coordinate_plugin.md). Made before the window, too.
  void addTextsOf(const coordinates::Registry& systems);

private:
  QString code_;
  QLocale before_;
  QTranslator* ours_ = nullptr; ///< One of `translators_`; null in English.
  std::vector<std::unique_ptr<QTranslator>> translators_;
};

/// How the language of the window says texts. For any thread.
Wording wording();

/// A text in the language of the window: its pattern, and those of its parts that have a translation; numbers
/// have the decimal mark of the language. English where there is no translation.
QString inWords(const Text& text);

inline QString inWords(const char* message) {
  return inWords(Text(message));
}

/// A name in the language of the window (a parameter, a handle, a part of an organ), as `named` says: a name
/// with a number behind it keeps the number. The name itself where it has no translation.
QString inWords(const std::string& name);

/// Parts and seconds in the units that texts are in.
inline constexpr double kPercent = 100, kMsPerSecond = 1000;

/// Formats a number as the language of the window writes it: "12,5" in German. With so many decimals, and
/// with so many significant digits. What is written as zero has no sign: never "-0.000".
QString formatNumber(double value, int decimals);
QString formatDigits(double value, int digits);
/// The decimal mark of the window's language, for texts that are drawn: ',' in German.
char decimalMark();
/// The separator between the numbers of a list: ", ", or "; " where decimals follow a comma: "80,5; 163,3".
QString listSeparator();

/// Parses a typed number, with the language's decimal mark or a point; empty if the text is not a number.
std::optional<double> numberIn(const QString& typed);

} // namespace viscera::app
