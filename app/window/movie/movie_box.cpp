#include "window/movie/movie_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

#include "viscera/scene/movie_writer.h"
#include "window/style/icon.h"
#include "window/widgets/new_file.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr QSize kSizes[] = {{1280, 720}, {1920, 1080}, {960, 540}, {640, 480}, {1080, 1080}};
constexpr int kMostFrames = 60;
constexpr int kMostCycles = 100;

QFormLayout* formOf(QWidget* widget) {
  return widget->findChild<QFormLayout*>();
}

} // namespace

MovieBox::MovieBox(Settings& settings, QWidget* parent) : QWidget(parent), settings_(settings) {
  setObjectName(QStringLiteral("recordBox"));
  auto* column = makeLayout<QVBoxLayout>(this, 8);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  column->addLayout(form);
  makeControls();
  column->addWidget(caption_);
  column->addWidget(table_);
  column->addWidget(missing_);
  column->addWidget(record_);
  connect(format_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    chosen_ = false;
    syncFormat();
  });
  connect(table_, &QCheckBox::toggled, this, &MovieBox::proposeFile);
  connect(file_, &QLineEdit::textEdited, this, [this] { chosen_ = true; });
  connect(record_, &QPushButton::clicked, this, [this] {
    if (running_)
      return Q_EMIT cancelRequested();
    settings_.setValue(kMoviesFolderKey, QFileInfo(file_->text()).absolutePath());
    Q_EMIT recordRequested(plan());
  });
  refresh();
}

void MovieBox::addRow(const QString& name, QWidget* control) {
  auto* label = new QLabel(name, this);
  label->setObjectName(QStringLiteral("muted"));
  label->setBuddy(control);
  control->setAccessibleName(name);
  formOf(this)->addRow(label, control);
}

void MovieBox::makeControls() {
  format_ = new QComboBox(this);
  format_->setObjectName(QStringLiteral("recordFormat"));
  for (const MovieFormatInfo& info : movieFormats())
    format_->addItem(info.name, static_cast<int>(info.format));
  addRow(tr("Kind"), format_);
  file_ = new QLineEdit(this);
  file_->setObjectName(QStringLiteral("recordFile"));
  auto* browse = makeIconButton("open", tr("Choose a destination"), this);
  connect(browse, &QToolButton::clicked, this, &MovieBox::chooseFile);
  auto* place = new QWidget(this);
  auto* row = makeLayout<QHBoxLayout>(place, 4);
  row->addWidget(file_, 1);
  row->addWidget(browse);
  addRow(tr("File"), place);
  size_ = new QComboBox(this);
  size_->setObjectName(QStringLiteral("recordSize"));
  for (const QSize& size : kSizes)
    size_->addItem(tr("%1 x %2").arg(size.width()).arg(size.height()), size);
  addRow(tr("Size"), size_);
  rate_ = new QSpinBox(this);
  rate_->setObjectName(QStringLiteral("recordRate"));
  rate_->setRange(1, kMostFrames);
  rate_->setValue(25);
  rate_->setSuffix(tr(" / s"));
  addRow(tr("Frames"), rate_);
  cycles_ = new QSpinBox(this);
  cycles_->setObjectName(QStringLiteral("recordCycles"));
  cycles_->setRange(1, kMostCycles);
  addRow(tr("Cycles"), cycles_);
  caption_ = new QCheckBox(tr("Write phase and volumes into it"), this);
  caption_->setChecked(true);
  table_ = new QCheckBox(tr("Table of volumes beside it (.csv)"), this);
  table_->setObjectName(QStringLiteral("recordTable"));
  missing_ = makeRemark({}, this);
  record_ = new QPushButton(this);
  record_->setObjectName(QStringLiteral("recordButton"));
}

MovieFormat MovieBox::format() const {
  return static_cast<MovieFormat>(format_->currentData().toInt());
}

MoviePlan MovieBox::plan() const {
  MoviePlan plan;
  plan.format = format();
  plan.file = file_->text();
  plan.size = size_->currentData().toSize();
  plan.framesPerSecond = rate_->value();
  plan.cycles = cycles_->value();
  plan.caption = caption_->isChecked();
  plan.table = table_->isChecked();
  return plan;
}

void MovieBox::setName(const QString& name) {
  name_ = name;
  proposeFile();
}

void MovieBox::setRunning(bool running) {
  const bool ended = running_ && !running;
  running_ = running;
  for (QWidget* control : std::initializer_list<QWidget*>{format_, file_, size_, rate_, cycles_, caption_})
    control->setEnabled(!running);
  record_->setText(running ? tr("Cancel the movie") : tr("Record"));
  record_->setIcon(icon(running ? "close" : "record"));
  record_->setToolTip(running ? tr("Discard the movie") : tr("Record what the view shows"));
  if (ended)
    chosen_ = false;
  syncFormat();
}

void MovieBox::refresh() {
  const bool ffmpeg = scene::ffmpegInstalled();
  auto* items = qobject_cast<QStandardItemModel*>(format_->model());
  for (const MovieFormatInfo& info : movieFormats()) {
    const int row = format_->findData(static_cast<int>(info.format));
    items->item(row)->setEnabled(ffmpeg || !info.needsFfmpeg);
  }
  if (!ffmpeg && infoOf(format()).needsFfmpeg)
    format_->setCurrentIndex(format_->findData(static_cast<int>(MovieFormat::ogg)));
  missing_->setText(tr("MP4 and GIF need the program ffmpeg, which is not installed on this computer."));
  missing_->setVisible(!ffmpeg);
  setRunning(running_);
}

void MovieBox::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void MovieBox::syncFormat() {
  const bool drawn = infoOf(format()).drawn;
  size_->setEnabled(drawn && !running_);
  caption_->setEnabled(drawn && !running_);
  table_->setEnabled(drawn && !running_);
  proposeFile();
}

void MovieBox::proposeFile() {
  if (chosen_ || running_)
    return;
  const QString folder = settings_.folder(kMoviesFolderKey, QStandardPaths::MoviesLocation);
  file_->setText(freeMovieFile(folder, name_.isEmpty() ? QStringLiteral("viscera") : name_, format(),
                               table_->isEnabled() && table_->isChecked()));
  file_->setToolTip(file_->text());
}

void MovieBox::chooseFile() {
  const MovieFormatInfo info = infoOf(format());
  const QString file =
      info.ending.isEmpty()
          ? QFileDialog::getExistingDirectory(this, tr("Folder for the pictures"), file_->text())
          : QFileDialog::getSaveFileName(this, tr("Record as"), file_->text(),
                                         QStringLiteral("%1 (*%2)").arg(info.name, info.ending));
  if (file.isEmpty())
    return;
  const QString named = info.ending.isEmpty() ? file : asNewFile(this, file, {info.ending});
  if (named.isEmpty())
    return;
  file_->setText(named);
  file_->setToolTip(file_->text());
  chosen_ = true;
}

} // namespace viscera::app
