#include "viscera/core/exact_sum.h"

#include <bit>
#include <cmath>
#include <limits>

namespace viscera {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr int kDigits = ExactSum::kLimbs - 1; // without the count of what is not finite
constexpr std::uint64_t kLow = 0xffffffff;
constexpr int kMostPending = 1 << 29; // additions of less than 2^33 each stay within 63 bits

} // namespace

void ExactSum::add(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
  if (exponent == 0x7ff) {
    limbs_[kDigits] += 1;
    return;
  }
  // A double is mantissa 2^(exponent - 1) times 2^-1074, with the leading 1 but where the exponent is 0; limb
  // i counts 2^(32 i) times that.
  if (exponent > 0)
    mantissa |= std::uint64_t{1} << 52;
  else
    exponent = 1;
  const auto limb = static_cast<std::size_t>((exponent - 1) >> 5);
  const int shift = (exponent - 1) & 31;
  const std::uint64_t low = (mantissa & kLow) << shift, high = (mantissa >> 32) << shift;
  const std::int64_t sign = bits >> 63 ? -1 : 1;
  limbs_[limb] += sign * static_cast<std::int64_t>(low & kLow);
  limbs_[limb + 1] += sign * static_cast<std::int64_t>((low >> 32) + (high & kLow));
  limbs_[limb + 2] += sign * static_cast<std::int64_t>(high >> 32);
  if (++pending_ == kMostPending)
    carry();
}

void ExactSum::add(const ExactSum& other) {
  ExactSum carried = other;
  const Limbs& more = carried.limbs();
  carry();
  for (std::size_t i = 0; i < more.size(); ++i)
    limbs_[i] += more[i];
  carry();
}

void ExactSum::carry() {
  for (std::size_t i = 0; i + 1 < kDigits; ++i) {
    const std::int64_t over = limbs_[i] >> 32; // rounds down: the limb becomes 0 to 2^32 - 1
    limbs_[i] -= over * (std::int64_t{1} << 32);
    limbs_[i + 1] += over;
  }
  pending_ = 0;
}

const ExactSum::Limbs& ExactSum::limbs() {
  carry();
  return limbs_;
}

ExactSum ExactSum::fromLimbs(const Limbs& limbs) {
  ExactSum sum;
  sum.limbs_ = limbs;
  sum.carry();
  return sum;
}

double ExactSum::value() const {
  if (limbs_[kDigits] != 0)
    return std::numeric_limits<double>::quiet_NaN();
  ExactSum sum = *this;
  sum.carry();
  const bool negative = sum.limbs_[kDigits - 1] < 0;
  if (negative) {
    for (std::int64_t& limb : sum.limbs_)
      limb = -limb;
    sum.carry();
  }
  int top = kDigits - 1;
  while (top > 3 && sum.limbs_[static_cast<std::size_t>(top)] == 0)
    --top;
  // Four limbs hold at least 97 bits of the sum and one more says whether there is anything below, so that
  // converting rounds as the whole would.
  Wide head = 0;
  for (int i = 0; i < 4; ++i)
    head = head << 32 | static_cast<std::uint64_t>(sum.limbs_[static_cast<std::size_t>(top - i)]);
  for (int i = top - 4; i >= 0; --i)
    head |= sum.limbs_[static_cast<std::size_t>(i)] != 0 ? 1 : 0;
  const double magnitude = std::ldexp(static_cast<double>(head), 32 * (top - 3) - 1074);
  return negative ? -magnitude : magnitude;
}

} // namespace viscera
