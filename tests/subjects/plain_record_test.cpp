// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter for plain records gives what the JSON reader gives, and gives way to it where it does
// not know better. GONOGO_TRIALS says how many lines are tried.
#include "oracle/records/plain_record.hpp"

#include <gtest/gtest.h>

#include "oracle/records/record_json.hpp"
#include "tests/trials.hpp"

namespace gonogo::oracle {
namespace {

using reference::Position;
using reference::Record;

constexpr std::string_view kNumbers[] = {"\"0\"",
                                         "\"-0\"",
                                         "\"12.5\"",
                                         "\"-40\"",
                                         "\"+3\"",
                                         "\"11/3\"",
                                         "\"1e3\"",
                                         "\"1e-9\"",
                                         "\"0x1p-3\"",
                                         "\"\"",
                                         "\".5\"",
                                         "\"5.\"",
                                         "\".\"",
                                         "\"-\"",
                                         "\"1.2.3\"",
                                         "\"9223372036854.775807\"",
                                         "\"9223372036854.775808\"",
                                         "\"0.0000001\"",
                                         "\"123456789012345678901\"",
                                         "\"1 \"",
                                         "\"a\"",
                                         "5",
                                         "-1",
                                         "null",
                                         "{\"root\":[\"1\",\"2\",\"3\"]}",
                                         "{\"enclosure\":[\"1\",\"1\"]}",
                                         "\"1\\u0030\"",
                                         "\"\\\"\""};
constexpr std::string_view kIntegers[] = {"1",
                                          "-1",
                                          "0",
                                          "-0",
                                          "7",
                                          "01",
                                          "1.0",
                                          "2",
                                          "1e0",
                                          "\"1\"",
                                          "-",
                                          "+1",
                                          "2147483647",
                                          "3",
                                          "2147483648",
                                          "999999999999999999",
                                          "1000000000000000000",
                                          "99999999999999999999"};
constexpr std::string_view kKinds[] = {"rapid", "feed", "arc", "arc3",  "thread",
                                       "dwell", "m",    "end", "alarm", "plunge"};
constexpr std::string_view kKeyTexts[] = {"k", "b",     "to",     "f",    "fm",    "plane",
                                          "c", "rot",   "via",    "lead", "start", "s",
                                          "m", "class", "clause", "x-a"};
constexpr std::string_view kPieces[] = {" ",       "\t",       "\"",   "{",  "}", ":",
                                        ",",       "[",        "]",    "\\", "1", "\"b\":1,",
                                        "\"m\":2", "\xC3\xA9", "\x7F", "\n"};

std::string axes(Chance& chance, std::string_view letters) {
  std::string text = "{";
  for (const char letter : letters) {
    if (text.size() > 1) text += ',';
    text += std::string("\"") + letter + "\":" + std::string(chance.one_of(kNumbers));
  }
  return text + "}";
}

std::string any_value(std::string_view key, Chance& chance) {
  if (key == "k") return '"' + std::string(chance.one_of(kKinds)) + '"';
  if (key == "to" || key == "via") {
    return axes(chance, chance.one_of({"xy", "z", "xyz", "zx", "yz", "", "xx", "q", "xyzac"}));
  }
  if (key == "c") return axes(chance, chance.one_of({"xy", "zx", "xz", "yz", "x", "xyz"}));
  if (key == "b" || key == "rot" || key == "m") return std::string(chance.one_of(kIntegers));
  if (key == "plane") {
    return std::string(chance.one_of({"\"G17\"", "\"G18\"", "\"G19\"", "\"G16\"", "\"G1\""}));
  }
  if (key == "fm") return std::string(chance.one_of({"\"min\"", "\"rev\"", "\"max\""}));
  if (key == "class" || key == "clause" || key == "x-a") {
    return std::string(chance.one_of({"\"GSK-G94-02\"", "7", "{\"a\":1}", "\"\\n\"", "\"\""}));
  }
  return std::string(chance.one_of(kNumbers));
}

// The keys of one kind, or any keys.
std::string any_line(Chance& chance) {
  static constexpr std::string_view kUsual[][7] = {{"k", "b", "to"},
                                                   {"k", "b", "to", "f", "clause"},
                                                   {"k", "b", "to", "f", "fm"},
                                                   {"k", "b", "plane", "c", "rot", "to", "f"},
                                                   {"k", "b", "to", "lead", "start"},
                                                   {"k", "b", "s"},
                                                   {"k", "b", "m"}};
  static constexpr std::string_view kOfUsual[] = {"rapid",  "feed",  "feed", "arc",
                                                  "thread", "dwell", "m"};
  const std::size_t kind = chance.below(std::size(kUsual));
  std::string text = "{";
  for (std::string_view key : kUsual[kind]) {
    if (chance.once_in(40)) key = chance.one_of(kKeyTexts);
    if (key.empty()) continue;
    if (text.size() > 1) text += chance.once_in(9) ? ", " : ",";
    const bool own_kind = key == "k" && !chance.once_in(10);
    text += '"' + std::string(key) + (chance.once_in(9) ? "\" : " : "\":") +
            (own_kind ? '"' + std::string(kOfUsual[kind]) + '"' : any_value(key, chance));
  }
  text += "}";
  if (chance.once_in(3)) {
    const std::size_t at = chance.below(text.size() + 1);
    text.replace(at, std::min(chance.below(3), text.size() - at), chance.one_of(kPieces));
  }
  return text;
}

bool same(const Position& a, const Position& b) {
  return a == b;
}

bool same(const Record& a, const Record& b) {
  return a.kind == b.kind && a.feed_mode == b.feed_mode && a.plane == b.plane && a.axes == b.axes &&
         a.rot == b.rot && a.m == b.m && a.before_cut == b.before_cut && a.block == b.block &&
         a.clause == b.clause && same(a.to, b.to) && a.feed == b.feed && a.centre == b.centre &&
         a.lead == b.lead && a.start == b.start && a.seconds == b.seconds &&
         a.via_axes == b.via_axes && same(a.via, b.via);
}

TEST(PlainRecord, IsWhatTheJsonReaderGives) {
  constexpr long kTrials = 200'000;
  JsonDocument document;
  long plain = 0;
  each_trial(kTrials, [&](Chance& chance) {
    const std::string line = any_line(chance);
    Record got;
    if (!read_plain_record(line, got)) return;
    ++plain;
    auto parsed = document.parse(line);
    auto* object = std::get_if<simdjson::dom::object>(&parsed);
    ASSERT_NE(object, nullptr) << line << " is no JSON object";
    const TraceLine want = read_trace_line(*object);
    auto* record = std::get_if<Record>(&want);
    ASSERT_NE(record, nullptr) << line << " is no record";
    ASSERT_TRUE(same(got, *record)) << line;
  });
  EXPECT_GT(plain, trial_count(kTrials) / 100);  // there was something to compare
  EXPECT_LT(plain, trial_count(kTrials));
}

TEST(PlainRecord, IsWhatTheReferenceWrites) {
  for (
      const std::string_view line :
      {R"({"k":"feed","b":5,"to":{"x":"54","z":"-30"},"f":"300","clause":"GSK-G94-03"})",
       R"({"k":"rapid","b":5,"to":{"z":"-40.125"}})",
       R"({"k":"m","b":7,"m":30,"clause":"GSK-COM-01"})",
       R"({"k":"arc","b":3,"plane":"G18","c":{"z":"1","x":"2"},"rot":-1,"to":{"x":"2","z":"3"},"f":"9","fm":"rev"})"}) {
    Record record;
    EXPECT_TRUE(read_plain_record(line, record)) << line;
  }
}

TEST(PlainRecord, LeavesKeysThatStandTwiceToTheReaderThatSaysSo) {
  for (const std::string_view line :
       {R"({"k":"dwell","s":"1","s":"1"})", R"({"k":"end","to":{"x":"1","x":"1"}})",
        R"({"k":"m","m":3,"clause":"a","clause":"a"})", R"({"k":"m","k":"m","m":3})"}) {
    Record record;
    EXPECT_FALSE(read_plain_record(line, record)) << line;
  }
}

}  // namespace
}  // namespace gonogo::oracle
