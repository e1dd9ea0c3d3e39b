#include "tracking/intake/ping_content.hpp"

#include <functional>
#include <vector>

namespace lookout::tracking {
namespace {

/// Fewer returns may repeat to the bit by chance.
constexpr std::size_t kTellingReturns = 3;

template <class Value>
std::string_view bytes_of(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

}  // namespace

std::string_view content_of(const core::SonarScan& scan) {
  return bytes_of(scan.returns);
}

std::string_view content_of(const core::SonarImage& image) {
  return bytes_of(image.intensity);
}

std::size_t hash_of(std::string_view content) {
  if (content.size() < kTellingReturns * sizeof(core::SonarReturn)) return 0;
  return std::hash<std::string_view>()(content);
}

}  // namespace lookout::tracking
