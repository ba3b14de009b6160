#include "window_test.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QStandardPaths>
#include <QUrl>

#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/surface_file.h"
#include "window/view/view_area.h"
#include "window/work/settings.h"

namespace viscera::tests {
namespace {

void write(const QString& file, const QByteArray& contents) {
  QFile out(file);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(contents);
}

TEST_F(WindowTest, OpeningASurfaceShowsItBoundToHandlesAroundIt) {
  open(sphereFile());
  ASSERT_EQ(document().organs().size(), 1u);
  const auto& organ = *document().organs().front();
  EXPECT_EQ(organ.name, "ball");
  EXPECT_EQ(document().rig().handles.size(), 30u);
  EXPECT_EQ(window().workspace().live().status(organ.id).state, live::BindingStatus::State::bound);
  ASSERT_EQ(view().view().organs().size(), 1u);
  EXPECT_EQ(view().view().organs().front()->mesh().points.rows(), organ.mesh->points.rows());
  EXPECT_EQ(message(), QString());
}

TEST_F(WindowTest, FoldersThatAreGoneAreNotProposed) {
  const auto proposed = [&](const QString& remembered) {
    app::Settings kept(QVariantMap{{QStringLiteral("folder"), remembered}});
    return kept.folder("folder", QStandardPaths::MoviesLocation);
  };
  EXPECT_EQ(proposed(path(QString())), path(QString()));
  for (const QString& gone : {path(QStringLiteral("gone")), sphereFile(), QString()})
    EXPECT_TRUE(QFileInfo(proposed(gone)).isDir()) << proposed(gone).toStdString();
}

TEST_F(WindowTest, SeveralFilesOpenedTogetherAreAllBoundAndNoneIsSelected) {
  window().files().open(
      {sphereFile(QStringLiteral("large.stl"), 90), sphereFile(QStringLiteral("small.stl"), 20)});
  ASSERT_TRUE(waitUntil([this] { return document().organs().size() == 2; }));
  settle();
  const auto expectAllBound = [this] {
    for (const auto& organ : document().organs())
      EXPECT_EQ(window().workspace().live().status(organ->id).state, live::BindingStatus::State::bound)
          << organ->name;
  };
  expectAllBound();
  EXPECT_EQ(window().workspace().selection().organ(), document::OrganId{}) << "handles are for all";
  // Around the small one, the large one is enclosed as well.
  window().workspace().selection().setOrgan(document().organs().back()->id);
  window().actions()["handles.place"]->trigger();
  settle();
  expectAllBound();
}

/// Everything that shows organs is made anew for a change of them.
TEST_F(WindowTest, FilesOpenedTogetherComeInTheColoursOfTheirTissuesInOneChange) {
  QStringList files;
  for (const char* name : {"bone_a", "bone_b", "muscle_a", "muscle_b", "tumour_a", "tumour_b"})
    files += sphereFile(QStringLiteral("%1.stl").arg(QLatin1String(name)), 30 + 5 * files.size());
  int changes = 0, changesOfOrgans = 0;
  const Subscription subscription = window().workspace().onChange([&](const document::Change& change) {
    ++changes;
    changesOfOrgans += change.organs() ? 1 : 0;
  });
  window().files().open(files);
  ASSERT_TRUE(waitUntil([this] { return document().organs().size() == 6; })) << message().toStdString();
  settle();
  EXPECT_EQ(changesOfOrgans, 1);
  EXPECT_EQ(changes, 1) << "with the handles that they get";
  for (const auto& organ : document().organs())
    EXPECT_NE(organ->look.color, document::OrganLook().color) << organ->name;
  EXPECT_EQ(window().workspace().undo().names().size(), 1u);
}

TEST_F(WindowTest, RecentFilesAreThoseThatHaveOpened) {
  const QString good = sphereFile(QStringLiteral("liver & ball.stl")),
                bad = path(QStringLiteral("empty.stl"));
  write(bad, {});
  window().files().open({bad, good});
  ASSERT_TRUE(waitUntil([this] { return !document().organs().empty() && !message().isEmpty(); }));
  EXPECT_TRUE(message().contains(QStringLiteral("empty.stl"))) << message().toStdString();
  QStringList recent;
  for (const QMenu* menu : window().findChildren<QMenu*>())
    if (menu->title().contains(QStringLiteral("recent")))
      for (const QAction* action : menu->actions())
        recent << action->text();
  EXPECT_EQ(recent, QStringList{QStringLiteral("liver && ball.stl")}) << "a single & would not be seen";
}

TEST_F(WindowTest, OpeningIsOneUndoStep) {
  open(sphereFile());
  EXPECT_EQ(window().workspace().undo().names().size(), 1u);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().organs().empty());
  EXPECT_TRUE(document().rig().handles.empty());
  EXPECT_TRUE(view().view().organs().empty());
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().organs().size(), 1u);
}

class BadFile : public WindowTest, public testing::WithParamInterface<std::pair<const char*, const char*>> {};

TEST_P(BadFile, SaysOneThingAndLeavesTheDocument) {
  open(sphereFile());
  const document::DocumentState before = document().state();
  const QString file = path(QString::fromLatin1(GetParam().first));
  write(file, GetParam().second);
  int messages = 0;
  const auto counting =
      QObject::connect(&window().workspace(), &app::Workspace::messageRaised, [&] { ++messages; });
  open(file);
  QObject::disconnect(counting);
  EXPECT_EQ(messages, 1);
  EXPECT_TRUE(message().contains(QFileInfo(file).fileName())) << message().toStdString();
  EXPECT_TRUE(document().state() == before);
  EXPECT_EQ(window().workspace().undo().names().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadFile,
    testing::Values(std::pair("empty.stl", ""),
                    std::pair("truncated.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"),
                    std::pair("text.obj", "this is no surface\n"), std::pair("letter.docx", "Dear colleague"),
                    std::pair("broken.mrk.json", "{\"markups\": [")));

TEST_F(WindowTest, AMissingFileSaysSoAndLeavesTheDocument) {
  open(path(QStringLiteral("nowhere.stl")));
  EXPECT_TRUE(message().contains(QStringLiteral("nowhere.stl")));
  EXPECT_TRUE(document().organs().empty());
}

TEST_F(WindowTest, TheGoodOfSeveralFilesAreOpenedAndAllBadOnesAreSaid) {
  write(path(QStringLiteral("empty.stl")), "");
  window().files().open(
      {path(QStringLiteral("nowhere.stl")), sphereFile(), path(QStringLiteral("empty.stl"))});
  settle();
  ASSERT_EQ(document().organs().size(), 1u);
  EXPECT_TRUE(message().contains(QStringLiteral("nowhere.stl"))) << message().toStdString();
  EXPECT_TRUE(message().contains(QStringLiteral("empty.stl"))) << message().toStdString();
}

TEST_F(WindowTest, AFileBesideASessionIsOpenedAndTheSessionIsSaid) {
  QFile session(path(QStringLiteral("case.viscera")));
  ASSERT_TRUE(session.open(QIODevice::WriteOnly));
  session.close();
  window().files().open({session.fileName(), sphereFile()});
  settle();
  ASSERT_EQ(document().organs().size(), 1u);
  EXPECT_TRUE(message().contains(QStringLiteral("case.viscera"))) << message().toStdString();
  EXPECT_TRUE(message().contains(QStringLiteral("alone"))) << message().toStdString();
}

TEST_F(WindowTest, ADroppedFileIsOpened) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(sphereFile())});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&view(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&view(), &drop);
  settle();
  EXPECT_EQ(document().organs().size(), 1u);
}

TEST_F(WindowTest, AnOrganOutsideTheHandlesOffersEnclosingOnesAndTheOfferMends) {
  open(sphereFile());
  open(sphereFile(QStringLiteral("larger.stl"), 200));
  ASSERT_EQ(document().organs().size(), 2u);
  const auto larger = document().organs()[1]->id;
  ASSERT_EQ(window().workspace().live().status(larger).state, live::BindingStatus::State::failed);
  EXPECT_TRUE(message().contains(QStringLiteral("outside"))) << message().toStdString();
  auto* offer = window().viewArea().messages()->findChild<QWidget*>(QStringLiteral("offer"));
  ASSERT_NE(offer, nullptr);
  QMetaObject::invokeMethod(offer, "click");
  settle();
  EXPECT_EQ(window().workspace().live().status(larger).state, live::BindingStatus::State::bound);
  EXPECT_EQ(document().rig().handles.size(), 38u);
  EXPECT_EQ(message(), QString());
}

TEST_F(WindowTest, SavedHandlesComeBackBitForBit) {
  open(sphereFile());
  const QString file = path(QStringLiteral("rig.mrk.json"));
  window().files().saveHandles(file);
  const Points rest = document().rig().restPositions();
  EXPECT_EQ(medical_io::readHandles(file.toStdString()).positions().rows(), rest.rows());
  open(file);
  Points again = document().rig().restPositions();
  // A file keeps handles by group: compare them as sets.
  for (Eigen::Index row = 0; row < rest.rows(); ++row) {
    bool found = false;
    for (Eigen::Index other = 0; other < again.rows(); ++other)
      found = found || rest.row(row) == again.row(other);
    EXPECT_TRUE(found) << "handle " << row;
  }
}

TEST_F(WindowTest, TheExportedOrganIsTheDeformedOne) {
  open(sphereFile());
  Points pose = document().pose();
  pose.rowwise() += Eigen::RowVector3d(5, 0, 0);
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  const QString file = path(QStringLiteral("moved.vtp"));
  window().files().exportOrgan(file);
  settle();
  const Bounds rest = boundsOf(document().organs().front()->mesh->points);
  const Bounds moved = boundsOf(medical_io::readSurface(file.toStdString()).mesh.points);
  EXPECT_NEAR(moved.center().x() - rest.center().x(), 5, 1e-3);
}

TEST_F(WindowTest, F12SavesAPictureOfTheView) {
  open(sphereFile());
  key(Qt::Key_F12);
  const QStringList pictures = QDir(path(QStringLiteral("pictures"))).entryList({QStringLiteral("*.png")});
  ASSERT_EQ(pictures.size(), 1);
  EXPECT_TRUE(message().contains(pictures.front()));
}

} // namespace
} // namespace viscera::tests
