#include "window/style/icon.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace viscera::app {
namespace {

/// Draws one SVG of black lines in the palette's colours.
class TintedSvg final : public QIconEngine {
public:
  explicit TintedSvg(QString file) : file_(std::move(file)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const qreal ratio = painter->device() ? painter->device()->devicePixelRatioF() : 1.0;
    QPixmap drawn = pixmap(rect.size() * ratio, mode, state);
    if (drawn.isNull())
      return;
    drawn.setDevicePixelRatio(ratio);
    painter->drawPixmap(rect, drawn);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    if (size.isEmpty()) // A widget without room yet.
      return {};
    const QColor color = colorFor(mode, state);
    const QString key = QStringLiteral("viscera:%1:%2x%3:%4")
                            .arg(file_)
                            .arg(size.width())
                            .arg(size.height())
                            .arg(color.rgba());
    QPixmap drawn;
    if (QPixmapCache::find(key, &drawn))
      return drawn;
    drawn = QPixmap(size);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    QSvgRenderer(file_).render(&painter, QRectF(QPointF(0, 0), size));
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(drawn.rect(), color);
    painter.end();
    QPixmapCache::insert(key, drawn);
    return drawn;
  }

  QIconEngine* clone() const override { return new TintedSvg(*this); }

private:
  static QColor colorFor(QIcon::Mode mode, QIcon::State state) {
    const QPalette palette = QApplication::palette();
    if (mode == QIcon::Disabled)
      return palette.color(QPalette::Disabled, QPalette::WindowText);
    if (state == QIcon::On)
      return palette.color(QPalette::Highlight);
    return palette.color(QPalette::WindowText);
  }

  QString file_;
};

} // namespace

QIcon icon(const char* name) {
  return QIcon(new TintedSvg(QStringLiteral(":/viscera/icons/%1.svg").arg(QLatin1String(name))));
}

} // namespace viscera::app
