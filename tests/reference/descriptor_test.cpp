// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of codes and words against what the interpreters do.
#include "reference/descriptor.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "word_bench.hpp"

namespace gonogo::reference::testing {
namespace {

std::string name_of(char letter, int tenths) {
  return tenths % 10 == 0 ? fmt::format("{}{}", letter, tenths / 10)
                          : fmt::format("{}{}.{}", letter, tenths / 10, tenths % 10);
}

// "read" also of a code that is refused by its place.
std::string treated(const Dialect& dialect, const std::string& program) {
  const Said said = said_of(program, bench_profile(dialect));
  if (said.alarm && said.alarm->alarm == AlarmClass::undefined_code) return "undefined";
  // G43 alone is read where a tool is loaded.
  const bool lacks_tool =
      said.not_covered && said.not_covered->message.find("tool changer") != std::string::npos;
  return said.not_covered && !lacks_tool ? "outside" : "read";
}

std::string described(const Dialect& dialect, const std::string& name) {
  const Code* const code = dialect.descriptor->find(name);
  if (code == nullptr) return "undefined";
  return code->treatment == Treatment::outside ? "outside" : "read";
}

TEST(Descriptor, HasEveryGCodeThatTheInterpreterKnows) {
  constexpr int kLast = 10'000;
  for (const Dialect& dialect : dialects()) {
    for (int tenths = 0; tenths < kLast; ++tenths) {
      const std::string name = name_of('G', tenths);
      ASSERT_EQ(treated(dialect, name + "\n"), described(dialect, name)) << dialect.name << name;
    }
  }
}

// A pattern of cases read 600000000 out of a name; ten times that is no int.
TEST(Descriptor, ANameWithMoreDigitsThanAnyCodeIsNone) {
  for (const char* const name : {"G600000000", "G6000000000000000000000", "M600000000.5"}) {
    EXPECT_EQ(tenths_of_name(name), -1) << name;
    for (const Dialect& dialect : dialects()) {
      EXPECT_EQ(dialect.descriptor->find(name), nullptr) << dialect.name << name;
    }
  }
  EXPECT_EQ(tenths_of_name("G00000081"), 810);
}

TEST(Descriptor, HasEveryNameThatTheInterpreterKnows) {
  for (const Dialect& dialect : dialects()) {
    for (const Code& code : dialect.descriptor->codes) {
      // An address is none without a value, and patterns stand for what the table does not list.
      if (code.tenths >= 0 || code.name.size() == 1 || code.name.ends_with("<n>")) continue;
      const std::string name(code.name);
      EXPECT_EQ(treated(dialect, name + "\n"), described(dialect, name)) << dialect.name << name;
    }
  }
  EXPECT_EQ(described(*find_dialect("sinumerik840d"), "CYCLE81"), "outside");
  EXPECT_EQ(described(*find_dialect("sinumerik840d"), "LCYC75"), "outside");
  EXPECT_EQ(described(*find_dialect("sinumerik802s"), "LCYC75"), "read");
}

// What a block with the function puts out beside its motion: nothing where the program ends there,
// the function before the motion or behind it.
Kind kind_of_m(const Dialect& dialect, const std::string& name) {
  const Profile profile = bench_profile(dialect);
  // M61 to M68 of RS274/NGC need a word (NGC-COM-09).
  const bool has_tool = dialect.name == "rs274" && name == "M61";
  const bool has_signal =
      dialect.name == "rs274" && name.starts_with("M6") && name.size() == 3 && name >= "M62";
  const char* const word = has_tool ? " Q0" : !has_signal ? "" : name >= "M67" ? " E0" : " P0";
  const Said said = said_of("G0 X1 " + name + word + "\nG0 X2\n", profile);
  if (said.records.find("\"to\":{\"x\":\"2\"") == std::string::npos &&
      said.records.find("\"b\":2") == std::string::npos) {
    return Kind::program_end;
  }
  const std::size_t motion = said.records.find("\"k\":\"rapid\"");
  const std::size_t function = said.records.find("\"k\":\"m\"");
  return function < motion ? Kind::machine : Kind::stop;
}

TEST(Descriptor, SaysWhenEveryMFunctionActs) {
  for (const Dialect& dialect : dialects()) {
    for (const Code& code : dialect.descriptor->codes) {
      if (!code.is_m()) continue;
      const std::string name(code.name);
      // They need an M70 before them, or a subprogram: NgcModes and NgcOWords have them.
      if (dialect.name == "rs274" && (name == "M72" || name == "M98" || name == "M99")) continue;
      if (code.treatment == Treatment::outside) {
        EXPECT_EQ(treated(dialect, name + "\n"), "outside") << dialect.name << name;
      } else {
        EXPECT_EQ(kind_of_m(dialect, name), code.kind) << dialect.name << name;
      }
    }
  }
}

// Where the table has no row of an M function, it is passed on before the motion, or undefined.
TEST(Descriptor, HasEveryMFunctionThatIsSpecial) {
  for (const Dialect& dialect : dialects()) {
    const bool is_rs274 = dialect.name == "rs274";
    for (int number = 0; number < 1000; ++number) {
      const std::string name = name_of('M', number * 10);
      if (dialect.descriptor->find(name) != nullptr) continue;
      if (dialect.name == "sinumerik802s" && number > 99) continue;
      if (is_rs274) {
        EXPECT_EQ(treated(dialect, name + "\n"), "undefined") << name;
      } else {
        EXPECT_EQ(kind_of_m(dialect, name), Kind::machine) << dialect.name << name;
      }
    }
  }
}

// G codes by their numbers, then names in the order of their bytes, then M functions.
TEST(Descriptor, StandsInItsOrder) {
  const auto place = [](const Code& code) {
    return std::tuple(code.is_m()   ? 2
                      : code.is_g() ? 0
                                    : 1,
                      code.tenths, code.tenths < 0 ? code.name : std::string_view());
  };
  for (const Dialect& dialect : dialects()) {
    const auto codes = dialect.descriptor->codes;
    for (std::size_t i = 1; i < codes.size(); ++i) {
      EXPECT_LT(place(codes[i - 1]), place(codes[i])) << dialect.name << " " << codes[i].name;
    }
  }
}

TEST(Descriptor, NamesEveryFeatureAndNoOther) {
  for (const Dialect& dialect : dialects()) {
    const Descriptor& table = *dialect.descriptor;
    std::set<std::string_view> named = {"basic"};
    const auto take = [&](const CodeWord& word) {
      if (!word.feature.empty()) named.insert(word.feature);
    };
    for (const Code& code : table.codes) {
      named.insert(code.feature);
      for (const UseFeature& rule : code.uses) named.insert(rule.feature);
      for (const auto& list : code.words) std::ranges::for_each(list, take);
    }
    std::ranges::for_each(table.everywhere, take);
    std::set<std::string_view> known;
    for (const DialectFeature& feature : table.features) {
      EXPECT_FALSE(feature.text.empty()) << feature.name;
      EXPECT_TRUE(known.insert(feature.name).second) << feature.name;
      EXPECT_EQ(named.contains(feature.name), !feature.is_of_text) << feature.name;
    }
    for (const std::string_view name : named) EXPECT_TRUE(known.contains(name)) << name;
  }
}

TEST(Descriptor, RestsOnClausesOfItsOwnDialect) {
  for (const Dialect& dialect : dialects()) {
    const std::string_view maker = dialect.clauses.front().id.substr(0, 4);
    for (const Code& code : dialect.descriptor->codes) {
      const bool acts =
          code.treatment == Treatment::read && !code.is_m() && code.kind != Kind::mode;
      EXPECT_FALSE(code.title.empty()) << code.name;
      EXPECT_EQ(code.clause != kNoClause, acts) << dialect.name << " " << code.name;
      if (acts) {
        EXPECT_TRUE(clause_name(code.clause).starts_with(maker)) << code.name;
      }
    }
  }
}

// The senses of a code and of the other one of its pair.
TEST(Descriptor, PairsTheSenses) {
  for (const Dialect& dialect : dialects()) {
    for (const Code& code : dialect.descriptor->codes) {
      const Code* const other = opposite_of(*dialect.descriptor, code);
      EXPECT_EQ(other != nullptr, code.sense != 0) << code.name;
      if (other == nullptr) continue;
      EXPECT_EQ(opposite_of(*dialect.descriptor, *other), &code);
      EXPECT_EQ(other->sense, -code.sense);
      EXPECT_EQ(other->feature, code.feature);
    }
  }
  const Descriptor& gsk = *find_dialect("gsk988ta")->descriptor;
  EXPECT_EQ(opposite_of(gsk, *gsk.find("G2"))->name, "G3");
  EXPECT_EQ(opposite_of(gsk, *gsk.find("G116"))->name, "G117");
}

// A word of a cycle that stays in force is the same when it is left out of the next block of the
// cycle; one that holds for its block is missing there, or another way follows.
TEST(Descriptor, SaysWhichWordsOfACycleStayInForce) {
  for (const Dialect& dialect : dialects()) {
    const Profile profile = bench_profile(dialect);
    for (const Code* code : codes_with_words(dialect)) {
      if (code->kind != Kind::cycle) continue;
      const Bench bench = bench_of(dialect, *code);
      for (const auto& [address, value] : bench.words) {
        const CodeWord* const word = code->find(address);
        if (word == nullptr) continue;
        // The next block of the cycle, from where the first one ended.
        std::string with;
        std::string without;
        for (const auto& [other, its_value] : bench.words) {
          const std::string text = " " + other + its_value;
          with += text;
          if (other != address) without += text;
        }
        const std::string first = bench.before + "\n" + std::string(code->name) + with + "\n";
        const bool is_same = said_of(first + "G04 P1\n" + with + "\n", profile) ==
                             said_of(first + "G04 P1\n" + without + "\n", profile);
        EXPECT_EQ(is_same, word->life == Life::modal)
            << dialect.name << " " << code->name << " " << address;
      }
    }
  }
}

// In RS274 words beside an M function are its own, or nobody's.
TEST(Descriptor, HasTheWordsOfMFunctions) {
  const Dialect& rs274 = *find_dialect("rs274");
  for (const Code& code : rs274.descriptor->codes) {
    if (!code.is_m() || code.treatment == Treatment::outside) continue;
    for (const char letter : std::string_view("DEHIJKLPQR")) {
      const std::string block = fmt::format("M70\n{} {}1", code.name, letter);
      const Said said = said_of(block + "\nM2\n", bench_profile(rs274));
      const bool unused = said.alarm && said.alarm->alarm == AlarmClass::unused_word;
      // NGC-OWD-13: no text says what they do beside other words.
      const bool is_call = code.name == "M98" || code.name == "M99";
      const bool is_left_out = is_call && letter != 'P' && letter != 'L';
      EXPECT_EQ(unused, !is_left_out && !code.takes(letter)) << block;
      EXPECT_TRUE(!is_left_out || said.not_covered) << block;
    }
  }
}

// The parameters that a cycle of the 802S looks at: another value, and it does something else.
TEST(Descriptor, HasTheParametersOfCycles) {
  const Dialect& dialect = *find_dialect("sinumerik802s");
  Profile profile = bench_profile(dialect);
  profile.tools["1"].radius = Number(5);
  const std::string before =
      "G17 G90 T1 D1 S100 M3 F100 G0 X0 Y0 Z30\nR101=5 R102=2 R103=0 R104=-8 R105=1\n"
      "R116=3 R117=4 R118=40 R119=24 R120=6 R121=3 R122=50 R123=90 R124=1 R125=0.5 R126=2 R127=1\n";
  for (const std::string_view name : {"LCYC75", "LCYC82"}) {
    const Code& code = *dialect.descriptor->find(name);
    const auto said = [&](const std::string& change) {
      return said_of(before + change + "\n" + std::string(name) + "\n", profile);
    };
    ASSERT_EQ(said("").ending(), "end") << name;
    for (int number = 0; number < 250; ++number) {
      const std::string address = fmt::format("R{}", number);
      const bool looks = !(said(address + "=-77.5") == said(""));
      EXPECT_EQ(looks, code.find(address) != nullptr) << name << " " << address;
    }
  }
}

}  // namespace
}  // namespace gonogo::reference::testing
