#pragma once

#include <QTranslator>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace viscera::app {

/// Qt's translator, which also translates texts that the numerical modules put together from parts
/// (viscera/core/phrase.h): it finds the pattern that a text was made of, and translates the pattern and the
/// parts. "Lock 3 handles" was made of "Lock {handle|%n handles}", and is "3 Griffe sperren" in German.
///
///     PhraseTranslator translator;
///     translator.load("viscera_de", ":/viscera/translations");
///     translator.readPatterns(":/viscera/translations/names_de.ts");
class PhraseTranslator final : public QTranslator {
  Q_OBJECT

public:
  using QTranslator::QTranslator;

  /// Takes the texts with places in them out of a file of translations. One that cannot be read has none.
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
    QString source;     ///< Of the pattern, as the file of translations has it.
    bool one = true;    ///< For the number 1, or without any number.
    bool joins = false; ///< It has no words of its own ("%1: %2"), and would be found in nearly any text.
    QStringList literals;
    std::vector<int> places; ///< Between the literals: 1 to 9; 0 is the number.
  };
  static Form formOf(const QString& source, bool one);
  /// What a text has in the places of a form, in their order; nothing when the form did not make it.
  static std::optional<QStringList> partsIn(const QString& text, const Form& form);
  QString made(const Form& form, const QStringList& parts) const;
  /// By the exact text, else by the most particular pattern that gives it, with a capital letter or without;
  /// those that only join their parts come last.
  QString translateWhole(const QString& text) const;
  /// The translation of exactly this text, here or of a plugin; null when there is none.
  QString exactly(const char* text, int n = -1) const;
  /// Of a name with a number behind it, as sequences give to handles ("LV endocardium 3"): the name's
  /// translation with the number; null when there is none.
  QString numbered(const std::string& text) const;
  /// Of a name that another follows, as a circulation's beat has it ("Heartbeat: Rest"), where the pattern
  /// of the first ("Heartbeat: %1") has a translation; else null.
  QString ofTwoNames(const QString& text) const;
  /// A part of a text: in words where it has a translation, a number with the decimal mark of the language,
  /// and what stands in quotes as it is, with the marks of the language.
  QString inWords(const QString& text) const;

  std::vector<std::unique_ptr<QTranslator>> plugins_;
  std::vector<Form> forms_; ///< Those with more letters of their own come first.
};

/// What the numerical modules say in English (steps, warnings, errors, tasks), in the language of the window;
/// as it is when it has no translation. Names are not messages: an organ may be called "Open heart", which is
/// no step (`inWords`). A phase of a sequence is a message here: the keys of a recorded one are numbered
/// ("key 3").
QString messageInWords(const std::string& text);

} // namespace viscera::app
