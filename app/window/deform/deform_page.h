#pragma once

#include "window/modes/mode.h"
#include "window/view/pose_editor.h"
#include "window/widgets/page.h"
#include "window/work/actions.h"
#include "window/work/workspace.h"

class QComboBox;

namespace viscera::app {

class ElasticGhost;
class VolumeBox;

/// The property page of the mode Deform: volume, lock and target, positions to type, compensating handles,
/// mirror, and reset.
class DeformPage final : public Page {
  Q_OBJECT

public:
  /// All have to live longer.
  DeformPage(const ModeParts& parts, const Actions& actions, const ElasticGhost& ghost,
             QWidget* parent = nullptr);

private:
  void addMirror();
  void addElasticity(const Actions& actions);
  void sync();
  void syncMoved();
  void syncHandles();
  void syncElasticity();

  Workspace& workspace_;
  PoseEditor& poses_;
  ViewModel& view_;
  const ElasticGhost& ghost_;
  VolumeBox* volume_ = nullptr;
  QLabel* organ_ = nullptr;
  QLabel* now_ = nullptr;
  QLabel* rest_ = nullptr;
  QLabel* change_ = nullptr;
  QLabel* moved_ = nullptr;
  QLabel* farthest_ = nullptr;
  QLabel* compensating_ = nullptr;
  QLabel* partners_ = nullptr;
  QLabel* elasticMedian_ = nullptr;
  QLabel* elasticLargest_ = nullptr;
  QLabel* elasticReason_ = nullptr;
  QComboBox* mirror_ = nullptr;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
