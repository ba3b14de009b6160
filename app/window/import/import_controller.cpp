#include "window/import/import_controller.h"

#include <QEvent>
#include <QFileInfo>

#include "viscera/medical_io/surface_pieces.h"
#include "window/import/file_actions.h"
#include "window/import/import_panel.h"
#include "window/import/organ_check.h"
#include "window/view/picture.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

constexpr const char* kImportSlot = "import";
constexpr double kGlass = 0.5, kSolid = 1;
/// Part of the diagonal: the camera does not move for a smaller difference.
constexpr double kElsewhere = 0.01;
const Vec3 kRemoved(0.85, 0.15, 0.1);

} // namespace

ImportController::ImportController(Workspace& workspace, FileActions& files, Picture& picture,
                                   QObject* parent)
    : QObject(parent), workspace_(workspace), files_(files), panel_(new ImportPanel), picture_(picture) {
  connect(panel_, &ImportPanel::accepted, this, &ImportController::accept);
  connect(panel_, &ImportPanel::cancelled, this, &ImportController::cancel);
  connect(panel_, &ImportPanel::repairRequested, this, &ImportController::repair);
  connect(panel_, &ImportPanel::previewRequested, this, &ImportController::previewRemoval);
  connect(panel_, &ImportPanel::revertRequested, this, &ImportController::revert);
  connect(panel_, &ImportPanel::includedChanged, this, &ImportController::include);
}

ImportController::~ImportController() {
  picture_.setTransientSurfaces({});
}

void ImportController::begin(document::ImportDraft draft, const QStringList& files) {
  if (open_)
    return workspace_.say({Message::Severity::warning,
                           tr("Import or cancel the files in the panel first, then open the others."),
                           {},
                           8});
  draft_ = std::move(draft);
  names_ = files;
  open_ = true;
  show();
  Q_EMIT opened();
}

void ImportController::accept() {
  if (!open_)
    return;
  const document::ImportDraft draft = std::move(draft_);
  const QStringList files = names_;
  close();
  files_.take(draft, files);
}

void ImportController::cancel() {
  if (!open_)
    return;
  workspace_.jobs().cancelSlot(kImportSlot);
  close();
}

bool ImportController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Close)
    cancel();
  return QObject::eventFilter(watched, event);
}

void ImportController::close() {
  open_ = false;
  draft_ = {};
  picture_.setTransientSurfaces({});
  Q_EMIT closed();
}

void ImportController::show() {
  removal_.clear(); // The new cards ask for no value.
  panel_->showDraft(draft_, names_.size() == 1
                                ? tr("Check of %1").arg(QFileInfo(names_.front()).fileName())
                                : tr("Check of %n files", nullptr, static_cast<int>(names_.size())));
  preview();
}

/// The organs in the view: transparent beside what the document holds, solid and alone where they will take
/// its place. They come into the picture when they lie elsewhere or are of another size.
void ImportController::preview() {
  const bool alone = files_.replacesPresent();
  std::vector<presentation::TransientSurface> surfaces;
  Bounds box;
  for (std::size_t i = 0; i < draft_.organs.size(); ++i) {
    const document::DraftOrgan& organ = draft_.organs[i];
    if (!organ.included)
      continue;
    const document::Organ& read = draft_.files.organs[i].organ;
    presentation::TransientSurface surface{organ.mesh, read.look.color, alone ? kSolid : kGlass,
                                           read.look.vertexColors};
    const Bounds own = boundsOf(organ.mesh->points);
    box = surfaces.empty() ? own : Bounds{box.low.cwiseMin(own.low), box.high.cwiseMax(own.high)};
    surfaces.push_back(std::move(surface));
  }
  if (!removal_.empty())
    addRemoved(surfaces);
  const double moved = (box.low - previewed_.low).norm() + (box.high - previewed_.high).norm();
  const bool elsewhere = !surfaces.empty() && moved > kElsewhere * box.diagonal();
  picture_.setTransientSurfaces(std::move(surfaces), alone);
  if (!elsewhere)
    return;
  picture_.view().frame(box);
  previewed_ = box;
}

/// Shows the part in red, while the organ around it becomes glass.
void ImportController::addRemoved(std::vector<presentation::TransientSurface>& surfaces) const {
  const auto& mesh = draft_.organs.at(fromOrgan_).mesh;
  const auto limit = medical_io::fragmentLimit(removal_.substr(removal_.find('=') + 1));
  if (!limit)
    return;
  for (presentation::TransientSurface& surface : surfaces)
    if (surface.mesh == mesh)
      surface.opacity = kGlass;
  auto part =
      std::make_shared<const geometry::TriangleMesh>(medical_io::SurfacePieces(*mesh).part(*limit, true));
  if (part->triangles.rows() > 0)
    surfaces.push_back({std::move(part), kRemoved, kSolid, false});
}

void ImportController::previewRemoval(std::size_t organ, const std::string& repair) {
  if (!open_)
    return;
  fromOrgan_ = organ;
  removal_ = repair.starts_with("remove-fragments=") ? repair : std::string();
  preview();
}

void ImportController::work(const QString& name, const std::vector<std::size_t>& organs,
                            std::function<document::ImportDraft(Progress&)> next) {
  panel_->setBusy(true);
  workspace_.jobs().submit<document::ImportDraft>(name.toStdString(), kImportSlot, std::move(next),
                                                  [this, organs](JobResult<document::ImportDraft> result) {
                                                    if (!open_)
                                                      return;
                                                    if (result.error)
                                                      workspace_.report(*result.error);
                                                    if (result.value)
                                                      draft_ = std::move(*result.value);
                                                    show();
                                                    if (result.value)
                                                      sayRefusals(organs);
                                                  });
}

/// Each card has its own reason.
void ImportController::sayRefusals(const std::vector<std::size_t>& organs) {
  std::vector<const DataError*> refusals;
  for (const std::size_t organ : organs)
    if (const auto& refusal = draft_.organs.at(organ).refusal)
      refusals.push_back(&*refusal);
  if (refusals.size() == 1)
    workspace_.report(*refusals.front());
  else if (!refusals.empty())
    workspace_.say(
        {Message::Severity::error,
         tr("%1 of %2 organs could not be repaired that way and stay as they are. The panel says why.")
             .arg(refusals.size())
             .arg(organs.size()),
         {},
         0});
}

void ImportController::repair(const std::vector<std::size_t>& organs, const std::string& repair) {
  if (open_)
    work(tr("Repairing: %1").arg(repairName(repair)), organs,
         [draft = draft_, organs, repair](Progress& progress) {
           return document::repaired(draft, organs, repair, progress);
         });
}

void ImportController::revert(std::size_t organ) {
  if (open_)
    work(tr("Checking again"), {organ},
         [draft = draft_, organ](Progress& progress) { return document::reverted(draft, organ, progress); });
}

void ImportController::include(const std::vector<std::size_t>& organs, bool included) {
  if (!open_)
    return;
  draft_ = document::withIncluded(std::move(draft_), organs, included);
  show();
}

} // namespace viscera::app
