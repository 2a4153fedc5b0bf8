// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known of each reading at the end, and why what is not known is not.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/identify/identifier.hpp"

namespace gonogo::identify {

// What kept the programs that show the reading from telling its values apart.
std::string Identifier::why_open(ReadingKey key) const {
  bool shown = false;
  bool skipped = false;
  bool the_same = false;
  bool judged = false;
  for (const Item& item : items_) {
    const Outcomes& outcomes =
        reference::reading(key).by_properties ? item.probe->by_property : item.probe->by_reading;
    if (outcomes.different < 2 || std::ranges::find(outcomes.keys, key) == outcomes.keys.end()) {
      continue;
    }
    shown = true;
    const bool answered = item.run && found_.runs[*item.run].outcome.answered();
    skipped = skipped || (item.run ? !answered : !usable(item) && !item.used);
    judged = judged || answered;
    the_same = the_same || (item.checked && item.outcome.size() == outcomes.leaves.size() &&
                            std::set(item.outcome.begin(), item.outcome.end()).size() == 1);
  }
  if (!pool_.shows(key) || !shown) return "no program of the corpus or the generators shows it";
  if (the_same) return "the judge admits both: the difference is below the tolerance or left open";
  if (skipped && !judged) return "the subject skips the programs that show it";
  if (skipped) return "the subject skips some of the programs that show it";
  return "it makes no difference under the readings that were found";
}

ReadingFound Identifier::choice_found(ReadingKey key) const {
  ReadingFound found{key, {}, {}};
  for (const ReadingValue value : choices_.values(key)) {
    found.values.emplace_back(text_of(reference::reading(key), value));
  }
  if (found.values.size() > 1) found.why = why_open(key);
  return found;
}

ReadingFound Identifier::property_found(ReadingKey key) const {
  const Reading& reading = reference::reading(key);
  ReadingFound found{key, {}, {}};
  std::vector<ReadingValue> values = properties_.values(key);
  const bool seen = seen_properties_.contains(key);
  if (seen && values.size() <= 2) values.resize(1);  // the named path, or "any" alone
  for (const ReadingValue value : values) found.values.emplace_back(text_of(reading, value));
  if (values.size() > 1) found.why = why_open(key);
  return found;
}

ReadingFound Identifier::length_found(ReadingKey key) const {
  if (known_lengths_.contains(key)) return {key, {std::string(base_.get(key))}, {}};
  const bool ran = std::ranges::any_of(found_.runs, [&](const ProbeRun& run) {
    return run.probe->lengths.contains(key) && run.outcome.answered();
  });
  const LengthsLeft& left = lengths_left_.at(key);
  std::vector<std::string> values = left.lengths;
  std::string why = "the subject answers no program that shows it";
  if (ran) why = "no length explains the programs that show it";
  if (!values.empty()) why = "the programs that show it come out the same under each";
  if (left.any_longer) why = "the programs that show it have room for no more than they show";
  if (values.empty()) values.emplace_back(base_.get(key));
  if (left.any_longer || !ran || left.lengths.empty()) values.emplace_back("another length");
  return {key, std::move(values), std::move(why)};
}

std::vector<ReadingFound> Identifier::findings() const {
  std::vector<ReadingFound> found;
  for (const Reading& reading : reference::readings()) {
    if (!reading.belongs_to(pool_.dialect)) continue;
    found.push_back(reading.is_length       ? length_found(reading.key)
                    : reading.by_properties ? property_found(reading.key)
                                            : choice_found(reading.key));
  }
  return found;
}

std::size_t Identification::answered() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(runs, [](const ProbeRun& run) { return run.outcome.answered(); }));
}

}  // namespace gonogo::identify
