#pragma once

#include <QFrame>

#include <vector>

#include "window/work/workspace.h"

class QLabel;
class QPushButton;

namespace viscera::app {

/// A card over the view that asks which organ a sequence is to move when the user's own organs are open: the
/// current organ, to which it is fitted, or its sample organ, which takes the place of all organs. Hidden
/// until `ask` is called; the answer that suits the organ's name better is the highlighted button.
class FitOffer final : public QFrame {
  Q_OBJECT

public:
  explicit FitOffer(Workspace& workspace, QWidget* parent = nullptr);

  /// Asks about the sequence of that id.
  void ask(const QString& sequence);

Q_SIGNALS:
  void fitChosen(const QString& sequence);
  void sampleChosen(const QString& sequence);

private:
  QPushButton* makeButton(const char* name);

  Workspace& workspace_;
  QString sequence_;
  std::shared_ptr<const document::Organ> asked_; ///< The organ that the question is about.
  QLabel* question_;
  QPushButton* fit_;
  QPushButton* sample_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
