#include "window/key_sequence/fit_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

#include "viscera/document/measured_values.h"
#include "viscera/live/sequence_file.h"
#include "viscera/live/sequence_setup.h"
#include "viscera/presentation/presenter.h"
#include "window/style/icon.h"
#include "window/style/language.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

constexpr const char* kHeartbeat = "heartbeat";
constexpr double kLeastEjection = 11, kMostEjection = 79;

QString placeText(const std::vector<Vec3>& places) {
  if (places.empty())
    return FitBox::tr("by the shape");
  if (places.size() > 1)
    return FitBox::tr("%n points", nullptr, static_cast<int>(places.size()));
  return QStringLiteral("%1, %2, %3")
      .arg(formatNumber(places.front().x(), 0))
      .arg(formatNumber(places.front().y(), 0))
      .arg(formatNumber(places.front().z(), 0));
}

} // namespace

FitBox::FitBox(Workspace& workspace, Playback& playback, Picture& picture, ViewWidget& view, QWidget* parent)
    : QWidget(parent), workspace_(workspace), playback_(playback), picture_(picture), view_(view),
      sequence_(new QComboBox(this)), target_(makeRemark({}, this)), ejectionBox_(new QWidget(this)),
      ejection_(new QDoubleSpinBox(ejectionBox_)),
      fit_(new QPushButton(icon("patient"), tr("Fit to this organ"), this)), glyphs_(view.view()) {
  setObjectName(QStringLiteral("fitBox"));
  auto* column = makeLayout<QVBoxLayout>(this, 6);
  column->addWidget(target_);
  sequence_->setObjectName(QStringLiteral("fitSequence"));
  sequence_->setAccessibleName(tr("Sequence to fit"));
  for (const live::SampleSequence& sample : live::sampleSequences())
    sequence_->addItem(inWords(sample.name), text(sample.id));
  column->addWidget(sequence_);
  ejection_->setObjectName(QStringLiteral("fitEjection"));
  ejection_->setRange(kLeastEjection, kMostEjection);
  ejection_->setDecimals(0);
  ejection_->setSuffix(tr(" %"));
  ejection_->setValue(kPercent * live::TextbookBeat().ejectionFraction);
  ejection_->setToolTip(
      tr("Of the left ventricle. The right one ejects as much blood, and the muscle keeps its volume"));
  auto* ejection = new QFormLayout(ejectionBox_);
  ejection->setContentsMargins(0, 0, 0, 0);
  ejection->addRow(tr("Ejection fraction"), ejection_);
  column->addWidget(ejectionBox_);
  fit_->setObjectName(QStringLiteral("fitButton"));
  fit_->setToolTip(tr("Place the sequence's handles around the organ and play it"));
  column->addWidget(fit_);
  connect(sequence_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    rebuildRows();
    syncTarget();
  });
  connect(fit_, &QPushButton::clicked, this, &FitBox::fitChosen);
  connect(&view, &ViewWidget::clicked, this, &FitBox::onClick);
  view.addClickTaker([this] { return !picking_.empty(); });
  subscriptions_.push_back(workspace.onChange([this](const document::Change&) { syncTarget(); }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncTarget(); }));
  subscriptions_.push_back(workspace.live().onEvent([this](const live::LiveEvent& event) {
    if (!event.more)
      syncGlyphs();
  }));
  rebuildRows();
  syncTarget();
}

FitBox::~FitBox() = default;

std::string FitBox::sequenceId() const {
  return sequence_->currentData().toString().toStdString();
}

void FitBox::rebuildRows() {
  landmarks_.points.clear();
  picking_.clear();
  rows_.clear();
  delete rowsBox_;
  rowsBox_ = new QWidget(this);
  auto* form = new QFormLayout(rowsBox_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(2);
  const std::string sequence = sequenceId();
  workspace_.guarded([&] {
    for (const live::LandmarkRole& role : live::landmarkRoles(sequence)) {
      Row row;
      row.pick = new QToolButton(rowsBox_);
      row.pick->setObjectName(QStringLiteral("landmark_%1").arg(text(role.role)));
      row.pick->setText(inWords(role.name));
      row.pick->setCheckable(true);
      row.pick->setToolTip(tr("%1: click its place in the view").arg(inWords(role.help)));
      row.place = new QLabel(rowsBox_);
      row.place->setObjectName(QStringLiteral("muted"));
      row.place->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
      form->addRow(row.pick, row.place);
      connect(row.pick, &QToolButton::clicked, this,
              [this, id = role.role](bool on) { pick(on ? id : std::string()); });
      rows_[role.role] = row;
    }
  });
  static_cast<QVBoxLayout*>(layout())->insertWidget(2, rowsBox_);
  rowsBox_->show();
  syncRows();
}

void FitBox::pick(const std::string& role) {
  picking_ = role;
  view_.setCursor(role.empty() ? Qt::ArrowCursor : Qt::CrossCursor);
  syncRows();
}

void FitBox::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  syncGlyphs();
}

void FitBox::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!picking_.empty())
    pick({});
  syncGlyphs();
}

/// The surface may be in motion: the landmark is where the clicked place is at rest.
void FitBox::onClick(const QPointF& place) {
  if (picking_.empty())
    return;
  const auto hit = view_.pickNear(place);
  const auto organ = hit ? workspace_.document().organ(picture_.organOf(hit->organ)) : nullptr;
  if (!organ || !isMarked(*organ))
    return;
  setLandmark(picking_, document::surfacePoint(*organ, hit->triangle,
                                               Vec3(hit->weights[0], hit->weights[1], hit->weights[2]))
                            .rest);
}

void FitBox::setLandmark(const std::string& role, const Vec3& position) {
  bool several = false;
  const std::string sequence = sequenceId();
  for (const live::LandmarkRole& known : live::landmarkRoles(sequence))
    several = several || (known.role == role && known.several);
  auto& points = landmarks_.points;
  std::erase_if(points, [&](const live::Landmark& point) {
    return point.computed || (!several && point.role == role);
  });
  points.push_back({role, position, false});
  if (!several)
    pick({});
  syncRows();
}

void FitBox::syncRows() {
  for (auto& [role, row] : rows_) {
    row.pick->setChecked(role == picking_);
    row.place->setText(role == picking_ ? tr("click the organ") : placeText(landmarks_.all(role)));
  }
  syncMarks();
}

/// Whether landmarks are places on this surface: after a repair the organ has another one.
bool FitBox::isMarked(const document::Organ& organ) const {
  return organ_ && organ.id == organ_->id && organ.mesh == organ_->mesh;
}

void FitBox::syncMarks() {
  marks_.clear();
  std::set<std::string> named; // Of a line of points only the first.
  for (const live::Landmark& point : landmarks_.points) {
    if (!organ_)
      break;
    const auto row = rows_.find(point.role);
    const bool first = named.insert(point.role).second && row != rows_.end();
    marks_.push_back({first ? row->second.pick->text().toStdString() : std::string(), point.position,
                      document::nearestPoint(*organ_, point.position), point.computed});
  }
  syncGlyphs();
}

void FitBox::syncGlyphs() {
  if (marks_.empty() && glyphs_.items().empty())
    return;
  std::vector<scene::MeasurementGlyphs::Item> items;
  const auto organ = organ_ ? workspace_.document().organ(organ_->id) : nullptr;
  for (const Mark& mark : marks_) {
    if (!isVisible() || !organ || !isMarked(*organ))
      break;
    const Vec3 now =
        document::placeNow(mark.surface, workspace_.state(), [this](document::OrganId id) -> const Points& {
          return workspace_.live().points(id);
        });
    items.push_back({{mark.rest + (now - mark.surface.rest)}, mark.name, !mark.computed});
  }
  glyphs_.setTheme(view_.view().theme());
  glyphs_.setItems(std::move(items));
  view_.scheduleRender();
}

std::shared_ptr<const document::Organ> FitBox::hollowHeart() const {
  const auto organ = workspace_.currentOrgan();
  return organ && sequenceId() == kHeartbeat ? live::heartWithCavities(workspace_.document().organs(), *organ)
                                             : nullptr;
}

std::shared_ptr<const document::Organ> FitBox::target() const {
  const auto heart = hollowHeart();
  return heart ? heart : workspace_.currentOrgan();
}

void FitBox::syncTarget() {
  if (const auto current = workspace_.currentOrgan(); current && !(organ_ && current->id == organ_->id))
    chooseMatchingSequence(*current);
  const auto organ = target();
  if (organ ? !isMarked(*organ) : organ_ != nullptr) {
    organ_ = organ;
    landmarks_.points.clear(); // They were places on another surface.
    syncRows();
  }
  fit_->setEnabled(organ && organ->closed());
  const bool hollow = hollowHeart() != nullptr;
  ejectionBox_->setVisible(hollow);
  if (!organ)
    target_->setText(tr("Open a patient's organ first."));
  else if (!organ->closed())
    target_->setText(
        tr("%1 is open; a sequence needs a closed surface.").arg(inWords(presentation::labelOf(*organ))));
  else if (hollow)
    target_->setText(tr("Makes %1 and its chambers beat like a textbook heart. The present shape counts as "
                        "the end of diastole. The result is a key sequence.")
                         .arg(inWords(presentation::labelOf(*organ))));
  else
    target_->setText(
        tr("Moves %1 like the sample organ. Landmarks that you do not set are found from its shape.")
            .arg(inWords(presentation::labelOf(*organ))));
}

void FitBox::chooseMatchingSequence(const document::Organ& organ) {
  for (const live::SampleSequence& sample : live::sampleSequences()) {
    if (live::matchesOrgan(sample, organ.name) != live::SequenceMatch::yes || sample.id == sequenceId())
      continue;
    sequence_->setCurrentIndex(sequence_->findData(text(sample.id)));
    rebuildRows();
  }
}

void FitBox::fit(const QString& sequence) {
  if (sequence_->currentData().toString() != sequence) {
    sequence_->setCurrentIndex(sequence_->findData(sequence));
    rebuildRows();
  }
  fitChosen();
}

void FitBox::fitChosen() {
  const auto organ = target();
  if (!organ)
    return;
  live::Landmarks given = landmarks_;
  std::erase_if(given.points, [](const live::Landmark& point) { return point.computed; });
  if (hollowHeart())
    return fitHeart(*organ, given);
  workspace_.inBackground<live::RetargetedSequence>(
      tr("Fitting %1").arg(sequence_->currentText()), "fit",
      [id = sequenceId(), organ, given](Progress& progress) {
        return live::retargetSequence(id, *organ, given, progress);
      },
      [this, id = organ->id, sequence = sequenceId(), given](const live::RetargetedSequence& fitted) {
        take(fitted, id, sequence, given);
      });
}

void FitBox::fitHeart(const document::Organ& heart, const live::Landmarks& given) {
  live::TextbookBeat beat;
  beat.ejectionFraction = ejection_->value() / kPercent;
  beat.given = given;
  workspace_.inBackground<live::PatientMotion>(
      tr("Fitting %1").arg(sequence_->currentText()), "fit",
      [organs = workspace_.document().organs(), heart, beat](Progress& progress) {
        return live::textbookMotion(organs, heart, beat, progress);
      },
      [this, id = heart.id, mesh = heart.mesh](const live::PatientMotion& found) {
        // Only on the surface for which it was found.
        if (const auto organ = workspace_.document().organ(id); organ && organ->mesh == mesh)
          takeHeart(found, *organ);
      });
}

void FitBox::takeHeart(const live::PatientMotion& found, const document::Organ& heart) {
  const std::string name = tr("Fit the textbook's beat to %1").arg(inWords(heart.name)).toStdString();
  if (!workspace_.perform(document::combined(name, {live::openSequence(found.sequence)})))
    return;
  for (const Text& warning : found.warnings)
    workspace_.say({Message::Severity::warning, asSentence(warning), {}, 0});
  playback_.play();
}

void FitBox::take(const live::RetargetedSequence& fitted, document::OrganId organ,
                  const std::string& sequence, const live::Landmarks& given) {
  const document::OrganList organs = workspace_.document().organs();
  const bool keeps = !live::keptInPlace(fitted, organs).empty();
  if (!workspace_.document().organ(organ) || !workspace_.perform(live::useRetargeted(fitted, organs)))
    return;
  playback_.setSequence(fitted.sequence, organ, live::FittedMotion{sequence, given});
  if (organ_ && organ_->id == organ)
    landmarks_ = fitted.landmarks;
  syncRows();
  for (const Text& warning : fitted.warnings)
    workspace_.say({Message::Severity::warning, inWords(warning), {}, 0});
  if (keeps)
    workspace_.say({Message::Severity::info,
                    tr("Spine and pelvis stay in place: breathing does not move them."),
                    {},
                    0});
  playback_.play();
}

} // namespace viscera::app
