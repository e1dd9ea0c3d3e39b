#include <functional>
#include <stdexcept>

#include "fusion/fusion_params.hpp"
#include "fusion/methods/covariance_fusion.hpp"
#include "fusion/methods/mutual_support_fusion.hpp"

namespace lookout::fusion {
namespace {

using Maker = std::function<std::unique_ptr<FusionMethod>(const FusionParams&)>;

/// A method of class `Method` from what `arguments` picks out of the parameters.
template <class Method, class... Arguments>
Maker maker(Arguments... arguments) {
  return
      [=](const FusionParams& params) { return std::make_unique<Method>(std::invoke(arguments, params)...); };
}

auto constant(auto value) {
  return [value](const FusionParams&) { return value; };
}

double process_noise_of(const FusionParams& params) {
  return params.kalman.process_noise;
}

const std::vector<std::pair<std::string, Maker>>& registry() {
  static const std::vector<std::pair<std::string, Maker>> entries{
      {"sdf", maker<SupportDegreeFusion>(&FusionParams::support_degree, &FusionParams::learned)},
      {"sdf_fixed", maker<SupportDegreeFixed>(&FusionParams::learned)},
      {"dw_a", maker<MutualSupportFusion>(constant(MutualSupport::a), &FusionParams::learned)},
      {"dw_b", maker<MutualSupportFusion>(constant(MutualSupport::b), &FusionParams::learned)},
      {"dw_c", maker<MutualSupportFusion>(constant(MutualSupport::c), &FusionParams::learned)},
      {"dw_d", maker<MutualSupportFusion>(constant(MutualSupport::d), &FusionParams::learned)},
      {"mean", maker<MeanFusion>(&FusionParams::learned)},
      {"single", maker<SingleNode>(&FusionParams::learned)},
      {"icov", maker<CovarianceFusion>(constant(CovarianceWeights::sum), process_noise_of)},
      {"ci", maker<CovarianceFusion>(constant(CovarianceWeights::intersection), process_noise_of)},
      {"ci_trace", maker<CovarianceFusion>(constant(CovarianceWeights::least_trace), process_noise_of)},
      {"ml", maker<MaximumLikelihoodFusion>(&FusionParams::kalman)},
      {"central", maker<CentralKalmanFusion>(&FusionParams::kalman)},
      {"learned", maker<LearnedGeometry>(&FusionParams::learned)}};
  return entries;
}

std::vector<std::string> names_of_registry() {
  std::vector<std::string> names;
  for (const auto& [name, make] : registry()) names.push_back(name);
  return names;
}

}  // namespace

const std::vector<std::string>& fusion_method_names() {
  static const std::vector<std::string> names = names_of_registry();
  return names;
}

std::unique_ptr<FusionMethod> make_fusion_method(const FusionParams& params) {
  for (const auto& [name, make] : registry()) {
    if (name == params.method) return make(params);
  }
  std::string accepted;
  for (const std::string& name : fusion_method_names()) accepted += " " + name;
  throw std::invalid_argument("method must be one of" + accepted + ", got " + params.method);
}

}  // namespace lookout::fusion
