#pragma once

namespace CLI {
class Validator;
}

/// What numbers options take. Another number, and what is none, is refused in one short sentence: "75bpm is
/// no number; it has to be above 0".
namespace viscera::app::cli {

/// Any number above `bound`.
CLI::Validator above(double bound);
/// Any number from `bound` on.
CLI::Validator atLeast(double bound);
/// Any number from `low` to `high`.
CLI::Validator between(double low, double high);
/// Any whole number from `low` to `high`.
CLI::Validator wholeBetween(int low, int high);

} // namespace viscera::app::cli
