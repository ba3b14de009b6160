#include "window/stress/stress_page.h"

#include <QAction>
#include <QButtonGroup>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <optional>

#include "viscera/elasticity/tissues.h"
#include "viscera/presentation/presenter.h"
#include "window/stress/histogram.h"
#include "window/stress/marks_box.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"
#include "window/widgets/value_slider.h"

namespace viscera::app {
namespace {

using Options = live::WitnessOptions;
/// Steps of the slider between the fewest and the most witnesses: it goes by factors.
constexpr int kCountSteps = 100;
constexpr int kRound = 100;
/// Young's modulus that a user's own material begins with.
constexpr double kFirstYoungKpa = 5;

int countAt(int step) {
  const double count =
      Options::kFewest * std::pow(double(Options::kMost) / Options::kFewest, double(step) / kCountSteps);
  const double unit = count < 2000 ? kRound : count < 20000 ? 10.0 * kRound / 2 : 10.0 * kRound;
  return static_cast<int>(std::lround(count / unit) * std::lround(unit));
}

int stepOf(int count) {
  return static_cast<int>(std::lround(kCountSteps * std::log(double(count) / Options::kFewest) /
                                      std::log(double(Options::kMost) / Options::kFewest)));
}

QString nameOf(live::WitnessOrigin origin) {
  switch (origin) {
  case live::WitnessOrigin::surface:
    return StressPage::tr("TetGen");
  case live::WitnessOrigin::repairedSurface:
    return StressPage::tr("TetGen, surface repaired");
  case live::WitnessOrigin::grid:
    return StressPage::tr("regular grid");
  }
  return {};
}

/// The way from an organ to the nearest handle at rest, mm, where that is far for the size of the organ: then
/// hardly anything moves it. None where a handle is near, and without handles, which is another matter.
std::optional<double> gapToHandles(const document::Organ& organ, const document::Rig& rig) {
  constexpr double kFar = 0.5; // Of the organ's diagonal.
  const Bounds box = boundsOf(organ.mesh->points);
  std::optional<double> nearest;
  for (const document::Handle& handle : rig.handles) {
    const double gap = (handle.rest - handle.rest.cwiseMax(box.low).cwiseMin(box.high)).norm();
    nearest = std::min(nearest.value_or(gap), gap);
  }
  return nearest && *nearest > kFar * box.diagonal() ? nearest : std::nullopt;
}

const QSize kMapSwatch(56, 12);

/// The colours of a map from left to right.
QIcon swatchOf(const scene::ColorMap& map) {
  QImage image(static_cast<int>(map.colors.rows()), 1, QImage::Format_RGB32);
  for (int i = 0; i < image.width(); ++i)
    image.setPixel(i, 0, qRgb(map.colors(i, 0), map.colors(i, 1), map.colors(i, 2)));
  return QPixmap::fromImage(image.scaled(kMapSwatch));
}

} // namespace

StressPage::StressPage(Workspace& workspace, Playback& playback, StressModel& model, CutController& cut,
                       const Actions& actions, QWidget* parent)
    : Page(parent), workspace_(workspace), playback_(playback), model_(model), cut_(cut) {
  makeMap(actions);
  makeNumbers(actions);
  makeMarks(actions);
  makeInside(actions);
  makeWitnesses();
  makeExport(actions);
  finish();
  connect(&model, &StressModel::lookChanged, this, &StressPage::syncLook);
  connect(&model, &StressModel::statusChanged, this, &StressPage::syncStatus);
  connect(&model, &StressModel::sampled, this, &StressPage::syncStatus);
  for (const auto told : {&StressModel::updated, &StressModel::numbersChanged})
    connect(&model, told, this, [this] {
      syncNumbers();
      syncThreshold();
    });
  connect(&playback, &Playback::stateChanged, this, &StressPage::syncStatus);
  connect(&playback, &Playback::advanced, this, &StressPage::syncPose);
  syncLook();
  syncStatus();
  syncNumbers();
}

QComboBox* StressPage::addChoice(const char* id, const QString& name, const QStringList& items,
                                 std::function<void(StressLook&, int)> change) {
  auto* box = new QComboBox(this);
  box->setObjectName(QLatin1String(id));
  box->setAccessibleName(name);
  box->addItems(items);
  connect(box, QOverload<int>::of(&QComboBox::activated), this,
          [this, change = std::move(change)](int index) {
            model_.change([&](StressLook& look) { change(look, index); });
          });
  add(box);
  return box;
}

void StressPage::makeMap(const Actions& actions) {
  addSection(tr("Map"));
  QStringList names;
  for (const live::StressQuantityDescription& quantity : live::stressQuantities())
    names.push_back(inWords(quantity.name));
  quantity_ = addChoice("stressQuantity", tr("Map"), names, [](StressLook& look, int index) {
    look.quantity = live::stressQuantities()[static_cast<std::size_t>(index)].quantity;
  });
  quantity_->setToolTip(
      tr("What the colours mean (M: next map). Rotational stress is the largest angle by which a direction "
         "is turned when the tissue is stretched; it is not a pressure."));
  meaning_ = addRemark(QString());
  meaning_->setObjectName(QStringLiteral("stressMeaning"));
  makeMaterial();
  QStringList maps;
  for (const scene::ColorMap& map : scene::colorMaps())
    maps.push_back(inWords(map.title));
  colors_ = addChoice("stressColors", tr("Colours"), maps, [](StressLook& look, int index) {
    look.*presentation::colorsOf(look.quantity) = scene::colorMaps()[static_cast<std::size_t>(index)].name;
  });
  colors_->setIconSize(kMapSwatch);
  for (int i = 0; i < colors_->count(); ++i)
    colors_->setItemIcon(i, swatchOf(scene::colorMaps()[static_cast<std::size_t>(i)]));
  colors_->setToolTip(tr("Colours from the lowest value to the highest; maps of angles and maps of ratios "
                         "each keep their own choice"));
  add(makePose());
  addCheck(actions["stress.peak"]);
  addCheck(actions["stress.surface"]);
  addCheck(actions["stress.pin"]);
  addCheck(actions["stress.logarithmic"]);
  addCheck(actions["stress.sameRange"]);
  addButton(actions["play.comparePose"]);
}

/// Shown with a quantity in pascals, and as long as a material is stated.
void StressPage::makeMaterial() {
  QStringList names = {tr("Choose a material")};
  for (const elasticity::Tissue& tissue : elasticity::tissues())
    names.push_back(inWords(named(tissue.name)));
  names.push_back(tr("Another material"));
  material_ = addChoice("stressMaterial", tr("Material"), names, [](StressLook& look, int index) {
    const auto tissues = elasticity::tissues();
    const double poisson = look.material.poisson;
    if (index == 0)
      look.material = {};
    else if (const auto tissue = static_cast<std::size_t>(index - 1); tissue < tissues.size())
      look.material = elasticity::materialOf(tissues[tissue].name, poisson);
    else
      look.material =
          elasticity::ownMaterial(look.material.stated() ? look.material.youngKpa : kFirstYoungKpa, poisson);
  });
  material_->setToolTip(
      tr("The tissue whose stiffness makes pascals of the deformation; it does not change the pose"));
  young_ = new ValueSlider(tr("Young's modulus"), {0.1, 100, 0.01, 2, tr(" kPa")}, this);
  young_->setObjectName(QStringLiteral("stressYoung"));
  connect(young_, &ValueSlider::valueChanged, this, [this](double value) {
    model_.change(
        [value](StressLook& look) { look.material = elasticity::ownMaterial(value, look.material.poisson); });
  });
  add(young_);
  poisson_ = new ValueSlider(tr("Poisson's ratio"), {0.3, 0.499, 0.001, 3, {}}, this);
  poisson_->setObjectName(QStringLiteral("stressPoisson"));
  connect(poisson_, &ValueSlider::valueChanged, this, [this](double value) {
    model_.change([value](StressLook& look) { look.material.poisson = value; });
  });
  add(poisson_);
  source_ = addRemark(QString());
  source_->setObjectName(QStringLiteral("stressSource"));
}

void StressPage::syncMaterial() {
  const StressLook& look = model_.look();
  const elasticity::StatedMaterial& material = look.material;
  const auto tissues = elasticity::tissues();
  const auto tissue = std::find_if(tissues.begin(), tissues.end(), [&](const elasticity::Tissue& one) {
    return one.name == material.tissue;
  });
  const bool own = material.stated() && tissue == tissues.end();
  material_->setCurrentIndex(!material.stated() ? 0 : static_cast<int>(tissue - tissues.begin()) + 1);
  const bool wanted = live::describe(look.quantity).ofMaterial;
  material_->setVisible(wanted || material.stated());
  young_->setVisible(own);
  young_->setValue(own ? material.youngKpa : kFirstYoungKpa);
  poisson_->setVisible(material.stated());
  poisson_->setValue(material.poisson);
  QString source;
  if (wanted && !material.stated())
    source = tr("Pascals exist only of a stated material. Choose a material first.");
  else if (material.stated() && !own)
    source = tr("Young's modulus %1 kPa, doi:%2")
                 .arg(formatNumber(material.youngKpa, 2),
                      QString::fromUtf8(tissue->doi.data(), static_cast<int>(tissue->doi.size())));
  source_->setText(source);
  source_->setVisible(!source.isEmpty());
}

QWidget* StressPage::makePose() {
  auto* box = new QWidget(this);
  auto* row = makeLayout<QHBoxLayout>(box, 4);
  auto* group = new QButtonGroup(box);
  const auto addButton = [&](const QString& name, const char* id, const QString& tip) {
    auto* button = new QPushButton(name, box);
    button->setObjectName(QLatin1String(id));
    button->setCheckable(true);
    button->setToolTip(tip);
    group->addButton(button);
    row->addWidget(button, 1);
    return button;
  };
  ownPose_ = addButton(tr("Your pose"), "stressOwnPose", tr("The map of your pose; handles can be dragged"));
  played_ = addButton(tr("Sequence"), "stressPlayed",
                      tr("The map of the sequence at the timeline's instant; Space plays"));
  connect(ownPose_, &QPushButton::clicked, this, [this] {
    instant_ = playback_.player().fraction();
    playback_.stop();
  });
  connect(played_, &QPushButton::clicked, this, [this] {
    if (!playback_.showing())
      playback_.seek(instant_);
    syncStatus(); // It may not be possible.
  });
  return box;
}

void StressPage::makeNumbers(const Actions& actions) {
  addSection(tr("Numbers"));
  state_ = addRemark(QString());
  state_->setObjectName(QStringLiteral("stressState"));
  hint_ = addRemark(QString());
  hint_->setObjectName(QStringLiteral("stressHint"));
  caution_ = addRemark(QString());
  caution_->setObjectName(QStringLiteral("stressCaution"));
  min_ = addFact(tr("Minimum"));
  mean_ = addFact(tr("Mean"));
  percentile_ = addFact(tr("95th percentile"));
  max_ = addFact(tr("Maximum"));
  folded_ = addFact(tr("Folded"));
  peakTime_ = addFact(tr("Time of the maximum"));
  peakTime_->setObjectName(QStringLiteral("stressPeakTime"));
  mean_->setObjectName(QStringLiteral("stressMean"));
  max_->setObjectName(QStringLiteral("stressMax"));
  folded_->setToolTip(tr("Witness points at which the tissue is turned inside out; in magenta, except on the "
                         "map of folded tissue"));
  histogram_ = new Histogram(this);
  add(histogram_);
  squeezed_ = addRemark(QString()); // Below the numbers, which stay in place when it comes.
  squeezed_->setObjectName(QStringLiteral("stressSqueezed"));
  addButton(actions["stress.maximum"]);
  toPeak_ = addButton(actions["stress.peakTime"]);
}

void StressPage::makeMarks(const Actions& actions) {
  addSection(tr("Probes"));
  marks_ = new MarksBox(workspace_, model_, actions, this);
  add(marks_);
}

void StressPage::setTheme(const Theme& theme) {
  marks_->setTheme(theme);
}

void StressPage::makeExport(const Actions& actions) {
  addSection(tr("Export"));
  for (const char* id :
       {"stress.exportMap", "stress.exportPoints", "stress.exportHistogram", "stress.exportCurve"})
    addButton(actions[id]);
}

void StressPage::makeInside(const Actions& actions) {
  addSection(tr("Cut and glyphs"));
  addCheck(actions["stress.cut"]);
  style_ = addChoice("stressCutStyle", tr("Cut"),
                     {tr("Smooth: through the tetrahedra"), tr("Crinkle: whole tetrahedra")},
                     [](StressLook& look, int index) {
                       look.style = index == 1 ? scene::CutStyle::crinkle : scene::CutStyle::smooth;
                     });
  offset_ = new ValueSlider(tr("Depth"), {-100, 100, 1, 0, tr(" %")}, this);
  offset_->setObjectName(QStringLiteral("stressOffset"));
  offset_->setToolTip(
      tr("Distance of the cut from the organ's middle; the arrow in the view moves it, the rim tilts it"));
  connect(offset_, &ValueSlider::valueChanged, this,
          [this](double value) { model_.change([value](StressLook& look) { look.offset = value / 100; }); });
  add(offset_);
  directions_ = makeDirections();
  add(directions_);
  addCheck(actions["stress.threshold"]);
  side_ = addChoice("stressSide", tr("Tissue"), {tr("Above the limit"), tr("Below the limit")},
                    [](StressLook& look, int index) { look.below = index == 1; });
  limit_ = new ValueSlider(tr("Limit"), {0, 1, 0.01, 2, {}}, this);
  limit_->setObjectName(QStringLiteral("stressLimit"));
  connect(limit_, &ValueSlider::valueChanged, this,
          [this](double value) { model_.change([value](StressLook& look) { look.limit = value; }); });
  add(limit_);
  glyphs_ = addChoice("stressGlyphs", tr("Glyphs"),
                      {tr("No glyphs"), tr("Ellipsoids of the stretch"), tr("Crosses of the stretch")},
                      [](StressLook& look, int index) { look.glyphs = static_cast<GlyphChoice>(index); });
  glyphs_->setToolTip(
      tr("Glyphs of the stretch at about 300 points: the shape that a small sphere of tissue takes"));
  addCheck(actions["stress.handles"]);
  addCheck(actions["stress.others"]);
}

QWidget* StressPage::makeDirections() {
  auto* box = new QWidget(this);
  auto* grid = makeLayout<QGridLayout>(box, 4);
  struct Direction {
    QString name;
    QString tip;
    Vec3 normal;
  };
  const Direction directions[] = {
      {tr("Coronal"), tr("Cut away the front"), Vec3::UnitY()},
      {tr("Sagittal"), tr("Cut away the right side"), Vec3::UnitX()},
      {tr("Axial"), tr("Cut away the upper part"), -Vec3::UnitZ()},
  };
  int index = 0;
  const auto addButton = [&](const QString& name, const QString& tip, std::function<void()> run) {
    auto* button = new QPushButton(name, box);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [run = std::move(run)] { run(); });
    grid->addWidget(button, index / 2, index % 2);
    ++index;
  };
  for (const Direction& direction : directions)
    addButton(direction.name, direction.tip, [this, normal = direction.normal] { cut_.cutAcross(normal); });
  addButton(tr("Facing the viewer"), tr("Cut through the middle, across the line of sight"),
            [this] { cut_.faceReader(); });
  return box;
}

QWidget* StressPage::makeWitnessCount() {
  auto* box = new QWidget(this);
  auto* grid = makeLayout<QGridLayout>(box);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  auto* name = new QLabel(tr("Number"), box);
  countField_ = new QSpinBox(box);
  countField_->setObjectName(QStringLiteral("stressWitnesses"));
  countField_->setRange(Options::kFewest, Options::kMost);
  countField_->setGroupSeparatorShown(true);
  countField_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  countField_->setAlignment(Qt::AlignRight);
  countField_->setKeyboardTracking(false);
  countField_->setAccessibleName(tr("Number of witness points"));
  name->setBuddy(countField_);
  countSlider_ = new QSlider(Qt::Horizontal, box);
  countSlider_->setObjectName(QStringLiteral("stressWitnessSteps"));
  countSlider_->setRange(0, kCountSteps);
  countSlider_->setAccessibleName(tr("Number of witness points"));
  countSlider_->setToolTip(
      tr("More points show finer detail and take longer; up to 20,000 the map follows a drag"));
  grid->addWidget(name, 0, 0);
  grid->addWidget(countField_, 0, 1, Qt::AlignRight);
  grid->addWidget(countSlider_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  const auto choose = [this](int count) {
    model_.change([count](StressLook& look) { look.witnesses = count; });
  };
  connect(countSlider_, &QSlider::valueChanged, this, [this, choose](int step) {
    const QSignalBlocker quiet(countField_);
    countField_->setValue(countAt(step));
    if (!countSlider_->isSliderDown())
      choose(countField_->value());
  });
  connect(countSlider_, &QSlider::sliderReleased, this, [this, choose] { choose(countField_->value()); });
  connect(countField_, QOverload<int>::of(&QSpinBox::valueChanged), this, choose);
  return box;
}

void StressPage::makeWitnesses() {
  addSection(tr("Witness points"));
  add(makeWitnessCount());
  origin_ = addFact(tr("Source"));
  origin_->setObjectName(QStringLiteral("stressOrigin"));
  points_ = addFact(tr("Points"));
  derivatives_ = addFact(tr("Derivatives"));
  remarks_ = addRemark(QString());
  retry_ = new QPushButton(tr("Try again"), this);
  connect(retry_, &QPushButton::clicked, this, [this] { model_.live().retry(); });
  add(retry_);
}

void StressPage::syncLook() {
  const StressLook& look = model_.look();
  quantity_->setCurrentIndex(static_cast<int>(look.quantity));
  meaning_->setText(inWords(live::describe(look.quantity).meaning));
  syncMaterial();
  const auto& maps = scene::colorMaps();
  const auto chosen = std::find_if(maps.begin(), maps.end(), [&](const scene::ColorMap& map) {
    return map.name == look.*presentation::colorsOf(look.quantity);
  });
  colors_->setCurrentIndex(static_cast<int>(chosen - maps.begin()));
  style_->setCurrentIndex(look.style == scene::CutStyle::crinkle ? 1 : 0);
  style_->setEnabled(look.cut);
  offset_->setValue(100 * look.offset);
  offset_->setEnabled(look.cut);
  directions_->setEnabled(look.cut);
  side_->setCurrentIndex(look.below ? 1 : 0);
  side_->setVisible(look.threshold);
  limit_->setVisible(look.threshold);
  glyphs_->setCurrentIndex(static_cast<int>(look.glyphs));
  if (!countSlider_->isSliderDown()) {
    const QSignalBlocker quietField(countField_), quietSlider(countSlider_);
    countField_->setValue(look.witnesses);
    countSlider_->setValue(stepOf(look.witnesses));
  }
  syncThreshold();
  syncNumbers();
}

void StressPage::syncThreshold() {
  if (!model_.look().threshold)
    return;
  const scene::ValueRange& range = model_.shown().range();
  const live::StressQuantityDescription& quantity = live::describe(model_.look().quantity);
  limit_->setRange({range.low, range.high, std::pow(10.0, -quantity.decimals), quantity.decimals,
                    quantity.unit.empty() ? QString() : QLatin1Char(' ') + inWords(quantity.unit)});
  limit_->setValue(model_.look().limit);
}

void StressPage::syncStatus() {
  using State = live::StressStatus::State;
  const live::StressStatus& status = model_.live().status();
  QString state;
  switch (status.state) {
  case State::off:
    state = workspace_.currentOrgan() ? QString() : tr("Open an organ to see where it is distorted.");
    break;
  case State::sampling:
    state = tr("Filling the organ with witness points...");
    break;
  case State::binding:
    state = tr("Binding the witness points to the handles...");
    break;
  case State::cancelled:
    state = tr("Cancelled. Press Try again to go on.");
    break;
  case State::failed:
    state = inWords(status.message);
    break;
  case State::ready:
    break;
  }
  state_->setText(state);
  state_->setVisible(!state.isEmpty());
  caution_->setText(model_.caution());
  caution_->setVisible(!model_.caution().isEmpty() && playback_.showing());
  retry_->setVisible(status.state == State::cancelled || status.state == State::failed);
  const auto mesh = model_.live().mesh();
  const QString none = QStringLiteral("-");
  origin_->setText(mesh ? nameOf(status.origin) : none);
  points_->setText(mesh ? tr("%1 in %2 tetrahedra")
                              .arg(locale().toString(static_cast<int>(mesh->witnesses)),
                                   locale().toString(static_cast<int>(mesh->tetrahedra.rows())))
                        : none);
  derivatives_->setText(status.state != State::ready ? none
                        : status.closedForm          ? tr("closed form")
                                                     : tr("differences"));
  QStringList lines;
  for (const Text& remark : status.remarks)
    lines.push_back(inWords(remark));
  if (status.state == State::ready && status.outside > 0)
    lines.push_back(
        tr("%n points lie outside the handles' hull and stay where they are.", nullptr, status.outside));
  remarks_->setText(lines.join(QLatin1Char('\n')));
  remarks_->setVisible(mesh && !lines.isEmpty());
  syncPose();
  syncNumbers();
}

/// Also when the mode begins with an instant of the sequence, of which the playback's state says nothing new.
void StressPage::syncPose() {
  const QSignalBlocker quietOwn(ownPose_), quietPlayed(played_);
  played_->setEnabled(playback_.sequence());
  (playback_.showing() ? played_ : ownPose_)->setChecked(true);
}

void StressPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  syncPose();
}

QString StressPage::hintText() const {
  const auto organ = workspace_.document().organ(model_.live().organ());
  if (!organ || !model_.shown().ready())
    return {};
  if (const auto gap = gapToHandles(*organ, workspace_.document().rig()))
    return tr("No handle is near %1: the nearest is %2 mm away. Place handles around it in Handles (2).")
        .arg(inWords(presentation::labelOf(*organ)), formatNumber(*gap, 0));
  return model_.shown().deformed() ? QString()
                                   : tr("Nothing is deformed: drag a handle, or play a sequence (Space).");
}

void StressPage::syncNumbers() {
  const QString none = QStringLiteral("-");
  const bool any = model_.shown().ready();
  const live::QuantitySummary& summary = model_.shown().summary();
  min_->setText(any ? model_.format(summary.min) : none);
  mean_->setText(any ? model_.format(summary.mean) : none);
  percentile_->setText(any ? model_.format(summary.percentile95) : none);
  max_->setText(any ? model_.format(summary.max) : none);
  const Text squeezed =
      any && model_.hasMap() ? live::volumeRemark(model_.shownMap(), model_.shown().witnesses()) : Text();
  squeezed_->setText(inWords(squeezed));
  squeezed_->setVisible(!squeezed.empty());
  const live::StressSample* peak = model_.peakInstant();
  setFactShown(peakTime_, peak);
  toPeak_->setVisible(peak);
  if (peak)
    peakTime_->setText(tr("%1 s").arg(formatNumber(peak->seconds, 2)));
  const QString hint = hintText();
  hint_->setText(hint);
  hint_->setVisible(!hint.isEmpty());
  folded_->setText(any ? locale().toString(model_.shown().folded()) : none);
  if (!any || !model_.shown().deformed())
    return histogram_->clear();
  if (!isVisible())
    return;
  Histogram::Contents contents{
      model_.shown().colors(), model_.shown().range(), summary.mean, summary.percentile95, {}};
  const StressLook& look = model_.look();
  contents.shown = !look.threshold ? scene::ValueRange{-1e300, 1e300}
                   : look.below    ? scene::ValueRange{-1e300, look.limit}
                                   : scene::ValueRange{look.limit, 1e300};
  histogram_->show(*model_.shown().values(), model_.shown().witnesses(), contents);
}

} // namespace viscera::app
