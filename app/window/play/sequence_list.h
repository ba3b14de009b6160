#pragma once

#include <QListWidget>

#include "window/timeline/playback.h"

namespace viscera::app {

/// A list of the sequences that can be played, each with a picture: those that suit the current organ first,
/// then the program's other sequences, then those of the user.
class SequenceList final : public QListWidget {
  Q_OBJECT

public:
  SequenceList(Workspace& workspace, Playback& playback, QWidget* parent = nullptr);

  QSize sizeHint() const override;

Q_SIGNALS:
  /// The user has chosen the sequence with this id.
  void sequenceChosen(const QString& id);

protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void rebuild();
  /// An entry of the list.
  struct Item {
    QString id;
    QString name;
    QString tip;
    friend bool operator==(const Item&, const Item&) = default;
  };

  std::vector<Item> wanted() const;
  void addSequence(const Item& item);
  void syncCurrent();

  Workspace& workspace_;
  Playback& playback_;
  std::vector<Item> shown_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
