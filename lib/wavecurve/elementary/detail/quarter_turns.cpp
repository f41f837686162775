#include "wavecurve/elementary/detail/quarter_turns.hpp"

#include <array>
#include <bit>
#include <cmath>

#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/exact_product.hpp"
#include "wavecurve/elementary/detail/round_to_integer.hpp"

namespace wavecurve::elementary {

namespace {

/// s = a - b, with its error added to the rest (Knuth, 1969).
double difference(double a, double b, double& rest) {
  const double s = a - b, part = s - a;
  rest += (a - (s - part)) - (b + part);
  return s;
}

QuarterTurns direct_quarter_turns(double x) {
  const double shifted = x * two_over_pi + integer_shift, k = shifted - integer_shift;
  if (k == 0) return {0, x, 0};
  // The first three parts of pi/2 have 32 bits, so that their products with k < 2^20 are exact.
  // The first difference is too: it is below 1, and a multiple of 2^-53, as x and the product are.
  double low = 0;
  double angle = difference(x - k * half_pi[0], k * half_pi[1], low);
  angle = difference(angle, k * half_pi[2], low);
  low -= k * half_pi[3];
  const double sum = angle + low;
  return {std::bit_cast<std::uint64_t>(shifted), sum, (angle - sum) + low};
}

using Words = std::array<std::uint64_t, 3>;  // from the highest to the lowest

/// 192 bits of 2/pi, the last of which has the weight 2^-last; last >= 158.
Words bits_of_two_over_pi(int last) {
  // The table begins with 64 zeros, for the bits in front of the point.
  const int first = last - 192 + 64;
  const std::size_t word = static_cast<std::size_t>(first / 64);
  const int shift = first % 64;
  Words bits;
  for (std::size_t i = 0; i < 3; ++i) {
    bits[i] = two_over_pi_bits[word + i] << shift;
    if (shift > 0) bits[i] |= two_over_pi_bits[word + i + 1] >> (64 - shift);
  }
  return bits;
}

/// The product modulo 2^192.
Words product(const Words& a, std::uint64_t b) {
  constexpr std::uint64_t mask = 0xffffffff;
  const std::uint64_t b_low = b & mask, b_high = b >> 32;
  Words result;
  std::uint64_t carry = 0;
  for (std::size_t i = 3; i-- > 0;) {
    const std::uint64_t low = (a[i] & mask) * b_low, high = (a[i] >> 32) * b_high;
    const std::uint64_t left = (a[i] >> 32) * b_low, right = (a[i] & mask) * b_high;
    const std::uint64_t middle = (low >> 32) + (left & mask) + (right & mask);
    result[i] = a[i] * b + carry;
    carry = high + (left >> 32) + (right >> 32) + (middle >> 32) + (result[i] < carry ? 1 : 0);
  }
  return result;
}

Words shifted_left(const Words& a, int bits) {
  if (bits == 0) return a;
  return {a[0] << bits | a[1] >> (64 - bits), a[1] << bits | a[2] >> (64 - bits), a[2] << bits};
}

/// The fraction bits / 2^192 as two doubles of 53 bits each; bits > 0.
void to_doubles(Words bits, double& head, double& tail) {
  int scale = -64;
  for (; bits[0] == 0; scale -= 64) bits = {bits[1], bits[2], 0};
  const int zeros = std::countl_zero(bits[0]);
  bits = shifted_left(bits, zeros);
  const std::uint64_t next = bits[0] << 53 | bits[1] >> 11;
  head = std::ldexp(static_cast<double>(bits[0] >> 11), scale - zeros + 11);
  tail = std::ldexp(static_cast<double>(next >> 11), scale - zeros + 11 - 53);
}

}  // namespace

QuarterTurns quarter_turns_in_whole_numbers(double x) {
  // |x| = m 2^e with m < 2^53 whole. What bits of 2/pi of a weight of 4 / 2^e and more add is whole
  // turns, what those below 2^-(e + 190) add is below 2^-137.
  int exponent;
  const double fraction = std::frexp(std::abs(x), &exponent);
  const auto m = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const Words quarters_in_bits = product(bits_of_two_over_pi(exponent - 53 + 190), m);
  std::uint64_t quarters = quarters_in_bits[0] >> 62;
  Words rest = shifted_left(quarters_in_bits, 2);
  const bool is_upper = rest[0] >> 63 != 0;
  if (is_upper) {  // the next multiple is nearer: 1 - rest, but for a unit of 2^-190
    ++quarters;
    for (std::uint64_t& word : rest) word = ~word;
  }
  double head, tail;
  to_doubles(rest, head, tail);
  const double angle = head * half_pi_head;
  double low = product_error(head, half_pi_head, angle);
  low += head * half_pi_tail + tail * half_pi_head;
  const double sum = angle + low;
  low = (angle - sum) + low;
  const bool is_negative = (x < 0) != is_upper;
  return {x < 0 ? 0 - quarters : quarters, is_negative ? -sum : sum, is_negative ? -low : low};
}

QuarterTurns quarter_turns(double x) {
  return std::abs(x) <= largest_direct_angle ? direct_quarter_turns(x)
                                             : quarter_turns_in_whole_numbers(x);
}

}  // namespace wavecurve::elementary
