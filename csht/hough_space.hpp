#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csht/line_sample.hpp"
#include "csht/vote_kernel.hpp"

namespace lookout::csht {

/// The grid of a Hough space. [Yan2018] Eq. (8), (9).
struct HoughGrid {
  double velocity_step = 0.44;  ///< h_v [m/s], > 0.
  double intercept_step = 1.5;  ///< h_n0 [m], > 0.
  double max_speed = 5.0;       ///< Rows reach from -max_speed to max_speed [m/s], > 0.
  double extent = 400.0;        ///< Intercepts that must be told apart span at most this [m], > 0.
};

/// How a line sample votes.
struct VoteParams {
  bool fuzzy = true;            ///< A Gaussian as wide as the line sample's error; else one whole cell.
  double width = 1.0;           ///< Of the Gaussian, in the line sample's own sigma, > 0.
  double min_width = 0.35;      ///< Narrowest Gaussian, in the range sigma, > 0.
  bool one_vote_a_scan = true;  ///< The line samples of a scan give a cell their maximum, not their sum.
};

/// A cell with its votes.
struct VoteCell {
  double velocity = 0.0;   ///< [m/s].
  double intercept = 0.0;  ///< At the reference time asked for [m].
  double votes = 0.0;      ///< Sum of the votes; a line sample gives at most 1.
};

/// What the vote matrix holds as a whole.
struct VoteStatistics {
  double peak = 0.0;  ///< Most votes in a cell.
  double mean = 0.0;  ///< Of the cells that have votes.
  int filled = 0;     ///< How many have.
};

/// The vote matrix over (velocity, intercept) of the lines position = intercept + velocity * time.
/// [Yan2018] Eq. (7)-(16).
///
/// The intercept axis is a ring: cell j and cell j + columns share their memory, so the matrix stays as small
/// as the sonar's reach however far the vehicle goes, and a scan is added and removed where it lies. Votes
/// are whole numbers (vote_kernel.hpp): after removing what was added the matrix is what it was, bit for bit.
class HoughSpace {
 public:
  /// @param range_sigma, max_sigma smallest and largest sigma of a line sample [m] that fuzzy votes tell
  /// apart.
  /// @throws std::invalid_argument on a grid or votes out of range.
  HoughSpace(const HoughGrid& grid, const VoteParams& params, double range_sigma, double max_sigma);

  void clear();  ///< Takes all votes back and keeps the memory.
  /// Adds the votes of line samples; those of one scan must stand together. A cell holds more than eight
  /// million votes, so no window of any sensor overflows it, however many line samples of a scan add up.
  void add(std::span<const LineSample> samples) { vote(samples, +1); }
  /// Takes votes back: the line samples of whole scans, as they were added.
  void remove(std::span<const LineSample> samples) { vote(samples, -1); }

  /// Over all cells. [Yan2018] Eq. (17).
  VoteStatistics statistics() const;

  /// The cells with more than `threshold` votes, as lines through intercept at `time` [s], where the
  /// intercepts lie within half the grid's extent of `centre` [m]. [Yan2018] Eq. (17).
  void cells_above(double threshold, double time, double centre, std::vector<VoteCell>& cells) const;

  int rows() const { return rows_; }               ///< Velocity cells.
  int columns() const { return columns_; }         ///< Intercept cells of the ring, a power of two.
  const HoughGrid& grid() const { return grid_; }  ///< As given.
  /// Velocity of a row [m/s].
  double velocity(int row) const { return first_velocity_ + row * grid_.velocity_step; }

 private:
  struct Voter {
    double intercept = 0.0;           ///< In row 0 [1/kPhases of a cell].
    double step = 0.0;                ///< From row to row [1/kPhases of a cell].
    int width = 0;                    ///< Index in the kernel.
    std::int32_t weight = kVoteUnit;  ///< Of the vote.
  };
  /// Where a voter's footprint lies in the row at hand.
  struct Place {
    const std::int16_t* values = nullptr;
    int column = 0;
    int length = 0;  ///< A whole number of VoteKernel::kLanes.
    std::int32_t weight = kVoteUnit;
  };

  void vote(std::span<const LineSample> samples, int sign);
  void vote_scan(std::span<const LineSample> samples, int sign);
  void vote_row(std::int32_t* votes, std::int32_t sign);
  Place place_of(const Voter& voter, int row) const;

  HoughGrid grid_;
  VoteParams params_;
  double min_width_;
  VoteKernel kernel_;
  int rows_;
  int columns_;
  double first_velocity_;
  std::vector<std::int32_t> votes_;  ///< rows_ x columns_. 16 bit would wrap at 128 votes.
  std::vector<std::int16_t> layer_;  ///< One row of one scan: a maximum of votes, never a sum.
  std::vector<Voter> voters_;
  std::vector<Place> places_;
};

}  // namespace lookout::csht
