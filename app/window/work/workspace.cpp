#include "window/work/workspace.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/presentation/space_parts.h"
#include "window/style/language.h"
#include "window/work/mailbox.h"

namespace viscera::app {
namespace {
constexpr int kToldSeconds = 8;
} // namespace

Workspace::Workspace(coordinates::Registry registry, QObject* parent)
    : QObject(parent), undo_(document_), registry_(std::move(registry)), jobs_(mailbox()),
      live_(document_, registry_, jobs_), stress_(document_, registry_, live_, jobs_),
      warp_(document_, live_, registry_, jobs_), selection_(document_) {
  // The offer would undo another step.
  stepsFollowed_ = undo_.onChange([this] {
    if (!told_.isEmpty() && undo_.position() != toldAt_)
      retract(std::exchange(told_, {}));
  });
}

bool Workspace::performTelling(const document::Command& command, const QString& said) {
  told_.clear();
  // First: what binding has to say of the step counts more.
  say({Message::Severity::info,
       said,
       {{tr("Undo"), [this] { guarded([this] { undo_.undo(); }); }}},
       kToldSeconds});
  if (!perform(command)) {
    retract(said);
    return false;
  }
  told_ = said;
  toldAt_ = undo_.position();
  return true;
}

bool Workspace::guarded(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const Cancelled&) {
    return false;
  } catch (const Error& error) {
    report(error);
  } catch (const std::exception& error) {
    report(reportsShortMemory(error) ? notEnoughMemory()
                                     : Error(kInternalError, std::string(error.what()), {},
                                             "this is a fault of the program; please report it"));
  } catch (...) { // A library's or a plugin's own kind.
    report(Error(kInternalError, "Internal error of an unknown kind", {},
                 "this is a fault of the program; please report it"));
  }
  return false;
}

QString sentenceOf(const Error& error) {
  Text said = error.where().empty() ? error.problem() : phrase("%1: %2", error.where(), error.problem());
  if (!error.tryThis().empty())
    said = phrase("%1. %2.", said, error.tryThis().capitalised());
  QString sentence = inWords(said);
  if (!sentence.isEmpty())
    sentence[0] = sentence[0].toUpper();
  return sentence;
}

QStringList Workspace::writing() const {
  QStringList names;
  for (const JobInfo& job : jobs_.jobs())
    if (job.slot.rfind(kWriting, 0) == 0)
      names.push_back(inWords(job.name));
  return names;
}

void Workspace::report(const Error& error) {
  say({Message::Severity::error, sentenceOf(error), {}, 0});
}

void Workspace::noteWritten(const QString& text, const QString& file) {
  const QUrl folder = QUrl::fromLocalFile(QFileInfo(file).absolutePath());
  say({Message::Severity::info,
       text,
       {{tr("Open folder"), [folder] { QDesktopServices::openUrl(folder); }}},
       8});
}

coordinates::Traits Workspace::systemTraits() const {
  return presentation::traitsOf(document_.state(), registry_);
}

std::shared_ptr<const document::Organ> Workspace::currentOrgan() const {
  return presentation::currentOrgan(document_.state(), selection_.organ());
}

std::shared_ptr<const document::Organ> Workspace::describedOrgan() const {
  const document::OrganList& organs = document_.organs();
  const auto whole =
      std::count_if(organs.begin(), organs.end(), [](const auto& organ) { return !organ->parent; });
  const auto selected = document_.organ(selection_.organ());
  return whole > 1 ? selected : currentOrgan();
}

QString asSentence(const Text& text) {
  QString sentence = inWords(text);
  if (sentence.isEmpty())
    return sentence;
  sentence[0] = sentence[0].toUpper();
  return sentence.endsWith(QLatin1Char('.')) ? sentence : sentence + QLatin1Char('.');
}

namespace {

QString withSign(double value, int decimals) {
  const double half = 0.5 * std::pow(10.0, -decimals);
  const double shown = std::abs(value) < half ? 0.0 : value;
  return (shown >= 0 ? QStringLiteral("+") : QString()) + formatNumber(shown, decimals);
}

} // namespace

QString formatChange(const live::OrganVolume& volume) {
  return QObject::tr("%1 ml").arg(withSign(volume.changeMl(), std::abs(volume.restMl) < 10 ? 3 : 1));
}

QString formatRelativeChange(const live::OrganVolume& volume) {
  return QObject::tr("%1 %").arg(withSign(100 * volume.relativeChange(), 1));
}

QString formatMilliliters(double milliliters) {
  const int decimals = std::abs(milliliters) < 1 ? 3 : std::abs(milliliters) < 1000 ? 1 : 0;
  return QObject::tr("%1 ml").arg(formatNumber(milliliters, decimals));
}

} // namespace viscera::app
