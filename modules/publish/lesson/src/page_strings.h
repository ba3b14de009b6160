#pragma once

#include <map>
#include <memory>
#include <string>

#include "viscera/core/phrase.h"

class QTranslator;

/// The texts of a lesson's page in its language.
namespace viscera::lesson {

/// The source text whose translation is the language code (BCP 47) of the translation itself.
inline constexpr const char* kLanguageCode = "en";

/// A text in the language of the program (`QCoreApplication::translate`, context "Lesson").
std::string said(const char* text);

/// Texts of a page in one language.
class PageWords {
public:
  /// `language` is a code of `pageLanguages`, whose translation comes with the program; empty: the language
  /// of the program. Reads a few kilobytes.
  explicit PageWords(const std::string& language = {});
  ~PageWords();
  PageWords(const PageWords&) = delete;
  PageWords& operator=(const PageWords&) = delete;

  /// A text of the context "Lesson", else a name of the numerical modules; as it is when there is no
  /// translation.
  std::string said(const char* text) const;

  /// A name of the numerical modules (resources/translations/names_*.ts): the people measured for a normal
  /// range, or a handle of a sequence. Unchanged when there is no translation.
  std::string named(const std::string& text) const;

  /// A text of the numerical modules: what a normal range means, or the phase of a sequence.
  std::string inWords(const Text& text) const;

  /// All texts of the page itself, by the keys that its script uses.
  std::map<std::string, std::string> pageStrings() const;

private:
  std::string translated(const char* context, const char* text, int number = -1) const;

  std::string language_;
  std::unique_ptr<QTranslator> translation_; ///< Null for English and for the program's own language.
};

} // namespace viscera::lesson
