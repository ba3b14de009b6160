#include "window/circulation/circulation_box.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <cmath>

#include "viscera/circulation/readings.h"
#include "viscera/circulation/scenario.h"
#include "viscera/document/circulation_commands.h"
#include "window/circulation/numbers_table.h"
#include "window/style/language.h"
#include "window/widgets/flow_layout.h"
#include "window/widgets/page.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/value_slider.h"

namespace viscera::app {
namespace {

/// A slider has about so many steps.
constexpr double kSliderSteps = 100;

/// The names of controls where a slider leaves little room; the tooltip has the whole.
QString shortName(const circulation::ParameterInfo& info) {
  static const std::map<std::string, QString> names = {
      {"stressedVolume", CirculationBox::tr("Preload: stressed blood")},
      {"systemicResistance", CirculationBox::tr("Afterload: body")},
      {"pulmonaryResistance", CirculationBox::tr("Afterload: lungs")},
      {"lvEes", CirculationBox::tr("Contractility, left")},
      {"rvEes", CirculationBox::tr("Contractility, right")},
      {"lvB", CirculationBox::tr("Stiffness, left")}};
  const auto found = names.find(info.name);
  return found == names.end() ? inWords(info.title) : found->second;
}

const circulation::ParameterInfo& infoOf(const std::string& name) {
  const auto& infos = circulation::parameterInfos();
  return *std::find_if(infos.begin(), infos.end(), [&](const auto& info) { return info.name == name; });
}

ValueSlider::Range rangeOf(const circulation::ParameterInfo& info) {
  const double power = std::floor(std::log10((info.highest - info.lowest) / kSliderSteps));
  return {info.lowest, info.highest, std::pow(10.0, power), std::max(0, static_cast<int>(-power)),
          QLatin1Char(' ') + text(info.unit)};
}

/// Enough for every parameter's value at rest.
constexpr int kDigitsAtRest = 4;

QString tipOf(const circulation::ParameterInfo& info) {
  const QString what =
      CirculationBox::tr("%1, %2 at rest").arg(inWords(info.title), formatDigits(info.rest, kDigitsAtRest));
  if (!info.normal)
    return what;
  const int decimals = rangeOf(info).decimals;
  return CirculationBox::tr("%1. Marked: normal, %2 %3 (%4)")
      .arg(what, normalText(*info.normal, decimals), text(info.unit), sourceText(*info.normal));
}

} // namespace

CirculationBox::CirculationBox(Workspace& workspace, Playback& playback, CirculationModel& model,
                               const Actions& actions, QWidget* parent)
    : QWidget(parent), workspace_(workspace), playback_(playback), model_(model),
      details_(new QWidget(this)) {
  setObjectName(QStringLiteral("circulationBox"));
  auto* column = makeLayout<QVBoxLayout>(this, 8);
  makeChoice();
  column->addWidget(makeScenarios()); // Always there: a scenario is one click away from the textbook's beat.
  column->addWidget(details_);
  auto* inner = makeLayout<QVBoxLayout>(details_, 8);
  summary_ = makeRemark({}, details_);
  failure_ = makeRemark({}, details_);
  failure_->setObjectName(QStringLiteral("circulationComplaint"));
  standing_ = makeRemark(tr("Only the sample heart can be moved by the circulation model; the charts show "
                            "its results for any organ."),
                         details_);
  inner->addWidget(summary_);
  inner->addWidget(failure_);
  inner->addWidget(standing_);
  inner->addWidget(makeComparison(actions));
  inner->addWidget(makeControls());
  subscription_ = workspace.onChange([this](const document::Change& change) {
    if (change.circulation() || change.organs())
      sync();
  });
  connect(&model, &CirculationModel::changed, this, &CirculationBox::sync);
  connect(&playback, &Playback::stateChanged, this, &CirculationBox::sync);
  sync();
}

void CirculationBox::makeChoice() {
  auto* row = makeLayout<QHBoxLayout>(nullptr, 4);
  auto* group = new QButtonGroup(this);
  const auto add = [&](const QString& name, const char* id, const QString& tip) {
    auto* button = new QPushButton(name, this);
    button->setObjectName(QLatin1String(id));
    button->setCheckable(true);
    button->setToolTip(tip);
    group->addButton(button);
    row->addWidget(button, 1);
    return button;
  };
  textbook_ =
      add(tr("Textbook beat"), "textbookBeat", tr("Volumes of healthy adults over one beat at this rate"));
  circulation_ = add(tr("Circulation"), "circulationBeat",
                     tr("A model of heart and vessels: pressures, pressure-volume loops, valves and sounds"));
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  connect(textbook_, &QAbstractButton::clicked, this, [this] {
    if (model_.on())
      workspace_.perform(document::driveHeart(false));
    if (movedOtherwise())
      Q_EMIT heartChosen();
    sync();
  });
  connect(circulation_, &QAbstractButton::clicked, this, [this] {
    if (!model_.on() || movedOtherwise())
      Q_EMIT scenarioChosen({});
    sync();
  });
}

QWidget* CirculationBox::makeScenarios() {
  auto* box = new QWidget(this);
  auto* flow = new FlowLayout(box, 4);
  for (const circulation::Scenario& scenario : circulation::scenarios()) {
    auto* button = new QToolButton(box);
    button->setObjectName(QStringLiteral("scenario.%1").arg(text(scenario.id)));
    button->setText(inWords(scenario.name));
    button->setToolTip(inWords(scenario.summary));
    button->setProperty("raised", true);
    button->setCheckable(true);
    connect(button, &QToolButton::clicked, this, [this, id = text(scenario.id)] {
      Q_EMIT scenarioChosen(id);
      sync(); // Where nothing changed, the mark stays.
    });
    flow->addWidget(button);
    scenarios_[scenario.id] = button;
  }
  return box;
}

QWidget* CirculationBox::makeComparison(const Actions& actions) {
  auto* box = new QWidget(details_);
  auto* column = makeLayout<QVBoxLayout>(box, 4);
  for (const char* id : {"play.keepBefore", "play.forgetBefore"})
    column->addWidget(makeActionButton(actions[id], box));
  kept_ = makeRemark({}, box);
  column->addWidget(kept_);
  return box;
}

QWidget* CirculationBox::makeControls() {
  auto* box = new QWidget(details_);
  auto* column = makeLayout<QVBoxLayout>(box, 8);
  column->addWidget(new CollapsibleSection(
      tr("Rate, preload, afterload"),
      makeGroup({"rate", "stressedVolume", "systemicResistance", "pulmonaryResistance"}), true, box));
  column->addWidget(new CollapsibleSection(tr("Muscle"), makeGroup({"lvEes", "rvEes", "lvB"}), true, box));
  column->addWidget(new CollapsibleSection(
      tr("Valves and pericardium"),
      makeGroup({"aorticArea", "aorticLeak", "mitralArea", "mitralLeak", "pericardialFluid"}), true, box));
  return box;
}

QWidget* CirculationBox::makeGroup(const std::vector<const char*>& names) {
  auto* box = new QWidget(details_);
  auto* column = makeLayout<QVBoxLayout>(box, 8);
  for (const char* name : names)
    column->addWidget(controls_[name] = makeControl(infoOf(name), shortName(infoOf(name))));
  return box;
}

ValueSlider* CirculationBox::makeControl(const circulation::ParameterInfo& info, const QString& name) {
  auto* control = new ValueSlider(name, rangeOf(info), details_);
  control->setObjectName(QStringLiteral("circulation.%1").arg(text(info.name)));
  control->setToolTip(tipOf(info));
  if (info.normal)
    control->setNormal(info.normal->low, info.normal->high);
  connect(control, &ValueSlider::valueChanged, this, [this, parameter = info.name](double value) {
    if (!workspace_.perform(document::setCirculationParameter(parameter, value)))
      sync();
  });
  connect(control, &ValueSlider::valueChosen, this, [this] { workspace_.undo().seal(); });
  return control;
}

bool CirculationBox::movedOtherwise() const {
  const Playback::Motion motion = playback_.motion();
  return motion.sequence && !live::sampleHeartOf(motion.recipe) && model_.hasHeart();
}

/// Marks what moves the heart: neither of the two where that is another motion, or where there is no heart.
void CirculationBox::markSource(bool drives) {
  const bool otherwise = movedOtherwise();
  textbook_->group()->setExclusive(false); // An exclusive group keeps one of its marks.
  textbook_->setChecked(!drives && !otherwise && model_.hasHeart());
  circulation_->setChecked(drives && !otherwise);
  textbook_->group()->setExclusive(true);
}

void CirculationBox::sync() {
  const document::CirculationChoice& choice = model_.choice();
  markSource(choice.drives);
  details_->setVisible(choice.drives);
  for (const auto& [id, button] : scenarios_)
    button->setChecked(choice.drives && !choice.fitted && id == choice.scenario);
  summary_->setText(choice.fitted ? tr("Fitted to the volume and the ejection fraction of a left ventricle.")
                                  : inWords(circulation::scenario(choice.scenario).summary));
  for (const auto& [name, control] : controls_)
    control->setValue(circulation::parameter(choice.parameters, name));
  failure_->setText(model_.failureReason());
  failure_->setVisible(!model_.failureReason().isEmpty());
  standing_->setVisible(!model_.hasHeart());
  kept_->setText(choice.kept ? tr("Before: %1").arg(inWords(choice.kept->name)) : QString());
  kept_->setVisible(choice.kept.has_value());
}

} // namespace viscera::app
