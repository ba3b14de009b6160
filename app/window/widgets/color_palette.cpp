#include "window/widgets/color_palette.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QGridLayout>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QWidgetAction>

#include "viscera/anatomy/part.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

struct TissueColor {
  const char* name;
  const char* organ; ///< Its row in the table of organs.
};

/// Names are translated where they are shown.
constexpr TissueColor kTissues[] = {
    {QT_TRANSLATE_NOOP("Tissue", "Muscle"), "muscle"},
    {QT_TRANSLATE_NOOP("Tissue", "Liver"), "liver"},
    {QT_TRANSLATE_NOOP("Tissue", "Kidney"), "kidney"},
    {QT_TRANSLATE_NOOP("Tissue", "Spleen"), "spleen"},
    {QT_TRANSLATE_NOOP("Tissue", "Stomach"), "stomach"},
    {QT_TRANSLATE_NOOP("Tissue", "Bowel"), "bowel"},
    {QT_TRANSLATE_NOOP("Tissue", "Arterial blood"), "artery"},
    {QT_TRANSLATE_NOOP("Tissue", "Venous blood"), "vein"},
    {QT_TRANSLATE_NOOP("Tissue", "Lung"), "lung"},
    {QT_TRANSLATE_NOOP("Tissue", "Bone"), "bone"},
    {QT_TRANSLATE_NOOP("Tissue", "Fat"), "fat"},
    {QT_TRANSLATE_NOOP("Tissue", "Bile"), "gallbladder"},
};
constexpr int kPaletteColumns = 6;

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

void chooseColor(QWidget* parent, const QPoint& globalPlace, const QColor& present,
                 std::function<void(const QColor&)> chosen, std::function<void()> finished) {
  auto* menu = new QMenu(parent);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  auto* box = new QWidget(menu);
  auto* grid = makeLayout<QGridLayout>(box, 4, {8, 4, 8, 4});
  int index = 0;
  for (const TissueColor& tissue : kTissues) {
    auto* button = new QToolButton(box);
    const QColor color = asColor(anatomy::colorOf({tissue.organ}));
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
