#include "window/panels/explore_page.h"

#include <QAction>
#include <QFileInfo>
#include <QGridLayout>
#include <QLocale>
#include <QPushButton>

#include "window/widgets/ready_made.h"

namespace viscera::app {

ExplorePage::ExplorePage(Workspace& workspace, const Actions& actions, QWidget* cut, QWidget* measurements,
                         QWidget* parts, QWidget* parent)
    : Page(parent), workspace_(workspace) {
  addSection(tr("View from"));
  add(makeViews(actions));
  addButton(actions["view.focus"]);
  addSection(tr("Cut"));
  add(cut);
  addSection(tr("Measure"));
  add(measurements);
  addSection(tr("Parts"));
  add(parts);
  addSection(tr("Show"));
  for (const char* id : {"view.handles", "view.ghost", "view.cube", "view.scale", "view.measurements"})
    addCheck(actions[id]);
  addSection(tr("Organ"));
  name_ = addFact(tr("Name"));
  volume_ = addFact(tr("Volume at rest"));
  size_ = addFact(tr("Size"));
  triangles_ = addFact(tr("Triangles"));
  surface_ = addFact(tr("Surface"));
  file_ = addFact(tr("File"));
  warnings_ = addRemark(QString());
  finish();
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      sync();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { sync(); }));
  sync();
}

QWidget* ExplorePage::makeViews(const Actions& actions) {
  auto* box = new QWidget(this);
  auto* grid = makeLayout<QGridLayout>(box, 4);
  int index = 0;
  for (const char* id :
       {"view.anterior", "view.posterior", "view.left", "view.right", "view.superior", "view.inferior"}) {
    QAction* action = actions[id];
    auto* button = new QPushButton(action->iconText(), box);
    button->setToolTip(action->toolTip());
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    grid->addWidget(button, index / 2, index % 2);
    ++index;
  }
  return box;
}

void ExplorePage::sync() {
  const auto organ = workspace_.currentOrgan();
  const QString none = QStringLiteral("-");
  name_->setText(organ ? text(organ->name) : none);
  volume_->setText(organ && organ->closed() ? formatMilliliters(organ->restVolumeMm3 / kMm3PerMl) : none);
  triangles_->setText(organ ? locale().toString(static_cast<int>(organ->mesh->triangles.rows())) : none);
  surface_->setText(!organ            ? none
                    : organ->closed() ? tr("closed")
                                      : tr("open, %n {edge|edges}", nullptr, organ->boundaryEdges));
  file_->setText(organ && !organ->file.empty() ? QFileInfo(text(organ->file.string())).fileName() : none);
  file_->setToolTip(organ ? text(organ->file.string()) : QString());
  size_->setText(none);
  if (organ) {
    const Bounds bounds = boundsOf(organ->mesh->points);
    const Vec3 size = bounds.high - bounds.low;
    size_->setText(
        tr("%1 x %2 x %3 mm").arg(size.x(), 0, 'f', 0).arg(size.y(), 0, 'f', 0).arg(size.z(), 0, 'f', 0));
  }
  QStringList lines;
  if (organ)
    for (const std::string& warning : organ->warnings)
      lines.push_back(text(warning));
  warnings_->setText(lines.join(QLatin1Char('\n')));
  warnings_->setVisible(!lines.isEmpty());
}

} // namespace viscera::app
