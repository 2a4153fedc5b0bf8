// SPDX-License-Identifier: GPL-3.0-or-later
//
// Row by row (the AETG way): a row begins with a tuple that is still uncovered; the other
// parameters come in a shuffled order, each taking the class that covers most of what is left. Of
// several rows made so the best is kept.
#include "fuzz/generate/cover/covering_array.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "fuzz/generate/choices.hpp"

namespace gonogo::cover {
namespace {

constexpr int kRowsTried = 12;

bool breaks(const Rule& rule, const Row& row) {
  return std::ranges::all_of(rule.members, [&](const Rule::Member& member) {
    const std::uint8_t chosen = row[member.parameter];
    return chosen != kOpen && member.classes[chosen];
  });
}

// Which rows there may be, with or without a fault.
class Space {
 public:
  Space(const Parameters& parameters, bool faulty) : parameters_(parameters), faulty_(faulty) {}

  // Fills the open places of the row by the first classes that the rules allow. False: there is no
  // such row.
  bool complete(Row& row) const { return allowed(row) && complete_from(row, 0); }
  bool extends(Row row) const { return complete(row); }

 private:
  std::size_t faults(const Row& row) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      count += row[i] != kOpen && parameters_.list[i].classes[row[i]].is_fault() ? 1U : 0U;
    }
    return count;
  }

  bool allowed(const Row& row) const {
    if (faults(row) > (faulty_ ? 1U : 0U)) return false;
    return std::ranges::none_of(parameters_.rules,
                                [&](const Rule& rule) { return breaks(rule, row); });
  }

  bool complete_from(Row& row, std::size_t parameter) const {
    while (parameter < row.size() && row[parameter] != kOpen) ++parameter;
    if (parameter == row.size()) return faults(row) == (faulty_ ? 1U : 0U);
    for (std::size_t c = 0; c < parameters_.list[parameter].classes.size(); ++c) {
      row[parameter] = static_cast<std::uint8_t>(c);
      if (allowed(row) && complete_from(row, parameter + 1)) return true;
    }
    row[parameter] = kOpen;
    return false;
  }

  const Parameters& parameters_;
  bool faulty_;
};

enum class State : std::uint8_t { wanted, covered, excluded, other };

// The tuples of some parameters, by the numbers of their classes in mixed base.
struct Combination {
  std::vector<std::size_t> parameters;
  std::vector<State> states;
};

class ArrayMaker {
 public:
  ArrayMaker(const Parameters& parameters, bool faulty, unsigned strength,
             generate::Choices& choices)
      : parameters_(parameters), space_(parameters, faulty), faulty_(faulty), choices_(choices) {
    const std::size_t all = parameters.list.size();
    with_.resize(all);
    std::vector<std::size_t> chosen(std::min<std::size_t>(strength, all));
    std::iota(chosen.begin(), chosen.end(), 0U);
    do {
      add(chosen);
    } while (next_combination(chosen, all));
  }

  void make(CoveringArray& array) {
    while (std::optional<Row> begin = next_wanted()) {
      Row row = best_row(*begin);
      cover(row);
      array.rows.push_back(std::move(row));
    }
    for (const Combination& combination : combinations_) {
      for (const State state : combination.states) {
        if (state == State::covered) ++array.tuples;
        if (state == State::excluded) ++array.excluded;
      }
    }
  }

 private:
  static bool next_combination(std::vector<std::size_t>& chosen, std::size_t all) {
    for (std::size_t i = chosen.size(); i-- > 0;) {
      if (chosen[i] + chosen.size() - i >= all) continue;
      std::iota(chosen.begin() + static_cast<std::ptrdiff_t>(i), chosen.end(), chosen[i] + 1);
      return true;
    }
    return false;
  }

  void add(const std::vector<std::size_t>& chosen) {
    Combination combination{chosen, {}};
    std::size_t tuples = 1;
    for (const std::size_t p : chosen) tuples *= parameters_.list[p].classes.size();
    combination.states.resize(tuples);
    for (std::size_t t = 0; t < tuples; ++t) {
      combination.states[t] = state_of(tuple_row(combination, t), combination);
    }
    for (const std::size_t p : chosen) with_[p].push_back(combinations_.size());
    combinations_.push_back(std::move(combination));
  }

  State state_of(const Row& tuple, const Combination& combination) const {
    const auto faults = std::ranges::count_if(combination.parameters, [&](std::size_t p) {
      return parameters_.list[p].classes[tuple[p]].is_fault();
    });
    if (faults != (faulty_ ? 1 : 0)) return State::other;
    return space_.extends(tuple) ? State::wanted : State::excluded;
  }

  Row tuple_row(const Combination& combination, std::size_t tuple) const {
    Row row(parameters_.list.size(), kOpen);
    for (const std::size_t p : combination.parameters) {
      const std::size_t classes = parameters_.list[p].classes.size();
      row[p] = static_cast<std::uint8_t>(tuple % classes);
      tuple /= classes;
    }
    return row;
  }

  // Where the row's tuple stands; nothing while one of the parameters is open.
  std::optional<std::size_t> place(const Combination& combination, const Row& row) const {
    std::size_t tuple = 0;
    std::size_t base = 1;
    for (const std::size_t p : combination.parameters) {
      if (row[p] == kOpen) return std::nullopt;
      tuple += base * row[p];
      base *= parameters_.list[p].classes.size();
    }
    return tuple;
  }

  std::optional<Row> next_wanted() {
    for (; first_ < combinations_.size(); ++first_) {
      const std::vector<State>& states = combinations_[first_].states;
      const auto found = std::ranges::find(states, State::wanted);
      if (found == states.end()) continue;
      return tuple_row(combinations_[first_], static_cast<std::size_t>(found - states.begin()));
    }
    return std::nullopt;
  }

  // What the row covers newly of the combinations with this parameter.
  std::size_t gain(const Row& row, std::size_t parameter) const {
    std::size_t count = 0;
    for (const std::size_t c : with_[parameter]) {
      const std::optional<std::size_t> at = place(combinations_[c], row);
      count += at && combinations_[c].states[*at] == State::wanted ? 1U : 0U;
    }
    return count;
  }

  // The class of the parameter that covers most; of equal ones the first after a random one.
  void choose(Row& row, std::size_t parameter, std::size_t& total) {
    const std::size_t classes = parameters_.list[parameter].classes.size();
    const std::size_t turn = choices_.below(static_cast<std::uint32_t>(classes));
    std::uint8_t best = kOpen;
    std::size_t best_gain = 0;
    for (std::size_t i = 0; i < classes; ++i) {
      const auto c = static_cast<std::uint8_t>((i + turn) % classes);
      row[parameter] = c;
      const std::size_t gained = gain(row, parameter);
      if ((best != kOpen && gained <= best_gain) || !space_.extends(row)) continue;
      best = c;
      best_gain = gained;
    }
    row[parameter] = best;
    total += best_gain;
  }

  Row best_row(const Row& begin) {
    Row best;
    std::size_t best_total = 0;
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < begin.size(); ++p) {
      if (begin[p] == kOpen) order.push_back(p);
    }
    for (int attempt = 0; attempt < kRowsTried; ++attempt) {
      for (std::size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[choices_.below(static_cast<std::uint32_t>(i))]);
      }
      Row row = begin;
      std::size_t total = 1;
      for (const std::size_t p : order) choose(row, p, total);
      if (total > best_total) {
        best = std::move(row);
        best_total = total;
      }
    }
    return best;
  }

  void cover(const Row& row) {
    for (Combination& combination : combinations_) {
      State& state = combination.states[place(combination, row).value()];
      if (state == State::wanted) state = State::covered;
    }
  }

  const Parameters& parameters_;
  Space space_;
  bool faulty_;
  generate::Choices& choices_;
  std::vector<Combination> combinations_;
  std::vector<std::vector<std::size_t>> with_;  // the combinations that name a parameter
  std::size_t first_ = 0;                       // no combination before it has a wanted tuple
};

}  // namespace

CoveringArray covering_array(const Parameters& parameters, Strength strength, std::uint64_t seed) {
  CoveringArray array;
  generate::Choices choices(seed);
  ArrayMaker(parameters, false, strength.valid, choices).make(array);
  if (array.rows.empty()) throw ModelError("The rules leave no row without a fault.");
  ArrayMaker(parameters, true, strength.faulty, choices).make(array);
  return array;
}

}  // namespace gonogo::cover
