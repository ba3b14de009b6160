#include "window/panels/color_palette.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QGridLayout>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QWidgetAction>

#include <utility>

#include "viscera/presentation/presenter.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

struct TissueColor {
  const char* name;
  const char* color;
};

/// Names are translated where they are shown.
constexpr TissueColor kTissues[] = {
    {QT_TRANSLATE_NOOP("Tissue", "Muscle"), "#b5483f"},
    {QT_TRANSLATE_NOOP("Tissue", "Liver"), "#9b4a3c"},
    {QT_TRANSLATE_NOOP("Tissue", "Kidney"), "#b0604f"},
    {QT_TRANSLATE_NOOP("Tissue", "Spleen"), "#8d4a63"},
    {QT_TRANSLATE_NOOP("Tissue", "Stomach"), "#d99a86"},
    {QT_TRANSLATE_NOOP("Tissue", "Bowel"), "#e0b39a"},
    {QT_TRANSLATE_NOOP("Tissue", "Arterial blood"), "#cf3a32"},
    {QT_TRANSLATE_NOOP("Tissue", "Venous blood"), "#4b66b8"},
    {QT_TRANSLATE_NOOP("Tissue", "Lung"), "#e3aaa9"},
    {QT_TRANSLATE_NOOP("Tissue", "Bone"), "#e9e0c9"},
    {QT_TRANSLATE_NOOP("Tissue", "Fat"), "#e8cf7a"},
    {QT_TRANSLATE_NOOP("Tissue", "Bile"), "#6f8f4e"},
};
constexpr int kPaletteColumns = 6;

/// Words in the names of files and segments, English and Latin; the first that fits counts.
constexpr std::pair<const char*, const char*> kWords[] = {
    {"liver", "#9b4a3c"},    {"hepar", "#9b4a3c"},   {"kidney", "#b0604f"},   {"ren_", "#b0604f"},
    {"spleen", "#8d4a63"},   {"stomach", "#d99a86"}, {"bowel", "#e0b39a"},    {"colon", "#d8a58c"},
    {"intestin", "#e0b39a"}, {"duoden", "#dfae94"},  {"pancrea", "#e0b878"},  {"gall", "#6f8f4e"},
    {"lung", "#e3aaa9"},     {"bone", "#e9e0c9"},    {"vertebra", "#e9e0c9"}, {"rib", "#e9e0c9"},
    {"aorta", "#cf3a32"},    {"arter", "#cf3a32"},   {"vein", "#4b66b8"},     {"cava", "#4b66b8"},
    {"portal", "#4b66b8"},   {"heart", "#a8483f"},   {"muscle", "#b5483f"},   {"bladder", "#d9b36a"},
    {"brain", "#e3c4b8"},    {"tumo", "#c9b13d"}};

void openDialog(QWidget* parent, const QColor& present, const std::function<void(const QColor&)>& chosen,
                const std::function<void()>& finished) {
  auto* dialog = new QColorDialog(present, parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setModal(false);
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  QObject::connect(dialog, &QColorDialog::currentColorChanged, parent, chosen);
  QObject::connect(dialog, &QColorDialog::finished, parent, [=](int result) {
    if (result == QDialog::Rejected)
      chosen(present);
    finished();
  });
  dialog->show();
}

} // namespace

QColor asColor(const Vec3& color) {
  return QColor::fromRgbF(color.x(), color.y(), color.z());
}

Vec3 asVec3(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}

QIcon swatch(const QColor& color) {
  QIcon icon;
  for (const int scale : {1, 2}) {
    QPixmap pixmap(16 * scale, 16 * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color.darker(140), 1));
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(2.5, 2.5, 11, 11), 3, 3);
    painter.end();
    // The same in every state: a selected row does not tint the colour of an organ.
    icon.addPixmap(pixmap, QIcon::Normal);
    icon.addPixmap(pixmap, QIcon::Selected);
  }
  return icon;
}

std::optional<QColor> tissueColor(const QString& name) {
  for (const auto& [word, color] : kWords)
    if (name.contains(QLatin1String(word), Qt::CaseInsensitive))
      return QColor(QLatin1String(color));
  return std::nullopt;
}

std::optional<Vec3> tissueColorFor(const QString& name, const document::Organ& organ) {
  const document::OrganLook& look = organ.look;
  document::OrganLook paintedAlike;
  paintedAlike.color = look.color;
  paintedAlike.vertexColors = false;
  const bool plain = look == document::OrganLook() && organ.mesh && organ.mesh->colors.rows() == 0;
  const bool numbered = look == paintedAlike && presentation::shownColor(look.color) != look.color;
  const auto color = plain || numbered ? tissueColor(name) : std::nullopt;
  return color ? std::optional(asVec3(*color)) : std::nullopt;
}

void chooseColor(QWidget* parent, const QPoint& globalPlace, const QColor& present,
                 std::function<void(const QColor&)> chosen, std::function<void()> finished) {
  auto* menu = new QMenu(parent);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  auto* box = new QWidget(menu);
  auto* grid = makeLayout<QGridLayout>(box, 4, {8, 4, 8, 4});
  int index = 0;
  for (const TissueColor& tissue : kTissues) {
    auto* button = new QToolButton(box);
    const QColor color(QLatin1String(tissue.color));
    button->setIcon(swatch(color));
    button->setIconSize(QSize(20, 20));
    button->setToolTip(QCoreApplication::translate("Tissue", tissue.name));
    button->setAccessibleName(button->toolTip());
    grid->addWidget(button, index / kPaletteColumns, index % kPaletteColumns);
    QObject::connect(button, &QToolButton::clicked, parent, [=] {
      menu->close();
      chosen(color);
      finished();
    });
    ++index;
  }
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(box);
  menu->addAction(action);
  menu->addSeparator();
  QObject::connect(menu->addAction(QCoreApplication::translate("Tissue", "Another colour...")),
                   &QAction::triggered, parent, [=] { openDialog(parent, present, chosen, finished); });
  menu->popup(globalPlace);
}

} // namespace viscera::app
