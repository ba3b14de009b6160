#include "window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>

#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>

#include "identified_slices.h"
#include "temporary_folder.h"
#include "viscera/document/scan_item.h"
#include "window/widgets/wrapped_label.h"

namespace viscera::tests {

/// A ball of 60 mm on the slices of Jane Doe.
class ExportAsDicom : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    LabelImage image = emptyLabels({32, 32, 18});
    image.indexToLps.linear() = Vec3(5, 5, 8).asDiagonal();
    image.indexToLps.translation() = Vec3(-77.5, -77.5, -68);
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      image.voxels[i] = std::int16_t(i % 977);
    for (int k = 0; k < image.size[2]; ++k) {
      ct_.put("slice" + std::to_string(k), dicomBytes(identifiedSlice(image, k)));
    }
    open(text(ct_.path()));
    ASSERT_TRUE(waitUntil([this] { return document().state().scan != nullptr; })) << message().toStdString();
    settle();
  }

  static QString text(const std::filesystem::path& file) { return QString::fromStdString(file.string()); }
  /// Shows the dialog, with the name of the patient read.
  void showDialog() {
    window().actions()["export.dicom"]->trigger();
    settle();
  }
  void exportInto(const QString& folder) {
    find<QLineEdit>("dicomFolder").setText(folder);
    find<QPushButton>("dicomExport").click();
    settle();
  }
  std::string bytes(const QString& folder, const char* name) {
    return contentsOf(std::filesystem::path(folder.toStdString()) / name);
  }

  TemporaryFolder ct_;
};

TEST_F(ExportAsDicom, WritesWhatIsChosenOnceAndWithoutIdentityNothingOfThePatient) {
  using testing::HasSubstr;
  using testing::Not;
  showDialog();
  EXPECT_LE(find<QDialog>("dicom").minimumSizeHint().width(), 940);
  EXPECT_LE(find<QDialog>("dicom").minimumSizeHint().height(), 560);
  EXPECT_FALSE(find<QSpinBox>("dicomPhases").isEnabled()) << "nothing moves the ball";
  EXPECT_THAT(find<QPlainTextEdit>("dicomIdentity").toPlainText().toStdString(),
              HasSubstr("PatientName: Doe^Jane"));
  for (const char* kind : {"dicomSegmentation", "dicomMeasurements"})
    find<QCheckBox>(kind).setChecked(false);
  EXPECT_FALSE(find<QPushButton>("dicomExport").isEnabled());
  EXPECT_FALSE(find<app::WrappedLabel>("dicomSaid").text().isEmpty());
  for (const char* kind : {"dicomSegmentation", "dicomMeasurements", "dicomSurfaces", "dicomContours"})
    find<QCheckBox>(kind).setChecked(true);
  const QString folder = path(QStringLiteral("out"));
  exportInto(folder);
  const std::map<const char*, const char*> classes = {{"segmentation.dcm", "1.2.840.10008.5.1.4.1.1.66.4"},
                                                      {"measurements.dcm", "1.2.840.10008.5.1.4.1.1.88."},
                                                      {"surface_1.dcm", "1.2.840.10008.5.1.4.1.1.104.3"},
                                                      {"contours.dcm", "1.2.840.10008.5.1.4.1.1.481.3"}};
  EXPECT_EQ(QDir(folder).entryList(QDir::Files).size(), 4) << message().toStdString();
  for (const auto& [name, classUid] : classes) {
    EXPECT_THAT(bytes(folder, name), HasSubstr(classUid)) << name;
    EXPECT_THAT(bytes(folder, name), HasSubstr("Doe^Jane")) << name;
  }
  EXPECT_TRUE(message().contains(QStringLiteral("segmentations (1)"))) << message().toStdString();

  showDialog(); // A folder with such a file is refused, and nothing is added.
  exportInto(folder);
  EXPECT_TRUE(message().contains(QStringLiteral("there already"))) << message().toStdString();
  EXPECT_EQ(QDir(folder).entryList(QDir::Files).size(), 4);

  showDialog();
  find<QCheckBox>("dicomWithoutIdentity").setChecked(true);
  find<QCheckBox>("dicomSegmentation").setChecked(false);
  exportInto(path(QStringLiteral("clean")));
  const std::string clean = bytes(path(QStringLiteral("clean")), "measurements.dcm");
  ASSERT_FALSE(clean.empty()) << message().toStdString();
  for (const char* value : {"Doe", "PID0815", "1.2.840.4711"})
    EXPECT_THAT(clean, Not(HasSubstr(value)));
}

} // namespace viscera::tests
