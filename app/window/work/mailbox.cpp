#include "window/work/mailbox.h"

#include <QCoreApplication>
#include <QEvent>
#include <QObject>

#include <deque>
#include <memory>
#include <mutex>
#include <utility>

namespace viscera::app {
namespace {

/// The functions pass through a mutex that the thread sanitiser sees, unlike those inside Qt; an event only
/// says that one has come.
class Mailbox final : public QObject {
public:
  void put(std::function<void()> work) {
    const std::lock_guard lock(mutex_);
    QCoreApplication::postEvent(this, new QEvent(QEvent::User));
    waiting_.push_back(std::move(work)); // Without memory for it, one event finds nothing.
  }

private:
  void customEvent(QEvent*) override {
    std::function<void()> work;
    {
      const std::lock_guard lock(mutex_);
      if (waiting_.empty())
        return;
      work = std::move(waiting_.front());
      waiting_.pop_front();
    }
    work();
  }

  std::mutex mutex_;
  std::deque<std::function<void()>> waiting_;
};

} // namespace

JobQueue::Post mailbox() {
  return [box = std::make_shared<Mailbox>()](std::function<void()> work) { box->put(std::move(work)); };
}

} // namespace viscera::app
