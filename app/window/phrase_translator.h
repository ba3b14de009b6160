#pragma once

#include <QTranslator>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace viscera::app {

/// Qt's translator, which also translates texts that the numerical modules put together from parts
/// (viscera/core/phrase.h): it finds the pattern from which a text was made, and translates the pattern and
/// the parts. "Lock 3 handles" was made from "Lock {handle|%n handles}", and becomes "3 Griffe sperren" in
/// German.
///
///     PhraseTranslator translator;
///     translator.load("viscera_de", ":/viscera/translations");
///     translator.readPatterns(":/viscera/translations/names_de.ts");
class PhraseTranslator final : public QTranslator {
  Q_OBJECT

public:
  using QTranslator::QTranslator;

  /// Reads the patterns, texts with places for parts, from a file of translations. A file that cannot be read
  /// has no patterns.
  void readPatterns(const QString& file);

  /// Takes the names and messages of a plugin out of a compiled file of translations. What the program itself
  /// has comes first, so that a plugin cannot rename it. Returns whether the file could be read.
  bool addPlugin(const QString& file);

  /// A text of the context of `messageInWords` that is no literal of the sources is taken for one that was
  /// put together. Null when no pattern gives it.
  QString translate(const char* context, const char* source, const char* disambiguation = nullptr,
                    int n = -1) const override;

private:
  /// What one form of a pattern, for one or for several, looks like.
  struct Form {
    QString source;     ///< The source text of the pattern in the file of translations.
    bool one = true;    ///< For the number 1, or without any number.
    bool joins = false; ///< It has no words of its own ("%1: %2"), and would be found in nearly any text.
    QStringList literals;
    std::vector<int> places; ///< Between the literals: 1 to 9; 0 is the number.
  };
  static Form formOf(const QString& source, bool one);
  /// The parts of a text at the places of a form, in their order; empty if the text does not match the form.
  static std::optional<QStringList> partsIn(const QString& text, const Form& form);
  QString made(const Form& form, const QStringList& parts) const;
  /// Translates by the exact text, else by the most specific pattern that matches it, with a capital letter
  /// or without; those that only join their parts come last.
  QString translateWhole(const QString& text) const;
  /// The translation of exactly this text, here or of a plugin; null when there is none.
  QString exactly(const char* text, int n = -1) const;
  /// The translation of a name with a number behind it, as sequences name handles ("LV endocardium 3"); null
  /// when the name has none.
  QString numbered(const std::string& text) const;
  /// The translation of two names joined by a colon, such as the name of a circulation's beat ("Heartbeat:
  /// Rest"), if the pattern of the first ("Heartbeat: %1") has a translation; else null.
  QString ofTwoNames(const QString& text) const;
  /// A part of a text: in words where it has a translation, a number with the decimal mark of the language,
  /// and what stands in quotes as it is, with the marks of the language.
  QString inWords(const QString& text) const;

  std::vector<std::unique_ptr<QTranslator>> plugins_;
  std::vector<Form> forms_; ///< Those with more letters of their own come first.
};

/// Translates a message of the numerical modules (steps, warnings, errors, tasks) into the language of the
/// window; as it is when it has no translation. Names are not messages: an organ may be called "Open heart",
/// which is no step (`inWords`). A phase of a sequence is a message here: the keys of a key sequence are
/// numbered ("key 3").
QString messageInWords(const std::string& text);

} // namespace viscera::app
