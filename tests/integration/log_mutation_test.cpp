// Thousands of damaged recordings and logs through `lookout replay`, in this process: each is tracked, or
// refused with one line of our own.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/input_error.hpp"
#include "core/random.hpp"
#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tests {
namespace {

constexpr int kMutations = 3000;
constexpr std::size_t kLogBytes = 3'000;  // Of a case's log: ten scans, milliseconds a mutation.
constexpr std::size_t kLongestRun = 24;   // Bytes that one mutation removes, repeats or overwrites.

constexpr std::array<const char*, 24> kTokens{"nan",
                                              "inf",
                                              "-inf",
                                              "1e308",
                                              "-1e308",
                                              "1e-320",
                                              "0",
                                              "-1",
                                              "",
                                              "9223372036854775807",
                                              "99999999999999999999",
                                              "2147483648",
                                              ",",
                                              ",,,",
                                              ";",
                                              "\"",
                                              "\n",
                                              "\r\n",
                                              "\t",
                                              "- {",
                                              "<<: *a",
                                              "&a [*a]",
                                              "clock",
                                              "\xff\xfe"};

/// What one mutation does to a file.
std::string mutated(std::string text, core::Random& random) {
  const auto any = [&random](std::size_t size) {
    return static_cast<std::size_t>(random.index(static_cast<int>(size)));
  };
  for (std::size_t times = 1 + any(3); times > 0; --times) {
    if (text.empty()) return text;
    const std::size_t at = any(text.size());
    const std::size_t run = std::min(1 + any(kLongestRun), text.size() - at);
    switch (any(6)) {
      case 0:
        text[at] = static_cast<char>(any(2) == 0 ? any(256) : '0' + any(10));
        break;
      case 1:
        text.erase(at, run);
        break;
      case 2:
        text.insert(at, text.substr(at, run));
        break;
      case 3:
        text.replace(at, std::min<std::size_t>(run, 4), kTokens[any(kTokens.size())]);
        break;
      case 4:
        std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(at), run, any(2) == 0 ? '\xff' : '\0');
        break;
      default:
        std::rotate(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), text.end());
        break;
    }
  }
  if (any(20) == 0) text.resize(any(text.size() + 1));
  return text;
}

/// Keeps what the replays say off the terminal.
class Silence {
 public:
  Silence() : kept_(dup(STDERR_FILENO)) { reopen(); }
  ~Silence() {
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  static void reopen() {
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDERR_FILENO);
    close(nothing);
  }
  int kept_;
};

/// How a replay ended: 0, or 2 with its line; what else it throws is somebody else's text.
int replay(const std::string& input, const std::string& out) {
  tools::Options options;
  options.inputs = {input};
  options.out = out;
  options.tracker = "csht";
  options.estimator = "ransac";
  try {
    return tools::replay_command(options);
  } catch (const core::InputError& error) {
    const std::string line = error.what();
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 0) << line;
    EXPECT_LT(line.size(), 1000u) << line;
    return 2;
  }
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

class Mutations : public ::testing::Test {
 protected:
  std::string log_ =
      text_of(LOOKOUT_SOURCE_DIR "/tests/data/cases/range_switched.lcmlog").substr(0, kLogBytes);
  TemporaryDirectory directory_;
  core::Random random_{1000};
  int tracked_ = 0, refused_ = 0;

  void count(int status) { ++(status == 0 ? tracked_ : refused_); }
};

TEST_F(Mutations, OfALog) {
  const std::string path = directory_.file("log");
  for (int i = 0; i < kMutations; ++i) {
    SCOPED_TRACE(i);
    write(path, mutated(log_, random_));
    const Silence silence;
    ASSERT_NO_THROW(count(replay(path, directory_.file("out")))) << i;
  }
  EXPECT_GT(tracked_, kMutations / 2);
}

TEST_F(Mutations, OfARecording) {
  const std::string recording = directory_.file("recording");
  write(directory_.file("log"), log_);
  {
    const Silence silence;
    ASSERT_EQ(replay(directory_.file("log"), recording), 0);
  }
  write(recording + "/geometry.csv", "time_s,sensor_id,num_beams,max_range_m\n0,0,60,50\n5,0,60,100\n");
  write(recording + "/truth.csv", "time_s,id,north_m,east_m\n0,1,40,10\n1,1,40,10\n2,1,40,10\n");
  const std::array<const char*, 5> names{"scans.csv", "vehicle.csv", "truth.csv", "sonar.yaml",
                                         "geometry.csv"};
  for (int i = 0; i < kMutations; ++i) {
    SCOPED_TRACE(i);
    const std::string path = recording + "/" + names[static_cast<std::size_t>(i) % names.size()];
    const std::string whole = text_of(path);
    write(path, mutated(whole, random_));
    {
      const Silence silence;
      ASSERT_NO_THROW(count(replay(recording, directory_.file("out")))) << i << " " << path;
    }
    write(path, whole);
  }
  EXPECT_GT(tracked_, kMutations / 20);
  EXPECT_GT(refused_, kMutations / 4);
}

}  // namespace
}  // namespace lookout::tests
