#pragma once

#include <QObject>

#include <memory>
#include <vector>

#include "viscera/scene/organ_labels.h"
#include "window/style/theme.h"
#include "window/view/organ_scene.h"
#include "window/workspace.h"

namespace viscera::app {

/// What is written beside an organ: "Left ventricle" for a cavity that is called LV, else its name.
QString labelOf(const document::Organ& organ);

/// The labels for organs of a document that have an actor; `actorOf` may give null.
std::vector<scene::OrganLabels::Item>
labelItems(const document::Document& document,
           const std::function<std::shared_ptr<const scene::OrganActor>(document::OrganId)>& actorOf);

/// Keeps the labels of a view as the document has the organs.
class LabelScene final : public QObject {
  Q_OBJECT

public:
  LabelScene(Workspace& workspace, OrganScene& organs, scene::OrganView& view, QObject* parent = nullptr);

  void setShown(bool shown);
  void setTheme(const scene::Theme& theme);
  const scene::OrganLabels& labels() const { return labels_; }

Q_SIGNALS:
  /// Something looks different: render when convenient.
  void changed();

private:
  void sync();

  Workspace& workspace_;
  OrganScene& organs_;
  scene::OrganLabels labels_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
