#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "tools/commands/commands.hpp"
#include "tools/doctor/findings.hpp"
#include "tools/doctor/link_test.hpp"
#include "tools/doctor/probes.hpp"

namespace lookout::tools {
namespace {

using Findings = std::vector<Finding>;

/// The way that messages take, where it is UDP multicast.
void look_at_multicast(const std::string& url, Findings& findings) {
  const MulticastUrl multicast = parse_multicast(url);
  const Route route = route_to(multicast);
  findings.push_back(judge_route(multicast, route));
  findings.push_back(judge_ttl(multicast, route));
  findings.push_back(judge_buffer(multicast, granted_buffer(multicast), most_allowed_buffer()));
}

void look_at_link(const Options& options, Findings& findings) {
  const std::string url = lcmtypes::Bus::resolved(options.lcm_url);
  if (lcmtypes::Bus::may_come_up(url)) look_at_multicast(url, findings);
  try {
    lcmtypes::Bus testing(options.lcm_url);
    findings.push_back(judge_link(test_link(testing)));
    lcmtypes::Bus listening(options.lcm_url);
    findings.push_back(judge_traffic(listen_to_traffic(listening, options.channel_prefix)));
  } catch (const lcmtypes::BusError& error) {
    LinkResult nothing;
    nothing.error = error.what();
    findings.push_back(judge_link(nothing));
  }
}

void look_at_machine(const Options& options, Findings& findings) {
  const std::string out = options.out.empty() ? "." : options.out;
  findings.push_back(judge_clock(current_year(), is_clock_synchronized()));
  findings.push_back(judge_jar(types_jar()));
  findings.push_back(judge_directory("output", out, write_error(out)));
  if (!options.state.empty()) {
    const std::string folder = std::filesystem::absolute(options.state).parent_path().string();
    findings.push_back(judge_directory("state", folder, write_error(folder)));
  }
  findings.push_back(judge_disk(out, free_bytes(out)));
}

}  // namespace

int doctor_command(const Options& options) {
  static_cast<void>(lcmtypes::Channels(options.channel_prefix));  // Refuses a bad prefix before all else.
  Findings findings;
  look_at_link(options, findings);
  look_at_machine(options, findings);
  for (const auto& finding : findings) std::cout << line_of(finding) << "\n";
  const bool fails = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict == Finding::Verdict::failure;
  });
  return fails ? 1 : 0;
}

}  // namespace lookout::tools
