#include "window/work/actions.h"

#include <QAction>
#include <QWidget>

#include "window/style/icon.h"

namespace viscera::app {

Actions::Actions(QWidget* window) : QObject(window), window_(window) {}

QAction* Actions::make(const char* id, const Description& description) {
  auto* action = new QAction(description.text, window_);
  action->setObjectName(QLatin1String(id));
  if (description.icon) {
    action->setIcon(icon(description.icon));
    action->setProperty(kIconName, QLatin1String(description.icon));
  }
  action->setShortcuts(description.shortcuts);
  QString label = description.text;
  label.remove(QLatin1Char('&'));
  if (label.endsWith(QLatin1String("...")))
    label.chop(3);
  QString tip = description.tip.isEmpty() ? label : description.tip;
  if (!description.shortcuts.isEmpty())
    tip += QStringLiteral(" (%1)").arg(description.shortcuts.front().toString(QKeySequence::NativeText));
  action->setToolTip(tip);
  window_->addAction(action);
  byId_[QLatin1String(id)] = action;
  order_.push_back(action);
  return action;
}

QAction* Actions::add(const char* id, const Description& description, std::function<void()> run) {
  QAction* action = make(id, description);
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  return action;
}

QAction* Actions::addToggle(const char* id, const Description& description, bool on,
                            std::function<void(bool)> run) {
  QAction* action = make(id, description);
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, [run = std::move(run)](bool checked) { run(checked); });
  return action;
}

void Actions::enableWhile(const std::vector<const char*>& ids, std::function<bool()> allowed) {
  onSync([this, ids, allowed = std::move(allowed)] {
    const bool enabled = allowed();
    for (const char* id : ids)
      (*this)[id]->setEnabled(enabled);
  });
}

void Actions::sync() {
  for (const auto& bring : syncs_)
    bring();
}

QAction* Actions::operator[](const char* id) const {
  const auto found = byId_.find(QLatin1String(id));
  Q_ASSERT(found != byId_.end());
  return found->second;
}

} // namespace viscera::app
