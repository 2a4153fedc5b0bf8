// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes in reading a word: its sign, its unit, diameter for radius, one too many, not at all.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {

using reference::Number;

namespace {

// Words that are read alike, and where.
struct Scope {
  std::set<std::string> addresses;
  Motions motions = {};  // empty: under every code
  int plane = 0;         // 0: in every plane

  bool has(const TextBlock& block, const TextWord& word) const {
    return addresses.contains(word.address) &&
           (motions.empty() || motions.contains(block.motion)) &&
           (plane == 0 || block.plane == plane);
  }
  std::string name() const {
    std::string text;
    for (const std::string& address : addresses) {
      text += fmt::format("{}{}", text.empty() ? "" : " ", address);
    }
    if (!motions.empty()) text += " of " + names_of(motions);
    if (plane != 0) text += fmt::format(" in G{}", plane);
    return text;
  }
};

// What becomes of the value; nothing: the word stays as it is.
struct Operation {
  std::string_view name;
  std::function<std::optional<Number>(const Number&)> value;
  bool (*where)(const TextBlock& block) = [](const TextBlock&) { return true; };
};

bool under_inches(const TextBlock& block) {
  return block.inch;
}

bool where_x_is_a_radius(const TextBlock& block) {
  return block.x_radius;
}

Number half_up(const Number& value, int places) {
  return Number::parse(value.decimal_text(places)).value();
}

const std::vector<Operation>& operations() {
  using Value = std::optional<Number>;
  static const std::vector<Operation> kOperations = {
      {"is taken with the other sign", [](const Number& v) -> Value { return -v; }},
      {"is taken without its sign", [](const Number& v) -> Value { return abs(v); }},
      {"is halved, a diameter for a radius", [](const Number& v) -> Value { return v / 2; }},
      {"is doubled, a radius for a diameter", [](const Number& v) -> Value { return v * 2; }},
      {"is not converted from inches", [](const Number& v) -> Value { return v * 5 / 127; },
       under_inches},
      {"is converted from inches", [](const Number& v) -> Value { return v * 127 / 5; },
       under_inches},
      {"is taken as millimetres, not inches", [](const Number& v) -> Value { return v * 5 / 127; }},
      {"is halved where X is a radius", [](const Number& v) -> Value { return v / 2; },
       where_x_is_a_radius},
      {"is 1000 times too large, milli for one", [](const Number& v) -> Value { return v * 1000; }},
      {"is 1000 times too small, one for milli", [](const Number& v) -> Value { return v / 1000; }},
      {"counts one too many", [](const Number& v) -> Value { return v + 1; }},
      {"counts one too few", [](const Number& v) -> Value { return v - 1; }},
      {"loses its decimals",
       [](const Number& v) -> Value { return v.sign() < 0 ? v.ceil() : v.floor(); }},
      {"is rounded to hundredths", [](const Number& v) -> Value { return half_up(v, 2); }},
      {"is 1 % too large", [](const Number& v) -> Value { return v * 101 / 100; }},
  };
  return kOperations;
}

void add_edit(std::string name, WordEdit edit, Variants& out) {
  out.push_back(
      {std::move(name), [edit = std::move(edit)](const Observation& seen) -> std::optional<Trial> {
         auto text = edited(ProgramText(seen.profile, seen.program), edit);
         if (!text) return std::nullopt;
         return Trial{std::move(*text), seen.profile, seen.outcome, std::nullopt};
       }});
}

void add_operations(const Scope& scope, Variants& out) {
  for (const Operation& operation : operations()) {
    add_edit(
        fmt::format("{} {}", scope.name(), operation.name),
        [scope, &operation](const TextBlock& block,
                            const TextWord& word) -> std::optional<std::string> {
          if (!word.value || !scope.has(block, word)) return std::nullopt;
          if (!operation.where(block)) return std::nullopt;
          const auto value = operation.value(*word.value);
          if (!value) return std::nullopt;
          return with_value(block, word, *value);
        },
        out);
  }
  add_edit(
      fmt::format("{} is ignored but under G91", scope.name()),
      [scope](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        if (block.incremental || !scope.has(block, word)) return std::nullopt;
        return "";
      },
      out);
  add_edit(
      fmt::format("{} is ignored", scope.name()),
      [scope](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        if (!scope.has(block, word)) return std::nullopt;
        return "";
      },
      out);
}

// The word under another address, in the same form.
std::string renamed(const TextBlock& block, const TextWord& word, const std::string& address) {
  const std::string text = block.text.substr(word.where.begin, word.where.end - word.where.begin);
  return address + text.substr(std::min(word.address.size(), text.size()));
}

void add_exchange(const std::string& a, const std::string& b, int plane, Variants& out) {
  const Scope scope{{a, b}, {}, plane};
  add_edit(
      fmt::format("{} and {} change places{}", a, b,
                  plane == 0 ? "" : fmt::format(" in G{}", plane)),
      [=](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        if (!scope.has(block, word)) return std::nullopt;
        return renamed(block, word, word.address == a ? b : a);
      },
      out);
}

// Addresses that stand in the program, codes apart.
std::set<std::string> addresses_of(const ProgramText& program) {
  std::set<std::string> addresses;
  for (const TextBlock& block : program.blocks) {
    for (const TextWord& word : block.words) {
      if (!word.is_code() && word.address != "T" && word.address != "S") {
        addresses.insert(word.address);
      }
    }
  }
  return addresses;
}

void add_exchanges(const std::set<std::string>& addresses, int plane, Variants& out) {
  const std::set<std::string> axes = {"X", "Y", "Z"};
  const std::set<std::string> centres = {"I", "J", "K"};
  for (const std::set<std::string>& kin : {axes, centres}) {
    for (const std::string& a : kin) {
      for (const std::string& b : kin) {
        if (a >= b || (!addresses.contains(a) && !addresses.contains(b))) continue;
        add_exchange(a, b, 0, out);
        add_exchange(a, b, plane, out);
      }
    }
  }
  for (const std::string& a : addresses) {
    for (const std::string& b : addresses) {
      const bool numbered = a.size() > 2 && b.size() > 2 && a[0] == 'R' && b[0] == 'R';
      if (a >= b || !numbered) continue;
      add_exchange(a, b, 0, out);
      add_exchange(a, b, plane, out);
    }
  }
}

// X=AC(10) read as X=10, as the mode in force says; or as the other of the two.
void add_brackets(Variants& out) {
  for (const std::string_view name : {"AC", "IC"}) {
    for (const std::string_view instead : {"", "AC", "IC"}) {
      if (name == instead) continue;
      add_edit(
          instead.empty() ? fmt::format("{} is ignored", name)
                          : fmt::format("{} does what {} does", name, instead),
          [=](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
            std::string text =
                block.text.substr(word.where.begin, word.where.end - word.where.begin);
            const std::size_t at = text.find(fmt::format("{}(", name));
            if (at == std::string::npos) return std::nullopt;
            return text.replace(at, name.size(), instead);
          },
          out);
    }
  }
}

// The axis across the plane of an arc does not move.
void add_flat_arcs(Variants& out) {
  add_edit(
      "the third axis of an arc is ignored",
      [](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        constexpr std::string_view kThird = "ZYX";  // of G17, G18, G19
        const bool arc = block.motion == "G2" || block.motion == "G3";
        const auto plane = static_cast<std::size_t>(block.plane - 17);
        if (!arc || plane > 2 || word.address != kThird.substr(plane, 1)) return std::nullopt;
        return "";
      },
      out);
}

}  // namespace

void add_word_variants(const Observation& departure, Variants& out) {
  const ProgramText program(departure.profile, departure.program);
  const std::set<std::string> addresses = addresses_of(program);
  const std::size_t line = departure.verdict.block;
  const bool known = line > 0 && line <= program.blocks.size();
  const int plane = known ? program.blocks[line - 1].plane : 17;
  std::vector<std::set<std::string>> sets;
  for (const std::string& address : addresses) sets.push_back({address});
  for (const std::set<std::string>& kin : {std::set<std::string>{"I", "J", "K"},
                                           {"I", "J", "K", "CR"},
                                           {"A", "C"},
                                           {"R", "Q"},
                                           {"U", "W"},
                                           {"X", "Y", "Z"}}) {
    std::size_t present = 0;
    for (const std::string& address : kin) present += addresses.count(address);
    if (present > 1) sets.push_back(kin);
  }
  for (const std::set<std::string>& set : sets) {
    add_operations({set}, out);
    for (const Motions& motions : motions_concerned(departure)) {
      add_operations({set, motions, 0}, out);
    }
    add_operations({set, {}, plane}, out);
  }
  add_exchanges(addresses, plane, out);
  add_flat_arcs(out);
  if (departure.profile.dialect.starts_with("sinumerik")) add_brackets(out);
}

}  // namespace gonogo::identify
