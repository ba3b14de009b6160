#include "window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "label_files.h"
#include "session_fixture.h"
#include "shapes.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/displacement_file.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/presentation/presenter.h"
#include "window/export/export_actions.h"
#include "window/import/arriving_surfaces.h"
#include "window/import/file_actions.h"
#include "window/import/import_controller.h"
#include "window/import/import_panel.h"
#include "window/import/repair_value_box.h"
#include "window/style/language.h"

namespace viscera::tests {
namespace {

using geometry::TriangleMesh;

/// Bad surfaces are caught before they are in the document, and repaired by one click.
class Import : public WindowTest {
protected:
  /// A ball of a normal liver's volume on the right side of the body.
  static TriangleMesh liver() { return sphere(4, 71.8, {-80, 10, 300}); }

  QString write(const TriangleMesh& mesh, const QString& name = QStringLiteral("liver.stl")) {
    const QString file = path(name);
    medical_io::writeSurface(file.toStdString(), mesh);
    return file;
  }

  /// A text file, which says nothing about its axes.
  QString writeUnstated(const TriangleMesh& mesh, const QString& name) {
    const QString file = path(name);
    std::ofstream out(file.toStdString());
    out << "OFF\n" << mesh.points.rows() << ' ' << mesh.triangles.rows() << " 0\n";
    out.precision(17);
    for (const auto& point : mesh.points.rowwise())
      out << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
    for (const auto& t : mesh.triangles.rowwise())
      out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    return file;
  }

  app::ImportPanel& panel() { return *window().imports().panel(); }

  QString findings() {
    QStringList all;
    for (const QLabel* label : panel().findChildren<QLabel*>())
      if (label->isVisible())
        all.push_back(label->text());
    return all.join(QLatin1Char('\n'));
  }

  QPushButton* repairButton(const QString& id) {
    for (QPushButton* button : panel().findChildren<QPushButton*>(QStringLiteral("repair")))
      if (button->isVisible() && button->property("repair") == id)
        return button;
    return nullptr;
  }

  void press(QPushButton* button) {
    ASSERT_TRUE(button);
    QTest::mouseClick(button, Qt::LeftButton);
    settle();
  }

  QPushButton* importButton() { return panel().findChild<QPushButton*>(QStringLiteral("primary")); }
  QPushButton* cancelButton() { return panel().findChild<QPushButton*>(QStringLiteral("cancelImport")); }

  /// Opens a file that is caught, presses one button, accepts; the organ is a good liver then.
  void expectOneClick(const QString& file, const QString& says, const QString& repair) {
    const document::DocumentState before = document().state();
    open(file);
    ASSERT_TRUE(window().imports().isOpen());
    EXPECT_TRUE(panel().isVisible());
    EXPECT_TRUE(document().state() == before) << "nothing is in the document before it is accepted";
    EXPECT_TRUE(findings().contains(says)) << findings().toStdString();
    EXPECT_EQ(importButton()->text(), QStringLiteral("Import as it is"));
    EXPECT_TRUE(importButton()->property("quiet").toBool()) << "the repair is what to press";
    press(repairButton(repair));
    EXPECT_FALSE(window().imports().draft().questionable()) << findings().toStdString();
    EXPECT_EQ(importButton()->text(), QStringLiteral("Import"));
    EXPECT_FALSE(importButton()->property("quiet").toBool());
    press(importButton());
    EXPECT_FALSE(window().imports().isOpen());
    EXPECT_FALSE(panel().isVisible());
    ASSERT_EQ(document().organs().size(), 1u);
    const document::Organ& organ = *document().organs().front();
    EXPECT_EQ(organ.name, "liver");
    EXPECT_TRUE(organ.closed());
    EXPECT_NEAR(organ.restVolumeMm3 / kMm3PerMl, 1540, 20);
    EXPECT_LT(boundsOf(organ.mesh->points).center().x(), -70);
    EXPECT_EQ(window().workspace().undo().names().size(), 1u) << "one step";
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(document().organs().empty());
  }
};

TEST_F(Import, AnStlInMetresIsCaughtAndScaledByOneClick) {
  expectOneClick(write(geometry::scaled(liver(), 0.001)), QStringLiteral("metres"), QStringLiteral("unit-m"));
}

TEST_F(Import, AnInsideOutSurfaceIsCaughtAndTurnedByOneClick) {
  TriangleMesh mesh = liver();
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  expectOneClick(write(mesh), QStringLiteral("inside out"), QStringLiteral("orient"));
}

TEST_F(Import, AnOpenSurfaceIsCaughtAndClosedByOneClick) {
  TriangleMesh mesh = liver();
  mesh.triangles = mesh.triangles.bottomRows(mesh.triangles.rows() - 64).eval();
  expectOneClick(write(mesh), QStringLiteral("open"), QStringLiteral("fill-holes"));
}

TEST_F(Import, ASurfaceInRasThatDoesNotSaySoIsCaughtAndTurnedByOneClick) {
  expectOneClick(writeUnstated(geometry::turnedHalf(liver()), QStringLiteral("liver.off")),
                 QStringLiteral("RAS"), QStringLiteral("ras-to-lps"));
}

TEST_F(Import, RemeshingSaysHowFarTheSurfaceHasMoved) {
  open(write(geometry::scaled(liver(), 0.001)));
  press(repairButton(QStringLiteral("unit-m")));
  const auto said = [this] { return panel().findChild<QLabel*>(QStringLiteral("surfaceChange")); };
  EXPECT_FALSE(said());
  window().imports().repair({0}, "remesh");
  ASSERT_TRUE(waitUntil([&] { return said() && said()->isVisible(); }));
  EXPECT_THAT(said()->text().toStdString(), testing::ContainsRegex("triangles instead of .* mm at most"));
}

TEST_F(Import, WhatCannotBeRepairedIsSaidAndDoesNotKeepTheOthersFromIt) {
  TriangleMesh flat;
  flat.points.resize(3, 3);
  flat.points << 0, 0, 0, 100, 0, 0, 0, 100, 0;
  flat.triangles.resize(1, 3);
  flat.triangles << 0, 1, 2;
  window().files().open({write(flat, QStringLiteral("leaf.ply")), write(flat, QStringLiteral("blade.ply")),
                         write(geometry::scaled(liver(), 0.001))});
  settle();
  const auto& organs = [this]() -> const std::vector<document::DraftOrgan>& {
    return window().imports().draft().organs;
  };
  const auto reasons = [this] {
    int shown = 0;
    for (const QLabel* label : panel().findChildren<QLabel*>(QStringLiteral("refusal")))
      shown += label->isVisible() && label->text().contains(QStringLiteral("encloses nothing")) ? 1 : 0;
    return shown;
  };
  ASSERT_EQ(organs().size(), 3u);
  window().imports().repair({0, 2}, "remesh");
  settle();
  EXPECT_THAT(organs()[2].repairs, testing::ElementsAre("remesh"));
  EXPECT_TRUE(message().contains(QStringLiteral("Leaf: The surface encloses nothing. Check")))
      << message().toStdString();
  EXPECT_EQ(reasons(), 1);
  window().imports().repair({0, 1, 2}, "remesh");
  settle();
  EXPECT_TRUE(message().contains(QStringLiteral("2 of 3 organs"))) << message().toStdString();
  EXPECT_EQ(reasons(), 2);
  press(importButton());
  EXPECT_EQ(document().organs().size(), 3u);
}

TEST_F(Import, CancelLeavesTheDocumentUntouched) {
  open(sphereFile());
  const document::DocumentState before = document().state();
  const std::size_t actors = view().view().organs().size();
  open(write(geometry::scaled(liver(), 0.001)));
  ASSERT_TRUE(window().imports().isOpen());
  EXPECT_EQ(view().view().organs().size(), actors + 1) << "it is shown as glass";
  press(repairButton(QStringLiteral("unit-m")));
  press(cancelButton());
  EXPECT_TRUE(document().state() == before);
  EXPECT_EQ(window().workspace().undo().names().size(), 1u);
  EXPECT_EQ(view().view().organs().size(), actors);
  EXPECT_FALSE(panel().isVisible());
}

TEST_F(Import, ACleanFileComesStraightInWithAQuietLine) {
  open(write(liver()));
  EXPECT_FALSE(window().imports().isOpen());
  EXPECT_EQ(document().organs().size(), 1u);
  const auto* badge = window().viewArea().findChild<QLabel*>(QStringLiteral("viewBadge"));
  EXPECT_TRUE(badge->text().contains(QStringLiteral("no problems found"))) << badge->text().toStdString();
}

TEST_F(Import, OnDemandACleanFileIsShownToo) {
  window().files().open({write(liver())}, true);
  settle();
  ASSERT_TRUE(window().imports().isOpen());
  press(importButton());
  EXPECT_EQ(document().organs().size(), 1u);
}

TEST_F(Import, OneOfSeveralIsLeftOutAndTheMirroredPatientIsPutRight) {
  const TriangleMesh spleen = sphere(3, 36, {90, 40, 300});
  window().files().open({write(geometry::mirrored(liver()), QStringLiteral("liver.ply")),
                         write(geometry::mirrored(spleen), QStringLiteral("spleen.ply")),
                         write(geometry::scaled(spleen, 0.001), QStringLiteral("speck.ply"))});
  settle();
  ASSERT_TRUE(window().imports().isOpen());
  EXPECT_TRUE(findings().contains(QStringLiteral("All organs together"))) << findings().toStdString();
  ASSERT_TRUE(window().imports().draft().arrangement);
  window().imports().repair({0, 1}, "mirror");
  settle();
  EXPECT_FALSE(window().imports().draft().arrangement);
  for (QCheckBox* box : panel().findChildren<QCheckBox*>(QStringLiteral("included")))
    if (box->isVisible() && box->text() == QStringLiteral("Speck"))
      box->click();
  settle();
  EXPECT_FALSE(window().imports().draft().questionable());
  press(importButton());
  ASSERT_EQ(document().organs().size(), 2u);
  EXPECT_LT(boundsOf(document().organs()[0]->mesh->points).center().x(), 0);
}

TEST_F(Import, ManyOrgansAreFilteredLeftOutTogetherAndGetOneUnitOfLength) {
  QStringList files = {write(geometry::scaled(liver(), 0.001))};
  for (const char* name : {"spleen", "kidney_left", "kidney_right", "stomach", "pancreas", "bladder"})
    files += write(geometry::scaled(sphere(2, 36, {0, 40, 300}), 0.001), QStringLiteral("%1.stl").arg(name));
  window().files().open(files);
  settle();
  ASSERT_TRUE(window().imports().isOpen());
  EXPECT_EQ(findings().count(QStringLiteral("not life-sized")), 1) << findings().toStdString();
  press(repairButton(QStringLiteral("unit-m")));
  for (const document::DraftOrgan& organ : window().imports().draft().organs)
    EXPECT_GT(organ.assessment.sizeMm.x(), 50) << organ.name;

  panel().findChild<QLineEdit*>(QStringLiteral("importFilter"))->setText(QStringLiteral("kidney_"));
  QStringList shown;
  for (const QCheckBox* box : panel().findChildren<QCheckBox*>(QStringLiteral("included")))
    if (box->isVisible())
      shown += box->text();
  shown.sort();
  EXPECT_EQ(shown, QStringList({QStringLiteral("Left kidney"), QStringLiteral("Right kidney")}));
  press(panel().findChild<QPushButton*>(QStringLiteral("importNone")));
  EXPECT_EQ(importButton()->text(), QStringLiteral("Import 5 organs"));
  press(panel().findChild<QPushButton*>(QStringLiteral("importAll")));
  EXPECT_FALSE(importButton()->text().contains(QStringLiteral("organs")));
  press(panel().findChild<QPushButton*>(QStringLiteral("importNone")));
  press(importButton());
  EXPECT_EQ(document().organs().size(), 5u);
}

TEST_F(Import, OrgansAreFilteredByWhatWasFound) {
  QStringList files;
  for (const char* name : {"a", "b", "c", "d", "e", "f"})
    files += write(sphere(2, 36), QStringLiteral("%1.stl").arg(name));
  TriangleMesh turned = sphere(2, 36);
  turned.triangles.col(1).swap(turned.triangles.col(2));
  for (const char* name : {"x", "y"})
    files += write(turned, QStringLiteral("%1.stl").arg(name));
  window().files().open(files);
  settle();
  ASSERT_TRUE(window().imports().isOpen());
  auto* list = panel().findChild<QComboBox*>(QStringLiteral("importFindings"));
  const int facing = list->findText(QStringLiteral("Triangles that face inward (2)"));
  ASSERT_GE(facing, 0);
  list->setCurrentIndex(facing);
  int shown = 0;
  for (const QCheckBox* box : panel().findChildren<QCheckBox*>(QStringLiteral("included")))
    shown += box->isVisible() ? 1 : 0;
  EXPECT_EQ(shown, 2);
  press(repairButton(QStringLiteral("orient")));
  EXPECT_FALSE(window().imports().draft().questionable()) << "both were turned";
}

TEST_F(Import, AxesAndUnitAreConvertedAfterItTooAsOneStep) {
  auto& menu = find<QMenu>("coordinateMenu");
  open(write(liver()));
  settle();
  ASSERT_FALSE(window().imports().isOpen());
  ASSERT_EQ(document().organs().size(), 1U);
  EXPECT_TRUE(menu.menuAction()->isEnabled());
  const Points before = document().organs()[0]->mesh->points;
  const auto choose = [&](const char* id) {
    auto* entry = menu.findChild<QAction*>(QLatin1String("organ.convert.") + QLatin1String(id));
    ASSERT_TRUE(entry) << id;
    entry->trigger();
    settle();
  };
  choose("ras-to-lps");
  const Points turned = document().organs()[0]->mesh->points;
  EXPECT_LT((turned.leftCols(2) + before.leftCols(2)).norm(), 1e-9);
  EXPECT_LT((turned.col(2) - before.col(2)).norm(), 1e-9);
  choose("unit-cm");
  EXPECT_LT((document().organs()[0]->mesh->points - 10 * turned).norm(), 1e-6);
  window().workspace().undo().undo();
  window().workspace().undo().undo();
  settle();
  EXPECT_EQ(document().organs()[0]->mesh->points, before);
}

TEST_F(Import, RepairsCanBeTakenBackAndARepairThatIsCancelledChangesNothing) {
  open(write(geometry::scaled(liver(), 0.001)));
  press(repairButton(QStringLiteral("unit-m")));
  press(panel().findChild<QPushButton*>(QStringLiteral("revert")));
  EXPECT_TRUE(window().imports().draft().questionable());
  window().imports().repair({0}, "unit-m");
  window().workspace().jobs().cancelSlot("import");
  settle();
  EXPECT_TRUE(window().imports().draft().organs.at(0).repairs.empty());
  EXPECT_TRUE(importButton()->isEnabled());
}

/// With faults to repair the bright button would be the wrong one.
TEST_F(Import, AsItIsIsAQuietButtonUntilNothingIsDoubtful) {
  const auto groundOf = [](QPushButton& button) {
    const QImage seen = button.grab().toImage();
    return seen.pixelColor(6, seen.height() / 2);
  };
  const auto ground = [&] { return groundOf(*importButton()); };
  open(write(geometry::scaled(liver(), 0.001)));
  ASSERT_TRUE(window().imports().isOpen());
  EXPECT_EQ(importButton()->text(), QStringLiteral("Import as it is"));
  EXPECT_TRUE(importButton()->property("quiet").toBool());
  EXPECT_EQ(ground(), groundOf(*cancelButton())) << "it looks as the others";
  const QColor quiet = ground();
  press(repairButton(QStringLiteral("unit-m")));
  EXPECT_EQ(importButton()->text(), QStringLiteral("Import"));
  EXPECT_FALSE(importButton()->property("quiet").toBool());
  EXPECT_NE(ground(), quiet) << "now it is the one to press";
}

TEST_F(Import, WhatIsWrongWithASurfaceThatIsTakenAsItIsIsSaidOnce) {
  TriangleMesh mesh = liver();
  mesh.triangles = mesh.triangles.bottomRows(mesh.triangles.rows() - 64).eval();
  open(write(mesh));
  ASSERT_TRUE(window().imports().isOpen());
  press(importButton());
  ASSERT_EQ(document().organs().size(), 1u);
  const std::vector<Text>& warnings = document().organs().front()->warnings;
  ASSERT_FALSE(warnings.empty());
  const std::vector<std::string> english = inEnglish(warnings);
  EXPECT_EQ(std::set<std::string>(english.begin(), english.end()).size(), english.size());
  const QString first = app::inWords(warnings.front());
  EXPECT_EQ(find<QLabel>("exploreRemarks").text().count(first), 1);
  EXPECT_FALSE(message().contains(first)) << "whoever has checked it has read it";
}

TEST_F(Import, PropertiesHaveTheirRoomAgainWhenItIsOver) {
  const auto& properties = find<QDockWidget>("properties");
  const int width = properties.width();
  open(write(geometry::scaled(liver(), 0.001)));
  ASSERT_TRUE(window().imports().isOpen());
  press(repairButton(QStringLiteral("unit-m")));
  press(importButton());
  ASSERT_FALSE(window().imports().isOpen());
  ASSERT_TRUE(properties.isVisible());
  EXPECT_NEAR(properties.width(), width, 4);
  for (const auto* area : properties.findChildren<QScrollArea*>())
    if (area->isVisible() && area->widget()) {
      EXPECT_LE(area->widget()->width(), area->viewport()->width()) << "its page is cut off";
      EXPECT_GE(area->widget()->height(), area->widget()->minimumSizeHint().height()) << "it is squashed";
    }
}

TEST_F(Import, ASecondFileWaitsUntilTheFirstIsDecided) {
  open(write(geometry::scaled(liver(), 0.001)));
  open(write(geometry::scaled(liver(), 0.002), QStringLiteral("other.stl")));
  EXPECT_EQ(window().imports().draft().organs.at(0).name, "liver");
  EXPECT_TRUE(message().contains(QStringLiteral("first"))) << message().toStdString();
}

TEST_F(Import, OrgansDisplacementsFieldAndTableOfAPoseAreWritten) {
  open(sphereFile());
  Points pose = document().pose();
  pose.rowwise() += Eigen::RowVector3d(5, 0, 0);
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  window().exports().exportTransform(path(QStringLiteral("field.nrrd")));
  settle();
  window().exports().exportDisplacements(path(QStringLiteral("moved.vtp")));
  settle();
  window().exports().exportTable(path(QStringLiteral("table.csv")));
  settle();
  std::ifstream field(path(QStringLiteral("field.nrrd")).toStdString(), std::ios::binary);
  std::string line;
  std::getline(field, line);
  EXPECT_EQ(line, "NRRD0004");
  window().exports().exportOrgans(path(QStringLiteral("all.glb")));
  settle();
  const Bounds posed =
      boundsOf(medical_io::readSurface(path(QStringLiteral("all.glb")).toStdString()).mesh.points);
  EXPECT_NEAR(posed.center().x(), 5, 1e-3) << "as it is posed";
  EXPECT_EQ(medical_io::readSurface(path(QStringLiteral("moved.vtp")).toStdString()).name, "ball");
  std::ifstream table(path(QStringLiteral("table.csv")).toStdString());
  std::getline(table, line);
  EXPECT_EQ(line.substr(0, 5), "name,");
  std::getline(table, line);
  EXPECT_EQ(line.substr(0, 5), "ball,");
}

TEST_F(Import, OrgansAreSeenAsTheyArriveInPlaceOfASampleThatIsSeenAgainWhenNoneIsTaken) {
  document::NewOrgan sample = ball("Sample");
  sample.organ.origin.sample = "ball@medium";
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({sample})));
  settle();
  ASSERT_TRUE(window().files().replacesPresent());
  const auto arriving = std::make_shared<const TriangleMesh>(liver());
  const auto seen = [&](const std::shared_ptr<const TriangleMesh>& mesh) {
    const auto& organs = view().view().organs();
    return std::any_of(organs.begin(), organs.end(), [&](const auto& organ) {
      return &organ->mesh() == mesh.get() && organ->visible() && organ->opacity() == 1;
    });
  };
  app::ArrivingSurfaces& arrival = window().arrivingSurfaces();
  const auto ticket = arrival.begin(true);
  const auto tell = app::ArrivingSurfaces::listener(ticket);
  std::thread([&] {
    tell({"liver", document::OrganLook().color, arriving, boundsOf(arriving->points)});
  }).join();
  ASSERT_TRUE(waitUntil([&] { return seen(arriving); }));
  EXPECT_FALSE(seen(sample.organ.mesh));
  EXPECT_LT((view().view().bounds().center() - boundsOf(arriving->points).center()).norm(), 1);
  EXPECT_TRUE(view().rect().contains(onScreen({-80, 10, 300}))) << "it comes into the picture";
  arrival.end(ticket, false);
  EXPECT_FALSE(seen(arriving));
  EXPECT_TRUE(seen(sample.organ.mesh));
  tell({"spleen", document::OrganLook().color, arriving, boundsOf(arriving->points)});
  QTest::qWait(300);
  EXPECT_FALSE(seen(arriving)) << "what comes too late is not shown";
}

TEST_F(Import, ThePreviewOfWhatReplacesASampleStandsAloneAndSolid) {
  document::NewOrgan sample = ball("Sample");
  sample.organ.origin.sample = "ball@medium";
  ASSERT_TRUE(window().workspace().perform(document::addOrgans({sample})));
  open(write(geometry::scaled(liver(), 0.001)));
  ASSERT_TRUE(window().imports().isOpen());
  for (const auto& organ : view().view().organs()) {
    EXPECT_EQ(organ->visible(), &organ->mesh() != sample.organ.mesh.get());
    EXPECT_EQ(organ->opacity(), 1);
  }
  window().imports().cancel();
  settle();
  ASSERT_EQ(view().view().organs().size(), 1u);
  EXPECT_TRUE(view().view().organs().front()->visible());
}

TEST_F(Import, ThePreviewHasTheColoursThatTheOrgansWillHave) {
  LabelImage image = emptyLabels();
  image.fill({2, 2, 2}, {8, 9, 9}, 1);
  image.fill({12, 2, 2}, {18, 9, 9}, 2);
  std::ofstream(path(QStringLiteral("a.seg.nrrd")).toStdString(), std::ios::binary)
      << nrrdFile(image, "right-anterior-superior",
                  "Segment0_ID:=S1\nSegment0_Name:=liver\nSegment0_Color:=0 1 1\nSegment0_LabelValue:=1\n"
                  "Segment1_ID:=S2\nSegment1_Name:=spleen\nSegment1_LabelValue:=2\n");
  open(path(QStringLiteral("a.seg.nrrd")));
  ASSERT_TRUE(window().imports().isOpen());
  const auto colors = [this] {
    std::vector<Vec3> all;
    for (const auto& organ : view().view().organs())
      all.push_back(organ->color());
    return all;
  };
  const std::vector<Vec3> previewed = colors();
  ASSERT_EQ(previewed.size(), 2U);
  EXPECT_LT((previewed[0] - presentation::shownColor({0, 1, 1})).norm(), 1e-9)
      << "the file's, though the program knows a liver's";
  press(importButton());
  EXPECT_EQ(colors(), previewed);
}

TEST_F(Import, RemovesFragmentsBelowASizeThatIsSeenBefore) {
  TriangleMesh ribs = sphere(3, 20, {-100, 0, 300});
  const auto add = [&ribs](const TriangleMesh& part) {
    const auto points = ribs.points.rows(), triangles = ribs.triangles.rows();
    ribs.points.conservativeResize(points + part.points.rows(), 3);
    ribs.points.bottomRows(part.points.rows()) = part.points;
    ribs.triangles.conservativeResize(triangles + part.triangles.rows(), 3);
    ribs.triangles.bottomRows(part.triangles.rows()) =
        part.triangles.array() + static_cast<std::int32_t>(points);
  };
  add(sphere(3, 15, {-100, 0, 360}));
  add(sphere(2, 1.5, {-100, 0, 400}));
  open(write(ribs, QStringLiteral("ribs.stl")));
  press(repairButton(QStringLiteral("remove-fragments")));
  auto& box = *panel().findChild<app::RepairValueBox*>();
  auto& effect = *box.findChild<QLabel*>(QStringLiteral("repairEffect"));
  EXPECT_TRUE(effect.text().startsWith(QStringLiteral("1 of 3 pieces goes"))) << effect.text().toStdString();
  EXPECT_EQ(window().imports().draft().organs[0].assessment.report.components, 3) << "only shown so far";
  auto& unit = *box.findChild<QComboBox*>();
  unit.setCurrentIndex(unit.findText(QStringLiteral("mm")));
  EXPECT_EQ(box.id(), QStringLiteral("remove-fragments=10mm"));
  press(box.findChild<QPushButton*>(QStringLiteral("applyRepair")));
  EXPECT_EQ(window().imports().draft().organs[0].assessment.report.components, 2) << "no rib is lost";
  press(panel().findChild<QPushButton*>(QStringLiteral("revert")));
  EXPECT_EQ(window().imports().draft().organs[0].assessment.report.components, 3);
}

TEST_F(Import, ScalesAnOrganOfMetresToLifeSize) {
  open(write(sphere(4, 1350), QStringLiteral("stomach.stl")));
  EXPECT_EQ(repairButton(QStringLiteral("scale"))->text(), QStringLiteral("Scale..."));
  press(repairButton(QStringLiteral("scale")));
  auto& box = *panel().findChild<app::RepairValueBox*>();
  press(box.findChild<QPushButton*>(QStringLiteral("lifeSize")));
  press(box.findChild<QPushButton*>(QStringLiteral("applyRepair")));
  EXPECT_NEAR(window().imports().draft().organs[0].assessment.volumeMl, 895, 10);
}

} // namespace
} // namespace viscera::tests
