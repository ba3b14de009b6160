#pragma once

#include <QObject>

#include <filesystem>
#include <functional>
#include <memory>
#include <set>

#include "viscera/document/scan_item.h"
#include "viscera/medical_io/image_file.h"
#include "window/work/workspace.h"

namespace viscera::app {

class FileActions;
class ScanActions;

/// Offers to open the scan that belongs to opened organs, or the organs that belong to an opened scan, when
/// it finds them beside the file. Each file is asked about once.
class PatientOffer final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer. `importing` returns whether the user is checking files before their import;
  /// nothing is offered then, because these may be the missing files.
  PatientOffer(Workspace& workspace, FileActions& files, ScanActions& scans, std::function<bool()> importing,
               QObject* parent = nullptr);

private:
  void look();
  void searchFolder(const std::filesystem::path& image, medical_io::ImageContents wanted);
  void offer(const std::filesystem::path& image, const std::filesystem::path& found,
             medical_io::ImageContents contents);
  bool misses(medical_io::ImageContents wanted) const;

  Workspace& workspace_;
  FileActions& files_;
  ScanActions& scans_;
  std::function<bool()> importing_;
  std::set<std::filesystem::path> asked_;
  std::shared_ptr<const document::OrganList> seenOrgans_;
  std::shared_ptr<const document::ScanItem> seenScan_;
  Subscription subscription_;
};

} // namespace viscera::app
