#pragma once

#include <cstdint>
#include <string>

/// What `lookout doctor` makes of what it measured. Pure functions.
namespace lookout::tools {

/// One line of the doctor's.
struct Finding {
  /// remark: works, but a person may want to know; failure: something would fail.
  enum class Verdict { ok, remark, failure };
  Verdict verdict = Verdict::ok;  ///< How it is.
  std::string name;               ///< What was looked at.
  std::string what;               ///< What was found.
  std::string cure;               ///< What to type; empty where there is nothing to do.
};

/// "ok    route: ...", with the cure behind an arrow.
std::string line_of(const Finding& finding);

/// A UDP multicast URL of LCM's, taken apart.
struct MulticastUrl {
  std::string address = "239.255.76.67";  ///< Of the group.
  int port = 7667;                        ///< Of it.
  int ttl = 0;                            ///< Hops that messages go; 0: they stay on this computer.
  int receive_buffer = 0;                 ///< That is asked for [bytes]; 0: the system's own choice.
};
/// What LCM reads out of "udpm://ADDRESS:PORT?ttl=N&recv_buf_size=N"; its defaults for what is not there.
MulticastUrl parse_multicast(const std::string& url);

/// By which interface multicast leaves.
struct Route {
  bool known = false;          ///< Whether there is one.
  bool loopback = false;       ///< Whether it is the loopback.
  std::string interface_name;  ///< "lo", "eth0"; empty where unknown.
};

Finding judge_route(const MulticastUrl& url, const Route& route);  ///< Whether messages can be sent.
Finding judge_ttl(const MulticastUrl& url,
                  const Route& route);  ///< Whether they get as far as they are meant to.
/// Whether a socket's buffer [bytes, as the kernel counts] holds the largest message beside others.
Finding judge_buffer(const MulticastUrl& url, std::int64_t granted, std::int64_t most_allowed);

/// What came back of test messages.
struct LinkResult {
  int small_sent = 0, small_heard = 0;  ///< Of 200 bytes.
  int large_sent = 0, large_heard = 0;  ///< Of one whole datagram.
  int split_sent = 0, split_heard = 0;  ///< Of several datagrams, as large images are.
  std::string error;                    ///< Why nothing could be sent; empty for nothing.
};
Finding judge_link(const LinkResult& result);  ///< Whether what is sent is heard, whole.

/// What the vehicle's channels brought while they were listened to.
struct TrafficResult {
  std::int64_t scans = 0, states = 0, damaged = 0, lost = 0;  ///< Messages.
  std::string last_error;                                     ///< About the damaged ones.
};
Finding judge_traffic(const TrafficResult& result);  ///< Whether senders speak our types.

Finding judge_clock(int year, bool synchronized);  ///< Whether the wall clock can be right.
/// Whether a directory takes files; `error` empty: it does.
Finding judge_directory(const std::string& name, const std::string& directory, const std::string& error);
Finding judge_disk(const std::string& directory, std::int64_t free_bytes);  ///< Whether a recording has room.
Finding judge_jar(const std::string& path);  ///< Whether lcm-spy can know our types; empty: no jar.

}  // namespace lookout::tools
