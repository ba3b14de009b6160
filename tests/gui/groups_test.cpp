#include "window_test.h"

#include <algorithm>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>

#include "build_paths.h"
#include "viscera/document/group_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/plugin/plugin_loader.h"
#include "viscera/scene/region_hulls.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/widgets/value_slider.h"

namespace viscera::tests {
namespace {

using State = live::BindingStatus::State;

/// Handles mode with a ball, and the coordinates that look at groups, from their plugin.
class Groups : public WindowTest {
protected:
  coordinates::Registry registry() const override {
    coordinates::Registry systems = coordinates::builtInRegistry();
    plugin::loadPlugins({VISCERA_BINARY_DIR "/lib/viscera/plugins/localised_scc_plugin.so"}, systems);
    return systems;
  }

  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    key(Qt::Key_2);
    perform(document::setSystem({"localised-s-celestial", {}}));
  }

  void perform(const document::Command& command) {
    ASSERT_TRUE(window().workspace().perform(command));
    settle();
  }
  void press(const char* name) {
    auto* button = window().findChild<QPushButton*>(QLatin1String(name));
    ASSERT_NE(button, nullptr) << name;
    ASSERT_TRUE(button->isEnabled()) << name;
    button->click();
    settle();
  }
  void takeOffer(const QString& label) {
    for (auto* button : window().viewArea().messages()->findChildren<QPushButton*>())
      if (button->isVisible() && button->text() == label)
        return button->click();
    FAIL() << "no offer \"" << label.toStdString() << "\" in: " << message().toStdString();
  }
  void undo() {
    key(Qt::Key_Z, Qt::ControlModifier);
    settle();
  }
  void groupAutomatically(int count) {
    window().findChild<QSpinBox*>(QStringLiteral("groupCount"))->setValue(count);
    press("groupAutomatically");
  }
  void select(std::size_t first, std::size_t count) {
    std::vector<document::HandleId> ids;
    for (std::size_t i = first; i < first + count; ++i)
      ids.push_back(rig().handles.at(i).id);
    window().workspace().selection().setHandles(ids);
  }
  const document::Rig& rig() { return document().rig(); }
  live::BindingStatus status() { return window().workspace().live().status(document().organs().front()->id); }
  const std::vector<scene::RegionHull>& hulls() { return view().view().regions().hulls(); }
  std::size_t steps() { return window().workspace().undo().position(); }
};

TEST_F(Groups, MakeThemselvesInOneStepAndAreShownAsHullsInTheirColours) {
  const std::size_t before = steps();
  const auto groups = rig().groups;
  groupAutomatically(3);
  ASSERT_EQ(rig().groups.size(), 3u);
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(status().state, State::bound) << status().message;
  ASSERT_EQ(hulls().size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(hulls()[i].color, rig().groups[i].color);
  key(Qt::Key_Z);
  EXPECT_GT(hulls().size(), 3u) << "with their zones";
  key(Qt::Key_Z);
  key(Qt::Key_R);
  EXPECT_TRUE(hulls().empty());
  key(Qt::Key_R);
  key(Qt::Key_3);
  EXPECT_TRUE(hulls().empty()) << "they belong to the handles at rest";
  key(Qt::Key_2);
  EXPECT_EQ(hulls().size(), 3u);
  undo();
  EXPECT_EQ(rig().groups, groups);
}

TEST_F(Groups, AreMadeChangedAndRemovedOneUndoStepEach) {
  const std::size_t groups = rig().groups.size();
  const std::size_t before = steps();
  select(8, 6);
  press("groupCreate");
  ASSERT_EQ(rig().groups.size(), groups + 1);
  EXPECT_EQ(rig().groups.back().handles.size(), 6u);
  EXPECT_EQ(window().workspace().selection().group(), rig().groups.back().id);

  auto* list = window().findChild<QTreeWidget*>(QStringLiteral("groupList"));
  ASSERT_EQ(list->topLevelItemCount(), int(groups + 1));
  list->topLevelItem(int(groups))->setText(0, QStringLiteral("Apex"));
  settle();
  EXPECT_EQ(rig().groups.back().name, "Apex");

  select(14, 2);
  press("groupAdd");
  EXPECT_EQ(rig().groups.back().handles.size(), 8u);
  select(8, 1);
  press("groupTakeOut");
  EXPECT_EQ(rig().groups.back().handles.size(), 7u);
  press("groupSelect");
  EXPECT_EQ(window().workspace().selection().handles(), rig().groups.back().handles);
  press("groupRemove");
  EXPECT_EQ(rig().groups.size(), groups);
  EXPECT_EQ(steps(), before + 5);
  for (int i = 0; i < 5; ++i)
    undo();
  EXPECT_EQ(steps(), before);
  EXPECT_EQ(rig().groups.size(), groups);
}

TEST_F(Groups, SayInOneSentenceWhatAutomaticGroupingHasAdded) {
  const auto said = [this] {
    QStringList sentences;
    for (const auto* label : window().findChildren<QLabel*>())
      if (label->isVisible() && label->text().startsWith(QStringLiteral("Automatic grouping has added")))
        sentences.push_back(label->text());
    return sentences.join(QLatin1Char('|')).toStdString();
  };
  EXPECT_EQ(said(), "");
  groupAutomatically(4);
  std::size_t added = 0, groups = 0;
  const auto isAdded = [this](document::HandleId id) {
    return rig().handles[std::size_t(rig().indexOf(id))].description == document::kAddedByGrouping;
  };
  for (const document::Handle& handle : rig().handles)
    added += isAdded(handle.id);
  for (const document::Group& group : rig().groups)
    groups += std::any_of(group.handles.begin(), group.handles.end(), isAdded);
  ASSERT_GT(added, 1u);
  EXPECT_EQ(said(), "Automatic grouping has added " + std::to_string(added) + " corner handles to " +
                        std::to_string(groups) + " of 4 groups.");
  undo();
  EXPECT_EQ(said(), "");
}

TEST_F(Groups, AHullTakesTheColourThatItsGroupIsGiven) {
  groupAutomatically(2);
  document::GroupEdit edit;
  edit.color = Vec3(0.2, 0.4, 0.6);
  perform(document::editGroup(rig().groups[0].id, edit));
  EXPECT_EQ(hulls()[0].color, *edit.color);
}

TEST_F(Groups, NameTheSystemInsideARegionAsTheListOfSystemsDoes) {
  const auto* inner = window().findChild<QComboBox*>(QStringLiteral("parameter/inner"));
  ASSERT_NE(inner, nullptr);
  EXPECT_GE(inner->findText(QStringLiteral("S-Celestial")), 0) << inner->itemText(0).toStdString();
}

TEST_F(Groups, TheOffsetSliderEndsAtItsBoundAndBindsLive) {
  groupAutomatically(3);
  auto* offset = window().findChild<app::ValueSlider*>(QStringLiteral("parameter/offset"));
  ASSERT_NE(offset, nullptr);
  auto* slider = offset->findChild<QSlider*>();
  slider->setSliderDown(true);
  slider->setValue(1);
  settle();
  const Values small = window().workspace().live().influence(document().organs()[0]->id, rig().handles[9].id);
  const std::size_t before = steps();
  slider->setValue(slider->maximum());
  settle();
  const Values large = window().workspace().live().influence(document().organs()[0]->id, rig().handles[9].id);
  EXPECT_EQ(status().state, State::bound);
  EXPECT_GT((small - large).cwiseAbs().maxCoeff(), 1e-6) << "the organ was not bound anew";
  EXPECT_EQ(steps(), before) << "one step a slide";
  slider->setSliderDown(false);
  EXPECT_LT(offset->value(), 200) << "the parameter's own maximum is 1000 mm, the ball's diameter 120";
}

TEST_F(Groups, HullsFollowAHandleThatIsDraggedAtRest) {
  groupAutomatically(3);
  const int handle = reachableHandle();
  ASSERT_GE(handle, 0);
  const auto verticesOf = [this] {
    std::vector<Points> all;
    for (const auto& hull : hulls())
      all.push_back(hull.vertices);
    return all;
  };
  const auto before = verticesOf();
  document::UndoStack::Step drag(window().workspace().undo(), "Drag");
  Points to(1, 3);
  to << 1.1 * rig().handles[std::size_t(handle)].rest.transpose();
  perform(document::moveRestHandles({rig().handles[std::size_t(handle)].id}, to));
  EXPECT_NE(verticesOf(), before) << "in the middle of the drag";
  EXPECT_EQ(status().state, State::bound);
  drag.cancel();
  settle();
  EXPECT_EQ(verticesOf(), before);
}

TEST_F(Groups, AGroupThatIsTooSmallOrFlatIsNamedAndUndoMends) {
  groupAutomatically(2);
  const document::DocumentState good = document().state();
  select(8, 3);
  press("groupCreate");
  EXPECT_EQ(status().state, State::failed);
  EXPECT_TRUE(message().contains(QString::fromStdString(rig().groups.back().name)))
      << message().toStdString();
  EXPECT_TRUE(message().contains(QStringLiteral("3 handles"))) << message().toStdString();
  takeOffer(QStringLiteral("Undo"));
  settle();
  EXPECT_EQ(document().state(), good);
  EXPECT_EQ(status().state, State::bound);
  select(0, 4); // One face of the box around the ball.
  press("groupCreate");
  EXPECT_EQ(status().state, State::failed);
  EXPECT_TRUE(message().contains(QStringLiteral("plane"))) << message().toStdString();
  undo();
  EXPECT_EQ(status().state, State::bound);
  EXPECT_TRUE(message().isEmpty()) << message().toStdString();
}

TEST_F(Groups, VerticesInNoRegionAreCountedAndAnEnclosingGroupMendsIt) {
  groupAutomatically(3);
  perform(document::removeGroup(rig().groups[1].id));
  ASSERT_EQ(status().state, State::failed);
  const auto lost = status().inNoRegion.size();
  ASSERT_GT(lost, 0u);
  EXPECT_TRUE(message().startsWith(QString::number(lost))) << message().toStdString();
  EXPECT_EQ(window().workspace().live().points(document().organs()[0]->id),
            document().organs()[0]->mesh->points);
  takeOffer(QStringLiteral("Add enclosing group"));
  settle();
  EXPECT_EQ(status().state, State::bound) << status().message;
  EXPECT_EQ(rig().groups.back().name, "Enclosing");
}

TEST_F(Groups, AnOffsetBeyondItsBoundIsSaidOnce) {
  groupAutomatically(3);
  perform(document::setParameter("offset", 900));
  EXPECT_EQ(status().state, State::bound);
  EXPECT_TRUE(message().contains(QStringLiteral("is cut to"))) << message().toStdString();
}

} // namespace
} // namespace viscera::tests
