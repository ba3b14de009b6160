#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "viscera/document/document.h"
#include "viscera/document/organ.h"

/// Parts of organs that have a name in anatomy (`document::Organ::places`), for labels and for a quiz.
namespace viscera::presentation {

/// A part of an organ, by the organ's id and the number of the part.
struct Part {
  document::OrganId organ;
  std::size_t place = 0;    ///< In `Organ::places`.
  Eigen::Index vertex = -1; ///< The vertex of the organ's surface nearest to the place.

  friend bool operator==(const Part&, const Part&) = default;
};

/// All parts of visible organs, in the order of the document. O(places x vertices).
std::vector<Part> partsOf(const document::OrganList& organs);

/// The parts that a click can reach: of visible organs that are not in another visible one.
std::vector<Part> clickableParts(const document::OrganList& organs);

/// The part's name, in English.
const std::string& nameOf(const Part& part, const document::OrganList& organs);

/// The part of the organ whose vertex is nearest to a place on it in its present pose; none for an organ
/// without parts. `points` are the organ's, `n x 3` mm.
std::optional<Part> nearestPart(const std::vector<Part>& parts, document::OrganId organ, const Points& points,
                                const Vec3& place);

/// The quiz: asks for all parts, one after the other, in an order that the seed chooses; one that was not
/// found is asked again at the end.
///
///     PartQuiz quiz(partsOf(organs), seed);
///     while (quiz.asked())
///       say(quiz.answer(clicked) ? "Right" : "No");
class PartQuiz {
public:
  PartQuiz() = default;
  PartQuiz(std::vector<Part> parts, unsigned seed);

  /// The part to find next; null when all were found.
  const Part* asked() const { return open_.empty() ? nullptr : &open_.front(); }
  /// Returns whether the answer is right. After a right or two wrong answers, asks for the next part.
  bool answer(const Part& chosen);

  const std::vector<Part>& all() const { return all_; }
  /// The parts found so far, in order.
  const std::vector<Part>& found() const { return found_; }
  int mistakes() const { return mistakes_; }

private:
  std::vector<Part> all_;
  std::vector<Part> open_; ///< Remaining parts; the first one is asked for.
  std::vector<Part> found_;
  int mistakes_ = 0;
  int tries_ = 0; ///< Number of answers to the present question.
};

} // namespace viscera::presentation
