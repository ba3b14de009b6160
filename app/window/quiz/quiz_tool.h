#pragma once

#include <QObject>
#include <QStringList>

#include <optional>
#include <vector>

#include "viscera/presentation/part_names.h"
#include "window/modes/mode.h"

namespace viscera::app {

/// A quiz about the parts of the organs: labels are hidden, the user is asked to click on a part, and the
/// label of a part that was found stays. A heart with valves is then asked for the valve that is open in a
/// phase of its beat. Does not change the document; when the organs change, the quiz ends.
class QuizTool final : public QObject {
  Q_OBJECT

public:
  /// A phase of the beat, and which choice is right: the mitral valve is open, the aortic one, or none.
  struct AskedPhase {
    QString name;
    int open = 0;
  };

  /// All have to live longer.
  QuizTool(Workspace& workspace, Picture& picture, QObject* parent = nullptr);

  /// Whether the organs have parts to ask for.
  bool possible() const;
  bool active() const { return quiz_.has_value(); }
  void begin();
  void end();
  /// Handles a click on an organ; null: on no organ. False when no answer is awaited.
  bool click(const ClickedPlace* place);

  /// "Click: Left atrium"; empty while nothing is asked.
  const QString& question() const { return question_; }
  /// Whether the last answer was right, and the progress of the quiz.
  const QString& result() const { return result_; }
  /// "3 right, 1 wrong"; empty before the first answer.
  QString score() const;
  /// What can be answered to the present question; empty where a click on a part answers.
  QStringList choices() const;
  void choose(int choice);
  const presentation::PartQuiz* quiz() const { return quiz_ ? &*quiz_ : nullptr; }

Q_SIGNALS:
  void changed();

private:
  QString nameOf(const presentation::Part& part) const;
  void ask();

  Workspace& workspace_;
  Picture& picture_;
  std::optional<presentation::PartQuiz> quiz_;
  std::shared_ptr<const document::OrganList> organs_; ///< The organs that the quiz is about.
  std::vector<AskedPhase> phases_;                    ///< Still to be asked for, after the parts.
  int right_ = 0;
  int wrong_ = 0;
  QString question_;
  QString result_;
  Subscription documents_;
};

} // namespace viscera::app
