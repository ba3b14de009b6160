#pragma once

#include <QListWidget>

#include "window/timeline/playback.h"

namespace viscera::app {

/// The sequences there are, each with a picture: those that the program brings and those of the user.
class SequenceList final : public QListWidget {
  Q_OBJECT

public:
  explicit SequenceList(Playback& playback, QWidget* parent = nullptr);

  QSize sizeHint() const override;

Q_SIGNALS:
  /// The user has chosen one, by its id.
  void sequenceChosen(const QString& id);

protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void rebuild();
  void addSequence(const QString& id, const QString& name, const QString& tip);
  void syncCurrent();

  Playback& playback_;
};

} // namespace viscera::app
