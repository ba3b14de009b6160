#include "window/view/heart_opener.h"

#include <QPointer>

#include "viscera/presentation/opened_heart.h"

namespace viscera::app {

HeartOpener::HeartOpener(Workspace& workspace, ViewModel& model, QObject* parent)
    : QObject(parent), workspace_(workspace), model_(model) {
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      follow();
  }));
  connect(&model, &ViewModel::changed, this, &HeartOpener::follow);
  follow();
}

void HeartOpener::follow() {
  const auto opened = presentation::openedHeart(workspace_.state(), model_.state());
  if (!opened) {
    if (!busy_)
      asked_.reset();
    return;
  }
  const bool there = tissue_ && tissue_->isOf(opened->heart);
  if (!there && !(asked_ && live::sameSurfaces(*asked_, opened->heart)))
    make(opened->heart);
}

void HeartOpener::make(const live::SampleHeartOrgans& heart) {
  using Tissue = std::shared_ptr<const live::HeartTissue>;
  asked_ = heart;
  busy_ = true;
  workspace_.jobs().submit<Tissue>(
      tr("Opening the heart").toStdString(), kSlot,
      [heart](Progress& progress) {
        return live::makeHeartTissue(heart, sample_organs::standardLibrary(), progress);
      },
      [guard = QPointer<HeartOpener>(this)](JobResult<Tissue> result) {
        if (!guard)
          return;
        guard->busy_ = false;
        if (result.error)
          guard->workspace_.report(*result.error);
        if (!result.value || !*result.value)
          return;
        guard->tissue_ = std::move(*result.value);
        Q_EMIT guard->made();
      });
}

} // namespace viscera::app
