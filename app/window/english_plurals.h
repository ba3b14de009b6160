#pragma once

#include <QTranslator>

namespace viscera::app {

/// Chooses singular or plural in the English texts as they stand in the source: "%n {vertex|vertices}"
/// becomes "1 vertex" or "17 vertices". Translations to other languages are installed after it and come
/// first.
class EnglishPlurals final : public QTranslator {
  Q_OBJECT

public:
  using QTranslator::QTranslator;

  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* disambiguation,
                    int n) const override;
};

} // namespace viscera::app
