#include "viscera/report/report_file.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <vector>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QByteArray>
#include <QEventLoop>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QScreen>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>
#include <QUrl>

#include "page_markup.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/report/fonts_at_hand.h"
#include "words.h"

namespace viscera::report {
namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kBrowserDpi = 96; ///< Of CSS pixels.

constexpr double kPageWidthMm = 210, kPageHeightMm = 297;
constexpr double kTopMm = 20, kBottomMm = 20; ///< Head and foot lie in these margins.
constexpr double kHeadMm = 12, kFootMm = 285; ///< Their base lines from the upper edge.
constexpr int kResolution = 600;              ///< Dots per inch: to place letters by.
/// A heading that stands lower on its page than this goes to the next one.
constexpr double kLowestHeading = 0.84;

constexpr const char* kFamilies[] = {"Noto Sans", "DejaVu Sans", "Liberation Sans", "Arial", "Helvetica"};

constexpr const char* kPdfStyle = R"(
h1 { font-size: 19pt; font-weight: 600; color: #14323a; margin-top: 0; margin-bottom: 0; }
h2 { font-size: 12.5pt; font-weight: 600; color: #00798c; margin-top: 16px; margin-bottom: 5px; }
p.made { font-size: 8.5pt; color: #5c6870; margin-top: 1px; margin-bottom: 9px; }
p.text { font-size: 8.5pt; color: #39434b; margin-top: 4px; margin-bottom: 5px; }
p.picture { margin-top: 6px; margin-bottom: 6px; }
.caption { font-size: 8pt; color: #5c6870; }
td.name { color: #5c6870; }
table.facts { margin-top: 6px; margin-bottom: 6px; }
table.numbers { margin-top: 5px; margin-bottom: 6px; border-collapse: collapse; border-style: none; }
table.numbers th { font-size: 8pt; font-weight: 600; color: #39434b; background-color: #e8f1f3; }
)";

constexpr const char* kBrowserStyle = R"(
body { font: 15px/1.45 "Noto Sans", "DejaVu Sans", "Liberation Sans", Arial, Helvetica, sans-serif; color: #22272b;
  background: #fff; max-width: 190mm; margin: 10mm auto; padding: 0 8mm; }
h1 { font-size: 28px; font-weight: 600; color: #14323a; margin: 0; }
h2 { font-size: 19px; font-weight: 600; color: #00798c; margin: 30px 0 8px; break-after: avoid; }
p.made { font-size: 13px; color: #5c6870; margin: 2px 0 14px; }
p.text { font-size: 13px; color: #39434b; }
p.picture { margin: 12px 0; break-inside: avoid; }
img { max-width: 100%; height: auto; }
.caption { font-size: 13px; color: #5c6870; }
table { border-collapse: collapse; margin: 6px 0 10px; font-variant-numeric: tabular-nums; }
td, th { vertical-align: top; }
td.name { color: #5c6870; padding-right: 18px; width: auto; white-space: nowrap; }
table.numbers { font-size: 14px; }
table.numbers th { font-size: 13px; font-weight: 600; color: #39434b; background: #e8f1f3; }
table.numbers td { border-bottom: 1px solid #d5dde2; }
table.numbers th, table.numbers td { padding: 4px 6px; }
tr { break-inside: avoid; }
@page { size: A4; margin: 18mm; }
@media print { body { margin: 0; padding: 0; max-width: none; font-size: 12px; } }
)";

std::vector<const Picture*> picturesOf(const Report& report) {
  std::vector<const Picture*> pictures;
  for (const Section& section : report.sections)
    for (const Block& block : section.blocks)
      if (const auto* grid = std::get_if<PictureGrid>(&block))
        for (const Picture& picture : grid->pictures)
          pictures.push_back(&picture);
  return pictures;
}

/// The text in one line, without what no font draws.
QString printable(const std::string& text) {
  QString line;
  for (const QChar letter : QString::fromStdString(text))
    if (letter.isPrint() || letter.isSpace())
      line += letter.isSpace() ? QChar(QLatin1Char(' ')) : letter;
  return line;
}

QFont textFont() {
  QFont font;
  const QStringList there = QFontDatabase().families();
  for (const char* family : kFamilies)
    if (there.contains(QLatin1String(family))) {
      font.setFamily(QLatin1String(family));
      break;
    }
  font.setStyleHint(QFont::SansSerif);
  font.setPointSizeF(9);
  return font;
}

/// The pages of a report, laid out for a device.
class PdfPages {
public:
  PdfPages(const Report& report, QPdfWriter& writer) : report_(report), writer_(writer), font_(textFont()) {
    text_.documentLayout()->setPaintDevice(&writer);
    text_.setDefaultFont(font_);
    text_.setDefaultStyleSheet(QLatin1String(kPdfStyle));
    text_.setDocumentMargin(0);
    const auto pictures = picturesOf(report);
    for (std::size_t i = 0; i < pictures.size(); ++i)
      text_.addResource(QTextDocument::ImageResource, QUrl(QString::fromStdString(nameOf(i))),
                        QImage::fromData(reinterpret_cast<const uchar*>(pictures[i]->png.data()),
                                         static_cast<int>(pictures[i]->png.size())));
    // Qt's rich text counts in pixels of the screen, and scales them to the device.
    const double pixelsPerMm = QGuiApplication::primaryScreen()->logicalDotsPerInchY() / kMmPerInch;
    text_.setHtml(QString::fromStdString(bodyOf(report, nameOf, pixelsPerMm)));
    text_.setPageSize({dots(kTextWidthMm), dots(kPageHeightMm - kTopMm - kBottomMm)});
    ruleTables(text_.rootFrame());
    keepTogether();
  }

  int count() const { return text_.pageCount(); }

  void paint() {
    QPainter painter(&writer_);
    for (int page = 0; page < count(); ++page) {
      if (page > 0)
        writer_.newPage();
      paintPage(painter, page);
    }
  }

private:
  static std::string nameOf(std::size_t place) { return "picture-" + std::to_string(place); }
  static double dots(double mm) { return mm / kMmPerInch * kResolution; }

  /// A thin line below each row: the eye keeps to it.
  static void ruleTables(QTextFrame* frame);
  /// A heading stays with what follows, and a picture with what is written below it.
  void keepTogether();
  void paintPage(QPainter& painter, int page) const;

  const Report& report_;
  QPdfWriter& writer_;
  QFont font_;
  QTextDocument text_;
};

void PdfPages::ruleTables(QTextFrame* frame) {
  for (QTextFrame* child : frame->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(child);
    if (table && table->format().headerRowCount() > 0)
      for (int row = 0; row < table->rows(); ++row)
        for (int column = 0; column < table->columns(); ++column) {
          QTextTableCell cell = table->cellAt(row, column);
          QTextTableCellFormat format = cell.format().toTableCellFormat();
          format.setBottomBorder(0.5);
          format.setBottomBorderStyle(QTextFrameFormat::BorderStyle_Solid);
          format.setBottomBorderBrush(QColor(0xd5, 0xdd, 0xe2));
          cell.setFormat(format);
        }
    ruleTables(child);
  }
}

void PdfPages::keepTogether() {
  const double height = text_.pageSize().height();
  for (QTextBlock block = text_.begin(); block.isValid(); block = block.next()) {
    const QRectF place = text_.documentLayout()->blockBoundingRect(block);
    const bool heading = block.blockFormat().headingLevel() > 0;
    const bool split = std::floor(place.top() / height) != std::floor((place.bottom() - 1) / height);
    const bool low = std::fmod(place.top(), height) > kLowestHeading * height;
    if ((heading && low) || (split && !QTextCursor(block).currentTable())) {
      QTextCursor cursor(block);
      QTextBlockFormat format = block.blockFormat();
      format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
      cursor.setBlockFormat(format);
      text_.setPageSize(text_.pageSize()); // Anew from the top: Qt leaves tables that follow where they were.
    }
  }
}

void PdfPages::paintPage(QPainter& painter, int page) const {
  const double left = dots((kPageWidthMm - kTextWidthMm) / 2), width = dots(kTextWidthMm);
  const double height = text_.pageSize().height();
  painter.save();
  painter.translate(left, dots(kTopMm) - page * height);
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = QRectF(0, page * height, width, height);
  context.palette.setColor(QPalette::Text, QColor(0x22, 0x27, 0x2b));
  painter.setClipRect(context.clip);
  text_.documentLayout()->draw(&painter, context);
  painter.restore();

  QFont small(font_);
  small.setPointSizeF(8);
  painter.setFont(small);
  painter.setPen(QColor(0x5c, 0x68, 0x70));
  const auto write = [&](double y, Qt::Alignment side, const std::string& text) {
    const QFontMetricsF metrics(small, &writer_);
    const QString shown = metrics.elidedText(printable(text), Qt::ElideRight, 0.8 * width);
    painter.drawText(QRectF(left, dots(y) - metrics.height(), width, metrics.height()), side, shown);
  };
  if (page > 0) {
    write(kHeadMm, Qt::AlignLeft, report_.title);
    painter.fillRect(QRectF(left, dots(kHeadMm + 1.5), width, dots(0.15)), QColor(0xd5, 0xdd, 0xe2));
  }
  write(kFootMm, Qt::AlignLeft, report_.made);
  write(kFootMm, Qt::AlignRight, said("Page %1 of %2", std::to_string(page + 1), std::to_string(count())));
}

int writePdf(const std::filesystem::path& file, const Report& report) {
  const FontsAtHand fonts;
  const QEventLoop
      timers;     // Rich text is laid out with a timer, for which a thread that is not Qt's has no place.
  QBuffer buffer; // Qt does not say when it cannot write to a file.
  buffer.open(QIODevice::WriteOnly);
  int pages = 0;
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(QString::fromStdString(report.title));
    writer.setCreator(QStringLiteral("Viscera " VISCERA_VERSION));
    PdfPages laidOut(report, writer);
    pages = laidOut.count();
    laidOut.paint();
  }
  const QByteArray& pdf = buffer.data();
  writeAtomically(file, [&](std::ostream& out) { out.write(pdf.constData(), pdf.size()); });
  return pages;
}

bool isPdf(const std::filesystem::path& file) {
  return file.extension() == ".pdf";
}

} // namespace

bool isReportFile(const std::filesystem::path& file) {
  return isPdf(file) || file.extension() == ".html" || file.extension() == ".htm";
}

std::string htmlOf(const Report& report) {
  const auto pictures = picturesOf(report);
  const auto inside = [&](std::size_t place) {
    return "data:image/png;base64," +
           QByteArray::fromStdString(pictures[place]->png).toBase64().toStdString();
  };
  return "<!DOCTYPE html>\n<html lang=\"" + QLocale().bcp47Name().toStdString() +
         "\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
         "style-src 'unsafe-inline'\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(report.title) + "</title>\n<style>" + kBrowserStyle + "</style>\n</head>\n<body>\n" +
         bodyOf(report, inside, kBrowserDpi / kMmPerInch) + "</body>\n</html>\n";
}

int writeReport(const std::filesystem::path& file, const Report& report) {
  if (!isReportFile(file))
    throw UsageError("A report cannot be written to this kind of file", file.string(),
                     "let it end in .pdf or .html");
  if (isPdf(file))
    return writePdf(file, report);
  writeAtomically(file, [&](std::ostream& out) { out << htmlOf(report); });
  return 1;
}

} // namespace viscera::report
