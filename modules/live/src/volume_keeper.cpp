#include "viscera/live/volume_keeper.h"

#include <algorithm>
#include <cmath>

#include "bound_organ.h"
#include "lock_preparation.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/deformer.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/document/edit.h"
#include "viscera/live/tissue_energy.h"

namespace viscera::live {

/// The energy of the tissue in surfaces that hang on handles.
struct KnownTissue {
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> surfaces;
  BindingTarget target;
  std::shared_ptr<const elasticity::LeastEnergy> energy;
};

namespace {

using deformation::LockedSurface;
using deformation::VolumeLock;

std::vector<int> rowsOf(const document::Rig& rig, const std::vector<document::HandleId>& handles) {
  std::vector<int> rows;
  for (const auto& [row, item] : document::edit::freeRows(rig, handles))
    rows.push_back(row);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

} // namespace

VolumeKeeper::VolumeKeeper(const document::DocumentState& state, PosedOrgans& organs, Threads threads,
                           JobQueue* jobs)
    : state_(state), organs_(organs), threads_(threads),
      preparation_(jobs ? std::make_shared<LockPreparation>(*jobs, threads) : nullptr) {}

std::vector<std::shared_ptr<const document::Organ>> VolumeKeeper::lockedOrgans() {
  std::vector<std::shared_ptr<const document::Organ>> locked;
  for (const auto& organ : *state_.organs)
    if (organ->volumeLocked && organ->closed() && organs_.bound(organ->id))
      locked.push_back(organ);
  return locked;
}

std::vector<LockedSurface>
VolumeKeeper::surfacesOf(const std::vector<std::shared_ptr<const document::Organ>>& organs) const {
  std::vector<LockedSurface> surfaces;
  for (const auto& organ : organs) {
    const deformation::Deformer& deformer = *organs_.bound(organ->id);
    surfaces.push_back({organ->name, deformer.sharedRest(), deformer.sharedBinding(), organ->restVolumeMm3});
  }
  return surfaces;
}

/// The locked surfaces as they are bound; none while one is being bound.
std::vector<LockedSurface> VolumeKeeper::preparable() {
  try {
    return surfacesOf(lockedOrgans());
  } catch (const DataError&) {
    return {};
  }
}

void VolumeKeeper::prepare() {
  if (preparation_)
    preparation_->want(preparable(), lock_.get());
}

void VolumeKeeper::dropOutdated() {
  if (preparation_)
    preparation_->keepOnly(preparable());
}

std::shared_ptr<VolumeLock>
VolumeKeeper::lockOf(const std::vector<std::shared_ptr<const document::Organ>>& organs) {
  if (organs.empty())
    return nullptr;
  // The adjacency of triangles takes longer to find than a frame lasts: one lock takes it from the other.
  // A motion that is under way keeps the lock, and with it the targets, that it began with.
  std::vector<LockedSurface> surfaces = surfacesOf(organs);
  if (!preparation_) {
    lock_ = std::make_shared<VolumeLock>(std::move(surfaces), threads_, VolumeLock::Forms::whenAsked,
                                         std::vector<std::shared_ptr<const VolumeLock>>{lock_});
    return lock_;
  }
  lock_ = std::make_shared<VolumeLock>(
      surfaces, threads_, VolumeLock::Forms::given,
      std::vector<std::shared_ptr<const VolumeLock>>{preparation_->ready(), lock_});
  preparation_->want(std::move(surfaces), lock_.get());
  return lock_;
}

/// The volumes that the organs have now.
void VolumeKeeper::takeTargets(VolumeLock& lock,
                               const std::vector<std::shared_ptr<const document::Organ>>& organs) const {
  const std::vector<double> now = lock.volumes(*state_.pose);
  for (std::size_t k = 0; k < organs.size(); ++k) {
    const double rest = organs[k]->restVolumeMm3;
    lock.setTarget(k, std::abs(now[k] - rest) <= kSameVolume * rest ? rest : now[k]);
  }
}

double VolumeKeeper::limitMm() const {
  return kFarthestCompensation * boundsOf(state_.rig->restPositions()).diagonal();
}

bool VolumeKeeper::anyMarked(const std::vector<int>& rows) const {
  return std::any_of(rows.begin(), rows.end(), [this](int row) {
    return state_.rig->handles[static_cast<std::size_t>(row)].compensates;
  });
}

/// The handles that are not locked and do not move.
std::vector<int> VolumeKeeper::freeBut(const std::vector<int>& moving) const {
  std::vector<int> free;
  const auto& handles = state_.rig->handles;
  for (int row = 0; row < static_cast<int>(handles.size()); ++row)
    if (!handles[static_cast<std::size_t>(row)].locked &&
        std::find(moving.begin(), moving.end(), row) == moving.end())
      free.push_back(row);
  return free;
}

/// The handles that the user marked and that are free, else all that are free.
std::vector<int> VolumeKeeper::compensating(const std::vector<int>& moving) const {
  std::vector<int> free = freeBut(moving);
  const auto& handles = state_.rig->handles;
  if (anyMarked(free))
    std::erase_if(free, [&handles](int row) { return !handles[static_cast<std::size_t>(row)].compensates; });
  return free;
}

std::vector<int> VolumeKeeper::partners(const std::vector<document::HandleId>& handles,
                                        const deformation::MirrorPlane& mirror) const {
  const Points rest = state_.rig->restPositions();
  auto found = deformation::mirrorPartners(rest, rowsOf(*state_.rig, handles), mirror,
                                           kMirrorTolerance * boundsOf(rest).diagonal());
  for (int& partner : found)
    if (partner >= 0 && state_.rig->handles[static_cast<std::size_t>(partner)].locked)
      partner = -1;
  return found;
}

/// The energy of the organs that bend, made again when they or their handles are others.
std::shared_ptr<const elasticity::LeastEnergy> VolumeKeeper::tissue() {
  if (!systems_)
    throw UsageError(misuse("handles cannot follow without the coordinate systems"));
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> surfaces;
  for (const auto& organ : *state_.organs)
    if (organ->mobility == document::Mobility::bends && organs_.bound(organ->id))
      surfaces.push_back(organ->mesh);
  BindingTarget target = makeTarget(state_, *systems_);
  if (tissue_ && tissue_->surfaces == surfaces && sameBinding(tissue_->target, target))
    return tissue_->energy;
  if (!target.system)
    throw DataError(target.problem);
  Progress progress;
  auto energy = tissueEnergy(surfaces, *target.system, target.handles,
                             deformation::withTetgen({target.parameters, threads_}), progress);
  tissue_ = std::make_shared<const KnownTissue>(
      KnownTissue{std::move(surfaces), std::move(target), std::move(energy)});
  return tissue_->energy;
}

LockedMotion VolumeKeeper::begin(const std::vector<document::HandleId>& handles,
                                 const std::optional<deformation::MirrorPlane>& mirror,
                                 const std::optional<Vec3>& plane, Others others) {
  const auto organs = lockedOrgans();
  LockedMotion::Setup setup{lockOf(organs), *state_.pose, rowsOf(*state_.rig, handles)};
  setup.plane = plane;
  if (mirror)
    setup.mirror = {*mirror, partners(handles, *mirror)};
  std::vector<int> moving = setup.selection;
  if (setup.mirror)
    moving.insert(moving.end(), setup.mirror->partners.begin(), setup.mirror->partners.end());
  if (others == Others::follow) {
    setup.following = freeBut(moving);
    setup.tissue = tissue();
  }
  if (setup.lock) {
    takeTargets(*lock_, organs);
    setup.compensating = compensating(moving);
    setup.alwaysCompensate = others == Others::compensate || anyMarked(setup.compensating);
    setup.limitMm = limitMm();
  }
  return LockedMotion(std::move(setup));
}

/// An organ that handles can give another volume.
std::shared_ptr<const document::Organ> VolumeKeeper::requireVolume(document::OrganId id) const {
  const auto organ = document::edit::requireOrgan(state_, id);
  if (!organ->closed())
    throw DataError(
        phrase("the surface is open (%n boundary {edge|edges}), so it has no volume that could be locked",
               organ->boundaryEdges),
        named(organ->name), "close its holes first");
  if (!organs_.bound(id))
    throw DataError("it follows no handles, so nothing can change its volume", named(organ->name),
                    "place handles around it");
  return organ;
}

deformation::RestoredPose VolumeKeeper::keep(const Points& wanted, const std::optional<AskedVolume>& asked) {
  auto organs = lockedOrgans();
  if (asked) {
    std::erase_if(organs, [&](const auto& organ) { return organ->id == asked->organ; });
    organs.insert(organs.begin(), requireVolume(asked->organ));
  }
  const auto lock = lockOf(organs);
  if (!lock)
    return {wanted, true, 0, 0, {}};
  takeTargets(*lock, organs);
  if (asked)
    lock->setTarget(0, asked->mm3);
  return lock->restore(wanted, compensating({}), deformation::LeastDisplacement(), limitMm());
}

Points VolumeKeeper::poseOfVolume(document::OrganId id, double targetMm3) {
  auto restored = keep(*state_.pose, AskedVolume{id, targetMm3});
  if (!restored.restored)
    throw DataError(restored.reason, named(state_.organ(id)->name),
                    "let more handles compensate, or ask for a volume nearer to the present one");
  return std::move(restored.pose);
}

} // namespace viscera::live
