#include "tracking/track_before_detect/frames/frame_tracker_registry.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/frames.hpp"
#include "tracking/track_before_detect/frames/h_pmht.hpp"
#include "tracking/track_before_detect/frames/immpda_ai.hpp"

namespace lookout::tracking {
namespace {

HPmhtParams adapt(HPmhtParams h_pmht, const TbdParams& params) {
  if (params.truncation == Truncation::zero) h_pmht = with_dark_cells(h_pmht);
  h_pmht.dct_db = params.dct_db;
  h_pmht.target_area = params.target_area;
  return h_pmht;
}

std::unique_ptr<FrameTracker> make_standard(const TbdParams& params) {
  return make_h_pmht(adapt(standard_h_pmht(), params));
}

std::unique_ptr<FrameTracker> make_improved_4(const TbdParams& params) {
  return make_h_pmht(adapt(improved_h_pmht_4(), params));
}

std::unique_ptr<FrameTracker> make_improved_1(const TbdParams& params) {
  return make_h_pmht(adapt(improved_h_pmht_1(), params));
}

std::unique_ptr<FrameTracker> make_points(const TbdParams& params) {
  ImmpdaAiParams points;
  points.dct_db = params.dct_db;
  points.target_area = params.target_area;
  return make_immpda_ai(points);
}

struct Entry {
  std::string_view name;
  std::unique_ptr<FrameTracker> (*make)(const TbdParams& params);
};
constexpr std::array<Entry, 4> kRegistry{{{"h_pmht", make_standard},
                                          {"i_h_pmht_4", make_improved_4},
                                          {"i_h_pmht_1", make_improved_1},
                                          {"immpda_ai", make_points}}};

void read_start(const core::YamlMap& map, TbdParams& params) {
  const std::vector<double> start = map.numbers("start");
  if (!map.has("start")) return;
  if (start.size() != 4) map.fail("start", "expected four numbers: x, y, vx, vy in pixels");
  params.start = Eigen::Vector4d(start[0], start[1], start[2], start[3]);
}

}  // namespace

void read_tbd_params(const core::YamlMap& map, TbdParams& params) {
  params.dct_db = map.number("dct_db", params.dct_db, {-20, 60});
  const bool zero = params.truncation == Truncation::zero, bright = params.polarity == Polarity::bright;
  params.truncation = map.choice("truncation", zero ? "zero" : "impute", {"zero", "impute"}) == "zero"
                          ? Truncation::zero
                          : Truncation::impute;
  params.polarity = map.choice("polarity", bright ? "bright" : "dark", {"bright", "dark"}) == "bright"
                        ? Polarity::bright
                        : Polarity::dark;
  const std::string differencing = map.choice("differencing", "automatic", {"automatic", "on", "off"});
  params.differencing = differencing == "on"    ? Differencing::on
                        : differencing == "off" ? Differencing::off
                                                : Differencing::automatic;
  read_start(map, params);
  params.target_area = map.number("target_area", params.target_area, core::kPositive);
  params.frame_step = map.integer("frame_step", params.frame_step, {1, 1000});
  params.frame_period = map.number("frame_period", params.frame_period, core::kPositive);
  params.start_position_sigma =
      map.number("start_position_sigma", params.start_position_sigma, core::kNotNegative);
  params.start_velocity_sigma =
      map.number("start_velocity_sigma", params.start_velocity_sigma, core::kNotNegative);
  params.pulse_length = map.number("pulse_length", params.pulse_length, core::kNotNegative);
  params.beam_width =
      core::radians(map.number("beam_width_deg", core::degrees(params.beam_width), core::kNotNegative));
  params.slowest = map.number("slowest", params.slowest, core::kNotNegative);
  params.birth_rate = map.number("birth_rate", params.birth_rate, core::kPositive);
  params.mark_time = map.number("mark_time", params.mark_time, core::kNotNegative);
  params.max_speed = map.number("max_speed", params.max_speed, core::kPositive);
  map.finish();
}

std::span<const std::string_view> frame_tracker_names() {
  static constexpr std::array<std::string_view, 4> kNames{kRegistry[0].name, kRegistry[1].name,
                                                          kRegistry[2].name, kRegistry[3].name};
  return kNames;
}

std::unique_ptr<FrameTracker> make_frame_tracker(std::string_view name, const TbdParams& params) {
  for (const Entry& entry : kRegistry)
    if (entry.name == name) return entry.make(params);
  throw std::invalid_argument("unknown tbd method " + std::string(name));
}

}  // namespace lookout::tracking
