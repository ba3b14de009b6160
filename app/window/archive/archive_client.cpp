#include "window/archive/archive_client.h"

#include "window/work/mailbox.h"
#include "window/work/workspace.h"

namespace viscera::app {
namespace {

/// One may still wait for an archive that is silent, while the next request begins.
constexpr int kArchiveWorkers = 2;
constexpr const char* kArchiveSlot = "archive";
constexpr double kMade = 0.5; ///< Part of sending until the files are made.

} // namespace

ArchiveClient::ArchiveClient(std::shared_ptr<clinic::KeyRing> ring, std::filesystem::path connectionsFile,
                             QObject* parent)
    : QObject(parent), ring_(std::move(ring)), file_(std::move(connectionsFile)),
      jobs_(mailbox(), kArchiveWorkers), subscription_(jobs_.onChange([this] { Q_EMIT progressed(); })) {}

std::vector<clinic::ArchiveConnection> ArchiveClient::connections() const {
  return clinic::readArchiveConnections(file_);
}

void ArchiveClient::setConnections(const std::vector<clinic::ArchiveConnection>& connections) {
  clinic::writeArchiveConnections(file_, connections);
}

void ArchiveClient::forgetPassword(const clinic::ArchiveConnection& connection) {
  answers_.erase(connection.name);
  if (!clinic::wantsPassword(connection))
    return;
  jobs_.submit<bool>(
      tr("Forgetting the password").toStdString(), {},
      [ring = ring_, connection](Progress& progress) {
        ring->forget(connection, progress);
        return true;
      },
      [](const JobResult<bool>&) {});
}

std::optional<JobInfo> ArchiveClient::present() const {
  const std::vector<JobInfo> jobs = jobs_.jobs();
  return jobs.empty() ? std::nullopt : std::optional(jobs.back());
}

std::optional<ArchiveClient::Answer> ArchiveClient::askFor(const clinic::ArchiveConnection& connection,
                                                           bool refused) {
  answers_.erase(connection.name);
  return question_ ? question_(connection, refused, ring_->isThere()) : std::nullopt;
}

template <class Value>
void ArchiveClient::run(const clinic::ArchiveConnection& connection, const QString& name, Work<Value> work,
                        std::function<void(Value)> then, std::optional<Answer> given, const JobPlace& place) {
  if (const auto known = answers_.find(connection.name); !given && known != answers_.end())
    given = known->second;
  JobQueue& jobs = place.jobs ? *place.jobs : jobs_;
  jobs.submit<std::optional<Value>>(
      name.toStdString(), place.jobs ? place.slot : kArchiveSlot,
      [connection, work, given, ring = ring_](Progress& progress) -> std::optional<Value> {
        std::optional<std::string> password;
        if (given)
          password = given->password;
        else if (clinic::wantsPassword(connection))
          password = ring->find(connection, progress);
        else
          password = std::string();
        if (!password)
          return std::nullopt;
        Value value = work(*password, progress);
        if (given && given->keep)
          ring->keep(connection, given->password, progress);
        return value;
      },
      [this, connection, name, work, then, given, place](JobResult<std::optional<Value>> result) {
        const bool refused = result.error && result.error->exitCode() == clinic::kPasswordRefused;
        if (refused || (result.value && !*result.value)) {
          if (const auto answer = askFor(connection, refused))
            return run<Value>(connection, name, work, then, answer, place);
          Q_EMIT failed(refused ? sentenceOf(*result.error) : tr("No password was given."));
        } else if (result.error) {
          Q_EMIT failed(sentenceOf(*result.error));
        } else if (result.value) {
          if (given)
            answers_[connection.name] = {given->password, false};
          then(std::move(**result.value));
        }
      });
}

void ArchiveClient::test(const clinic::ArchiveConnection& connection, std::function<void()> then) {
  run<bool>(
      connection, tr("Testing %1").arg(text(connection.name)),
      [connection](const std::string& password, Progress& progress) {
        clinic::testArchive(connection, password, progress);
        return true;
      },
      [then = std::move(then)](bool) { then(); });
}

void ArchiveClient::query(const clinic::ArchiveConnection& connection, const clinic::ArchiveQuery& query,
                          std::function<void(std::vector<clinic::ArchiveStudy>)> then) {
  run<std::vector<clinic::ArchiveStudy>>(
      connection, tr("Searching %1").arg(text(connection.name)),
      [connection, query](const std::string& password, Progress& progress) {
        return clinic::queryArchive(connection, password, query, progress);
      },
      std::move(then));
}

void ArchiveClient::retrieve(const clinic::ArchiveConnection& connection, const std::string& studyUid,
                             const std::string& seriesUid, const std::filesystem::path& folder,
                             std::function<void()> then) {
  run<bool>(
      connection, tr("Fetching from %1").arg(text(connection.name)),
      [connection, studyUid, seriesUid, folder](const std::string& password, Progress& progress) {
        using clinic::Existing;
        if (seriesUid.empty())
          clinic::retrieveStudy(connection, password, studyUid, folder, progress, Existing::replace);
        else
          clinic::retrieveSeries(connection, password, studyUid, seriesUid, folder, progress,
                                 Existing::replace);
        return true;
      },
      [then = std::move(then)](bool) { then(); });
}

void ArchiveClient::send(const clinic::ArchiveConnection& connection, const JobPlace& place,
                         std::function<std::vector<std::filesystem::path>(Progress&)> make,
                         std::function<void()> then) {
  using Files = std::vector<std::filesystem::path>;
  run<bool>(
      connection, tr("Sending to %1").arg(text(connection.name)),
      [connection, make = std::move(make),
       made = std::make_shared<std::optional<Files>>()](const std::string& password, Progress& progress) {
        if (!*made) // Else the archive has refused a password, and there is another one now.
          runPart(progress, 0, kMade, [&](Progress& part) { *made = make(part); });
        runPart(progress, kMade, 1,
                [&](Progress& part) { clinic::sendToArchive(connection, password, **made, part); });
        return true;
      },
      [then = std::move(then)](bool) { then(); }, {}, place);
}

} // namespace viscera::app
