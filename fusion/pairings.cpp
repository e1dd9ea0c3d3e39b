#include "fusion/pairings.hpp"

namespace lookout::fusion {

bool Pairings::pair(const LocalTrack& local, std::int64_t global_id, Company company) {
  Pairing& pairing = pairings_[local.key()];
  const bool began_again = local.heard() < pairing.heard;
  if (pairing.global_id != global_id || began_again) pairing = {global_id, local.heard(), 0, false, false};
  pairing.heard = local.heard();
  const bool proved = pairing.heard - pairing.since + 1 >= probation_;
  pairing.votes = pairing.votes || company != Company::voices || proved;
  pairing.trusted = pairing.trusted || company == Company::none || proved;
  return pairing.votes;
}

std::int64_t Pairings::global_of(const Key& local) const {
  const auto found = pairings_.find(local);
  return found == pairings_.end() ? -1 : found->second.global_id;
}

std::int64_t Pairings::trusted_in(const LocalTrack& local) const {
  const auto found = pairings_.find(local.key());
  if (found == pairings_.end()) return -1;
  const Pairing& pairing = found->second;
  return pairing.trusted && local.heard() >= pairing.heard ? pairing.global_id : -1;
}

void Pairings::rename(std::int64_t ended, std::int64_t kept) {
  for (auto& [key, pairing] : pairings_) {
    if (pairing.global_id == ended) pairing.global_id = kept;
  }
}

void Pairings::forget_unknown(const LocalTrackStore::Tracks& known) {
  std::erase_if(pairings_, [&](const auto& entry) { return !known.contains(entry.first); });
}

}  // namespace lookout::fusion
