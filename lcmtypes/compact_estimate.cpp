#include "lcmtypes/compact_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::lcmtypes {
namespace {

constexpr int kByte = 8;
constexpr int kDataBytes = static_cast<int>(kCompactBytes) - 1;  // The last is the check.
constexpr int kTimeBits = 24, kNodeIdBits = 8, kTrackIdBits = 16, kNodeBits = 24, kPositionBits = 20;
constexpr int kVelocityBits = 14, kFlagBits = 1, kSigmaBits = 8, kCorrelationBits = 8;
constexpr std::int64_t kMillisecond = 1000;  // [us]
constexpr double kNodeStep = 2.0 * CompactLimits::kNodeError;
constexpr double kPositionStep = 0.05;   // [m]
constexpr double kVelocityStep = 0.005;  // [m/s]
constexpr double kCorrelationStep = 1.0 / 127.0;
constexpr double kShrink = 0.012;  // Three half steps of a correlation: what is sent stays positive definite.

/// Writes and reads unsigned numbers of some bits one after another.
class BitStream {
 public:
  explicit BitStream(CompactEstimate& bytes) : bytes_(bytes) {}

  void put(std::uint64_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit, ++at_) {
      if ((value >> bit) & 1U)
        bytes_[static_cast<std::size_t>(at_ / kByte)] |= static_cast<std::uint8_t>(0x80U >> (at_ % kByte));
    }
  }
  std::uint64_t get(int bits) {
    std::uint64_t value = 0;
    for (int bit = 0; bit < bits; ++bit, ++at_) {
      const unsigned byte = bytes_[static_cast<std::size_t>(at_ / kByte)];
      value = (value << 1U) | ((byte >> (kByte - 1 - at_ % kByte)) & 1U);
    }
    return value;
  }
  /// A signed number in steps, offset binary. @return whether it fits.
  bool put_steps(double value, double step, int bits) {
    const double steps = std::round(value / step);
    const double half = std::ldexp(1.0, bits - 1);
    if (!(steps >= -half && steps < half)) return false;
    put(static_cast<std::uint64_t>(static_cast<std::int64_t>(steps + half)), bits);
    return true;
  }
  double get_steps(double step, int bits) {
    return step * (static_cast<double>(get(bits)) - std::ldexp(1.0, bits - 1));
  }

 private:
  CompactEstimate& bytes_;
  int at_ = 0;
};

/// CRC-8 of all bytes but the last, polynomial x^8 + x^2 + x + 1.
std::uint8_t check_of(const CompactEstimate& packet) {
  constexpr unsigned kPolynomial = 0x07U, kTop = 0x80U, kFull = 0xFFU;
  unsigned check = kFull;  // Not 0, so that a packet of zeros is refused.
  for (int i = 0; i < kDataBytes; ++i) {
    check ^= packet[static_cast<std::size_t>(i)];
    for (int bit = 0; bit < kByte; ++bit)
      check = ((check & kTop) != 0U ? (check << 1U) ^ kPolynomial : check << 1U) & kFull;
  }
  return static_cast<std::uint8_t>(check);
}

/// Standard deviations go by their logarithm: 255 even steps from the least to the largest.
double sigma_step() {
  return std::log(CompactLimits::kLargestSigma / CompactLimits::kLeastSigma) / 255.0;
}

void put_sigma(double sigma, BitStream& stream) {
  const double bounded = std::clamp(sigma, CompactLimits::kLeastSigma, CompactLimits::kLargestSigma);
  const double steps = std::log(bounded / CompactLimits::kLeastSigma) / sigma_step();
  stream.put(static_cast<std::uint64_t>(std::lround(steps)), kSigmaBits);
}

void put_covariance(const Eigen::Matrix4d& covariance, BitStream& stream) {
  const Eigen::Vector4d sigma = covariance.diagonal().cwiseSqrt();
  for (const double own : sigma) put_sigma(own, stream);
  for (Eigen::Index i = 0; i < sigma.size(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j)
      stream.put_steps(covariance(i, j) / (sigma(i) * sigma(j)), kCorrelationStep, kCorrelationBits);
  }
}

Eigen::Matrix4d get_covariance(BitStream& stream) {
  Eigen::Vector4d sigma;
  for (double& own : sigma)
    own = CompactLimits::kLeastSigma * std::exp(sigma_step() * static_cast<double>(stream.get(kSigmaBits)));
  Eigen::Matrix4d correlation = Eigen::Matrix4d::Identity();
  for (Eigen::Index i = 0; i < sigma.size(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j)
      correlation(i, j) = correlation(j, i) =
          stream.get_steps(kCorrelationStep, kCorrelationBits) / (1.0 + kShrink);
  }
  return sigma.asDiagonal() * correlation * sigma.asDiagonal();
}

/// Whether it has standard deviations and correlations that can be sent.
bool is_covariance(const Eigen::Matrix4d& covariance) {
  return covariance.allFinite() && covariance.diagonal().minCoeff() > 0.0;
}

/// The time nearest to `now` whose milliseconds end in these 24 bits [us].
std::int64_t unwrapped(std::int64_t bits, std::int64_t now) {
  constexpr std::int64_t kTurn = std::int64_t{1} << kTimeBits;
  const std::int64_t here = now / kMillisecond;
  std::int64_t apart = (bits - here) % kTurn;
  if (apart >= kTurn / 2) apart -= kTurn;
  if (apart < -kTurn / 2) apart += kTurn;
  return (here + apart) * kMillisecond;
}

bool put_motion(const core::LocalEstimate& estimate, BitStream& stream) {
  bool fits = true;
  for (const double own : estimate.p_earth_node) fits = fits && stream.put_steps(own, kNodeStep, kNodeBits);
  // Seen from where the receiver will take the node to be.
  const Eigen::Vector2d node = kNodeStep * (estimate.p_earth_node / kNodeStep).array().round().matrix();
  const Eigen::Vector2d offset = estimate.state.head<2>() - node;
  for (const double own : offset) fits = fits && stream.put_steps(own, kPositionStep, kPositionBits);
  const Eigen::Vector2d velocity = estimate.state.tail<2>();
  for (const double own : velocity) fits = fits && stream.put_steps(own, kVelocityStep, kVelocityBits);
  return fits;
}

void get_motion(BitStream& stream, core::LocalEstimate& estimate) {
  for (double& own : estimate.p_earth_node) own = stream.get_steps(kNodeStep, kNodeBits);
  for (int i = 0; i < 2; ++i)
    estimate.state(i) = estimate.p_earth_node(i) + stream.get_steps(kPositionStep, kPositionBits);
  for (int i = 2; i < 4; ++i) estimate.state(i) = stream.get_steps(kVelocityStep, kVelocityBits);
}

}  // namespace

std::optional<CompactEstimate> pack(const core::LocalEstimate& estimate) {
  if (estimate.node_id < 0 || estimate.node_id >= CompactLimits::kMostNodes || estimate.track_id < 0)
    return {};
  if (estimate.covariance && !is_covariance(*estimate.covariance)) return {};
  CompactEstimate packet{};
  BitStream stream(packet);
  constexpr std::uint64_t kTimeMask = (std::uint64_t{1} << kTimeBits) - 1;
  const std::int64_t time = std::llround(static_cast<double>(estimate.utime) / kMillisecond);
  stream.put(static_cast<std::uint64_t>(time) & kTimeMask, kTimeBits);
  stream.put(static_cast<std::uint64_t>(estimate.node_id), kNodeIdBits);
  stream.put(static_cast<std::uint64_t>(estimate.track_id % CompactLimits::kTrackIds), kTrackIdBits);
  if (!put_motion(estimate, stream)) return {};
  stream.put(estimate.covariance ? 1 : 0, kFlagBits);
  if (estimate.covariance) put_covariance(*estimate.covariance, stream);
  packet.back() = check_of(packet);
  return packet;
}

std::optional<core::LocalEstimate> unpack(const CompactEstimate& packet, std::int64_t now) {
  if (check_of(packet) != packet.back()) return {};
  CompactEstimate bytes = packet;
  BitStream stream(bytes);
  core::LocalEstimate estimate;
  estimate.utime = unwrapped(static_cast<std::int64_t>(stream.get(kTimeBits)), now);
  estimate.node_id = static_cast<std::int32_t>(stream.get(kNodeIdBits));
  estimate.track_id = static_cast<std::int64_t>(stream.get(kTrackIdBits));
  get_motion(stream, estimate);
  if (stream.get(kFlagBits) != 0) estimate.covariance = get_covariance(stream);
  return estimate;
}

}  // namespace lookout::lcmtypes
