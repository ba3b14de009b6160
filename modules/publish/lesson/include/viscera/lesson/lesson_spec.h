#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::lesson {

/// The camera of a lesson's view, upright and directed at `focus`.
struct Eye {
  Vec3 position = Vec3::Zero(); ///< mm, LPS; what is seen is as in a picture of 30 degrees from there.
  Vec3 focus = Vec3::Zero();
};

/// The plane at which a lesson's heart is cut open; it stands still while the heart moves.
struct PlannedCut {
  Vec3 origin = Vec3::Zero();  ///< mm, LPS.
  Vec3 normal = Vec3::UnitY(); ///< Unit, towards the part that stays.
  bool on = false;
  bool blood = false; ///< The chambers are full of blood, else empty.
};

/// A slide of a lesson: a view with its caption.
struct PlannedSlide {
  std::string title = {};
  std::string text = {}; ///< Describes the view; may be empty.
  std::optional<Eye> eye = {};
  std::string side = {}; ///< "anterior", "posterior", "left", "right", "superior", "inferior"; or empty.
  std::optional<double> fraction = {};  ///< Of the cycle, [0, 1]: the slide stands still there.
  std::string phase = {};               ///< Or in the middle of this phase, by its name in the sequence.
  std::optional<double> rate = {};      ///< Cycles a minute; the nearest that is offered.
  std::vector<std::string> hidden = {}; ///< Names of organs that are switched off.
  std::vector<std::size_t> hiddenSurfaces = {}; ///< The same by their places among the plan's surfaces.
  std::optional<double> seeThrough = {};        ///< Opacity of the walls, [0, 1].
  std::optional<bool> names = {};               ///< Whether names are shown; empty: the reader's choice.
  bool handles = false;
  std::optional<PlannedCut> cut = {}; ///< Of a session's slide; empty: as the reader has it.
};

/// A label of a lesson specification: a name and where it belongs.
struct SpecLabel {
  std::string surface; ///< The organ's name, or of a sample organ its surface's: "outer".
  std::string text;
  Vec3 at = Vec3::Zero(); ///< mm, LPS.
};

/// The lesson specification: title, texts, labels and slides that an author gives beyond the document
/// (docs/lessons.md, "A lesson's own file").
struct LessonSpec {
  std::string language; ///< Of the page's own texts, a code of `pageLanguages`; empty: the program's.
  std::string title;    ///< Empty: the document's.
  std::string notes;
  std::map<std::string, std::string> names; ///< Of an organ, label or phase: what it is called instead.
  std::vector<double> rates;                ///< Empty: chosen.
  std::vector<SpecLabel> labels;
  std::vector<PlannedSlide> slides;
  bool strain = false;        ///< Whether a bull's eye of the left ventricle's strain follows the beat.
  std::optional<int> handles; ///< How many are placed; 0: none. Nothing: the rig's own where they are few.
};

/// A language of the texts that every lesson page has, such as buttons.
struct PageLanguage {
  std::string code; ///< BCP 47: "de".
  std::string name; ///< In that language: "Deutsch".
};

/// The languages that come with the program, English first.
std::vector<PageLanguage> pageLanguages();

/// Reads a lesson specification from JSON. Throws `DataError` that names `where` and the key for invalid
/// text.
LessonSpec readSpec(const std::string& json, const std::string& where);

/// The lesson specification that the program has for a sequence on its sample organ: title, names of parts,
/// slides, sources. Empty for others.
LessonSpec readySpec(const std::string& sequence);

} // namespace viscera::lesson
