#pragma once

#include <QRegularExpression>
#include <QString>

namespace viscera::tests {

/// Whether a text has words, which differ between languages. Places, numbers, units and keys are the same in
/// all of them, and so is the name of a file: "%1 ml", "Ctrl+K", "stress.csv". share_translations.py asks the
/// same.
inline bool hasWords(QString text) {
  static const QRegularExpression file(QStringLiteral(R"(^/?[a-z]+(\.[a-z0-9]+)+$)"));
  static const QRegularExpression sameEverywhere(
      QStringLiteral(R"(%n|%\d|((Ctrl|Alt|Shift)\+)+\S|\b(ml|mm|ms|min)\b)"));
  static const QRegularExpression word(QStringLiteral(R"(\p{L}{2,})"));
  return !text.contains(file) && text.remove(sameEverywhere).contains(word);
}

} // namespace viscera::tests
