#pragma once

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/clinic/archive.h"
#include "viscera/clinic/key_ring.h"
#include "viscera/core/job_queue.h"

namespace viscera::app {

/// Where a request to an archive waits and runs.
struct JobPlace {
  JobQueue* jobs = nullptr; ///< Null: the workers of the client itself. Open requests end with it.
  std::string slot;
};

/// Speaks with the archives that the user has named, on workers of its own, one request at a time: a new one
/// cancels the one before. Knows the list of archives and asks for passwords, which it keeps in memory, or
/// in the system's key ring where the user wants that.
class ArchiveClient final : public QObject {
  Q_OBJECT

public:
  /// What a user answers to the question for a password.
  struct Answer {
    std::string password;
    bool keep = false; ///< In the key ring.
  };
  /// Asks for the password of an archive; none: the user gives it up. `refused`: the one before was wrong.
  using Question =
      std::function<std::optional<Answer>(const clinic::ArchiveConnection&, bool refused, bool canKeep)>;

  ArchiveClient(std::shared_ptr<clinic::KeyRing> ring, std::filesystem::path connectionsFile,
                QObject* parent = nullptr);

  void setQuestion(Question question) { question_ = std::move(question); }
  void setKeyRing(std::shared_ptr<clinic::KeyRing> ring) { ring_ = std::move(ring); }

  /// The archives of the file. Throws `DataError` for a damaged one.
  std::vector<clinic::ArchiveConnection> connections() const;
  /// Writes the file. Throws `CannotCreateError`.
  void setConnections(const std::vector<clinic::ArchiveConnection>& connections);
  /// Forgets the password of a connection, also in the key ring.
  void forgetPassword(const clinic::ArchiveConnection& connection);

  void test(const clinic::ArchiveConnection& connection, std::function<void()> then);
  void query(const clinic::ArchiveConnection& connection, const clinic::ArchiveQuery& query,
             std::function<void(std::vector<clinic::ArchiveStudy>)> then);
  /// Fetches a series, or a whole study for an empty `seriesUid`, into a folder that may be there.
  void retrieve(const clinic::ArchiveConnection& connection, const std::string& studyUid,
                const std::string& seriesUid, const std::filesystem::path& folder,
                std::function<void()> then);
  /// Stores files in the archive. `make` makes them, once, on the same worker; the job belongs to `place`,
  /// which shows its progress and cancels it.
  void send(const clinic::ArchiveConnection& connection, const JobPlace& place,
            std::function<std::vector<std::filesystem::path>(Progress&)> make, std::function<void()> then);
  /// Cancels what runs on the workers of this object.
  void cancel() { jobs_.cancelAll(); }

  /// The request that is being fulfilled; none while nothing is.
  std::optional<JobInfo> present() const;

Q_SIGNALS:
  /// `present` has changed.
  void progressed();
  /// A request was not fulfilled, for the reason in this sentence.
  void failed(const QString& sentence);

private:
  template <class Value>
  using Work = std::function<Value(const std::string& password, Progress&)>;

  /// Runs it with the password that is known; asks, and runs it again, when there is none or it is wrong.
  template <class Value>
  void run(const clinic::ArchiveConnection& connection, const QString& name, Work<Value> work,
           std::function<void(Value)> then, std::optional<Answer> given = {}, const JobPlace& place = {});
  std::optional<Answer> askFor(const clinic::ArchiveConnection& connection, bool refused);

  std::shared_ptr<clinic::KeyRing> ring_;
  std::filesystem::path file_;
  Question question_;
  std::map<std::string, Answer> answers_; ///< By name of the archive, as long as the program runs.
  JobQueue jobs_;
  Subscription subscription_;
};

} // namespace viscera::app
