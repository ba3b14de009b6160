#include "viscera/workbench/workbench.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "viscera/document/measurement.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/live/motion_copy.h"
#include "workbench_parts.h"

namespace viscera::workbench {
namespace {

constexpr double kAtOnce = std::numeric_limits<double>::infinity(); ///< A frame that lasts for ever.

live::LiveStress::Options stressOptions(Threads threads) {
  live::LiveStress::Options options;
  options.frameSeconds = kAtOnce;
  options.threads = options.witnesses.threads = threads;
  return options;
}

/// A name that a document does not have.
[[noreturn]] void failWithout(const char* problem, const std::string& name,
                              const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& one : known)
    list += (list.empty() ? "" : ", ") + one;
  throw UsageError(misuse(problem, name), {}, misuse("choose one of: %1", list));
}

} // namespace

Workbench::Impl::Impl(Setup with, Progress* told)
    : setup(std::move(with)), progress(told ? told : &unheard),
      organs(document, setup.systems, jobs, {kAtOnce, setup.threads}),
      stress(document, setup.systems, organs, jobs, stressOptions(setup.threads)),
      warp(document, organs, setup.systems, jobs, {kAtOnce, setup.threads}),
      keeper(document.state(), organs, setup.threads), motion(document.state(), organs, setup.threads) {
  keeper.setSystems(setup.systems);
}

void Workbench::Impl::settle() {
  const Subscription told = jobs.onChange([this] {
    const std::vector<JobInfo> all = jobs.jobs();
    if (!all.empty() && all.front().running)
      progress->report(all.front().fraction, all.front().step);
  });
  loop.runUntil([this] {
    if (progress->cancelled())
      jobs.cancelAll();
    return jobs.idle();
  });
  progress->throwIfCancelled();
}

void Workbench::Impl::finish() {
  settle();
  happened.emit();
}

void Workbench::Impl::perform(const document::Command& command) {
  undo.seal();
  undo.perform(command);
  organs.showDocumentPose();
}

std::shared_ptr<const document::Organ> Workbench::Impl::requireOrgan(const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& organ : document.organs()) {
    if (organ->name == name)
      return organ;
    names.push_back(organ->name);
  }
  failWithout("There is no organ \"%1\"", name, names);
}

int Workbench::Impl::requireRow(const std::string& label) const {
  const int row = document.rig().indexOf(label);
  if (row >= 0)
    return row;
  std::vector<std::string> labels;
  for (const document::Handle& handle : document.rig().handles)
    labels.push_back(handle.label);
  failWithout("There is no handle \"%1\"", label, labels);
}

std::shared_ptr<const sequences::Sequence> Workbench::Impl::sequence() {
  if (sequenceKnown)
    return motion.sequence();
  const live::SessionMotion saved = live::sessionMotion(contents.view, document.circulation());
  auto made = live::makeSequence(document.state(), saved, setup.samples, *progress, setup.threads);
  motion.setSequence(made);
  if (made) {
    motion.setRatePerMinute(live::rateOf(saved, *made));
    motion.prescribe(live::prescribedVolume(document.state(), saved));
  }
  sequenceKnown = true;
  return made;
}

PlayedVolumes Workbench::Impl::show(double seconds) {
  motion.show(seconds);
  return {seconds, motion.volumesMl(), motion.obstacle()};
}

Workbench::Workbench() : Workbench(Setup()) {}

Workbench::Workbench(Setup setup, Progress* progress)
    : impl_(std::make_unique<Impl>(std::move(setup), progress)) {}

Workbench::~Workbench() = default;

void Workbench::tell(Progress* progress) {
  impl_->progress = progress ? progress : &impl_->unheard;
}

const document::DocumentState& Workbench::state() const {
  return impl_->document.state();
}

void Workbench::perform(const document::Command& command) {
  impl_->perform(command);
  impl_->finish();
}

bool Workbench::undo() {
  if (!impl_->undo.canUndo())
    return false;
  impl_->undo.undo();
  impl_->organs.showDocumentPose();
  impl_->finish();
  return true;
}

bool Workbench::redo() {
  if (!impl_->undo.canRedo())
    return false;
  impl_->undo.redo();
  impl_->organs.showDocumentPose();
  impl_->finish();
  return true;
}

const document::UndoStack& Workbench::steps() const {
  return impl_->undo;
}

document::OrganId Workbench::organ(const std::string& name) const {
  return impl_->requireOrgan(name)->id;
}

document::HandleId Workbench::handle(const std::string& label) const {
  return state().rig->handles[static_cast<std::size_t>(impl_->requireRow(label))].id;
}

void Workbench::lock(const std::string& organ, bool locked) {
  perform(document::setVolumeLocked(impl_->requireOrgan(organ)->id, locked));
}

Vec3 Workbench::drag(const std::string& handle, const Vec3& by, live::Others others) {
  const document::HandleId moved = this->handle(handle);
  live::LockedMotion motion = impl_->keeper.begin({moved}, std::nullopt, std::nullopt, others);
  motion.translate(by);
  if (motion.selection().empty()) // The handle itself is locked.
    return Vec3::Zero();
  if (others != live::Others::asMarked)
    live::requireExact(motion, by);
  document::Command command = document::setPose(motion.sharedPose());
  command.name = document::moveHandles({moved}, Points::Zero(1, 3)).name;
  perform(command);
  return motion.given();
}

void Workbench::pose(const Points& places, live::Others others) {
  if (places.rows() != state().pose->rows() || !places.allFinite())
    return perform(document::setPose(places)); // Refuses it.
  if (others == live::Others::follow) {
    std::vector<document::HandleId> sent;
    for (Eigen::Index row = 0; row < places.rows(); ++row)
      if (places.row(row) != state().pose->row(row))
        sent.push_back(state().rig->handles[static_cast<std::size_t>(row)].id);
    live::LockedMotion motion = impl_->keeper.begin(sent, std::nullopt, std::nullopt, others);
    motion.reach(places);
    if (!motion.obstacle().empty())
      throw DataError(motion.obstacle(), {}, "unlock it, or move the handles less far");
    return perform(document::setPose(motion.sharedPose()));
  }
  deformation::RestoredPose kept = impl_->keeper.keep(places);
  if (!kept.restored)
    throw DataError(kept.reason, {}, "unlock it, or let more handles compensate");
  perform(document::setPose(std::move(kept.pose)));
}

void Workbench::rest() {
  perform(document::resetPose());
}

void Workbench::showPose(const Points& places) {
  impl_->organs.showPose(places);
  impl_->finish();
}

void Workbench::showRest() {
  impl_->organs.showRest();
  impl_->finish();
}

void Workbench::showDocumentPose() {
  impl_->organs.showDocumentPose();
  impl_->finish();
}

live::LiveBinding& Workbench::organs() {
  return impl_->organs;
}

const live::LiveBinding& Workbench::organs() const {
  return impl_->organs;
}

live::OrganVolume Workbench::volume(const std::string& organ) {
  return impl_->organs.volume(impl_->requireOrgan(organ)->id);
}

const sequences::Sequence* Workbench::sequence() {
  return impl_->sequence().get();
}

std::shared_ptr<const sequences::Sequence> Workbench::sharedSequence() {
  return impl_->sequence();
}

void Workbench::setSequence(std::shared_ptr<const sequences::Sequence> sequence, double rate) {
  impl_->motion.setSequence(std::move(sequence));
  impl_->sequenceKnown = true;
  if (rate > 0)
    impl_->motion.setRatePerMinute(rate);
  impl_->finish();
}

live::MotionRunner& Workbench::motion() {
  impl_->sequence();
  return impl_->motion;
}

PlayedVolumes Workbench::show(double seconds) {
  motion().requireMovable();
  PlayedVolumes played = impl_->show(seconds);
  impl_->finish();
  return played;
}

std::vector<PlayedVolumes> Workbench::play(double framesPerSecond, double cycles) {
  motion().requireMovable();
  const int frames = frameCount(impl_->motion.ratePerMinute(), framesPerSecond, cycles);
  std::vector<PlayedVolumes> played;
  for (int frame = 0; frame < frames; ++frame) {
    impl_->progress->throwIfCancelled();
    played.push_back(impl_->show(frame / framesPerSecond));
    impl_->progress->report(static_cast<double>(frame + 1) / frames);
  }
  impl_->finish();
  return played;
}

live::CycleCurves Workbench::cycle() {
  motion().requireMovable();
  live::MotionCopy copy(impl_->motion, impl_->organs.copy());
  return live::measureCycle(copy.runner(), *impl_->progress);
}

const live::LiveStress& Workbench::stress(const std::string& organ, int witnesses) {
  if (const Text missing = tryStress(impl_->requireOrgan(organ)->id, witnesses); !missing.empty())
    throw DataError(missing, named(organ));
  return impl_->stress;
}

Text Workbench::tryStress(document::OrganId organ, int witnesses) {
  impl_->stress.setWanted(witnesses);
  impl_->stress.follow(organ);
  impl_->finish();
  const live::StressStatus& status = impl_->stress.status();
  if (status.state == live::StressStatus::State::ready)
    return {};
  return status.message.empty() ? misuse("there is no organ") : status.message;
}

void Workbench::findStressCycle(live::CycleParts parts) {
  if (!sequence() || !impl_->motion.movable())
    return;
  impl_->stress.findCycle(live::posedCycle(impl_->motion, impl_->organs.copy()), parts);
  impl_->finish();
}

live::LiveStress& Workbench::stressMap() {
  return impl_->stress;
}

document::MeasuredValues Workbench::measure(const document::Measurement& measurement) {
  return document::measure(
      measurement, state(),
      [this](document::OrganId organ) -> const Points& { return impl_->organs.points(organ); },
      &impl_->memory);
}

document::MeasuredValues Workbench::measure(const std::string& measurement) {
  std::vector<std::string> names;
  for (const document::Measurement& one : *state().measurements) {
    if (one.name == measurement)
      return measure(one);
    names.push_back(one.name);
  }
  failWithout("There is no measurement \"%1\"", measurement, names);
}

live::LiveWarp* Workbench::warp() {
  impl_->warp.setWanted(true);
  impl_->settle();
  if (!impl_->warp.problem().empty())
    throw DataError(impl_->warp.problem(), diagnostic("the scan cannot be warped"));
  return impl_->warp.map() ? &impl_->warp : nullptr;
}

Subscription Workbench::onHappened(std::function<void()> observer) {
  return impl_->happened.connect(std::move(observer));
}

int frameCount(double ratePerMinute, double framesPerSecond, double cycles) {
  return std::max(1, static_cast<int>(std::lround(cycles * 60.0 / ratePerMinute * framesPerSecond)));
}

} // namespace viscera::workbench
