#include "tools/experiments/compare/compared_methods.hpp"

#include <algorithm>

#include "core/files/text_file.hpp"
#include "core/input_error.hpp"
#include "tools/cli/configuration.hpp"

namespace lookout::tools {
namespace {

constexpr std::size_t kLongestLabel = 40;

/// Labels stand in file names, keys, HTML and LaTeX alike.
void require_label(const std::string& label) {
  const bool plain = std::all_of(label.begin(), label.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == ':' || c == '+';
  });
  if (label.empty() || label.size() > kLongestLabel || !plain)
    throw core::InputError("--method: label " + core::shown(label) +
                           ", expected 1 to 40 letters, digits, `_ - . : +`");
}

ComparedMethod method_of(const std::string& word, const Options& options) {
  ComparedMethod method{word, options};
  method.options.tracker.clear();
  method.options.estimator.clear();
  if (const auto equals = word.find('='); equals != std::string::npos) {
    if (!options.config.empty())
      throw core::InputError("--method " + word + ": has a configuration of its own, expected no --config");
    method.label = word.substr(0, equals);
    method.options.config = word.substr(equals + 1);
  } else {
    const auto colon = word.find(':');
    method.options.tracker = word.substr(0, colon);
    if (colon != std::string::npos) method.options.estimator = word.substr(colon + 1);
  }
  require_label(method.label);
  return method;
}

void require_it_works(const ComparedMethod& method) try {
  const Configuration configuration = load_configuration(method.options);
  if (tracks_images(configuration))
    throw core::InputError("h_pmht tracks raw images, expected a method of scans");
  refuse_idle_choices(method.options, configuration);
} catch (const core::InputError& error) {
  throw core::InputError("--method " + method.label + ": " + error.what());
}

}  // namespace

std::vector<ComparedMethod> compared_methods(const Options& options) {
  if (options.methods.empty()) throw core::InputError("--method NAME is missing; --help lists the trackers");
  std::vector<ComparedMethod> methods;
  for (const auto& word : options.methods) {
    methods.push_back(method_of(word, options));
    require_it_works(methods.back());
    const auto same = [&](const ComparedMethod& other) { return other.label == methods.back().label; };
    if (std::count_if(methods.begin(), methods.end(), same) > 1)
      throw core::InputError("--method: " + methods.back().label + " is there twice, expected each once");
  }
  return methods;
}

}  // namespace lookout::tools
