#include "window/handles/system_box.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

#include "viscera/document/system_commands.h"
#include "viscera/presentation/space_parts.h"
#include "window/style/language.h"
#include "window/widgets/flow_layout.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/system_combo.h"
#include "window/widgets/value_slider.h"

namespace viscera::app {
namespace {

/// A step that leaves two to three hundred places on the slider, round in decimals.
double stepFor(const coordinates::Parameter& parameter, double maximum) {
  if (parameter.integer)
    return 1;
  return std::pow(10.0, std::floor(std::log10((maximum - parameter.minimum) / 50)));
}

/// The slider's range when the handles bound the parameter by `bound` (infinite: they do not). It begins at
/// a whole step, so that its places are round numbers.
ValueSlider::Range rangeOf(const coordinates::Parameter& parameter, double bound) {
  const double maximum = std::max(std::min(parameter.maximum, bound), 2 * parameter.minimum);
  const double step = stepFor(parameter, maximum);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 0.5)));
  const QString unit = parameter.unit.empty() ? QString() : QLatin1Char(' ') + text(parameter.unit);
  if (!std::isfinite(bound))
    return {parameter.minimum, maximum, step, decimals, unit};
  // Ends that move with the handles stay on the steps, or the slider would pull the value along.
  const double top = step * std::ceil(maximum / step);
  return {step * std::ceil(parameter.minimum / step), std::min(top, parameter.maximum), step, decimals, unit};
}

} // namespace

SystemBox::SystemBox(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), combo_(new SystemCombo(workspace.registry(), this)),
      summary_(makeRemark({}, this)), badges_(new QWidget(this)), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(8);
  combo_->setObjectName(QStringLiteral("systems"));
  combo_->setAccessibleName(tr("Coordinates"));
  combo_->setToolTip(tr("Coordinate system that binds the organs to the handles"));
  new FlowLayout(badges_, 4);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  badges_->setSizePolicy(policy);
  column_->addWidget(combo_);
  column_->addWidget(summary_);
  column_->addWidget(badges_);
  connect(combo_, &SystemCombo::systemChosen, this, [this](const std::string& id) {
    document::SystemChoice choice;
    choice.id = id;
    workspace_.undo().seal();
    workspace_.perform(document::setSystem(choice));
    workspace_.undo().seal();
  });
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.system() || change.rig())
      sync();
  });
  sync();
}

void SystemBox::sync() {
  const document::SystemChoice& choice = workspace_.document().system();
  combo_->setSystem(choice.id);
  if (choice.id != shownSystem_ && workspace_.registry().contains(choice.id)) {
    shownSystem_ = choice.id;
    const auto system = workspace_.registry().find(choice.id);
    summary_->setText(inWords(system->summary()));
    rebuildBadges(system->traits());
    rebuildParameters();
  }
  if (!readers_.empty()) // Computed anew, about a millisecond.
    upperBounds_ = presentation::layoutOf(workspace_.state(), workspace_.registry()).upperBounds;
  for (const auto& read : readers_)
    read();
}

void SystemBox::rebuildBadges(const coordinates::Traits& traits) {
  while (QLayoutItem* item = badges_->layout()->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  const auto badge = [this](bool shown, const QString& label, const QString& tip) {
    if (!shown)
      return;
    auto* widget = new QLabel(label, badges_);
    widget->setObjectName(QStringLiteral("traitBadge"));
    widget->setToolTip(tip);
    badges_->layout()->addWidget(widget);
  };
  badge(!traits.needsCage, tr("no cage"), tr("Handles may stand anywhere around the organ"));
  badge(traits.needsCage, tr("cage"),
        tr("Works with a closed surface over the handles: their convex hull, or a cage that was loaded"));
  badge(traits.positive, tr("positive"),
        tr("No coordinate is negative: the organ follows the direction of every handle"));
  badge(traits.interpolates, tr("interpolating"), tr("A point at a handle follows it exactly"));
  badge(traits.closedFormGradient, tr("exact gradient"), tr("Stress is computed without differences"));
  badge(!traits.everywhere, tr("gaps"),
        tr("Some points inside the hull have no coordinates and do not move"));
  badge(!traits.continuous, tr("jumps"), tr("Neighbouring points may move very differently"));
  badge(traits.continuous && !traits.smooth, tr("kinks"), tr("The deformed organ may show creases"));
  badge(traits.usesGroups, tr("groups"), tr("Handles act by their groups"));
  badge(traits.needsTetrahedra, tr("tetrahedra"), tr("Fills the organ with tetrahedra first"));
}

void SystemBox::rebuildParameters() {
  readers_.clear();
  delete parameterBox_;
  parameterBox_ = new QWidget(this);
  auto* column = makeLayout<QVBoxLayout>(parameterBox_, 8, {0, 4, 0, 0});
  for (const coordinates::Parameter& parameter : workspace_.registry().find(shownSystem_)->parameters())
    if (!parameter.withoutEffect)
      column->addWidget(editorFor(parameter));
  column_->addWidget(parameterBox_);
  parameterBox_->show();
}

QWidget* SystemBox::editorFor(const coordinates::Parameter& parameter) {
  QString name = text(parameter.name);
  if (!name.isEmpty())
    name[0] = name[0].toUpper();
  name = inWords(name.toStdString()); // The identifier is a word, which the command line takes as it is.
  const auto present = [this, parameter] { return workspace_.document().system().parameters.get(parameter); };
  if (!parameter.choices.empty()) {
    auto* box = new QWidget(parameterBox_);
    auto* row = makeLayout<QHBoxLayout>(box);
    auto* combo = new QComboBox(box);
    row->addWidget(new QLabel(name, box), 1);
    row->addWidget(combo);
    combo->setObjectName(QStringLiteral("parameter/") + text(parameter.name));
    const coordinates::Registry& registry = workspace_.registry();
    for (const std::string& choice :
         parameter.choices) // Systems are called what the list of them calls them.
      combo->addItem(inWords(registry.contains(choice) ? registry.find(choice)->name() : choice));
    combo->setToolTip(inWords(parameter.help));
    combo->setAccessibleName(name);
    connect(combo, QOverload<int>::of(&QComboBox::activated), this, [this, parameter](int index) {
      workspace_.perform(document::setParameter(parameter.name, index));
      workspace_.undo().seal();
    });
    readers_.push_back([combo, present] {
      const QSignalBlocker quiet(combo);
      combo->setCurrentIndex(static_cast<int>(present()));
    });
    return box;
  }
  return sliderFor(parameter, name);
}

QWidget* SystemBox::sliderFor(const coordinates::Parameter& parameter, const QString& name) {
  auto* box = new QWidget(parameterBox_);
  auto* column = makeLayout<QVBoxLayout>(box, 2);
  auto* slider = new ValueSlider(name, rangeOf(parameter, std::numeric_limits<double>::infinity()), box);
  slider->setObjectName(QStringLiteral("parameter/") + text(parameter.name));
  slider->setToolTip(inWords(parameter.help));
  auto* remark = makeRemark({}, box);
  column->addWidget(slider);
  column->addWidget(remark);
  connect(slider, &ValueSlider::valueChanged, this, [this, parameter](double value) {
    workspace_.perform(document::setParameter(parameter.name, value));
  });
  connect(slider, &ValueSlider::valueChosen, this, [this] { workspace_.undo().seal(); });
  readers_.push_back([this, slider, remark, parameter] {
    const auto bound = upperBounds_.find(parameter.name);
    const double most = bound == upperBounds_.end() ? std::numeric_limits<double>::infinity() : bound->second;
    const double value = workspace_.document().system().parameters.get(parameter);
    slider->setRange(rangeOf(parameter, most));
    slider->setValue(value);
    const QString limit = tr("%1 %2").arg(formatNumber(most, 1)).arg(text(parameter.unit));
    remark->setText(value > most
                        ? tr("The value is set to %1 %2, but these handles allow at most %3, so %3 is used.")
                              .arg(value)
                              .arg(text(parameter.unit), limit)
                        : tr("These handles allow up to %1.").arg(limit));
    remark->setVisible(std::isfinite(most));
  });
  return box;
}

} // namespace viscera::app
