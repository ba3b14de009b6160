#include "window/widgets/welcome_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "window/style/icon.h"

namespace viscera::app {

WelcomeCard::WelcomeCard(QMenu* samples, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("welcomeCard"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 10, 12, 14);
  column->setSpacing(8);
  auto* heading = new QHBoxLayout;
  auto* title = new QLabel(tr("Welcome to Viscera"), this);
  QFont font = title->font();
  font.setPointSizeF(font.pointSizeF() * 1.25);
  font.setBold(true);
  title->setFont(font);
  auto* closeButton = new QToolButton(this);
  closeButton->setIcon(icon("close"));
  closeButton->setIconSize(QSize(14, 14));
  closeButton->setToolTip(tr("Close this card (Help > Welcome shows it again)"));
  closeButton->setAccessibleName(tr("Close this card"));
  heading->addWidget(title, 1);
  heading->addWidget(closeButton);
  column->addLayout(heading);
  auto* text = new QLabel(tr("Organs that move and deform, with their volumes alive."), this);
  text->setObjectName(QStringLiteral("muted"));
  text->setWordWrap(true);
  column->addWidget(text);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  const auto addButton = [&](const char* name, const QString& label, const QString& tip) {
    auto* button = new QPushButton(icon(name), label, this);
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  };
  auto* open =
      addButton("patient", tr("Open a patient..."), tr("Choose organ surfaces of a patient (Ctrl+O)"));
  auto* sample = addButton("heart", tr("Sample organs"), tr("Organs that come with the program"));
  auto* tour = addButton("tour", tr("Two-minute tour"), tr("What there is in this window, step by step"));
  sample->setMenu(samples);
  column->addLayout(row);
  connect(open, &QPushButton::clicked, this, &WelcomeCard::openRequested);
  connect(tour, &QPushButton::clicked, this, &WelcomeCard::tourRequested);
  connect(closeButton, &QToolButton::clicked, this, [this] {
    hide();
    Q_EMIT closed();
  });
}

} // namespace viscera::app
