// The kept corpus through every target, in this process and without a fuzzer: whatever one of these files
// once broke stays mended. usage: fuzz_replay CORPUS, a folder with one for each target.
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

// CMake names the targets, whose entries it renames: LLVMFuzzerTestOneInput of wire_fuzz.cpp is
// lookout_fuzz_wire here.
#define TARGET(name) int lookout_fuzz_##name(const std::uint8_t* data, std::size_t size);
extern "C" {
LOOKOUT_FUZZ_TARGETS
}
#undef TARGET

namespace {

struct Target {
  const char* name;
  int (*entry)(const std::uint8_t*, std::size_t);
};

#define TARGET(name) Target{#name, lookout_fuzz_##name},
constexpr std::array kTargets{LOOKOUT_FUZZ_TARGETS};
#undef TARGET

/// Files that went through; they end the process where a promise is broken.
int replay(const Target& target, const std::filesystem::path& corpus) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus / target.name)) {
    std::cout << entry.path().string() << std::endl;  // The last one named is the one that broke it.
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    target.entry(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++files;
  }
  std::cout << target.name << ": " << files << " files\n";
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_replay CORPUS\n";
    return 2;
  }
  for (const Target& target : kTargets)
    if (replay(target, argv[1]) == 0) {
      std::cerr << target.name << ": no file in its corpus\n";
      return 1;
    }
  return 0;
}
