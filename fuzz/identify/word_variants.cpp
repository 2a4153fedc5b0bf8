// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes in reading a word: its sign, its unit, diameter for radius, one too many, not at all.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {

namespace {

// Words that are read alike, and where.
struct Scope {
  std::set<std::string> addresses;
  Motions motions = {};             // empty: under every code
  std::optional<Plane> plane = {};  // nothing: in every plane
  bool is_outside = false;          // in every plane but that

  bool has(const TextBlock& block, const TextWord& word) const {
    return addresses.contains(name_of(word)) &&
           (motions.empty() || motions.contains(block.modes.code_name())) &&
           (!plane || (block.modes.plane == *plane) != is_outside);
  }
  std::string where() const {
    if (!plane) return {};
    return fmt::format(" {} G{}", is_outside ? "outside" : "in", plane_code(*plane));
  }
  std::string name() const {
    std::string text = fmt::format("{}", fmt::join(addresses, " "));
    if (!motions.empty()) text += " of " + names_of(motions);
    return text + where();
  }
};

bool everywhere(const TextBlock&) {
  return true;
}

// Which words a mistake may be made with.
enum class Words : std::uint8_t {
  measured,  // all but numbers of times
  counted,   // numbers of times, of tools and of functions
  steps,     // those by which a cycle goes on again and again
  choices,   // of one of a few ways
};

// What becomes of the value; nothing: the word stays as it is.
struct Operation {
  std::string_view name;
  std::function<std::optional<Number>(const Number&)> value;
  bool (*where)(const TextBlock& block) = everywhere;
  std::string_view opposite = {};  // its name
  Words words = Words::measured;
};

bool under_inches(const TextBlock& block) {
  return block.modes.inch;
}

bool where_x_is_a_radius(const TextBlock& block) {
  return block.modes.x_radius;
}

// Also a parameter that is given before the block of its cycle.
bool is_a_choice(const Descriptor& table, const std::string& name) {
  return std::ranges::any_of(table.codes, [&](const Code& code) {
    const CodeWord* const word = code.find(name);
    return word != nullptr && word->role == Role::number;
  });
}

bool is_among(Words words, const TextBlock& block, const TextWord& word, const Descriptor& table) {
  const CodeWord* const known = block.role_of(word, table);
  if (known == nullptr) return words != Words::steps && words != Words::choices;
  const bool is_counted =
      known->role == Role::count || known->role == Role::turns || known->role == Role::number;
  switch (words) {
    case Words::measured:
      return !is_counted;
    case Words::counted:
      return is_counted;
    case Words::steps:
      return known->role == Role::step;
    case Words::choices:
      return is_a_choice(table, name_of(word));
  }
  return false;
}

const std::vector<Operation>& operations() {
  using Value = std::optional<Number>;
  static const std::vector<Operation> kOperations = {
      {"is taken with the other sign", [](const Number& v) -> Value { return -v; }},
      {"is taken without its sign", [](const Number& v) -> Value { return abs(v); }},
      {"is halved, a diameter for a radius", [](const Number& v) -> Value { return v / 2; },
       everywhere, "is doubled, a radius for a diameter"},
      {"is doubled, a radius for a diameter", [](const Number& v) -> Value { return v * 2; }},
      {"is not converted from inches", [](const Number& v) -> Value { return v * 5 / 127; },
       under_inches, "is converted from inches"},
      {"is converted from inches", [](const Number& v) -> Value { return v * 127 / 5; },
       under_inches},
      {"is taken as millimetres, not inches", [](const Number& v) -> Value { return v * 5 / 127; }},
      {"has no effect, as if it were without limit",
       [](const Number& v) -> Value { return v * 1'000'000; }},
      {"is halved where X is a radius", [](const Number& v) -> Value { return v / 2; },
       where_x_is_a_radius},
      {"has no effect: one step goes all the way",
       [](const Number& v) -> Value { return v * 1000; },
       everywhere,
       {},
       Words::steps},
      {"is 1000 times too large, milli for one", [](const Number& v) -> Value { return v * 1000; },
       everywhere, "is 1000 times too small, one for milli"},
      {"is 1000 times too small, one for milli", [](const Number& v) -> Value { return v / 1000; }},
      {"counts one too many", [](const Number& v) -> Value { return v + 1; }, everywhere,
       "counts one too few", Words::counted},
      {"counts one too few",
       [](const Number& v) { return v < 1 ? Value() : Value(v - 1); },
       everywhere,
       {},
       Words::counted},
      {"takes 2 for 3, and 3 for 2",
       [](const Number& v) { return v == 2 || v == 3 ? Value(5 - v) : Value(); },
       everywhere,
       {},
       Words::choices},
      {"loses its decimals",
       [](const Number& v) -> Value { return v.sign() < 0 ? v.ceil() : v.floor(); }},
      {"is rounded to hundredths", [](const Number& v) -> Value { return half_up(v, 2); }},
      {"is 1 % too large", [](const Number& v) -> Value { return v * 101 / 100; }},
  };
  return kOperations;
}

void add_operations(const Scope& scope, const Descriptor& table, Variants& out) {
  // The simplest goes first: what is ignored may be too small to matter as well.
  add_without(
      fmt::format("{} is ignored", scope.name()),
      [scope](const TextBlock& block, const TextWord& word) { return scope.has(block, word); },
      out);
  for (const Operation& operation : operations()) {
    add_edit(
        fmt::format("{} {}", scope.name(), operation.name),
        [scope, &operation, &table](const TextBlock& block,
                                    const TextWord& word) -> std::optional<std::string> {
          if (!scope.has(block, word) || !operation.where(block)) return std::nullopt;
          if (!is_among(operation.words, block, word, table)) return std::nullopt;
          const auto written = exact_value_of(word);
          const auto value = written ? operation.value(*written) : std::nullopt;
          if (!value) return std::nullopt;
          return with_value(word, *value);
        },
        out);
    if (!operation.opposite.empty()) {
      out.back().opposite = fmt::format("{} {}", scope.name(), operation.opposite);
    }
  }
  add_without(
      fmt::format("{} is ignored but under G91", scope.name()),
      [scope](const TextBlock& block, const TextWord& word) {
        return !block.modes.incremental && scope.has(block, word);
      },
      out);
}

// The word under another address, in the same form.
std::string renamed(const TextWord& word, const std::string& address) {
  return address + word.text.substr(name_of(word).size());
}

// Where they are what they are said to be: K is a centre beside an arc, and a lead beside a thread.
// No role: anywhere.
void add_exchange(const std::string& a, const std::string& b, const Scope& scope,
                  std::optional<Role> role, const Descriptor& table, Variants& out) {
  add_edit(
      fmt::format("{} and {} change places{}", a, b, scope.where()),
      [=, &table](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        if (!scope.has(block, word)) return std::nullopt;
        const CodeWord* const known = block.role_of(word, table);
        if (role && known != nullptr && known->role != *role) return std::nullopt;
        return renamed(word, name_of(word) == a ? b : a);
      },
      out);
}

using Addresses = std::set<std::string>;

// Addresses that stand in the program, except codes, spindle and tool.
Addresses addresses_of(const ProgramText& program) {
  Addresses addresses;
  for (const TextBlock& block : program.blocks) {
    for (const TextWord& word : block.words) {
      if (!is_word(word) || !block.code_of(word).empty()) continue;
      const CodeWord* const role = block.role_of(word, *program.table);
      const bool is_choice = block.modes.in_cycle() && block.modes.code()->find(name_of(word));
      const bool moves_nothing = role != nullptr && (role->role == Role::speed ||
                                                     (role->role == Role::number && !is_choice));
      if (!moves_nothing) addresses.insert(name_of(word));
    }
  }
  return addresses;
}

// What a cycle's own words are called where it is called by its name.
bool is_parameter_of_cycle(const Descriptor& table, const std::string& name) {
  return is_parameter(name) && std::ranges::any_of(table.codes, [&](const Code& code) {
           return code.kind == Kind::cycle && code.find(name) != nullptr;
         });
}

void add_exchanges(const Descriptor& table, const Addresses& addresses, Plane plane,
                   Variants& out) {
  const auto add_pair = [&](const std::string& a, const std::string& b, std::optional<Role> role) {
    add_exchange(a, b, {{a, b}}, role, table, out);
    add_exchange(a, b, {{a, b}, {}, plane}, role, table, out);
    if (plane != Plane::g17) add_exchange(a, b, {{a, b}, {}, Plane::g17, true}, role, table, out);
  };
  for (const Role role : {Role::place, Role::centre}) {
    const Addresses kin = addresses_with(table, {role});
    for (const std::string& a : kin) {
      for (const std::string& b : kin) {
        if (a < b && (addresses.contains(a) || addresses.contains(b))) add_pair(a, b, role);
      }
    }
  }
  for (const std::string& a : addresses) {
    for (const std::string& b : addresses) {
      if (a < b && is_parameter_of_cycle(table, a) && is_parameter_of_cycle(table, b)) {
        add_pair(a, b, std::nullopt);
      }
    }
  }
}

// The axis across the plane of an arc does not move.
void add_flat_arcs(Variants& out) {
  add_without(
      "the third axis of an arc is ignored",
      [](const TextBlock& block, const TextWord& word) {
        const char third = "XYZ"[index(axes_of(block.modes.plane).d)];
        return block.modes.is_of(Kind::arc) && name_of(word) == std::string(1, third);
      },
      out);
}

}  // namespace

void add_word_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  const Descriptor& table = *program.table;
  const Addresses addresses = addresses_of(program);
  const std::size_t line = departure.verdict.block;
  const bool known = line > 0 && line <= program.blocks.size();
  const Plane plane = known ? program.blocks[line - 1].modes.plane : Plane::g17;
  add_flat_arcs(out);
  std::vector<Addresses> sets;
  for (const std::string& address : addresses) sets.push_back({address});
  for (const Addresses& kin : kin_addresses(table)) {
    const auto present = std::ranges::count_if(
        kin, [&](const std::string& address) { return addresses.contains(address); });
    if (present > 1 && std::ranges::find(sets, kin) == sets.end()) sets.push_back(kin);
  }
  for (const Addresses& set : sets) {
    add_operations({set}, table, out);
    for (const Motions& motions : motions_concerned(departure)) {
      add_operations({set, motions}, table, out);
    }
    add_operations({set, {}, plane}, table, out);
  }
  add_exchanges(table, addresses, plane, out);
}

}  // namespace gonogo::identify
