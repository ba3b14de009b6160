#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/command.h"
#include "viscera/document/organ.h"
#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/sequences/sequence.h"

/// Fits the shipped sequences to a patient's heart, stomach or liver.
namespace viscera::live {

/// A landmark: a named place of an organ by which a sequence is fitted to it.
struct Landmark {
  std::string role;             ///< As in `landmarkRoles`: "apex".
  Vec3 position = Vec3::Zero(); ///< mm, LPS.
  bool computed = false;        ///< Found by the program, not given by a user.

  bool operator==(const Landmark&) const = default;
};

/// The landmarks of one organ. Those of one role that may come several times are in order.
struct Landmarks {
  std::vector<Landmark> points;

  /// The first of that role, or null.
  const Landmark* find(const std::string& role) const;
  /// All of that role, in order.
  std::vector<Vec3> all(const std::string& role) const;

  bool operator==(const Landmarks&) const = default;
};

/// A kind of landmark that a sequence can use, with its name and hint for the user.
struct LandmarkRole {
  std::string role; ///< "apex"; as labels in files, where numbers behind it do not count ("centreline-2").
  std::string name; ///< "Apex", for a button.
  std::string help; ///< "The tip of the heart", where to click.
  bool several = false; ///< A line of points, in order.
};

/// The landmarks that a sequence can use, in the order in which a user is asked for them. heartbeat: apex,
/// base, right. peristalsis: fundus, centreline (several), body, pylorus. breathing: none. Throws
/// `UsageError` for an unknown sequence.
const std::vector<LandmarkRole>& landmarkRoles(const std::string& sequence);

/// The landmarks in a handle file, by the labels of its points: case, a number behind the label ("Apex-1")
/// and the spelling "centerline" do not matter. Throws `DataError`, which lists the possible labels, for a
/// point with any other label and for one that comes twice but may not.
Landmarks landmarksFrom(const medical_io::HandleFile& file, const std::string& sequence,
                        const std::string& where);

/// The landmarks as a handle file, which `landmarksFrom` reads back.
medical_io::HandleFile landmarkFile(const Landmarks& landmarks, const std::string& name);

/// Checks the given landmarks and finds all others that the sequence needs by the shape of the organ.
/// heartbeat needs apex and base both or none, `right` may be given alone with them; peristalsis needs fundus
/// and pylorus both or none. Throws `DataError`, whose text names a remedy, for an organ that is open, inside
/// out, in pieces; for landmarks too few, far outside the organ, at one place or on one line. Some 100 ms at
/// 30,000 triangles.
Landmarks completeLandmarks(const std::string& sequence, const document::Organ& organ, const Landmarks& given,
                            Progress& progress);

/// A sequence that was fitted to an organ, with its handles and landmarks.
struct RetargetedSequence {
  std::shared_ptr<const sequences::Sequence> sequence; ///< Never null.
  document::Rig rig;             ///< Its rest handles, in its order, with labels and groups.
  document::SystemChoice system; ///< The coordinates for which it was made, softness in the organ's size.
  Landmarks landmarks;           ///< All landmarks that were used.
  double scale = 1;              ///< The organ's size as a multiple of the sample organ's.
  double restVolumeMl = 0;       ///< Of the organ.
  std::vector<Text> warnings;    ///< Warnings for the user: first that the organ is of another kind than the
                                 ///< sequence's, then others, such as an implausible size.
};

/// Makes the sequence `id` for `organ`: finds missing landmarks, places handles around this organ and applies
/// the same curves to them. heartbeat: the surface loses 8.2 % of its volume in systole; peristalsis: its
/// volume stays, to rounding, in every pose, and waves are made shallower where folds of the surface would
/// cross (with a warning); breathing: its volume stays. Every vertex lies inside the handles' hull. A second
/// or a few at 30,000 triangles. Throws what `completeLandmarks` throws, `DataError` if the shape of the
/// organ does not match the landmarks, `UsageError` for an unknown sequence, `Cancelled`. For any thread.
RetargetedSequence retargetSequence(const std::string& id, const document::Organ& organ,
                                    const Landmarks& given, Progress& progress, Threads threads = {});

/// The organs that a fitted sequence may not move, by the table of organs: in breathing the spine and the
/// pelvis, whatever handles lie around them. Those that stay in place already are not among them.
std::vector<document::OrganId> keptInPlace(const RetargetedSequence& retargeted,
                                           const document::OrganList& organs);

/// The command that puts the handles and coordinates of a fitted sequence into the document, and keeps those
/// of its `organs` in place that it may not move (`keptInPlace`): one undo step. The organ is in the document
/// already.
document::Command useRetargeted(const RetargetedSequence& retargeted, const document::OrganList& organs = {});

} // namespace viscera::live
