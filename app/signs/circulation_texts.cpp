#include "signs/circulation_texts.h"

#include <QColor>
#include <QStringList>

namespace viscera::app {

QString circulationLegendText(const presentation::ShownCirculation* before, const Wording& language) {
  QStringList parts;
  for (const presentation::CirculationLine& line : presentation::circulationLegend(before)) {
    const QColor color = QColor::fromRgbF(line.color.x(), line.color.y(), line.color.z());
    parts.push_back(QStringLiteral("<span style=\"color:%1\">%2</span>&nbsp;%3")
                        .arg(color.name(), line.dashed ? QStringLiteral("- -") : QStringLiteral("&#9632;"),
                             QString::fromStdString(inWords(line.name, language)).toHtmlEscaped()));
  }
  return parts.join(QStringLiteral("&nbsp;&nbsp; "));
}

std::vector<scene::CurvePanel> circulationPanels(const presentation::ShownCirculation& shown,
                                                 const presentation::ShownCirculation* before,
                                                 const presentation::StripLook& look,
                                                 const Wording& language) {
  std::vector<scene::CurvePanel> panels = presentation::circulationStrip(shown, before, look);
  for (scene::CurvePanel& panel : panels)
    for (std::string* title : {&panel.xTitle, &panel.yTitle})
      *title = inWords(named(*title), language);
  return panels;
}

} // namespace viscera::app
