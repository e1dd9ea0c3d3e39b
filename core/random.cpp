#include "core/random.hpp"

#include <mrpt/random/RandomGenerators.h>

#include <random>

namespace lookout::core {
namespace {

/// One step of SplitMix64 (Steele, Lea, Flood 2014): spreads neighbouring seeds over the whole word.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint32_t derive(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return static_cast<std::uint32_t>(mix(mix(mix(seed) ^ stream) ^ index) >> 32);
}

}  // namespace

struct Random::Impl {
  mrpt::random::CRandomGenerator generator;
};

Random::Random(std::uint64_t seed) : impl_(std::make_unique<Impl>()) {
  impl_->generator.randomize(derive(seed, 0, 0));
}

Random::Random(std::uint64_t seed, RandomStream stream, std::uint64_t index)
    : impl_(std::make_unique<Impl>()) {
  reseed(seed, stream, index);
}

Random::~Random() = default;
Random::Random(Random&&) noexcept = default;
Random& Random::operator=(Random&&) noexcept = default;

void Random::reseed(std::uint64_t seed, RandomStream stream, std::uint64_t index) {
  // A new object, for randomize() keeps the second half of a pair of Gaussian draws.
  impl_->generator = mrpt::random::CRandomGenerator(derive(seed, static_cast<std::uint64_t>(stream), index));
}

double Random::uniform(double low, double high) {
  // 53 bits, half open: MRPT's own drawUniform has 32 bits and reaches `high`.
  const std::uint64_t bits = impl_->generator.drawUniform64bit() >> 11;
  return low + (high - low) * static_cast<double>(bits) * 0x1p-53;
}

double Random::gaussian(double sigma) {
  return sigma * impl_->generator.drawGaussian1D_normalized();
}

bool Random::bernoulli(double probability) {
  return uniform(0.0, 1.0) < probability;
}

int Random::poisson(double mean) {
  return mean > 0.0 ? std::poisson_distribution<int>(mean)(*this) : 0;
}

int Random::index(int size) {
  return static_cast<int>(uniform(0.0, static_cast<double>(size)));
}

Random::result_type Random::operator()() {
  return impl_->generator.drawUniform32bit();
}

}  // namespace lookout::core
