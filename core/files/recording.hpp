#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/motion_element.hpp"
#include "core/pose_history.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"

/// Recording directories and the CSV files of the command line: seconds, metres, radians, one header line.
namespace lookout::core {

/// Where in a recording's lists a further clock begins: the log was played twice, or the clock was set back.
struct ClockStart {
  std::size_t scan = 0;   ///< Index of its first scan.
  std::size_t state = 0;  ///< Of its first vehicle state.
  std::size_t truth = 0;  ///< Of its first list of truth.
};

/// What a vehicle's sensors saw and where it was; the data of a recording directory.
struct Recording {
  std::vector<SonarScan> scans;        ///< In order of time within each clock; each with its geometry.
  std::vector<VehicleState> vehicle;   ///< Likewise.
  std::vector<GroundTruth> truth;      ///< Likewise; empty where there is no truth.csv.
  std::optional<SonarParams> params;   ///< Of sonar.yaml, over `defaults`; nothing where there is none.
  std::vector<std::string> notes;      ///< What a reader should be told of the files: a line each.
  std::vector<ClockStart> new_clocks;  ///< After the first, which begins at 0; mostly none.
  bool is_fixed = false;               ///< A sensor at the origin: no vehicle.csv.
  bool has_images =
      false;  ///< Sonar images lie beside it (core/files/image_recording.hpp); without scans no scans.csv.
};

/// Reads `scans.csv`, `vehicle.csv` and, where present, `truth.csv`, `sonar.yaml` and `geometry.csv`. Beside
/// images there may be no scans.csv: then there are no scans. Without vehicle.csv the sensor stands at the
/// origin, which `notes` says. Angles may stand in degrees
/// (`bearing_deg`, `heading_deg`); a bearing or range of nan or inf is a silence and counted in `notes`.
/// @param defaults what sonar.yaml overrides, and the geometry of the scans.
/// @throws InputError naming file, line and column.
Recording read_recording(const std::string& directory, const SonarParams& defaults = {});

/// Writes the same files: truth.csv, sonar.yaml and geometry.csv only where there is something in them, and
/// no vehicle.csv for a fixed sensor. Files of another recording in the directory do not stay, images among
/// them unless `has_images`, who writes them beforehand (`ImageWriter`).
void write_recording(const std::string& directory, const Recording& recording);

/// Tracks at one scan time.
struct TrackList {
  std::int64_t utime = 0;     ///< Scenario time [us].
  std::vector<Track> tracks;  ///< In the order of the file; empty where nothing was tracked.
};

/// tracks.csv, one row a track and time; with a column `clock` where times go back. `read_tracks` needs
/// time_s,north_m,east_m alone, groups rows by time, and refuses more than one clock. Without a column `id`
/// the rows of a time are numbered, so that an identity says nothing from one time to the next.
void write_tracks(const std::string& path, const std::vector<TrackList>& lists);
/// Reads tracks.csv. @throws InputError naming file, line and column.
std::vector<TrackList> read_tracks(const std::string& path);

/// truth.csv alone; needs time_s,north_m,east_m, takes the rest where present (visible where absent); `id` as
/// in read_tracks.
std::vector<GroundTruth> read_truth(const std::string& path);
/// Writes truth.csv alone. @throws std::runtime_error where the disk refuses.
void write_truth(const std::string& path, const std::vector<GroundTruth>& truth);

/// Motion elements at one scan time, and elements.csv of them.
struct ElementList {
  std::int64_t utime = 0;               ///< Scenario time [us].
  std::vector<MotionElement> elements;  ///< Empty where nothing was found.
};
/// Writes elements.csv, one row an element. @throws std::runtime_error where the disk refuses.
void write_elements(const std::string& path, const std::vector<ElementList>& lists);

}  // namespace lookout::core
