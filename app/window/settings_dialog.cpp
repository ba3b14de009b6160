#include "window/settings_dialog.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "window/style/language.h"
#include "window/widgets/elided_label.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr int kSettingsWidth = 520;

QString withoutMark(QString text) {
  return text.remove(QLatin1Char('&'));
}

} // namespace

SettingsDialog::SettingsDialog(Settings& settings, const Actions& actions, QWidget* parent)
    : QDialog(parent), settings_(settings), actions_(actions) {
  setObjectName(QStringLiteral("settings"));
  setWindowTitle(tr("Settings"));
  setMinimumWidth(kSettingsWidth);
  auto* column = makeLayout<QVBoxLayout>(this, 12, {16, 16, 16, 16});
  column->addWidget(makeLook());
  column->addWidget(makeStart());
  column->addWidget(makeFolders());
  column->addWidget(
      makeRemark(tr("Lengths are in mm, volumes in ml, everywhere; numbers have the decimal mark "
                    "of the language."),
                 this));
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

QWidget* SettingsDialog::makeLook() {
  auto* box = new QGroupBox(tr("Look"), this);
  auto* form = new QFormLayout(box);
  auto* language = new QComboBox(box);
  language->setObjectName(QStringLiteral("settingsLanguage"));
  language->addItem(tr("As the system"), QString());
  for (const Language& one : languages())
    language->addItem(one.name, one.code);
  language->setCurrentIndex(std::max(0, language->findData(settings_.value("window/language").toString())));
  form->addRow(tr("Language"), language);
  auto* later = makeRemark(tr("The next start uses the language."), box);
  later->hide();
  form->addRow(later);
  connect(language, QOverload<int>::of(&QComboBox::activated), this, [this, language, later] {
    settings_.setValue("window/language", language->currentData());
    later->show();
  });
  auto* theme = new QComboBox(box);
  theme->setObjectName(QStringLiteral("settingsTheme"));
  for (const char* id : {"theme.dark", "theme.light"})
    theme->addItem(withoutMark(actions_[id]->text()), QLatin1String(id));
  theme->setCurrentIndex(actions_["theme.light"]->isChecked() ? 1 : 0);
  connect(theme, QOverload<int>::of(&QComboBox::activated), this,
          [this, theme] { actions_[theme->currentData().toByteArray().constData()]->setChecked(true); });
  form->addRow(tr("Theme"), theme);
  for (const char* id : {"view.shading", "view.cube", "view.scale", "view.handles"})
    addSwitch(*form, actions_[id]);
  auto* layout = new QPushButton(withoutMark(actions_["view.layout"]->text()), box);
  connect(layout, &QPushButton::clicked, actions_["view.layout"], &QAction::trigger);
  form->addRow(layout);
  return box;
}

QWidget* SettingsDialog::makeStart() {
  auto* box = new QGroupBox(tr("Start"), this);
  auto* form = new QFormLayout(box);
  auto* welcome = new QCheckBox(tr("Show the welcome"), box);
  welcome->setObjectName(QStringLiteral("settingsWelcome"));
  welcome->setChecked(settings_.value("window/welcome", true).toBool());
  connect(welcome, &QCheckBox::toggled, this, [this](bool on) { settings_.setValue("window/welcome", on); });
  form->addRow(welcome);
  return box;
}

QWidget* SettingsDialog::makeFolders() {
  auto* box = new QGroupBox(tr("Folders that dialogs begin in"), this);
  auto* form = new QFormLayout(box);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  addFolder(*form, tr("Organs and sessions"), kFolderKey, QStandardPaths::DocumentsLocation);
  addFolder(*form, tr("Sequences"), kSequencesFolderKey, QStandardPaths::DocumentsLocation);
  addFolder(*form, tr("Pictures"), kPicturesFolderKey, QStandardPaths::PicturesLocation);
  addFolder(*form, tr("Movies"), kMoviesFolderKey, QStandardPaths::MoviesLocation);
  return box;
}

void SettingsDialog::addFolder(QFormLayout& form, const QString& name, const char* key,
                               QStandardPaths::StandardLocation standard) {
  auto* row = new QWidget(this);
  auto* layout = makeLayout<QHBoxLayout>(row, 8);
  auto* place = new QLabel(row);
  place->setObjectName(QLatin1String(key));
  place->setTextInteractionFlags(Qt::TextSelectableByMouse);
  place->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  const auto tell = [this, place, key, standard] {
    const QString folder = QDir::toNativeSeparators(settings_.folder(key, standard));
    place->setToolTip(folder);
    place->setText(place->fontMetrics().elidedText(folder, Qt::ElideMiddle, kSettingsWidth / 2));
  };
  tell();
  auto* choose = new QPushButton(tr("Choose..."), row);
  choose->setAccessibleName(name);
  layout->addWidget(place, 1);
  layout->addWidget(choose);
  connect(choose, &QPushButton::clicked, this, [this, name, key, standard, tell] {
    const QString chosen = QFileDialog::getExistingDirectory(this, name, settings_.folder(key, standard));
    if (chosen.isEmpty())
      return;
    settings_.setValue(key, chosen);
    tell();
  });
  form.addRow(name, row);
}

void SettingsDialog::addSwitch(QFormLayout& form, QAction* action) {
  auto* check = new QCheckBox(withoutMark(action->text()), this);
  check->setObjectName(QStringLiteral("settings.") + action->objectName());
  check->setToolTip(action->toolTip());
  check->setChecked(action->isChecked());
  connect(check, &QCheckBox::toggled, action, [action](bool on) {
    if (action->isChecked() != on)
      action->trigger();
  });
  connect(action, &QAction::toggled, check, &QCheckBox::setChecked);
  form.addRow(check);
}

} // namespace viscera::app
