#pragma once

#include <string_view>

/// The words of a name that say something of an organ and name none themselves.
namespace viscera::anatomy {

enum class Meaning {
  unknown,
  noise, ///< Articles, endings of files, and what programs write: "the", "stl", "model".
  left,  ///< Of the patient, or of the heart.
  right,
  inside, ///< The cavity of a chamber: "cavity", "endocardial".
  wall,   ///< The wall of an organ; of a chamber, its muscle.
  piece,  ///< "lobe", "upper".
  lesion, ///< "tumour", "cyst".
  denial, ///< There is no organ, or a thing for one: "without", "background", "phantom".
};

/// What a word in small letters without accents means. O(length).
Meaning meaningOf(std::string_view word);

} // namespace viscera::anatomy
