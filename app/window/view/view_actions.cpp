#include "window/view/view_actions.h"

#include <QAction>
#include <QDateTime>

#include "viscera/document/organ_commands.h"
#include "viscera/presentation/presenter.h"
#include "viscera/scene/picture.h"
#include "window/style/language.h"
#include "window/work/organ_looks.h"

namespace viscera::app {
namespace {
constexpr const char* kShading = "view/shading";
} // namespace

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
  makeShading(actions);
  makeMeshLook(actions);
}

void ViewActions::makeViews(Actions& actions) {
  struct View {
    const char* id;
    QString name;
    QKeySequence key;
    QKeySequence otherKey; ///< Where there is no keypad.
    scene::StandardView view;
  };
  // The digits of the keypad; those of the main row choose the mode.
  const auto keypad = [](int key, bool shift) {
    return QKeySequence(static_cast<int>(Qt::KeypadModifier) + (shift ? static_cast<int>(Qt::SHIFT) : 0) +
                        key);
  };
  using scene::StandardView;
  const View views[] = {
      {"view.anterior", tr("&Anterior"), keypad(Qt::Key_1, false), tr("Alt+1"), StandardView::anterior},
      {"view.posterior", tr("&Posterior"), keypad(Qt::Key_1, true), tr("Alt+2"), StandardView::posterior},
      {"view.left", tr("&Left"), keypad(Qt::Key_3, false), tr("Alt+3"), StandardView::left},
      {"view.right", tr("&Right"), keypad(Qt::Key_3, true), tr("Alt+4"), StandardView::right},
      {"view.superior", tr("&Superior"), keypad(Qt::Key_7, false), tr("Alt+5"), StandardView::superior},
      {"view.inferior", tr("&Inferior"), keypad(Qt::Key_7, true), tr("Alt+6"), StandardView::inferior}};
  for (const View& view : views)
    actions.add(view.id, {view.name, "view", {view.key, view.otherKey}, {}},
                [this, from = view.view] { lookFrom(from); });
}

void ViewActions::makeSwitches(Actions& actions) {
  using presentation::ViewState;
  ViewModel& view = parts_.view;
  view.addToggle(actions, "view.handles", {tr("Show &handles in every mode"), "handles", {Qt::Key_H}, {}},
                 &ViewState::handles);
  view.addToggle(actions, "view.ghost", {tr("&Ghost of the rest shape"), "ghost", {Qt::Key_G}, {}},
                 &ViewState::ghost);
  view.addToggle(actions, "view.cut",
                 {tr("Cut &open"),
                  nullptr,
                  {tr("Shift+C")},
                  tr("Cut all organs open by a plane; their cavities are hollow then")},
                 [](ViewState& state) -> bool& { return state.cut.on; });
  view.addToggle(
      actions, "view.conduction",
      {tr("Co&nduction system"),
       "beat",
       {},
       tr("In the sample heart: sinus node, atrioventricular node, bundles and branches, lit where "
          "the excitation of the beat is; names of parts name them")},
      &ViewState::conduction);
  view.addToggle(actions, "view.cube", {tr("Orientation &cube"), "view", {}, {}},
                 &ViewState::orientationCube);
  view.addToggle(actions, "view.scale", {tr("Scale &bar"), nullptr, {}, {}}, &ViewState::scaleBar);
}

/// A setting of the user, not of a session, because it depends on the computer whether it can be drawn.
void ViewActions::makeShading(Actions& actions) {
  shading_ = std::make_unique<scene::DepthShading>(parts_.area.view()->view());
  if (const QVariant kept = parts_.settings.value(kShading); kept.isValid())
    shading_->setWanted(kept.toBool());
  QAction* action = actions.addToggle(
      "view.shading",
      {tr("Sha&de in folds"),
       nullptr,
       {tr("Shift+D")},
       tr("Darken the folds of organs and soften the light; takes time on a computer without a graphics "
          "processor")},
      shading_->wanted(), [this](bool on) {
        if (on == shading_->wanted())
          return;
        shading_->setWanted(on);
        parts_.settings.setValue(kShading, on);
        parts_.area.view()->scheduleRender();
      });
  actions.onSync([this, action] { action->setChecked(shading_->wanted()); });
}

/// The settings are for inspecting a mesh. Sessions do not keep them, so that no lecture opens with edges.
void ViewActions::makeMeshLook(Actions& actions) {
  const auto add = [&](const char* id, const Actions::Description& description, bool scene::MeshLook::*part) {
    actions.addToggle(id, description, false, [this, part](bool on) {
      scene::OrganView& view = parts_.area.view()->view();
      scene::MeshLook look = view.meshLook();
      look.*part = on;
      view.setMeshLook(look);
      parts_.area.view()->scheduleRender();
    });
  };
  add("view.edges",
      {tr("&Edges of triangles"), nullptr, {Qt::Key_W}, tr("Draw the triangles of organs as lines")},
      &scene::MeshLook::edges);
  add("view.flat",
      {tr("&Flat triangles"),
       nullptr,
       {tr("Shift+W")},
       tr("Give each triangle of an organ one shade, in place of a smooth surface")},
      &scene::MeshLook::flat);
}

void ViewActions::lookFrom(scene::StandardView from) {
  parts_.area.view()->view().lookFrom(from);
  parts_.area.view()->scheduleRender();
}

void ViewActions::focus() {
  scene::OrganView& view = parts_.area.view()->view();
  const auto organ = parts_.workspace.document().organ(parts_.workspace.selection().organ());
  if (organ && !organ->look.visible) { // Framing a hidden organ shows it.
    document::OrganLook look = organ->look;
    look.visible = true;
    parts_.workspace.perform(document::setOrganLook(organ->id, look));
    parts_.workspace.undo().seal();
  }
  const auto selected = organ ? parts_.picture.actorOf(organ->id) : nullptr;
  view.frame(selected ? selected->bounds() : view.bounds());
  parts_.area.view()->scheduleRender();
  if (organ)
    offerIsolate(*organ);
}

void ViewActions::offerIsolate(const document::Organ& organ) {
  const auto actor = parts_.picture.actorOf(organ.id);
  const scene::OrganActor* cover = actor ? parts_.picture.view().coverOf(*actor) : nullptr;
  const auto other = parts_.workspace.document().organ(parts_.picture.organOf(cover));
  if (!other)
    return;
  constexpr int kSeconds = 15;
  Message message;
  message.text = tr("%1 is hidden behind %2.")
                     .arg(inWords(presentation::labelOf(organ)), inWords(presentation::labelOf(*other)));
  message.offers.push_back({tr("Show only this"), [this, id = organ.id] {
                              if (parts_.workspace.document().organ(id))
                                showOnly(parts_.workspace, {id});
                            }});
  message.seconds = kSeconds;
  parts_.workspace.say(message);
}

void ViewActions::saveScreenshot() {
  const QString folder = parts_.settings.folder(kPicturesFolderKey, QStandardPaths::PicturesLocation);
  const QString file =
      QStringLiteral("%1/viscera_%2.png")
          .arg(folder, QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd_hhmmss_zzz")));
  const bool done = parts_.workspace.guarded(
      [&] { scene::savePicture(parts_.area.view()->renderWindow(), file.toStdString()); });
  if (done)
    parts_.workspace.noteWritten(tr("Picture saved as %1").arg(file), file);
}

} // namespace viscera::app
