#pragma once

#include <QDir>
#include <QRegularExpression>

#include <initializer_list>

namespace viscera::tests {

/// Makes this test use the display that CTest assigns to it exclusively, with settings and sockets of that
/// display; keeps the present ones if CTest assigns none. Call it before the application is created. CTest
/// gets the list of displays by `--resource-spec-file`, as in test.sh.
inline void useLentDisplay() {
  const QString lent = qEnvironmentVariable("CTEST_RESOURCE_GROUP_0_DISPLAYS"); // "id:99,slots:1"
  const QString number = QRegularExpression(QStringLiteral("id:(\\d+)")).match(lent).captured(1);
  if (number.isEmpty())
    return;
  qputenv("DISPLAY", ":" + number.toLatin1());
  for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"}) {
    if (qEnvironmentVariableIsEmpty(variable))
      continue;
    const QString folder = qEnvironmentVariable(variable) + QStringLiteral("/display_") + number;
    QDir().mkpath(folder);
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner); // Qt asks for it.
    qputenv(variable, QFile::encodeName(folder));
  }
}

} // namespace viscera::tests
