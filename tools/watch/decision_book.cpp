#include "tools/watch/decision_book.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace lookout::tools {

void DecisionBook::add(std::string_view lines) {
  const std::scoped_lock alone(mutex_);
  while (!lines.empty()) {
    const std::string line(lines.substr(0, lines.find('\n')));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    if (auto decision = parse_decision(line)) add_line(decision->first, std::move(decision->second));
  }
}

std::vector<DecisionLine> DecisionBook::of(std::int64_t track) const {
  const std::scoped_lock alone(mutex_);
  const auto found = told_.find(track);
  if (found == told_.end()) return {};
  return {found->second.begin(), found->second.end()};
}

void DecisionBook::add_line(std::int64_t track, DecisionLine line) {
  const bool ends =
      line.text.find(": end,") != std::string::npos || line.text.find(": merge,") != std::string::npos;
  std::deque<DecisionLine>& lines = told_[track];
  lines.push_back(std::move(line));
  if (lines.size() > kMostDecisionLines) lines.pop_front();
  if (ends) ended_.push_back(track);
  if (told_.size() <= most_tracks_) return;
  // Of living tracks the oldest, which has the smallest identity.
  told_.erase(ended_.empty() ? told_.begin()->first : ended_.front());
  if (!ended_.empty()) ended_.pop_front();
}

}  // namespace lookout::tools
