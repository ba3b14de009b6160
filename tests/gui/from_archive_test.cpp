#include "window_test.h"

#include <QAbstractButton>
#include <QAction>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include <gmock/gmock.h>

#include "orthanc.h"
#include "viscera/document/scan_item.h"
#include "viscera/medical_io/archive_origin.h"
#include "viscera/medical_io/scan.h"
#include "window/archive/archive_actions.h"
#include "window/session/session_files.h"
#include "window/widgets/message_bar.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::tests {
namespace {

/// A key ring that holds passwords as long as it lives.
class RingInMemory final : public clinic::KeyRing {
public:
  bool isThere() const override { return true; }
  std::optional<std::string> find(const clinic::ArchiveConnection& connection, Progress&) override {
    const auto found = kept_.find(connection.address);
    return found == kept_.end() ? std::nullopt : std::optional(found->second);
  }
  bool keep(const clinic::ArchiveConnection& connection, const std::string& password, Progress&) override {
    kept_[connection.address] = password;
    return true;
  }
  void forget(const clinic::ArchiveConnection& connection, Progress&) override {
    kept_.erase(connection.address);
  }
  bool empty() const { return kept_.empty(); }

private:
  std::map<std::string, std::string> kept_;
};

/// A window whose archive is an Orthanc of its own, with one series.
class FromTheArchive : public WindowTest {
protected:
  void SetUp() override {
    if (!orthancIsThere() && std::getenv("CI") == nullptr)
      GTEST_SKIP() << "there is no Orthanc with its plugin for DICOMweb";
    ASSERT_TRUE(orthancIsThere()) << "continuous integration must have Orthanc and its plugin for DICOMweb";
    for (const char* name : kFolders) {
      before_.push_back(qgetenv(name));
      qputenv(name, QByteArray::fromStdString((home_ / name).string()));
    }
    orthanc_.emplace();
    ASSERT_TRUE(orthanc_->answers());
    Progress quiet;
    clinic::sendToArchive(dimseTo(orthanc_->dimsePort), {}, madeSeries(made_), quiet);
    clinic::writeArchiveConnections(clinic::archiveConnectionsFile(), {webTo(orthanc_->webPort)});
    WindowTest::SetUp();
    archive().client().setKeyRing(ring_);
  }
  void TearDown() override {
    if (before_.empty())
      return;
    WindowTest::TearDown();
    for (std::size_t i = 0; i < before_.size(); ++i)
      if (before_[i].isEmpty())
        qunsetenv(kFolders[i]);
      else
        qputenv(kFolders[i], before_[i]);
  }

  app::ArchiveActions& archive() { return window().archive(); }
  QString said() { return find<app::WrappedLabel>("archiveSaid").text(); }
  bool hasScan() { return document().state().scan != nullptr; }
  QAbstractButton* offer(const QString& named) {
    for (auto* button : window().viewArea().messages()->findChildren<QAbstractButton*>())
      if (button->text() == named)
        return button;
    return nullptr;
  }

  static constexpr const char* kFolders[] = {"XDG_CONFIG_HOME", "XDG_CACHE_HOME"};
  std::vector<QByteArray> before_;
  TemporaryFolder home_, made_;
  std::optional<Orthanc> orthanc_;
  std::shared_ptr<RingInMemory> ring_ = std::make_shared<RingInMemory>();
};

TEST_F(FromTheArchive, ASeriesIsFoundFetchedOpenedAndFetchedAgainForItsSession) {
  std::vector<bool> asked; // Whether the password before was wrong.
  archive().client().setQuestion([&](const clinic::ArchiveConnection&, bool refused, bool canKeep) {
    asked.push_back(refused);
    EXPECT_TRUE(canKeep);
    return std::optional(app::ArchiveClient::Answer{refused ? kArchivePassword : "wrong", true});
  });
  window().actions()["file.fromArchive"]->trigger();
  ASSERT_TRUE(archive().dialog());
  EXPECT_LE(archive().dialog()->minimumSizeHint().width(), 940);
  EXPECT_LE(archive().dialog()->minimumSizeHint().height(), 560);
  auto& list = find<QTreeWidget>("archiveStudies");
  find<QLineEdit>("archiveFrom").setText(QStringLiteral("1 March"));
  find<QPushButton>("archiveSearch").click();
  EXPECT_TRUE(said().contains(QStringLiteral("1 March is no day"))) << said().toStdString();
  find<QLineEdit>("archiveFrom").setText(QStringLiteral("2024-03-01"));
  find<QLineEdit>("archivePatientId").setText(QStringLiteral("PID08"));
  find<QPushButton>("archiveSearch").click();
  ASSERT_TRUE(waitUntil([&] {
    return list.topLevelItemCount() == 1 && list.topLevelItem(0)->childCount() == 1;
  })) << said().toStdString();
  EXPECT_EQ(asked, (std::vector<bool>{false, true}));
  EXPECT_FALSE(ring_->empty());
  EXPECT_EQ(list.topLevelItem(0)->text(0), QString::fromUtf8("M\xC3\xBCller, Jane"));
  EXPECT_EQ(list.topLevelItem(0)->text(2), QStringLiteral("2024-03-01"));
  find<QPushButton>("archiveOpen").click();
  ASSERT_TRUE(waitUntil([&] { return hasScan(); })) << message().toStdString();
  EXPECT_EQ(document().state().scan->scan->size[2], 8);
  settle();

  const QString session = path(QStringLiteral("s.viscera"));
  bool saved = false;
  window().sessions().saveTo(session, false, [&] { saved = true; });
  ASSERT_TRUE(waitUntil([&] { return saved; }));
  for (const auto& folder : {home_.path(), std::filesystem::path(path({}).toStdString())})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) {
        EXPECT_THAT(contentsOf(entry.path()), testing::Not(testing::HasSubstr(kArchivePassword)));
      }
  std::filesystem::remove_all(clinic::archiveFolder());
  window().sessions().open(session);
  ASSERT_TRUE(waitUntil([&] { return offer(QStringLiteral("Fetch it from Ward")) != nullptr; }))
      << message().toStdString();
  EXPECT_FALSE(hasScan());
  offer(QStringLiteral("Fetch it from Ward"))->click();
  ASSERT_TRUE(waitUntil([&] { return hasScan(); })) << message().toStdString();
  settle();

  const auto origin = medical_io::readArchiveOrigin(document().state().scan->file);
  ASSERT_TRUE(origin);
  QString fetched;
  archive().fetchAgain(*origin, "..", [&](const QString& folder) { fetched = folder; });
  ASSERT_TRUE(waitUntil([&] { return !fetched.isEmpty(); })) << message().toStdString();
  EXPECT_EQ(std::filesystem::path(fetched.toStdString()),
            clinic::archiveFolder() / "sessions" / origin->seriesUid)
      << "a session names no folder above";
}

} // namespace
} // namespace viscera::tests
