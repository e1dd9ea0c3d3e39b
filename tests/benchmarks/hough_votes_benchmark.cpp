// Votes per second of the Hough accumulation against a plain scalar loop and against the machine's
// memory-copy bandwidth, and incremental votes (a scan in, a scan out) against voting anew, in one run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/random.hpp"
#include "csht/csht_params.hpp"
#include "csht/hough_space.hpp"

namespace lookout::csht {
namespace {

constexpr int kWindowScans = 20;  // [Yan2018] section V

/// Uniform detections, as many a scan as literal clutter brings: 27 at P_F = .3, 63 at .7.
std::vector<LineSample> random_samples(int num_scans, int detections) {
  core::Random random(1);
  std::vector<LineSample> samples;
  for (int scan = 0; scan < num_scans; ++scan)
    for (int k = 0; k < detections; ++k)
      samples.push_back({scan, 0.5 * scan, random.uniform(0.0, 150.0), random.uniform(1.0, 3.0)});
  return samples;
}

core::SonarParams sonar() {
  core::SonarParams params;
  params.max_speed = 5.0;  // [Yan2018] Table 2
  return params;
}

HoughSpace make_space(const VoteParams& votes) {
  return {csht_grid(CshtParams::window(), sonar()), votes, sonar().range_sigma, sonar().range_sigma};
}

/// The plain loop over samples, rows and cells of [Yan2018] Eq. (15), (16) with the same Gaussian votes, as
/// one would write it first: no ring, no whole numbers, an exponential a vote.
class PlainVotes {
 public:
  explicit PlainVotes(const HoughSpace& space)
      : grid_(space.grid()),
        rows_(space.rows()),
        columns_(space.columns()),
        first_velocity_(space.velocity(0)),
        votes_(static_cast<std::size_t>(rows_ * columns_)),
        layer_(votes_.size()) {}

  void vote(std::span<const LineSample> samples) {
    std::fill(votes_.begin(), votes_.end(), 0.0F);
    for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end) {
      std::fill(layer_.begin(), layer_.end(), 0.0F);
      for (end = begin; end < samples.size() && samples[end].scan == samples[begin].scan; ++end)
        spread(samples[end]);
      for (std::size_t k = 0; k < votes_.size(); ++k) votes_[k] += layer_[k];
    }
  }
  float* data() { return votes_.data(); }

 private:
  void spread(const LineSample& sample) {
    for (int row = 0; row < rows_; ++row) {
      const double velocity = first_velocity_ + row * grid_.velocity_step;
      const double intercept =
          sample.position - velocity * sample.time + 0.5 * columns_ * grid_.intercept_step;
      const int first = static_cast<int>((intercept - 3.0 * sample.sigma) / grid_.intercept_step);
      const int last = static_cast<int>((intercept + 3.0 * sample.sigma) / grid_.intercept_step);
      for (int column = std::max(first, 0); column <= std::min(last, columns_ - 1); ++column) {
        const double off = ((column + 0.5) * grid_.intercept_step - intercept) / sample.sigma;
        float& cell = layer_[static_cast<std::size_t>(row * columns_ + column)];
        cell = std::max(cell, static_cast<float>(std::exp(-0.5 * off * off)));
      }
    }
  }

  HoughGrid grid_;
  int rows_, columns_;
  double first_velocity_;
  std::vector<float> votes_, layer_;
};

/// Votes are (sample, row) pairs: each spreads over a footprint of cells.
void count_votes(benchmark::State& state, std::size_t samples, int rows) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(samples) * rows);
}

void fuzzy_votes(benchmark::State& state) {
  HoughSpace space = make_space({});
  const auto samples = random_samples(kWindowScans, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    space.clear();
    space.add(samples);
    benchmark::DoNotOptimize(space);
  }
  count_votes(state, samples.size(), space.rows());
}
BENCHMARK(fuzzy_votes)->Arg(4)->Arg(27)->Arg(63);

void plain_votes(benchmark::State& state) {
  VoteParams votes;
  votes.fuzzy = false;
  votes.one_vote_a_scan = false;
  HoughSpace space = make_space(votes);
  const auto samples = random_samples(kWindowScans, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    space.clear();
    space.add(samples);
    benchmark::DoNotOptimize(space);
  }
  count_votes(state, samples.size(), space.rows());
}
BENCHMARK(plain_votes)->Arg(4)->Arg(27)->Arg(63);

void scalar_loop(benchmark::State& state) {
  const HoughSpace space = make_space({});
  PlainVotes plain(space);
  const auto samples = random_samples(kWindowScans, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    plain.vote(samples);
    benchmark::DoNotOptimize(plain.data());
  }
  count_votes(state, samples.size(), space.rows());
}
BENCHMARK(scalar_loop)->Arg(4)->Arg(27)->Arg(63);

/// The window slides by a scan: the newest in, the oldest out. Compare with fuzzy_votes, which votes anew.
void sliding_votes(benchmark::State& state) {
  HoughSpace space = make_space({});
  const auto detections = static_cast<std::size_t>(state.range(0));
  constexpr std::size_t kScans = 400;
  const auto samples = random_samples(static_cast<int>(kScans), static_cast<int>(detections));
  const std::span<const LineSample> all(samples);
  space.add(all.first(kWindowScans * detections));
  std::size_t scan = 0;
  for (auto _ : state) {
    space.remove(all.subspan(scan % kScans * detections, detections));
    space.add(all.subspan((scan + kWindowScans) % kScans * detections, detections));
    ++scan;
    benchmark::DoNotOptimize(space);
  }
  count_votes(state, 2 * detections, space.rows());
}
BENCHMARK(sliding_votes)->Arg(4)->Arg(27)->Arg(63);

/// The machine's yardstick: copying 64 MB, beyond every cache, and the accumulator's own size, within one.
void memory_copy(benchmark::State& state) {
  const auto bytes = static_cast<std::size_t>(state.range(0));
  std::vector<char> from(bytes, 1), to(bytes);
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), bytes);
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}
BENCHMARK(memory_copy)->Arg(24 << 10)->Arg(64 << 20);

}  // namespace
}  // namespace lookout::csht

BENCHMARK_MAIN();
