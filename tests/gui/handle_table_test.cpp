#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>

#include "viscera/document/organ_commands.h"
#include "window/handles/handle_table.h"
#include "window_test.h"

namespace viscera::tests {

class HandleTableTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    window().actions()["handles.table"]->trigger();
    settle();
    table_ = window().findChild<app::HandleTable*>(QStringLiteral("handleTable"));
    ASSERT_NE(table_, nullptr);
    ASSERT_TRUE(table_->isVisible());
  }

  app::HandleModel& model() { return table_->model(); }
  QVariant at(int row, int column) { return model().data(model().index(row, column), Qt::EditRole); }
  bool type(int row, int column, const QVariant& value) {
    return model().setData(model().index(row, column), value, Qt::EditRole);
  }

  app::HandleTable* table_ = nullptr;
};

TEST_F(HandleTableTest, ShowsWhereHandlesAreAndTakesWhatIsTypedAsOneStep) {
  using Column = app::HandleModel;
  const Vec3 rest = document().rig().handles[2].rest;
  ASSERT_EQ(model().rowCount(), static_cast<int>(document().rig().handles.size()));
  EXPECT_EQ(at(2, Column::restY).toDouble(), rest.y());
  ASSERT_TRUE(type(2, Column::poseY, rest.y() + 7));
  EXPECT_NEAR(document().pose()(2, 1), rest.y() + 7, 1e-12);
  EXPECT_NEAR(at(2, Column::moved).toDouble(), 7, 1e-12);
  EXPECT_FALSE(type(2, Column::poseY, QStringLiteral("far"))) << "no number";
  window().workspace().undo().undo();
  EXPECT_EQ(at(2, Column::moved).toDouble(), 0);
  ASSERT_TRUE(type(2, Column::restZ, rest.z() + 3));
  EXPECT_EQ(document().rig().handles[2].rest.z(), rest.z() + 3);
  ASSERT_TRUE(type(2, Column::label, QStringLiteral("Tip")));
  EXPECT_EQ(document().rig().handles[2].label, "Tip");
}

TEST_F(HandleTableTest, TellsTheCoordinatesOfTheVertexThatIsClicked) {
  EXPECT_EQ(model().weights().size(), 0);
  key(Qt::Key_1); // A click in Handles mode adds a handle.
  click(QPoint(view().width() / 2, view().height() / 2));
  settle();
  ASSERT_TRUE(model().shownVertex());
  const app::ShownVertex vertex = *model().shownVertex();
  const Values& weights = model().weights();
  ASSERT_EQ(weights.size(), model().rowCount());
  EXPECT_NEAR(weights.sum(), 1, 1e-9);
  for (int row = 0; row < model().rowCount(); ++row) {
    const document::HandleId handle = document().rig().handles[static_cast<std::size_t>(row)].id;
    EXPECT_EQ(weights[row], window().workspace().live().influence(vertex.organ, handle)[vertex.vertex]);
  }
  const Vec3 made = document().rig().restPositions().transpose() * weights;
  EXPECT_LT((made - document().organs().front()->mesh->points.row(vertex.vertex).transpose()).norm(), 1e-6);
  const auto* said = table_->findChild<QLabel*>(QStringLiteral("handleTableVertex"));
  EXPECT_TRUE(said->text().startsWith(QStringLiteral("Vertex %1 of Ball").arg(vertex.vertex)))
      << said->text().toStdString();
  table_->copy();
  const QStringList lines = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  ASSERT_EQ(lines.size(), model().rowCount() + 1);
  EXPECT_EQ(lines[6].split(QLatin1Char('\t')).last().toDouble(), weights[5]) << "all digits are copied";
}

TEST_F(HandleTableTest, KeepsALockedVolumeAsThePageDoes) {
  const auto organ = document().organs().front()->id;
  ASSERT_TRUE(window().workspace().perform(document::setVolumeLocked(organ, true)));
  settle();
  const double before = window().workspace().live().volume(organ).nowMl;
  ASSERT_TRUE(type(2, app::HandleModel::poseY, at(2, app::HandleModel::poseY).toDouble() + 9));
  settle();
  EXPECT_NEAR(window().workspace().live().volume(organ).nowMl, before, 1e-6 * before);
}

} // namespace viscera::tests
