#include "window/sample_loader.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <vector>

#include "viscera/anatomy/part.h"
#include "viscera/document/open_files.h"
#include "viscera/document/system_commands.h"
#include "viscera/live/sequence_setup.h"
#include "window/heart_look.h"

namespace viscera::app {
SampleLoader::SampleLoader(Workspace& workspace, HandlePlacer& placer, Playback& playback, QObject* parent)
    : QObject(parent), workspace_(workspace), placer_(placer), playback_(playback),
      library_(sample_organs::standardLibrary()) {}

QString SampleLoader::nameInWords(const QString& name) {
  static const std::map<QString, const char*> kNames = {
      {QStringLiteral("digestive_system"),
       QT_TRANSLATE_NOOP("viscera::app::SampleNames", "digestive system")},
      {QStringLiteral("heart"), QT_TRANSLATE_NOOP("viscera::app::SampleNames", "heart")},
      {QStringLiteral("kidney_left"), QT_TRANSLATE_NOOP("viscera::app::SampleNames", "left kidney")},
      {QStringLiteral("kidney_right"), QT_TRANSLATE_NOOP("viscera::app::SampleNames", "right kidney")},
      {QStringLiteral("liver"), QT_TRANSLATE_NOOP("viscera::app::SampleNames", "liver")},
      {QStringLiteral("stomach"), QT_TRANSLATE_NOOP("viscera::app::SampleNames", "stomach")},
      {QStringLiteral("stomach_and_bowel"),
       QT_TRANSLATE_NOOP("viscera::app::SampleNames", "stomach and bowel")}};
  const auto known = kNames.find(name);
  return known == kNames.end() ? QString(name).replace(QLatin1Char('_'), QLatin1Char(' '))
                               : QCoreApplication::translate("viscera::app::SampleNames", known->second);
}

QString SampleLoader::title(const QString& name) {
  QString title = nameInWords(name);
  title[0] = title[0].toUpper();
  return title;
}

QStringList SampleLoader::names() const {
  QStringList names;
  for (const std::string& name : sample_organs::sampleNames(library_))
    names.push_back(text(name));
  return names;
}

void SampleLoader::load(const QString& name, bool play) {
  Q_EMIT began(name);
  workspace_.jobs().submit<Sample>(
      tr("Sample %1").arg(nameInWords(name)).toStdString(), kSlot,
      [library = library_, id = name.toStdString()](Progress& progress) {
        return make(library, id, progress);
      },
      [this, name, play](JobResult<Sample> result) {
        if (result.error)
          workspace_.report(*result.error);
        if (result.value) {
          take(*result.value, name);
          if (play && playback_.sequence() && playback_.wantedPose() == live::WantedPose::sequence)
            playback_.play();
        }
        Q_EMIT ended();
      });
}

bool SampleLoader::loading() const {
  const std::vector<JobInfo> jobs = workspace_.jobs().jobs();
  return std::any_of(jobs.begin(), jobs.end(), [](const JobInfo& job) { return job.slot == kSlot; });
}

SampleLoader::Sample SampleLoader::make(const sample_organs::SampleLibrary& library, const std::string& name,
                                        Progress& progress) {
  constexpr auto resolution = sample_organs::Resolution::medium;
  Sample sample;
  for (const live::SampleSequence& motion : live::sampleSequences()) {
    if (motion.organ != name)
      continue;
    live::SequenceSetup setup = live::setUpSequence(library, motion.id, resolution, progress);
    sample.organs = document::organsFrom(setup.organ);
    sample.motion = setup.sequence;
    sample.recipe = live::SampleMotion{motion.id, resolution};
    sample.rig = std::move(setup.rig);
    sample.system = std::move(setup.system);
    break;
  }
  if (!sample.motion)
    sample.organs = document::organsFrom(sample_organs::sampleOrgan(library, name, resolution, progress));
  dress(sample.organs);
  return sample;
}

void SampleLoader::dress(std::vector<document::NewOrgan>& organs) {
  for (const document::NewOrgan& organ : organs)
    if (organ.parentInBatch >= 0)
      organs[organ.parentInBatch].organ.look.opacity = kWallOpacity;
  for (document::NewOrgan& organ : organs) {
    document::OrganLook& look = organ.organ.look;
    const Colors& painted = organ.organ.mesh->colors;
    if (painted.rows() > 0)
      look.color = painted.cast<double>().colwise().mean().transpose() / 255.0;
    // Blood in its textbook colours: they stay apart also through the wall.
    if (const auto chamber = anatomy::chamberNamed(organ.organ.name))
      look.color = anatomy::colorOf(*chamber);
    look.vertexColors = organ.parentInBatch < 0;
  }
}

void SampleLoader::take(const Sample& sample, const QString& name) {
  playback_.setSequence(nullptr, {});
  const bool untouched = workspace_.undo().isClean();
  const bool first = workspace_.undo().names().empty() && workspace_.document().organs().empty();
  const bool done = workspace_.guarded([&] {
    document::UndoStack& undo = workspace_.undo();
    document::UndoStack::Step step(undo, tr("Sample %1").arg(nameInWords(name)).toStdString());
    const document::OrganList& present = workspace_.document().organs();
    if (!present.empty())
      undo.perform(document::removeAllOrgans());
    undo.perform(document::replaceRig({}));
    undo.perform(document::setSystem(sample.system));
    undo.perform(document::addOrgans(sample.organs));
    undo.perform(sample.motion ? document::replaceRig(sample.rig)
                               : placer_.command(workspace_.document().organs()));
    step.finish();
  });
  if (!done)
    return;
  const auto& organ = workspace_.document().organs().front();
  workspace_.selection().setOrgan(organ->id);
  if (sample.motion)
    playback_.setSequence(sample.motion, organ->id, sample.recipe);
  Q_EMIT loaded(name, untouched, first);
}

} // namespace viscera::app
