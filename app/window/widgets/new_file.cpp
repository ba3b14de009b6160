#include "window/widgets/new_file.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMessageBox>

#include <algorithm>

namespace viscera::app {
namespace {

QString newFileText(const char* text) {
  return QCoreApplication::translate("NewFile", text);
}

} // namespace

QString asNewFile(QWidget* parent, const QString& chosen, const QStringList& endings) {
  const bool complete = std::any_of(endings.begin(), endings.end(), [&chosen](const QString& ending) {
    return chosen.endsWith(ending, Qt::CaseInsensitive);
  });
  if (chosen.isEmpty() || complete)
    return chosen;
  const QString file = chosen + endings.front();
  if (!QFileInfo::exists(file))
    return file;
  const auto answer = QMessageBox::question(
      parent, newFileText(QT_TRANSLATE_NOOP("NewFile", "Replace the file?")),
      newFileText(QT_TRANSLATE_NOOP("NewFile", "%1 already exists. Do you want to replace it?"))
          .arg(QFileInfo(file).fileName()),
      QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
  return answer == QMessageBox::Yes ? file : QString();
}

} // namespace viscera::app
