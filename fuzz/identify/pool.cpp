// SPDX-License-Identifier: GPL-3.0-or-later
//
// The programs to choose from: of each way of telling readings apart the shortest few.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/generate/generator.hpp"
#include "fuzz/identify/probe.hpp"

namespace gonogo::identify {
namespace {

// A subject may skip one.
constexpr std::size_t kEqualProbes = 3;
// A longer program is no probe for people to read.
constexpr std::size_t kMostPoolBytes = 2'000;

class PoolMaker {
 public:
  PoolMaker(std::string_view dialect, const std::optional<Profile>& machine)
      : machine_(machine), kinds_(reading_kinds(dialect)) {
    pool_.dialect = dialect;
  }
  void take_corpus(const oracle::Corpus& corpus);
  void take_generated();
  ProbePool finish();

 private:
  void take(std::string id, std::string program, const Profile& profile,
            std::set<std::string> features);
  void keep(Probe probe);
  bool shows_everything();

  const std::optional<Profile>& machine_;
  ReadingKinds kinds_;
  ProbePool pool_;
  std::map<std::string, std::vector<Probe>> equal_;  // by what they tell apart
};

void PoolMaker::take(std::string id, std::string program, const Profile& profile,
                     std::set<std::string> features) {
  ++pool_.seen;
  if (program.size() > kMostPoolBytes) return;
  auto probe = make_probe(std::move(id), std::move(program), machine_ ? *machine_ : profile);
  if (!probe) return;
  probe->features = std::move(features);
  if (auto named = with_named_paths(*probe)) keep(std::move(*named));
  keep(std::move(*probe));
}

void PoolMaker::keep(Probe probe) {
  std::string key = probe.by_reading.signature() + "|" + probe.by_property.signature();
  if (probe.named_paths) key += "|named";
  for (const ReadingKey length : probe.lengths)
    key += fmt::format("|{}:{}", index(length), probe.by_length);
  std::vector<Probe>& equal = equal_[key];
  const auto place = std::ranges::upper_bound(equal, probe.program.size(), {},
                                              [](const Probe& one) { return one.program.size(); });
  equal.insert(place, std::move(probe));
  if (equal.size() > kEqualProbes) equal.pop_back();
}

void PoolMaker::take_corpus(const oracle::Corpus& corpus) {
  oracle::CaseReader reader(corpus, oracle::Detail::to_run, {pool_.dialect});
  while (const auto test = reader.next()) {
    take(test->id, test->program, test->profile, {test->features.begin(), test->features.end()});
  }
}

bool PoolMaker::shows_everything() {
  pool_.probes.clear();
  for (const auto& [key, probes] : equal_) {
    pool_.probes.insert(pool_.probes.end(), probes.begin(), probes.end());
  }
  const auto shown = [&](ReadingKey key) { return pool_.shows(key); };
  return std::ranges::all_of(kinds_.choices, shown) &&
         std::ranges::all_of(kinds_.properties, shown);
}

void PoolMaker::take_generated() {
  const auto known = generate::generators();
  const auto found = std::ranges::find(known, pool_.dialect, &generate::Generator::dialect);
  if (found == known.end()) return;
  constexpr std::size_t kMostGenerated = 1'000;
  constexpr std::size_t kAtOnce = 500;
  while (pool_.generated < kMostGenerated && !shows_everything()) {
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      const std::uint64_t seed = ++pool_.generated;
      generate::Choices choices(seed);
      generate::GeneratedProgram program = found->generate(choices, nullptr);
      take(fmt::format("generated.{}", seed), std::move(program.text), program.profile, {});
    }
  }
}

ProbePool PoolMaker::finish() {
  shows_everything();  // collects the probes
  return std::move(pool_);
}

}  // namespace

ProbePool make_pool(const oracle::Corpus& corpus, std::string_view dialect,
                    const std::optional<Profile>& machine) {
  PoolMaker maker(dialect, machine);
  maker.take_corpus(corpus);
  maker.take_generated();
  return maker.finish();
}

}  // namespace gonogo::identify
