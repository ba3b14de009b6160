#include "window/recorded/fit_box.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "viscera/motion/motion_recipe.h"
#include "viscera/motion/sequence_setup.h"
#include "window/style/icon.h"
#include "window/widgets/ready_made.h"

namespace viscera::app {
namespace {

/// Of given landmarks and of those that were found; apart also for colour-blind eyes.
const Vec3 kGiven(0.95, 0.62, 0.0);
const Vec3 kFound(0.34, 0.71, 0.91);

QString placeText(const std::vector<Vec3>& places) {
  if (places.empty())
    return FitBox::tr("found by itself");
  if (places.size() > 1)
    return FitBox::tr("%n {point|points}", nullptr, static_cast<int>(places.size()));
  return QStringLiteral("%1, %2, %3")
      .arg(places.front().x(), 0, 'f', 0)
      .arg(places.front().y(), 0, 'f', 0)
      .arg(places.front().z(), 0, 'f', 0);
}

} // namespace

FitBox::FitBox(Workspace& workspace, Playback& playback, ViewWidget& view, QWidget* parent)
    : QWidget(parent), workspace_(workspace), playback_(playback), view_(view),
      sequence_(new QComboBox(this)), target_(makeRemark({}, this)),
      fit_(new QPushButton(icon("patient"), tr("Fit to this organ"), this)) {
  setObjectName(QStringLiteral("fitBox"));
  auto* column = makeLayout<QVBoxLayout>(this, 6);
  column->addWidget(target_);
  sequence_->setObjectName(QStringLiteral("fitSequence"));
  sequence_->setAccessibleName(tr("Sequence to fit"));
  for (const motion::SampleSequence& sample : motion::sampleSequences())
    sequence_->addItem(text(sample.name), text(sample.id));
  column->addWidget(sequence_);
  fit_->setObjectName(QStringLiteral("fitButton"));
  fit_->setToolTip(tr("Puts the sequence's handles around the organ and plays"));
  column->addWidget(fit_);
  glyphs_.setRenderer(view.view().renderer());
  connect(sequence_, QOverload<int>::of(&QComboBox::activated), this, &FitBox::rebuildRows);
  connect(fit_, &QPushButton::clicked, this, &FitBox::fit);
  connect(&view, &ViewWidget::clicked, this, &FitBox::onClick);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs()) {
      landmarks_.points.clear(); // They were places on organs that may be gone.
      syncRows();
    }
    syncTarget();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncTarget(); }));
  rebuildRows();
  syncTarget();
}

FitBox::~FitBox() {
  glyphs_.setRenderer(nullptr);
}

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
  workspace_.guarded([&] {
    for (const motion::LandmarkRole& role : motion::landmarkRoles(sequenceId())) {
      Row row;
      row.pick = new QToolButton(rowsBox_);
      row.pick->setObjectName(QStringLiteral("landmark_%1").arg(text(role.role)));
      row.pick->setText(text(role.name));
      row.pick->setCheckable(true);
      row.pick->setToolTip(tr("%1: choose it by a click in the view").arg(text(role.help)));
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

void FitBox::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!picking_.empty())
    pick({});
}

void FitBox::onClick(const QPointF& place) {
  if (picking_.empty())
    return;
  if (const auto hit = view_.pickNear(place))
    setLandmark(picking_, hit->position);
}

void FitBox::setLandmark(const std::string& role, const Vec3& position) {
  bool several = false;
  for (const motion::LandmarkRole& known : motion::landmarkRoles(sequenceId()))
    several = several || (known.role == role && known.several);
  auto& points = landmarks_.points;
  std::erase_if(points, [&](const motion::Landmark& point) {
    return point.computed || (!several && point.role == role);
  });
  points.push_back({role, position, false});
  if (!several)
    pick({});
  syncRows();
}

void FitBox::syncRows() {
  std::vector<scene::LandmarkGlyphs::Mark> marks;
  for (auto& [role, row] : rows_) {
    row.pick->setChecked(role == picking_);
    row.place->setText(role == picking_ ? tr("click the organ") : placeText(landmarks_.all(role)));
  }
  for (const motion::Landmark& point : landmarks_.points)
    marks.push_back({point.position, point.computed ? kFound : kGiven});
  glyphs_.setMarks(std::move(marks));
  view_.scheduleRender();
}

void FitBox::syncTarget() {
  const auto organ = workspace_.currentOrgan();
  fit_->setEnabled(organ && organ->closed());
  if (!organ)
    target_->setText(tr("Open a patient's organ first."));
  else if (!organ->closed())
    target_->setText(tr("%1 is open; a sequence needs a closed surface.").arg(text(organ->name)));
  else
    target_->setText(
        tr("Moves %1 as the sample moves. Landmarks that you do not give are found by its shape.")
            .arg(text(organ->name)));
}

void FitBox::fit() {
  const auto organ = workspace_.currentOrgan();
  if (!organ)
    return;
  motion::Landmarks given = landmarks_;
  std::erase_if(given.points, [](const motion::Landmark& point) { return point.computed; });
  workspace_.inBackground<motion::RetargetedSequence>(
      tr("Fitting %1").arg(sequence_->currentText()), "fit",
      [id = sequenceId(), organ, given](Progress& progress) {
        return motion::retargetSequence(id, *organ, given, progress);
      },
      [this, id = organ->id, sequence = sequenceId(), given](const motion::RetargetedSequence& fitted) {
        take(fitted, id, sequence, given);
      });
}

void FitBox::take(const motion::RetargetedSequence& fitted, document::OrganId organ,
                  const std::string& sequence, const motion::Landmarks& given) {
  if (!workspace_.document().organ(organ) || !workspace_.perform(motion::useRetargeted(fitted)))
    return;
  playback_.setSequence(fitted.sequence, organ, motion::fittedRecipe(sequence, given));
  landmarks_ = fitted.landmarks;
  syncRows();
  for (const std::string& warning : fitted.warnings)
    workspace_.say({Message::Severity::warning, text(warning), {}, 0});
  playback_.play();
}

} // namespace viscera::app
