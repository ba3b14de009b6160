#include <QAction>
#include <QClipboard>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "play_fixture.h"
#include "viscera/document/rig_commands.h"
#include "viscera/live/stress_files.h"
#include "viscera/scene/tissue_actor.h"
#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"
#include "window/export/report_export.h"
#include "window/session/session_files.h"
#include "window/stress/stress_export.h"
#include "window/stress/stress_mode.h"
#include "window/style/language.h"

namespace viscera::tests {
namespace {

QByteArray bytesOf(const QString& file) {
  QFile stream(file);
  return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
}

} // namespace

class ReportOfTheHeart : public PlayMode {
protected:
  /// Its ejection fraction is that of the window's heart.
  bool coarseSamples() const override { return false; }
  app::ReportExport& reports() { return *window().findChild<app::ReportExport*>(); }
};

TEST_F(ReportOfTheHeart, HasTheMotionWithItsEjectionFractionWhileTheWindowGoesOn) {
  const QString file = path(QStringLiteral("heart.html"));
  reports().write(file);
  settle();
  const QString page = QString::fromUtf8(bytesOf(file));
  ASSERT_FALSE(page.isEmpty()) << message().toStdString();
  EXPECT_TRUE(page.contains(QStringLiteral("<h2>Motion</h2>")));
  EXPECT_TRUE(page.contains(QStringLiteral("57.9"))) << "the ejection fraction";
  EXPECT_FALSE(page.contains(QStringLiteral("/tmp")));
}

class GermanReport : public ReportOfTheHeart {
  app::InstalledLanguage german_{QStringLiteral("de")};
};

TEST_F(GermanReport, HasNoEnglishNamesOfSystemsParametersPhasesQuantitiesAndRanges) {
  window().setMode("stress");
  ASSERT_TRUE(waitUntil([&] { return window().stress().model().shown().ready(); }));
  settle();
  const QString file = path(QStringLiteral("herz.html"));
  reports().write(file);
  settle();
  const QString page = QString::fromUtf8(bytesOf(file));
  ASSERT_FALSE(page.isEmpty()) << message().toStdString();
  for (const char* german : {"<h2>Bewegung</h2>", "Herzschlag", "Lokalität", "Rotationsstress",
                             "800 Gesunde von 45 bis 74 Jahren", "Ejektionsfraktion: Frauen", "Organe"})
    EXPECT_TRUE(page.contains(QString::fromUtf8(german))) << german;
  for (const char* english : {"Heartbeat", "locality", "softness", "Rotational stress", "Volume ratio",
                              "olumic", "jection", "healthy people", "standard deviations", "stroke volume",
                              "Handles", "percentile", "Change", "From the left"})
    EXPECT_FALSE(page.contains(QLatin1String(english))) << english;
}

class Report : public WindowTest {
protected:
  app::ReportExport& reports() { return *window().findChild<app::ReportExport*>(); }
  void pose() {
    Points moved = document().pose();
    moved.row(moved.rows() - 1) *= 1.4;
    ASSERT_TRUE(window().workspace().perform(document::setPose(moved)));
    settle();
  }
};

TEST_F(Report, IsOfferedWithCommandsOnceThereIsAnOrgan) {
  for (const char* id : {"file.report", "edit.copyCommands"})
    EXPECT_FALSE(window().actions()[id]->isEnabled()) << id;
  open(sphereFile());
  for (const char* id : {"file.report", "edit.copyCommands"})
    EXPECT_TRUE(window().actions()[id]->isEnabled()) << id;
  pose();
  const QString file = path(QStringLiteral("ball.pdf"));
  reports().write(file);
  settle();
  EXPECT_TRUE(bytesOf(file).startsWith("%PDF-")) << message().toStdString();
  EXPECT_THAT(message().toStdString(), testing::HasSubstr("pages"));
}

TEST_F(Report, CommandsAreCopiedAndNameTheFileOrTheSessionThatHoldsTheOrgan) {
  const QString ball = sphereFile();
  open(ball);
  pose();
  window().actions()["edit.copyCommands"]->trigger();
  settle();
  const QString script = QGuiApplication::clipboard()->text();
  EXPECT_TRUE(script.startsWith(QStringLiteral("#!/bin/sh\n"))) << script.toStdString();
  EXPECT_TRUE(script.contains(QStringLiteral("viscera deform ") + ball)) << script.toStdString();
  EXPECT_FALSE(script.contains(QStringLiteral(".viscera")));
  const QString saved = path(QStringLiteral("s.viscera"));
  window().sessions().saveTo(saved, false);
  settle();
  window().actions()["edit.copyCommands"]->trigger();
  settle();
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("viscera render ") + saved));
}

TEST_F(Report, StressLeavesTheWindowAsTheCommandLineWritesIt) {
  open(sphereFile());
  pose();
  app::StressModel& model = window().stress().model();
  model.change([](app::StressLook& look) { look.witnesses = 400; });
  for (const char* id :
       {"stress.exportMap", "stress.exportPoints", "stress.exportHistogram", "stress.exportCurve"})
    EXPECT_FALSE(window().actions()[id]->isEnabled()) << id << " without a map";
  key(Qt::Key_4);
  ASSERT_TRUE(waitUntil([&] { return model.shown().ready(); }));
  settle();
  EXPECT_TRUE(window().actions()["stress.exportMap"]->isEnabled());
  EXPECT_FALSE(window().actions()["stress.exportCurve"]->isEnabled()) << "there is no sequence";
  const auto mesh = model.live().mesh();
  app::StressExport& exports = window().stress().exports();
  exports.exportMap(path(QStringLiteral("w.vtu")));
  settle();
  exports.exportPoints(path(QStringLiteral("w.csv")));
  settle();
  exports.exportHistogram(path(QStringLiteral("h.csv")));
  settle();
  // What viscera stress calls, on the same numbers.
  const auto same = [&](const char* name) { return path(QLatin1String(name)).toStdString(); };
  live::writeStressSolid(same("c.vtu"), *mesh, model.live().points(), model.live().map());
  live::writeStressTable(same("c.csv"), *mesh, model.live().points(), model.live().map());
  EXPECT_EQ(bytesOf(path(QStringLiteral("w.vtu"))), bytesOf(path(QStringLiteral("c.vtu"))));
  EXPECT_EQ(bytesOf(path(QStringLiteral("w.csv"))), bytesOf(path(QStringLiteral("c.csv"))));
  EXPECT_GT(bytesOf(path(QStringLiteral("w.vtu"))).size(), 10000);
  EXPECT_EQ(bytesOf(path(QStringLiteral("h.csv"))).count('\n'), live::kHistogramBars + 1);
}

TEST_F(Report, GoesToTheMaximumOfTheMapAndCutsThere) {
  open(sphereFile());
  pose();
  app::StressModel& model = window().stress().model();
  model.change([](app::StressLook& look) { look.witnesses = 400; });
  key(Qt::Key_4);
  ASSERT_TRUE(waitUntil([&] { return model.shown().ready(); }));
  settle();
  const auto go = [&] {
    window().actions()["stress.maximum"]->trigger();
    settle();
    const auto values = model.live().map().rotationalStress.head(model.live().mesh()->witnesses);
    ASSERT_GE(model.probe(), 0);
    EXPECT_EQ(values[model.probe()], model.live().statistics().max);
    EXPECT_TRUE(model.look().cut);
    EXPECT_LE(std::abs(model.look().offset), 1);
    EXPECT_NEAR(model.look().normal.norm(), 1, 1e-12);
  };
  const presentation::Presenter& drawn = window().picture().presenter();
  const auto fromThePlane = [&](const Points& points) {
    const scene::CutPlane plane = drawn.cutPlane()->GetPlane();
    return std::abs((Vec3(points.row(model.probe()).transpose()) - plane.origin).dot(plane.normal));
  };
  go();
  EXPECT_NEAR(fromThePlane(model.live().points()), 0, 1e-9);

  // One side far out: the tissue is cut where the pose has brought it, not where it was.
  const Vec3 normal = model.look().normal;
  Points pulled = document().rig().restPositions();
  for (Eigen::Index row = 0; row < pulled.rows(); ++row)
    pulled.row(row) += std::max(0.0, 0.8 * pulled.row(row).dot(normal.transpose())) * normal.transpose() +
                       0.3 * std::abs(pulled(row, 2)) * Vec3::UnitX().transpose();
  ASSERT_TRUE(window().workspace().perform(document::setPose(pulled)));
  settle();
  go();
  EXPECT_NEAR(fromThePlane(model.live().points()), 0, 1e-9);
  EXPECT_GT(fromThePlane(model.live().mesh()->points), 3) << "the pose moves the point through the plane";
  EXPECT_GT(drawn.tissue()->cutTriangles(), 0);

  // All of it beyond where the plane can be pushed along its normal.
  Points away = document().rig().restPositions();
  away.rowwise() += 150 * model.look().normal.transpose();
  away.row(0) += Eigen::RowVector3d(20, -30, 10);
  ASSERT_TRUE(window().workspace().perform(document::setPose(away)));
  settle();
  go();
  EXPECT_NEAR(fromThePlane(model.live().points()), 0, 1e-9);
}

} // namespace viscera::tests
