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

/// What one sensor saw and where its vehicle was; the data of a recording directory.
struct Recording {
  std::vector<SonarScan> scans;       ///< In order of time; geometry from the params.
  std::vector<VehicleState> vehicle;  ///< In order of time.
  std::vector<GroundTruth> truth;     ///< Empty where there is no truth.csv.
  std::optional<SonarParams> params;  ///< Of sonar.yaml, over `defaults`; nothing where there is none.
  std::vector<std::string> notes;     ///< What a reader should be told of the files: a line each.
};

/// Reads `scans.csv`, `vehicle.csv` and, where present, `truth.csv` and `sonar.yaml`. Angles may stand in
/// degrees
/// (`bearing_deg`, `heading_deg`); a bearing or range of nan or inf is a silence and counted in `notes`.
/// @param defaults what sonar.yaml overrides, and the geometry of the scans.
/// @throws InputError naming file, line and column.
Recording read_recording(const std::string& directory, const SonarParams& defaults = {});

/// Writes the same files (truth.csv and sonar.yaml only where there is something in them).
void write_recording(const std::string& directory, const Recording& recording);

/// Tracks at one scan time.
struct TrackList {
  std::int64_t utime = 0;     ///< Scenario time [us].
  std::vector<Track> tracks;  ///< In the order of the file; empty where nothing was tracked.
};

/// tracks.csv, one row a track and time. `read_tracks` needs time_s,id,north_m,east_m alone; groups rows by
/// time.
void write_tracks(const std::string& path, const std::vector<TrackList>& lists);
/// Reads tracks.csv. @throws InputError naming file, line and column.
std::vector<TrackList> read_tracks(const std::string& path);

/// truth.csv alone; needs time_s,id,north_m,east_m, takes the rest where present (visible where absent).
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
