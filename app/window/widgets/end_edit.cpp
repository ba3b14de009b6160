#include "window/widgets/end_edit.h"

#include <QAbstractItemDelegate>
#include <QLineEdit>
#include <QTreeWidget>

namespace viscera::app {

void endEdit(QTreeWidget& list) {
  auto* editor = list.viewport()->findChild<QLineEdit*>();
  if (!editor)
    return;
  QAbstractItemDelegate* delegate = list.itemDelegate();
  Q_EMIT delegate->commitData(editor);
  Q_EMIT delegate->closeEditor(editor);
}

} // namespace viscera::app
