#include "window/timeline/sample_loader.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <vector>

#include "viscera/document/system_commands.h"

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
  workspace_.jobs().submit<workbench::LoadedSample>(
      tr("Sample %1").arg(nameInWords(name)).toStdString(), kSlot,
      [library = library_, id = name.toStdString()](Progress& progress) {
        return workbench::loadSample(library, id, sample_organs::Resolution::medium, progress);
      },
      [this, name, play](JobResult<workbench::LoadedSample> result) {
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

void SampleLoader::take(const workbench::LoadedSample& sample, const QString& name) {
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
