#include "window/play/curve_box.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QPushButton>
#include <QSignalBlocker>

#include "viscera/presentation/presenter.h"
#include "viscera/sequences/volume_curve.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {

CurveBox::CurveBox(Workspace& workspace, Playback& playback, Settings& settings, QWidget* parent)
    : QWidget(parent), workspace_(workspace), playback_(playback), settings_(settings),
      organ_(new QComboBox(this)), choose_(new QPushButton(icon("chart"), tr("Curve..."), this)),
      remove_(new QPushButton(icon("remove"), tr("Remove"), this)), shown_(makeRemark({}, this)) {
  setObjectName(QStringLiteral("curveBox"));
  auto* grid = makeLayout<QGridLayout>(this, 4);
  organ_->setObjectName(QStringLiteral("curveOrgan"));
  organ_->setAccessibleName(tr("Organ whose volume is prescribed"));
  choose_->setObjectName(QStringLiteral("chooseCurve"));
  choose_->setToolTip(
      tr("A .csv file with two columns: the fraction of the cycle (or time_s) and the volume in ml. At each "
         "instant the handles move as little as possible to reach that volume"));
  remove_->setObjectName(QStringLiteral("removeCurve"));
  remove_->setToolTip(tr("Let the sequence alone determine the volume again"));
  grid->addWidget(organ_, 0, 0, 1, 2);
  grid->addWidget(choose_, 1, 0);
  grid->addWidget(remove_, 1, 1);
  grid->addWidget(shown_, 2, 0, 1, 2);
  connect(choose_, &QPushButton::clicked, this, &CurveBox::choose);
  connect(remove_, &QPushButton::clicked, this, [this] { playback_.prescribe(std::nullopt); });
  connect(&playback_, &Playback::stateChanged, this, &CurveBox::sync);
  sync();
}

void CurveBox::choose() {
  const QString file = QFileDialog::getOpenFileName(window(), tr("Prescribe a volume"),
                                                    settings_.value(kSequencesFolderKey).toString(),
                                                    tr("Volume curves (*.csv *.txt *.tsv)"));
  if (file.isEmpty())
    return;
  settings_.setValue(kSequencesFolderKey, QFileInfo(file).absolutePath());
  load(file);
}

void CurveBox::load(const QString& file) {
  const document::OrganId organ{organ_->currentData().toLongLong()};
  std::optional<live::PrescribedVolume> volume;
  workspace_.guarded([&] {
    volume = {organ, sequences::readVolumeCurve(file.toStdString(), playback_.player().periodSeconds()),
              QFileInfo(file).fileName().toStdString()};
  });
  if (volume && playback_.prescribe(volume))
    sync();
}

void CurveBox::sync() {
  const auto& prescribed = playback_.player().runner().prescribed();
  const qlonglong chosen = prescribed ? prescribed->organ.value : organ_->currentData().toLongLong();
  const QSignalBlocker quiet(organ_);
  organ_->clear();
  for (const auto& organ : workspace_.document().organs())
    if (organ->closed()) {
      const QString name = inWords(presentation::labelOf(*organ));
      organ_->addItem(shortenedName(name, *organ_), static_cast<qlonglong>(organ->id.value));
      organ_->setItemData(organ_->count() - 1, name, Qt::ToolTipRole);
    }
  organ_->setCurrentIndex(std::max(0, organ_->findData(chosen)));
  organ_->setEnabled(!prescribed);
  choose_->setEnabled(playback_.sequence() && organ_->count() > 0);
  remove_->setEnabled(prescribed.has_value());
  shown_->setText(prescribed ? tr("%1 follows %2; dashed in the chart.")
                                   .arg(organ_->currentText(), QString::fromStdString(prescribed->file))
                             : QString());
  shown_->setVisible(prescribed.has_value());
}

} // namespace viscera::app
