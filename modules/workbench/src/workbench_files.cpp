#include <utility>

#include <nlohmann/json.hpp>

#include "viscera/document/import_draft.h"
#include "viscera/document/open_files.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/scan_item.h"
#include "viscera/document/system_commands.h"
#include "viscera/workbench/handle_placement.h"
#include "viscera/workbench/loaded_sample.h"
#include "workbench_parts.h"

// What a workbench reads and writes.
namespace viscera::workbench {

void Workbench::Impl::reset(document::SessionContents given) {
  motion.setSequence(nullptr);
  sequenceKnown = false;
  stress.follow({});
  undo.reset({}); // The ids of the other document mean nothing here.
  undo.reset(given.state);
  organs.showDocumentPose();
  contents = std::move(given);
  contents.state = {};
}

Opened Workbench::open(const std::vector<std::filesystem::path>& files) {
  if (files.size() == 1 && document::isSessionFile(files.front()))
    return restore(files.front());
  document::OpenedFiles read = document::accepted(document::draftOf(
      document::openPatient(files, *impl_->progress, {}, document::Sessions::alone, state().scan),
      *impl_->progress));
  Opened opened{std::move(read.warnings), std::move(read.failures)};
  std::vector<document::Command> commands;
  if (read.scan)
    commands.push_back(document::openScan(*read.scan));
  const Text name = read.name;
  commands.push_back(document::openCommand(
      name, std::move(read), false,
      [](const document::Organ&, const document::OrganList& organs) { return placeHandlesOrBox(organs); }));
  perform(document::combined(name, std::move(commands)));
  return opened;
}

void Workbench::openSample(const std::string& name, sample_organs::Resolution resolution) {
  LoadedSample sample =
      loadSample(impl_->setup.samples, name, resolution, *impl_->progress, impl_->setup.threads);
  impl_->reset({});
  impl_->perform(document::combined(
      named(name),
      {document::setSystem(sample.system), document::addOrgans(std::move(sample.organs)),
       document::Command{{}, [&sample](const document::DocumentState& state, document::IdSource& ids) {
                           return (sample.motion ? document::replaceRig(sample.rig)
                                                 : placeHandles(wholeOrgans(*state.organs), *state.organs))
                               .apply(state, ids);
                         }}}));
  impl_->undo.reset(impl_->document.state());
  impl_->motion.setSequence(sample.motion);
  impl_->sequenceKnown = true;
  if (sample.motion)
    impl_->contents.view =
        live::viewOf({{{state().organs->front()->id, sample.recipe}}, live::Playing{.motion = 0}});
  impl_->finish();
}

Opened Workbench::restore(const std::filesystem::path& session) {
  document::OpenedSession read = document::readSession(session, impl_->setup.samples, *impl_->progress);
  restore(std::move(read.contents));
  return {std::move(read.warnings), {}};
}

void Workbench::restore(document::SessionContents contents) {
  impl_->reset(std::move(contents));
  impl_->finish();
}

document::SessionContents Workbench::session() const {
  document::SessionContents contents = impl_->contents;
  contents.state = state();
  return contents;
}

void Workbench::save(const std::filesystem::path& session, std::optional<bool> embed) {
  if (embed)
    impl_->contents.embedSurfaces = impl_->contents.embedScan = *embed;
  document::writeSession(session, this->session(), *impl_->progress);
  impl_->undo.markSaved();
  impl_->finish();
}

} // namespace viscera::workbench
