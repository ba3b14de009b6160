#include "sparse_system.h"

#include <algorithm>
#include <array>

namespace viscera::elasticity {
namespace {

constexpr int kUnknowns = ElementShare::kUnknowns;
constexpr Eigen::Index kPairs = kUnknowns * (kUnknowns + 1) / 2;
constexpr Eigen::Index kBatch = 512; ///< Tetrahedra whose shares are kept at a time.

} // namespace

SparseSystem::SparseSystem(const ElasticBody& body, const std::vector<bool>& isFree, const Loads& loads)
    : body_(body), loads_(loads), names_(isFree.size(), -1),
      pressed_(static_cast<std::size_t>(body.mesh().tetrahedra.rows())) {
  for (std::size_t i = 0; i < isFree.size(); ++i)
    if (isFree[i])
      names_[i] = size_++;
  for (std::size_t p = 0; p < loads.pressures.size(); ++p)
    for (std::size_t f = 0; f < loads.pressures[p].faces.size(); ++f) {
      auto& list = pressed_[static_cast<std::size_t>(loads.pressures[p].faces[f].tetrahedron)];
      list.push_back(static_cast<std::int32_t>(p));
      list.push_back(static_cast<std::int32_t>(f));
    }
  makePattern();
}

void SparseSystem::makePattern() {
  const Eigen::Index tetrahedra = body_.mesh().tetrahedra.rows();
  std::vector<Eigen::Triplet<double, std::int32_t>> entries;
  entries.reserve(static_cast<std::size_t>(tetrahedra * kPairs));
  const auto visit = [&](Eigen::Index t, const auto& take) {
    std::array<Eigen::Index, kUnknowns> rows;
    for (int i = 0; i < kUnknowns; ++i)
      rows[std::size_t(i)] = names_[std::size_t(body_.unknown(t, i))];
    for (int i = 0; i < kUnknowns; ++i)
      for (int k = 0; k <= i; ++k)
        take(std::max(rows[std::size_t(i)], rows[std::size_t(k)]),
             std::min(rows[std::size_t(i)], rows[std::size_t(k)]));
  };
  for (Eigen::Index t = 0; t < tetrahedra; ++t)
    visit(t, [&](Eigen::Index row, Eigen::Index column) {
      if (column >= 0)
        entries.emplace_back(static_cast<std::int32_t>(row), static_cast<std::int32_t>(column), 0.0);
    });
  matrix_.resize(size_, size_);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  matrix_.makeCompressed();
  slots_.reserve(static_cast<std::size_t>(tetrahedra * kPairs));
  for (Eigen::Index t = 0; t < tetrahedra; ++t)
    visit(t, [&](Eigen::Index row, Eigen::Index column) {
      if (column < 0) {
        slots_.push_back(-1);
        return;
      }
      const auto* rows = matrix_.innerIndexPtr();
      const auto* begin = rows + matrix_.outerIndexPtr()[column];
      const auto* end = rows + matrix_.outerIndexPtr()[column + 1];
      slots_.push_back(static_cast<std::int32_t>(std::lower_bound(begin, end, row) - rows));
    });
}

void SparseSystem::scatter(Eigen::Index tetrahedron, const ElementShare& share) {
  double* values = matrix_.valuePtr();
  const std::int32_t* slot = slots_.data() + tetrahedron * kPairs;
  for (int i = 0; i < kUnknowns; ++i)
    for (int k = 0; k <= i; ++k, ++slot)
      if (*slot >= 0)
        values[*slot] += share.stiffness(i, k);
}

SparseSystem::Sums SparseSystem::assemble(const Values& state, double part, const Values& ahead,
                                          Threads threads, Progress& progress) {
  Sums sums;
  sums.force = Values::Zero(body_.unknowns());
  sums.inner = Values::Zero(body_.unknowns());
  sums.smallestJacobian = 1e300;
  Values right = Values::Zero(body_.unknowns());
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  const Eigen::Index tetrahedra = body_.mesh().tetrahedra.rows();
  std::vector<ElementShare> shares(static_cast<std::size_t>(std::min(kBatch, tetrahedra)));
  for (Eigen::Index from = 0; from < tetrahedra; from += kBatch) {
    progress.throwIfCancelled();
    const Eigen::Index count = std::min(kBatch, tetrahedra - from);
    std::vector<ElementShare::Vector> inner(static_cast<std::size_t>(count));
    parallelRanges(count, 16, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index i = begin; i < end; ++i) {
        ElementShare& share = shares[std::size_t(i)];
        body_.shareOf(from + i, state, share);
        inner[std::size_t(i)] = share.force;
        const auto& pressed = pressed_[std::size_t(from + i)];
        for (std::size_t k = 0; k < pressed.size(); k += 2) {
          const Pressure& pressure = loads_.pressures[std::size_t(pressed[k])];
          addPressure(body_, pressure.faces[std::size_t(pressed[k + 1])], part * pressure.kpa, state, share);
        }
      }
    });
    for (Eigen::Index i = 0; i < count; ++i) { // In one order, whatever the number of threads.
      const ElementShare& share = shares[std::size_t(i)];
      ElementShare::Vector moves;
      for (int k = 0; k < kUnknowns; ++k)
        moves[k] = ahead[body_.unknown(from + i, k)];
      const ElementShare::Vector anticipated = share.force + share.stiffness * moves;
      for (int k = 0; k < kUnknowns; ++k) {
        const Eigen::Index unknown = body_.unknown(from + i, k);
        sums.force[unknown] += share.force[k];
        sums.inner[unknown] += inner[std::size_t(i)][k];
        right[unknown] -= anticipated[k];
      }
      scatter(from + i, share);
      sums.energy += share.energy;
      sums.smallestJacobian = std::min(sums.smallestJacobian, share.smallestJacobian);
    }
  }
  right_.resize(size_);
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (names_[i] >= 0)
      right_[names_[i]] = right[static_cast<Eigen::Index>(i)];
  return sums;
}

Values SparseSystem::step(const Values& ahead) {
  if (!analysed_)
    factors_.analyzePattern(matrix_);
  analysed_ = true;
  factors_.factorize(matrix_);
  if (factors_.info() != Eigen::Success)
    return {};
  const Values solved = factors_.solve(right_);
  if (!solved.allFinite())
    return {};
  Values step = ahead;
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (names_[i] >= 0)
      step[static_cast<Eigen::Index>(i)] = solved[names_[i]];
  return step;
}

} // namespace viscera::elasticity
