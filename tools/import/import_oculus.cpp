#include "tools/import/import_oculus.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "core/beam_bearings.hpp"
#include "core/files/image_recording.hpp"
#include "core/files/mapped_file.hpp"
#include "core/files/recording.hpp"
#include "core/input_error.hpp"
#include "core/sonar_limits.hpp"
#include "tools/import/oculus_packets.hpp"
#include "tools/import/wrapped_clock.hpp"

namespace lookout::tools {
namespace {

/// Pings of the files, in order, into a recording that begins with the first.
class OculusImport {
 public:
  explicit OculusImport(const std::string& out) : out_(out) {}

  void add_file(const std::string& path) {
    const core::MappedFile file(path, "a packet stream of an Oculus sonar");
    OculusPackets packets(file.bytes(), path);
    while (auto ping = packets.next()) add(*std::move(ping));
    for (const auto& damage : packets.damages()) summary_.left_out.push_back(damage);
    if (packets.other_packets() > 0)
      summary_.notes.push_back(path + ": " + std::to_string(packets.other_packets()) +
                               " packets are no simple ping results and were passed over");
  }

  ImportSummary finish() {
    if (!writer_) throw core::InputError(nothing());
    writer_->close();
    core::Recording recording;
    recording.params = params();
    recording.has_images = recording.is_fixed = true;
    core::write_recording(out_, recording);
    note_what_is_unusual();
    summary_.imported = describe();
    return std::move(summary_);
  }

 private:
  void add(OculusPing ping) {
    if (!writer_) writer_.emplace(out_);
    core::SonarImage& image = ping.image;
    image.utime = core::microseconds(clock_.add(ping.number, ping.start, ping.wrap));
    image.sequence = ping.number;
    has_row_gains_ = has_row_gains_ || ping.has_row_gains;
    if (count_ > 0 && image.utime <= last_utime_) {
      std::ostringstream line;
      line << "ping " << ping.number << " has the time of the one before";
      summary_.left_out.push_back(line.str());
      return;
    }
    writer_->add(image);
    if (count_++ == 0) first_ = ping, first_.image.intensity.clear();
    last_utime_ = image.utime;
  }

  std::string nothing() const {
    std::string text = "no whole Oculus ping (version 1 or 2 of the simple ping result)";
    for (const auto& line : summary_.left_out) return text + "; " + line;
    return text + "; expected a packet stream as the sonar sends it";
  }

  core::SonarParams params() const {
    const core::SonarImage& image = first_.image;
    core::SonarParams params;
    params.num_beams = image.num_beams();
    params.first_bearing = image.bearings.front();
    params.bearing_step = core::mean_step(image.bearings);
    params.max_range = image.num_bins * image.range_step;
    params.range_sigma = std::max(core::SonarLimits::kMinRangeSigma, image.range_step);
    if (count_ > 1) {
      const double period = core::seconds(last_utime_) / static_cast<double>(count_ - 1);
      params.scan_period =
          std::clamp(period, core::SonarLimits::kMinScanPeriod, core::SonarLimits::kMaxScanPeriod);
    }
    return params;
  }

  void note_what_is_unusual() {
    if (has_row_gains_)
      summary_.notes.emplace_back(
          "each range came with a gain of its own, which is not applied to the intensities");
    if (clock_.restarts() == 0) return;
    std::ostringstream restarts;
    restarts << "the sonar's count of pings went back " << clock_.restarts()
             << " times: how long it paused there is unknown";
    summary_.notes.push_back(restarts.str());
  }

  std::string describe() const {
    const core::SonarImage& image = first_.image;
    std::ostringstream line;
    line << count_ << " pings in " << core::seconds(last_utime_) << " s, " << image.num_beams()
         << " beams from " << core::degrees(image.bearings.front()) << " to "
         << core::degrees(image.bearings.back()) << " degrees, " << image.num_bins << " ranges of "
         << image.range_step << " m, " << first_.frequency << " Hz";
    return line.str();
  }

  std::string out_;
  ImportSummary summary_;
  WrappedClock clock_;
  std::optional<core::ImageWriter> writer_;
  OculusPing first_;
  std::size_t count_ = 0;
  std::int64_t last_utime_ = 0;
  bool has_row_gains_ = false;
};

}  // namespace

ImportSummary import_oculus(const std::vector<std::string>& files, const std::string& out) {
  OculusImport import(out);
  for (const auto& file : files) import.add_file(file);
  return import.finish();
}

}  // namespace lookout::tools
