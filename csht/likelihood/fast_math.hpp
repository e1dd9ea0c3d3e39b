#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

/// Elementary functions without branches or calls, so that loops over them vectorise. Single precision unless
/// they say otherwise.
namespace lookout::csht {

/// e^x for x in [-80, 80] (clamped beyond). Powers of two by exponent bits, the rest by Taylor to degree 6 on
/// [-ln 2 / 2, ln 2 / 2]: relative error below 3e-7.
inline float fast_exp(float x) {
  constexpr float kLimit = 80.0F;
  constexpr float kRounder =
      12582912.0F;  // 1.5 x 2^23: adding it leaves the nearest integer in the low bits.
  x = x < -kLimit ? -kLimit : x;
  x = x > kLimit ? kLimit : x;
  const float scaled = x * std::numbers::log2e_v<float>;
  const float shifted = scaled + kRounder;
  const std::int32_t power = std::bit_cast<std::int32_t>(shifted) - std::bit_cast<std::int32_t>(kRounder);
  const float rest = (scaled - (shifted - kRounder)) * std::numbers::ln2_v<float>;
  float series = rest * (1.0F / 720) + 1.0F / 120;
  series = series * rest + 1.0F / 24;
  series = series * rest + 1.0F / 6;
  series = series * rest + 1.0F / 2;
  series = series * rest + 1.0F;
  series = series * rest + 1.0F;
  return series * std::bit_cast<float>((power + 127) << 23);
}

/// ln x for normal x > 0: exponent bits, and the series of atanh on [sqrt(1/2), sqrt(2)): error below 3e-7 of
/// max(1, |ln x|).
inline float fast_log(float x) {
  constexpr std::int32_t kSqrtHalf = 0x3f3504f3;  // The bits of sqrt(1/2).
  const std::int32_t bits = std::bit_cast<std::int32_t>(x) - kSqrtHalf;
  const std::int32_t power = bits >> 23;
  const float mantissa = std::bit_cast<float>((bits & 0x007fffff) + kSqrtHalf);
  const float t = (mantissa - 1.0F) / (mantissa + 1.0F);
  const float square = t * t;
  const float series =
      2.0F * t *
      (1.0F + square * (1.0F / 3 + square * (1.0F / 5 + square * (1.0F / 7 + square * (1.0F / 9)))));
  return static_cast<float>(power) * std::numbers::ln2_v<float> + series;
}

/// Probability that a standard normal number exceeds x: [Abramowitz1964] 26.2.17, error below 1e-6 in single
/// precision.
inline float fast_normal_tail(float x) {
  constexpr float kDensity = 0.3989422804F;  // 1 / sqrt(2 pi).
  const float size = x < 0.0F ? -x : x;
  const float t = 1.0F / (1.0F + 0.2316419F * size);
  float series = 1.330274429F;
  series = series * t - 1.821255978F;
  series = series * t + 1.781477937F;
  series = series * t - 0.356563782F;
  series = (series * t + 0.319381530F) * t;
  const float tail = kDensity * fast_exp(-0.5F * size * size) * series;
  return x < 0.0F ? 1.0F - tail : tail;
}

/// The angle of (x, y) in (-pi, pi], 0 at the origin. [Abramowitz1964] 4.4.49 on [0, 1], error below 1e-6
/// rad.
inline float fast_atan2(float y, float x) {
  constexpr float kTiny = 1e-30F;
  const float ax = x < 0.0F ? -x : x;
  const float ay = y < 0.0F ? -y : y;
  const float low = ax < ay ? ax : ay;
  const float high = (ax < ay ? ay : ax) + kTiny;
  const float t = low / high;
  const float s = t * t;
  float angle = 0.0028662257F;
  angle = angle * s - 0.0161657367F;
  angle = angle * s + 0.0429096138F;
  angle = angle * s - 0.0752896400F;
  angle = angle * s + 0.1065626393F;
  angle = angle * s - 0.1420889944F;
  angle = angle * s + 0.1999355085F;
  angle = angle * s - 0.3333314528F;
  angle = (angle * s + 1.0F) * t;
  angle = ax < ay ? std::numbers::pi_v<float> / 2 - angle : angle;
  angle = x < 0.0F ? std::numbers::pi_v<float> - angle : angle;
  return y < 0.0F ? -angle : angle;
}

/// Sine and cosine of one angle.
struct SinCos {
  double sin, cos;  ///< Of one angle.
};

/// Sine and cosine for |x| < 1e6, double precision: whole half turns off, the rest by Taylor to degrees 15
/// and 16 on [-pi / 2, pi / 2]: error below 1e-9.
inline SinCos fast_sin_cos(double x) {
  constexpr double kRounder = 6755399441055744.0;  // 1.5 x 2^52, as kRounder of fast_exp.
  const double shifted = x * std::numbers::inv_pi + kRounder;
  const double half_turns = shifted - kRounder;
  const double rest = x - half_turns * std::numbers::pi;
  const double s = rest * rest;
  double sine = 1.0 - s * (1.0 / 210);
  sine = 1.0 - s * (1.0 / 156) * sine;
  sine = 1.0 - s * (1.0 / 110) * sine;
  sine = 1.0 - s * (1.0 / 72) * sine;
  sine = 1.0 - s * (1.0 / 42) * sine;
  sine = 1.0 - s * (1.0 / 20) * sine;
  sine = 1.0 - s * (1.0 / 6) * sine;
  double cosine = 1.0 - s * (1.0 / 240);
  cosine = 1.0 - s * (1.0 / 182) * cosine;
  cosine = 1.0 - s * (1.0 / 132) * cosine;
  cosine = 1.0 - s * (1.0 / 90) * cosine;
  cosine = 1.0 - s * (1.0 / 56) * cosine;
  cosine = 1.0 - s * (1.0 / 30) * cosine;
  cosine = 1.0 - s * (1.0 / 12) * cosine;
  cosine = 1.0 - s * (1.0 / 2) * cosine;
  const double odd = half_turns - 2.0 * ((0.5 * half_turns - 0.25 + kRounder) - kRounder);
  const double sign = 1.0 - 2.0 * odd;
  return {sign * rest * sine, sign * cosine};
}

}  // namespace lookout::csht
