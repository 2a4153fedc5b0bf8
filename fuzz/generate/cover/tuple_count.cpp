// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/tuple_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace gonogo::cover {
namespace {

// A parameter and one of its classes, by their numbers, in the order of the parameters.
using Tuple = std::vector<std::pair<std::size_t, std::size_t>>;

class Counter {
 public:
  explicit Counter(const Parameters& parameters) : parameters_(parameters) {}

  // Visits every tuple of `size` parameters.
  void for_each(std::size_t size, const std::function<void(const Tuple&)>& visit) const {
    Tuple tuple;
    visit_from(0, std::min(size, parameters_.list.size()), tuple, visit);
  }

  std::size_t faults(const Tuple& tuple) const {
    std::size_t count = 0;
    for (const auto& [p, c] : tuple) {
      if (!parameters_.list[p].classes[c].alarms.empty()) ++count;
    }
    return count;
  }

  bool is_unsaid(const Tuple& tuple) const {
    return std::ranges::any_of(tuple, [&](const auto& one) {
      return parameters_.list[one.first].classes[one.second].is_unsaid;
    });
  }

  // Whether some whole row holds the tuple, breaks no rule, and has as many faults as the tuple.
  bool possible(const Tuple& tuple) const {
    std::vector<std::size_t> row(parameters_.list.size(), kNone);
    for (const auto& [p, c] : tuple) row[p] = c;
    return keeps_rules(row) && fill(row, 0);
  }

  bool valid_row(const Row& row) const {
    Tuple all;
    for (std::size_t p = 0; p < row.size(); ++p) all.emplace_back(p, row[p]);
    return faults(all) <= 1 && possible(all);
  }

  std::string text(const Tuple& tuple) const {
    std::string out;
    for (const auto& [p, c] : tuple) {
      out += fmt::format("{}{}={}", out.empty() ? "" : " ", parameters_.list[p].name,
                         parameters_.list[p].classes[c].name);
    }
    return out;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void visit_from(std::size_t p, std::size_t left, Tuple& tuple,
                  const std::function<void(const Tuple&)>& visit) const {
    if (left == 0) return visit(tuple);
    for (; p + left <= parameters_.list.size(); ++p) {
      for (std::size_t c = 0; c < parameters_.list[p].classes.size(); ++c) {
        tuple.emplace_back(p, c);
        visit_from(p + 1, left - 1, tuple, visit);
        tuple.pop_back();
      }
    }
  }

  bool keeps_rules(const std::vector<std::size_t>& row) const {
    for (const Rule& rule : parameters_.rules) {
      std::size_t held = 0;
      for (const Rule::Member& member : rule.members) {
        const std::size_t c = row[member.parameter];
        if (c != kNone && member.classes[c]) ++held;
      }
      if (held == rule.members.size()) return false;
    }
    return true;
  }

  bool fill(std::vector<std::size_t>& row, std::size_t p) const {
    if (p == row.size()) return true;
    if (row[p] != kNone) return fill(row, p + 1);
    for (std::size_t c = 0; c < parameters_.list[p].classes.size(); ++c) {
      if (!parameters_.list[p].classes[c].alarms.empty()) continue;
      row[p] = c;
      if (keeps_rules(row) && fill(row, p + 1)) return true;
    }
    row[p] = kNone;
    return false;
  }

  const Parameters& parameters_;
};

// Every tuple that counts: valid classes alone, and one fault of a text with valid classes.
void for_each_counted(const Counter& counter, Strength strength,
                      const std::function<void(const Tuple&)>& visit) {
  counter.for_each(strength.valid, [&](const Tuple& tuple) {
    if (counter.faults(tuple) == 0) visit(tuple);
  });
  counter.for_each(strength.faulty, [&](const Tuple& tuple) {
    if (counter.faults(tuple) == 1 && !counter.is_unsaid(tuple)) visit(tuple);
  });
}

// A row with a fault shows only the tuples that hold the fault.
bool holds(const Counter& counter, const Row& row, std::size_t faults_of_row, const Tuple& tuple) {
  return faults_of_row == counter.faults(tuple) &&
         std::ranges::all_of(tuple, [&](const auto& one) { return row[one.first] == one.second; });
}

std::size_t faults_of(const Counter& counter, const Row& row) {
  Tuple all;
  for (std::size_t p = 0; p < row.size(); ++p) all.emplace_back(p, row[p]);
  return counter.faults(all);
}

}  // namespace

TupleCount count_tuples(const Parameters& parameters, Strength strength,
                        const std::vector<Row>& rows) {
  const Counter counter(parameters);
  TupleCount count;
  std::vector<std::size_t> faults;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    faults.push_back(faults_of(counter, rows[i]));
    if (!counter.valid_row(rows[i])) count.invalid.push_back(fmt::format("row {}", i + 1));
  }
  for_each_counted(counter, strength, [&](const Tuple& tuple) {
    if (!counter.possible(tuple)) {
      ++count.excluded;
      return;
    }
    ++count.allowed;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!holds(counter, rows[i], faults[i], tuple)) continue;
      ++count.covered;
      return;
    }
    count.missing.push_back(counter.text(tuple));
  });
  return count;
}

std::vector<std::string> tuples_of(const Parameters& parameters, Strength strength,
                                   const Row& row) {
  const Counter counter(parameters);
  std::vector<std::string> tuples;
  const std::size_t faults = faults_of(counter, row);
  // A row is tried with its own classes only.
  const std::size_t size =
      std::min<std::size_t>(faults == 0 ? strength.valid : strength.faulty, row.size());
  std::vector<bool> chosen(row.size());
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(size), true);
  do {
    Tuple tuple;
    for (std::size_t p = 0; p < row.size(); ++p) {
      if (chosen[p]) tuple.emplace_back(p, row[p]);
    }
    if (counter.faults(tuple) == faults) tuples.push_back(counter.text(tuple));
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return tuples;
}

}  // namespace gonogo::cover
