#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lookout::tools {

/// How the values of a column over the scans of a run become the run's one figure.
enum class Reduction {
  mean,        ///< Over the scans that have a value.
  last,        ///< The column says how it stands so far.
  power_mean,  ///< (mean of value^p)^(1/p), p the order of the metrics.
  pair_mean    ///< Mean over all pairs of target and track: weighted by `nees_pairs`.
};

/// What is measured at each scan of a run.
struct CurveColumn {
  const char* name;     ///< As files and reports call it.
  const char* unit;     ///< "m", "s", or "1" for a plain number.
  Reduction reduction;  ///< To the figure of a run.
  bool is_tested;       ///< Whether methods are compared by it.
  bool more_is_better;  ///< Of those by which methods are compared; less is, of the others.
  const char* meaning;  ///< One line for a reader of the report.
};

/// All columns, in the order of the files.
inline constexpr std::array<CurveColumn, 21> kCurveColumns{{
    {"ospa", "m", Reduction::mean, true, false, "OSPA of the positions"},
    {"ospa_localization", "m", Reduction::mean, false, false, "its part from the positions of pairs"},
    {"ospa_cardinality", "m", Reduction::mean, false, false, "its part from a wrong count"},
    {"velocity_ospa", "m/s", Reduction::mean, false, false, "OSPA of the velocities"},
    {"gospa", "m", Reduction::mean, true, false, "GOSPA of the positions, alpha 2"},
    {"gospa_localization", "m", Reduction::mean, false, false, "its part from tracked targets"},
    {"gospa_missed", "m", Reduction::mean, false, false, "its part from targets without a track"},
    {"gospa_false", "m", Reduction::mean, false, false, "its part from tracks without a target"},
    {"ospa2", "m", Reduction::mean, true, false, "OSPA(2) of the tracks over the window that ends here"},
    {"tgospa", "m", Reduction::power_mean, true, false,
     "trajectory GOSPA over the run, a scan's share of it"},
    {"tgospa_switches", "1", Reduction::last, false, false,
     "changes of track that trajectory GOSPA pays for, so far"},
    {"num_targets", "1", Reduction::mean, false, false, "targets that count"},
    {"num_tracks", "1", Reduction::mean, false, false, "tracks that count"},
    {"count_correct", "1", Reduction::mean, true, true, "share of scans with as many tracks as targets"},
    {"time_to_confirm_s", "s", Reduction::last, true, false,
     "from a target's first scan to its first track, so far"},
    {"false_per_100s", "1", Reduction::last, true, false,
     "tracks on no target for most of their scans in 100 s, so far"},
    {"identity_switches", "1", Reduction::last, true, false,
     "changes of the track that is on a target, so far"},
    {"followed_share", "1", Reduction::last, false, true,
     "share of its scans that a target has a track, so far"},
    {"purity", "1", Reduction::last, false, true,
     "share of a track's scans that are on its main target, so far"},
    {"nees", "1", Reduction::pair_mean, false, false,
     "normalised estimation error squared over its 4 degrees"},
    {"nees_pairs", "1", Reduction::mean, false, false, "pairs of target and track that it is of"},
}};

/// The number of a column. @throws std::out_of_range where there is none of this name.
std::size_t column_index(const std::string& name);

/// All columns of one run, a value a scan; NaN where a scan has none. Values are multiples of 1e-6, so that
/// files that hold them are exact and short.
struct Curve {
  std::vector<std::int64_t> utime;                               ///< Of the scans [us], increasing.
  std::array<std::vector<double>, kCurveColumns.size()> values;  ///< In the order of `kCurveColumns`.
  double time_ms = 0.0;                                          ///< Mean processor time of a scan [ms].

  std::vector<double>& operator[](const std::string& name) { return values[column_index(name)]; }
  const std::vector<double>& operator[](const std::string& name) const { return values[column_index(name)]; }
  void round();  ///< Brings every value to a multiple of 1e-6.
};

/// The figure of a run: one column reduced. NaN where no scan has a value.
/// @param order p of `Reduction::power_mean`, >= 1.
double reduce(const Curve& curve, std::size_t column, double order);

/// A line of a log that holds a curve under a key, and back; nothing of a line of another shape.
std::string to_line(const std::string& key, const Curve& curve);
/// @see to_line
std::optional<Curve> curve_of(const std::string& line);

}  // namespace lookout::tools
