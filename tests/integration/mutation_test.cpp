// Damages files of every format at random and hands them to the commands that read them: none may crash,
// hang, end with another status than 0, 1 or 2, or show an exception's text in place of a sentence. A child
// process a mutation, forked and not started anew, so that one takes two milliseconds. usage: mutation_test
// FORMAT [MUTATIONS [SEED]]
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <string_view>

#include "core/files/image_recording.hpp"
#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/tools/import/oculus_bytes.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tests {
namespace {

constexpr unsigned kLongestRun = 10;                // Of one command [s].
constexpr rlim_t kLargestMemory = rlim_t{2} << 30;  // Of one command [bytes].
constexpr int kMostReported = 5;
/// What a library would say. A sentence of ours holds none of them.
constexpr std::array kExceptionTexts{"std::",      "bad_alloc",    "vector",         "basic_string",
                                     "stoi",       "stod",         "what()",         "terminate",
                                     "json.excep", "yaml-cpp",     "bad conversion", "filesystem error",
                                     "_M_",        "length_error", "map::at",        "Assertion"};

std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

using namespace std::string_view_literals;
/// What is put in: first numbers that a reader may trip over, then the signs of CSV and YAML.
constexpr auto kTokens = std::to_array<std::string_view>(
    {"nan",  "inf",     "-1",   "0",     "1e308", "1e-308", "-1e9", "99999999999999999999",
     "0x10", "1.7e+09", ",",    ";",     "\"",    "'",      "\0"sv, "\xff\xfe",
     "\n",   "\r\n",    "\t",   "- ",    "{",     "}",      "[",    "]",
     "&a ",  "*a",      "<<: ", "---\n", "#",     ":",      "true", "\xEF\xBB\xBF"});
constexpr std::size_t kNumbers = 10;     // Of these tokens.
constexpr std::size_t kLongestCut = 12;  // Bytes that are erased or doubled.
constexpr std::size_t kKinds = 9;        // Of changes; four of the nine replace a number.
constexpr std::size_t kLinesToACut = 8;  // Lines are swapped seven times as often as a file is cut off.

/// Changes bytes as storage, editors and people do.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (std::size_t changes = 1 + below(2); changes > 0; --changes) change(text);
    return text;
  }
  std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }

 private:
  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(text.size() - at, 1 + below(kLongestCut));
    switch (const std::size_t kind = below(kKinds)) {
      case 0:
        flip_bit(text, at);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.insert(at, kTokens[below(kTokens.size())]);
        break;
      default:
        if (kind < kKinds - 1)
          replace_number(text, at, std::string(kTokens[below(kNumbers)]));
        else
          below(kLinesToACut) == 0 ? text.resize(at) : swap_lines(text);
    }
  }

  void flip_bit(std::string& text, std::size_t at) {
    if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(CHAR_BIT)));
  }

  static void replace_number(std::string& text, std::size_t at, const std::string& by) {
    std::size_t begin = text.find_first_of("0123456789", at);
    if (begin == std::string::npos) return;
    while (begin > 0 && std::string_view("0123456789.-").find(text[begin - 1]) != std::string_view::npos)
      --begin;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.e+-", begin), text.size());
    text.replace(begin, end - begin, by);
  }

  void swap_lines(std::string& text) {
    const std::size_t begin = text.rfind('\n', below(text.size()));
    if (begin == std::string::npos) return;
    const std::size_t end = text.find('\n', begin + 1);
    if (end == std::string::npos) return;
    text = text.substr(0, begin) + text.substr(end) + text.substr(begin, end - begin);
  }

  std::mt19937 random_;
};

/// A format: good files, and the command that reads them.
struct Format {
  std::map<std::string, std::string> files;  ///< By name in the folder.
  std::vector<std::string> damaged;          ///< Those to damage, one at a time.
  std::function<int(const std::string& folder)> command;
};

const std::string kSource = LOOKOUT_SOURCE_DIR;

constexpr const char* kScene =
    "duration: 1.0\nvehicle: {north: 0.0, east: 0.0, north_velocity: 0.87, east_velocity: 0.5}\n"
    "sonar: {num_beams: 30, first_bearing_deg: -29, bearing_step_deg: 2.0, max_range: 100.0, scan_period: "
    "0.5,\n"
    "        range_sigma: 1.0, miss_probability: 0.3, false_alarm_probability: 0.1, clutter: literal}\n"
    "targets:\n  - {id: 1, north: 60.0, east: 8.0, north_velocity: -0.5, east_velocity: -1.0, appear: 0.0, "
    "disappear: 9.0}\n"
    "  - {id: 2, north: 20.0, east: 0.0, turn_rate_deg: 1.0, acceleration: 0.1}\n";

constexpr const char* kConfiguration =
    "sensor: {range_sigma: 3.0, max_speed: 3.0}\nestimator: {name: csht, window_scans: 20}\n"
    "tracker: {name: csht, coast_s: 10.0, initiator: csht}\noutput: {min_existence: 0.5}\n"
    "initiator: {position_sigma: 60.0, range_sigma: 10.0, azimuth_sigma_deg: 0.3, min_speed: 100.0, "
    "max_speed: 400.0,\n"
    "            min_plots: 4, window_scans: 5, variant: text}\n"
    "tbd: {dct_db: 5.0, truncation: zero, polarity: bright, start: [120.0, 80.0, 2.5, 0.0]}\n"
    "fusion: {support: any, unit: km, origin: zero, association: one_to_one}\n";

tools::Options options_in(const std::string& folder, const std::string& input) {
  tools::Options options;
  options.inputs = {folder + "/" + input};
  options.out = folder + "/out";
  options.tracker = "gnn";
  return options;
}

/// The rows of a file of a recording up to a time [s], and its header: it costs what it is long to track what
/// is read.
std::string rows_until(const std::string& csv, double seconds) {
  std::istringstream lines(csv);
  std::string text, line;
  while (std::getline(lines, line))
    if (text.empty() || std::strtod(line.c_str(), nullptr) <= seconds) text += line + "\n";
  return text;
}

Format recording_format() {
  constexpr double kLength = 7.0;  // Of thirty seconds; two scans more than the tracker takes to confirm.
  const std::string plain = kSource + "/tests/data/cases/csv_forms/crlf/";
  Format format;
  for (const char* name : {"scans.csv", "vehicle.csv", "truth.csv"})
    format.files[name] = rows_until(read(plain + name), kLength);
  format.files["sonar.yaml"] = read(plain + "sonar.yaml");
  format.damaged = {"scans.csv", "vehicle.csv", "truth.csv", "sonar.yaml"};
  format.command = [](const std::string& folder) { return tools::replay_command(options_in(folder, "")); };
  return format;
}

Format scene_format() {
  return {{{"scene.yaml", kScene}}, {"scene.yaml"}, [](const std::string& folder) {
            return tools::run_command(options_in(folder, "scene.yaml"));
          }};
}

Format configuration_format() {
  return {{{"scene.yaml", kScene}, {"config.yaml", kConfiguration}},
          {"config.yaml"},
          [](const std::string& folder) {
            tools::Options options = options_in(folder, "scene.yaml");
            options.config = folder + "/config.yaml";
            options.tracker.clear();
            return tools::run_command(options);
          }};
}

Format image_format() {
  Format format;
  for (int frame = 0; frame < 4; ++frame) {
    std::string image = "P5\n12 10\n255\n";
    for (int pixel = 0; pixel < 120; ++pixel) image += static_cast<char>((pixel * 37 + frame * 11) % 64);
    image[13 + static_cast<std::size_t>(40 + frame)] = static_cast<char>(200);
    format.files["frame" + std::to_string(frame) + ".pgm"] = image;
    format.damaged.push_back("frame" + std::to_string(frame) + ".pgm");
  }
  format.command = [](const std::string& folder) {
    tools::Options options = options_in(folder, "");
    options.method = "i_h_pmht_4";
    options.tracker.clear();
    options.out = folder + "/tracks.csv";
    return tools::tbd_command(options);
  };
  return format;
}

Format points_format() {
  std::string points = read(kSource + "/tools/data/example_points.csv");
  return {{{"points.csv", points}}, {"points.csv"}, [](const std::string& folder) {
            tools::Options options = options_in(folder, "points.csv");
            options.method = "vct";
            options.tracker.clear();
            options.out = folder + "/tracks.csv";
            return tools::initiate_command(options);
          }};
}

Format tracks_format() {
  const std::string truth = read(kSource + "/tests/data/cases/csv_forms/crlf/truth.csv");
  return {{{"truth.csv", truth}, {"tracks.csv", truth}},
          {"truth.csv", "tracks.csv"},
          [](const std::string& folder) {
            tools::Options options = options_in(folder, "truth.csv");
            options.inputs.push_back(folder + "/tracks.csv");
            return tools::ospa_command(options);
          }};
}

/// A recording of two images, tracked.
Format sonar_image_format() {
  const TemporaryDirectory folder;
  core::SonarImage image;
  image.bearings = {-0.2, -0.1, 0.0, 0.15};
  image.range_step = 0.5;
  image.num_bins = 12;
  core::ImageWriter writer(folder.path());
  for (image.utime = 0; image.utime < 3; ++image.utime) {
    image.intensity.assign(48, 1.0 + static_cast<double>(image.utime));
    writer.add(image);
  }
  writer.close();
  Format format;
  for (const char* name :
       {"images.csv", "bearings.csv", "images/000000.pgm", "images/000001.pgm", "images/000002.pgm"})
    format.files[name] = read(folder.file(name)), format.damaged.emplace_back(name);
  format.command = [](const std::string& in) {
    tools::Options options = options_in(in, "");
    options.tracker.clear();
    options.estimator = "h_pmht";
    return tools::replay_command(options);
  };
  return format;
}

/// An import of files in the folder.
Format import_format(const std::string& name, const std::map<std::string, std::string>& files,
                     const std::vector<std::string>& inputs) {
  Format format{files, {}, {}};
  for (const auto& [file, text] : files) format.damaged.push_back(file);
  format.command = [name, inputs](const std::string& folder) {
    tools::Options options;
    options.method = name;
    for (const auto& input : inputs)
      options.inputs.push_back((std::filesystem::path(folder) / input).string());
    options.out = folder + "/out";
    return tools::import_command(options);
  };
  return format;
}

Format oculus_format() {
  OculusSpec second;
  second.version = 2;
  return import_format(
      "oculus", {{"dive.raw", oculus_packet({}) + oculus_packet(second) + oculus_packet({})}}, {"dive.raw"});
}

Format pgm_format() {
  return import_format("pgm",
                       {{"geometry.yaml",
                         "beam_bearings_deg: [-5, 0, 6]\nmin_range: 1\nmax_range: 4\nping_period: 0.1\n"
                         "rows: beams\nranges_from: near\nmount_x: 1.0\n"},
                        {"a1.pgm", "P5\n4 3\n255\nabcdefghijkl"},
                        {"a2.pgm", "P2\n4 3\n99\n1 2 3 4 5 6 7 8 9 10 11 12\n"}},
                       {"."});
}

Format autoferry_format() {
  const std::string cases = kSource + "/tests/data/cases/autoferry_forms/";
  return import_format("autoferry",
                       {{"d.json", read(cases + "empty_d.json")}, {"g.json", read(cases + "ok_g.json")}},
                       {"d.json", "g.json"});
}

/// What the program does with a command: its exit status, its words on stderr.
int as_the_program(const Format& format, const std::string& folder) {
  try {
    return format.command(folder);
  } catch (const core::InputError& error) {
    std::cerr << "lookout: " << error.what() << "\n";
    return 2;
  } catch (const std::invalid_argument& error) {
    std::cerr << "lookout: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "lookout: " << error.what() << "\n";
    return 1;
  }
}

struct Outcome {
  int status = -1;  ///< Of a child that ended by itself; else minus its signal.
  std::string said;
};

Outcome run_child(const Format& format, const std::string& folder) {
  const std::string said = folder + "/said";
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{kLargestMemory, kLargestMemory};
    setrlimit(RLIMIT_AS, &limit);
    alarm(kLongestRun);
    if (freopen(said.c_str(), "w", stderr) == nullptr || freopen("/dev/null", "w", stdout) == nullptr)
      _exit(99);
    const int status = as_the_program(format, folder);
    std::cerr.flush();
    fflush(nullptr);
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read(said)};
}

bool is_fault(const Outcome& outcome) {
  if (outcome.status < 0 || outcome.status > 2) return true;
  for (const char* text : kExceptionTexts)
    if (outcome.said.find(text) != std::string::npos) return true;
  const auto refusals = outcome.said.find("lookout: ");
  return outcome.status == 2 &&
         (refusals == std::string::npos || outcome.said.find('\n', refusals) + 1 != outcome.said.size());
}

int test(const std::string& name, const Format& format, int mutations, unsigned seed) {
  const TemporaryDirectory folder;
  Mutator mutate(seed);
  std::array<int, 3> ended{};
  int faults = 0;
  for (int i = 0; i < mutations; ++i) {
    for (const auto& [file, text] : format.files) {
      std::filesystem::create_directories(std::filesystem::path(folder.file(file)).parent_path());
      folder.write(file, text);
    }
    const std::string& victim = format.damaged[mutate.below(format.damaged.size())];
    const std::string damaged = mutate(format.files.at(victim));
    write(folder.file(victim), damaged);
    const Outcome outcome = run_child(format, folder.path());
    if (!is_fault(outcome)) {
      ++ended[static_cast<std::size_t>(outcome.status)];
      continue;
    }
    if (++faults <= kMostReported)
      std::cout << name << " " << i << " (" << victim << "): status " << outcome.status << ": "
                << outcome.said << "\n"
                << damaged << "\n";
  }
  std::cout << name << ": " << mutations << " mutations: " << ended[0] << " read, " << ended[2]
            << " refused, " << ended[1] << " failed, " << faults << " faults\n";
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace lookout::tests

int main(int argc, char** argv) try {
  using namespace lookout::tests;
  const std::map<std::string, Format (*)()> formats{{"recording", recording_format},
                                                    {"scene", scene_format},
                                                    {"configuration", configuration_format},
                                                    {"images", image_format},
                                                    {"points", points_format},
                                                    {"tracks", tracks_format},
                                                    {"sonar_images", sonar_image_format},
                                                    {"oculus", oculus_format},
                                                    {"pgm", pgm_format},
                                                    {"autoferry", autoferry_format}};
  if (argc < 2 || !formats.contains(argv[1])) return std::cerr << "expected a format\n", 2;
  const int mutations = argc > 2 ? std::atoi(argv[2]) : 3000;
  const unsigned seed = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  return test(argv[1], formats.at(argv[1])(), mutations, seed);
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
