#include "window/panels/volume_box.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <utility>

#include "viscera/presentation/presenter.h"
#include "window/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {
constexpr double kSmallestMl = 0.001;
constexpr double kLargestMl = 100000;
} // namespace

VolumeBox::VolumeBox(Workspace& workspace, PoseEditor& poses, QWidget* parent)
    : QWidget(parent), workspace_(workspace), poses_(poses), field_(new QDoubleSpinBox(this)),
      apply_(new QPushButton(tr("Apply"), this)) {
  setObjectName(QStringLiteral("volumeBox"));
  auto* row = makeLayout<QHBoxLayout>(this, 8);
  auto* label = new QLabel(tr("Target"), this);
  label->setObjectName(QStringLiteral("muted"));
  label->setBuddy(field_);
  field_->setObjectName(QStringLiteral("targetVolume"));
  field_->setRange(kSmallestMl, kLargestMl);
  field_->setDecimals(1);
  field_->setSuffix(tr(" ml"));
  field_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field_->setAlignment(Qt::AlignRight);
  field_->setKeyboardTracking(false);
  field_->setAccessibleName(tr("Target volume"));
  field_->setToolTip(tr("Give the organ this volume with the smallest motion of the compensating handles, or "
                        "of all free ones"));
  apply_->setObjectName(QStringLiteral("applyVolume"));
  apply_->setToolTip(field_->toolTip());
  row->addWidget(label);
  row->addWidget(field_, 1);
  row->addWidget(apply_);
  connect(field_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] { typed_ = true; });
  connect(apply_, &QPushButton::clicked, this, [this] {
    const auto organ = workspace_.currentOrgan();
    if (organ && poses_.setVolume(organ->id, field_->value()) && organ->volumeLocked)
      workspace_.note(tr("%1 now has the target volume; its lock keeps this volume from now on.")
                          .arg(inWords(presentation::labelOf(*organ))));
    apply_->setFocus();
    typed_ = false;
    sync();
  });
  sync();
}

void VolumeBox::sync() {
  const auto organ = workspace_.currentOrgan();
  const live::OrganVolume volume = organ ? workspace_.live().volume(organ->id) : live::OrganVolume();
  setEnabled(volume.closed && organ && workspace_.live().deformer(organ->id));
  const document::OrganId current = organ ? organ->id : document::OrganId();
  if (std::exchange(shown_, current) != current)
    typed_ = false;
  if (typed_ || field_->hasFocus() || !volume.closed)
    return;
  const QSignalBlocker quiet(field_);
  field_->setDecimals(volume.restMl < 10 ? 3 : 1);
  field_->setValue(volume.nowMl);
}

} // namespace viscera::app
