#include "window/view/view_actions.h"

#include <QDateTime>

#include "viscera/document/organ_commands.h"
#include "viscera/scene/picture.h"

namespace viscera::app {

ViewActions::ViewActions(const Parts& parts, Actions& actions, QObject* parent)
    : QObject(parent), parts_(parts) {
  actions.add("file.screenshot",
              {tr("Save s&creenshot"), "camera", {Qt::Key_F12}, tr("Save a picture of the 3D view")},
              [this] { saveScreenshot(); });
  makeViews(actions);
  actions.add("view.focus",
              {tr("&Focus"), "focus", {Qt::Key_F}, tr("Bring the selected organ, or all, into the picture")},
              [this] { focus(); });
  actions.enableWhile({"view.focus"}, [this] { return !parts_.workspace.document().organs().empty(); });
  makeSwitches(actions);
}

void ViewActions::makeViews(Actions& actions) {
  struct View {
    const char* id;
    QString name;
    QKeySequence key;
    scene::StandardView view;
  };
  // The digits of the keypad; those of the main row choose the mode.
  const auto keypad = [](int key, bool shift) {
    return QKeySequence(static_cast<int>(Qt::KeypadModifier) + (shift ? static_cast<int>(Qt::SHIFT) : 0) +
                        key);
  };
  using scene::StandardView;
  const View views[] = {
      {"view.anterior", tr("&Anterior"), keypad(Qt::Key_1, false), StandardView::anterior},
      {"view.posterior", tr("&Posterior"), keypad(Qt::Key_1, true), StandardView::posterior},
      {"view.left", tr("&Left"), keypad(Qt::Key_3, false), StandardView::left},
      {"view.right", tr("&Right"), keypad(Qt::Key_3, true), StandardView::right},
      {"view.superior", tr("&Superior"), keypad(Qt::Key_7, false), StandardView::superior},
      {"view.inferior", tr("&Inferior"), keypad(Qt::Key_7, true), StandardView::inferior}};
  for (const View& view : views)
    actions.add(view.id, {view.name, "view", {view.key}, {}}, [this, from = view.view] { lookFrom(from); });
}

void ViewActions::makeSwitches(Actions& actions) {
  using presentation::ViewState;
  ViewModel& view = parts_.view;
  view.addToggle(actions, "view.handles", {tr("Show &handles in every mode"), "handles", {Qt::Key_H}, {}},
                 &ViewState::handles);
  view.addToggle(actions, "view.ghost", {tr("&Ghost of the reference shape"), "ghost", {Qt::Key_G}, {}},
                 &ViewState::ghost);
  view.addToggle(actions, "view.cut",
                 {tr("Cut &open"),
                  nullptr,
                  {tr("Shift+C")},
                  tr("Cut all organs open by a plane; their cavities are hollow then")},
                 [](ViewState& state) -> bool& { return state.cut.on; });
  view.addToggle(actions, "view.cube", {tr("Orientation &cube"), "view", {}, {}},
                 &ViewState::orientationCube);
  view.addToggle(actions, "view.scale", {tr("Scale &bar"), nullptr, {}, {}}, &ViewState::scaleBar);
}

void ViewActions::lookFrom(scene::StandardView from) {
  parts_.area.view()->view().lookFrom(from);
  parts_.area.view()->scheduleRender();
}

void ViewActions::focus() {
  scene::OrganView& view = parts_.area.view()->view();
  const auto organ = parts_.workspace.document().organ(parts_.workspace.selection().organ());
  if (organ && !organ->look.visible) { // Who wants to see it does not want an empty place.
    document::OrganLook look = organ->look;
    look.visible = true;
    parts_.workspace.perform(document::setOrganLook(organ->id, look));
    parts_.workspace.undo().seal();
  }
  const auto selected = organ ? parts_.picture.actorOf(organ->id) : nullptr;
  view.frame(selected ? selected->bounds() : view.bounds());
  parts_.area.view()->scheduleRender();
}

void ViewActions::saveScreenshot() {
  const QString folder = parts_.settings.folder("files/pictures", QStandardPaths::PicturesLocation);
  const QString file =
      QStringLiteral("%1/viscera_%2.png")
          .arg(folder, QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd_hhmmss_zzz")));
  const bool done = parts_.workspace.guarded(
      [&] { scene::savePicture(parts_.area.view()->renderWindow(), file.toStdString()); });
  if (done)
    parts_.workspace.noteWritten(tr("Picture saved as %1").arg(file), file);
}

} // namespace viscera::app
