#include "window/english_plurals.h"

#include <QRegularExpression>

namespace viscera::app {

QString EnglishPlurals::translate(const char*, const char* source, const char*, int n) const {
  if (n < 0)
    return {};
  const QRegularExpression choice(QStringLiteral(R"(\{([^{}|]*)\|([^{}|]*)\})"));
  return QString::fromUtf8(source).replace(choice, n == 1 ? QStringLiteral("\\1") : QStringLiteral("\\2"));
}

} // namespace viscera::app
