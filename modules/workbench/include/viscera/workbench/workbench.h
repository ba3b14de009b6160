#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/coordinates/registry.h"
#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/core/signal.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/document/measured_values.h"
#include "viscera/document/session_file.h"
#include "viscera/document/undo_stack.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/live_binding.h"
#include "viscera/live/live_stress.h"
#include "viscera/live/live_warp.h"
#include "viscera/live/motion_runner.h"
#include "viscera/live/session_motion.h"
#include "viscera/live/volume_keeper.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::workbench {

/// What a workbench works with.
struct Setup {
  coordinates::Registry systems = coordinates::builtInRegistry();
  sample_organs::SampleLibrary samples = sample_organs::standardLibrary();
  Threads threads = {};
};

/// What a user should know about files that were opened.
struct Opened {
  std::vector<Text> warnings;
  std::vector<Error> failures; ///< Of files that could not be read, while others were.
};

/// The volume of an organ at one instant of a motion.
struct PlayedVolumes {
  double seconds = 0;              ///< Since the beginning of the motion.
  std::vector<double> milliliters; ///< Of each organ of the document, in its order; 0 for an open surface.
  Text obstacle;                   ///< Why locked volumes could not be kept; else empty.
};

/// How many frames show so many cycles of a motion: one at least.
int frameCount(double ratePerMinute, double framesPerSecond, double cycles);

/// The open document at work: its undo steps, the bindings of its organs, locked volumes, stress, the warped
/// scan and the motion that it plays. It knows no window: every call returns when its work is done and all
/// parts agree. The same calls give the same bits, whatever the number of threads.
///
/// Organs and handles are named as a user names them; each function throws `UsageError`, which lists the
/// names, for one that does not exist. A function that throws leaves the document as it was. For one thread.
///
///     workbench::Workbench bench;
///     bench.restore("ball.viscera");
///     bench.lock("ball");
///     bench.drag("H-1", Vec3(5, 0, 0));
///     std::cout << bench.volume("ball").nowMl << " ml\n";
///     for (const workbench::PlayedVolumes& instant : bench.play(25))
///       std::cout << instant.seconds << ' ' << instant.milliliters.front() << '\n';
///     bench.undo();
///     bench.save("posed.viscera");
class Workbench {
public:
  Workbench();
  /// Long work is reported to `progress`, which may cancel it by `Cancelled`, and must live longer; null: it
  /// is not reported. Binding organs to other handles is not cancelled.
  explicit Workbench(Setup setup, Progress* progress = nullptr);
  ~Workbench();
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  /// Reports long work to another `progress` from now on, or to none.
  void tell(Progress* progress);

  /// Files.
  ///
  /// Opens surfaces, label maps, handle files and a scan as one undo step, as the window does with files that
  /// hold nothing odd; organs without handles get some. A session alone is restored. Throws as
  /// `document::openPatient` and `readSession`.
  Opened open(const std::vector<std::filesystem::path>& files);
  /// Opens a sample organ with its handles and its motion in place of everything. Throws as `loadSample`.
  void openSample(const std::string& name,
                  sample_organs::Resolution resolution = sample_organs::Resolution::medium);
  /// Restores a session in place of everything. Throws as `document::readSession`.
  Opened restore(const std::filesystem::path& session);
  /// The same for contents that are read already, or made by a caller.
  void restore(document::SessionContents contents);
  /// What `save` writes: the document as it is, with the view that the session had.
  document::SessionContents session() const;
  /// Writes a session; `embed` says whether the surfaces and the scan are inside, none: as in the session
  /// that was restored. Throws as `document::writeSession`.
  void save(const std::filesystem::path& session, std::optional<bool> embed = std::nullopt);

  /// The document.
  ///
  const document::DocumentState& state() const;
  /// Performs a command as one undo step. Throws as `UndoStack::perform`.
  void perform(const document::Command& command);
  /// One step back or forth; false when there is none.
  bool undo();
  bool redo();
  const document::UndoStack& steps() const;
  document::OrganId organ(const std::string& name) const;
  document::HandleId handle(const std::string& label) const;

  /// The pose.
  ///
  /// Locks an organ's volume, or unlocks it. Throws `DataError` for an open surface.
  void lock(const std::string& organ, bool locked = true);
  /// Moves a handle in the pose by a vector, mm, and returns how far it went: with `asMarked` as far as the
  /// locked volumes let it, with `compensate` all the way, while other handles make up for the volumes, and
  /// with `follow` all the way, while the free handles follow by the least elastic energy. Those two throw
  /// `DataError` where they cannot.
  Vec3 drag(const std::string& handle, const Vec3& by, live::Others others = live::Others::asMarked);
  /// Gives all handles their places, `n x 3` mm in the document's order; where volumes are locked, all free
  /// handles make up for them, and it throws `DataError` where they cannot. With `follow` only the handles
  /// that are sent elsewhere go to their places, and the free ones follow.
  void pose(const Points& places, live::Others others = live::Others::asMarked);
  /// All handles at rest.
  void rest();
  /// Shows a pose without changing the document, `n x 3` mm, the handles at rest, or the document's pose
  /// again. Throws `DataError` for a pose of another size.
  void showPose(const Points& places);
  void showRest();
  void showDocumentPose();
  /// The organs in the pose that is shown.
  live::LiveBinding& organs();
  const live::LiveBinding& organs() const;
  live::OrganVolume volume(const std::string& organ);

  /// The motion.
  ///
  /// The sequence that the session plays, or that belongs to the sample; made again (seconds) when it is
  /// first asked for. Null where there is none.
  const sequences::Sequence* sequence();
  std::shared_ptr<const sequences::Sequence> sharedSequence();
  /// Takes a sequence instead, or none; `rate` is in cycles a minute, 0: its standard rate. Throws
  /// `UsageError` for a rate that the sequence does not allow.
  void setSequence(std::shared_ptr<const sequences::Sequence> sequence, double rate = 0);
  /// Poses the organs at an instant of the motion, as playing does, without changing the document, and
  /// measures them. Throws `UsageError` where no sequence moves these handles.
  PlayedVolumes show(double seconds);
  /// Every instant of `cycles` cycles at so many frames a second. The last one stays shown.
  std::vector<PlayedVolumes> play(double framesPerSecond, double cycles = 1);
  /// The volumes over one cycle, with every extreme. Shows what was shown before.
  live::CycleCurves cycle();
  /// What poses the organs, for code that goes through a motion by itself.
  live::MotionRunner& motion();

  /// Measurements.
  ///
  /// Computes the rotational stress of an organ in the pose that is shown at about `witnesses` points in it.
  /// Throws `DataError` with the reason where there is none.
  const live::LiveStress& stress(const std::string& organ, int witnesses = 2000);
  /// The same for an organ of the document; returns why it is not possible, empty on success.
  Text tryStress(document::OrganId organ, int witnesses);
  /// Adds the stress over a cycle of the motion to that map, where the motion moves the handles.
  void findStressCycle(live::CycleParts parts);
  live::LiveStress& stressMap();
  /// The value of a measurement of the document by its name, at rest and in the pose that is shown.
  document::MeasuredValues measure(const std::string& measurement);
  document::MeasuredValues measure(const document::Measurement& measurement);
  /// The deformation of the scan by the pose that is shown; null at rest. Throws `DataError` where it cannot
  /// be bound.
  live::LiveWarp* warp();

  /// Calls `observer` once after every call that changed something, when all parts agree.
  [[nodiscard]] Subscription onHappened(std::function<void()> observer);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace viscera::workbench
