// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a corpus that cannot be read is told: file, place and what is wrong.
#include <gtest/gtest.h>

#include "corpus_testing.hpp"
#include "tests/has.hpp"

namespace gonogo::testing {
namespace {

constexpr std::string_view kGoodVectorFile =
    R"({"format":1,"corpus":"2026.1.0","dialect":"gsk988ta",
"cycle":"g94","groups":[{"gid":"t.a","features":["g94"],"clauses":["GSK-G94-01"],"profile":{},
"cases":[{"id":"t.a.000001","comment":"one","program":"G00 X2\n",
"expect":[{"records":[{"k":"rapid","b":1,"to":{"x":"1"},"clause":"GSK-COM-05"},
{"k":"end","to":{"x":"1"}}]}],
"tags":{"tway":[],"sign":[]},"provenance":"hand"}]}]})";

// kGoodVectorFile with one text in place of another.
std::string broken(std::string_view from, std::string_view to) {
  std::string text(kGoodVectorFile);
  const std::size_t place = text.find(from);
  if (place == std::string::npos) ADD_FAILURE() << from;
  return text.replace(place, from.size(), to);
}

std::string vector_file_error(const std::string& text) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("bad.json", text);
  const std::string message = corpus_error([&] { oracle::read_vector_file(file); });
  EXPECT_TRUE(message.starts_with(file)) << message;
  return message.substr(std::min(file.size(), message.size()));
}

TEST(Loader, ReadsAGoodFile) {
  const ScratchFolder scratch;
  const auto cases = oracle::read_vector_file(scratch.write("good.json", kGoodVectorFile));
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_EQ(cases[0].id, "t.a.000001");
  EXPECT_EQ(cases[0].program, "G00 X2\n");
  EXPECT_EQ(cases[0].group, "t.a");
  ASSERT_EQ(cases[0].expect.size(), 1U);
  ASSERT_EQ(cases[0].expect[0].records.size(), 2U);
  EXPECT_EQ(cases[0].expect[0].records[0].to[reference::Axis::x], reference::Number(1));
  EXPECT_EQ(reference::clause_name(cases[0].expect[0].records[0].clause), "GSK-COM-05");
}

TEST(Loader, AnotherFormat) {
  EXPECT_EQ(vector_file_error(broken("\"format\":1", "\"format\":3")),
            ": at /format: This program reads vector files of format 1 and 2, not 3.");
}

TEST(Loader, NoJson) {
  EXPECT_GT(vector_file_error("{\"format\":").size(), 5U);
}

TEST(Loader, AKeyTwice) {
  EXPECT_TRUE(
      has(vector_file_error(broken("\"cycle\":\"g94\"", "\"cycle\":\"g94\",\"cycle\":\"g94\"")),
          "cycle"));
}

TEST(Loader, AMissingKey) {
  EXPECT_EQ(vector_file_error(broken("\"comment\":\"one\",", "")),
            ": at /groups/0/cases/0: The key \"comment\" is missing.");
}

TEST(Loader, AnUnknownKey) {
  EXPECT_EQ(vector_file_error(broken("\"comment\"", "\"x/y\":1,\"comment\"")),
            ": at /groups/0/cases/0/x~1y: There is no such key in the format.");
}

TEST(Loader, AnUnknownClause) {
  EXPECT_EQ(vector_file_error(broken("GSK-G94-01", "GSK-G94-99")),
            ": at /groups/0/clauses/0: There is no clause GSK-G94-99.");
  EXPECT_EQ(vector_file_error(broken("GSK-COM-05", "GSK-COM-99")),
            ": at /groups/0/cases/0/expect/0/records/0/clause: There is no clause GSK-COM-99.");
}

TEST(Loader, ABareNumber) {
  EXPECT_TRUE(vector_file_error(broken("{\"x\":\"1\"},\"cl", "{\"x\":1},\"cl"))
                  .starts_with(": at /groups/0/cases/0/expect/0/records/0: "));
}

TEST(Loader, ATextThatIsNoNumber) {
  EXPECT_TRUE(vector_file_error(broken("{\"x\":\"1\"},\"cl", "{\"x\":\"1.2.3\"},\"cl"))
                  .starts_with(": at /groups/0/cases/0/expect/0/records/0: "));
}

TEST(Loader, AnUnknownRecord) {
  EXPECT_TRUE(vector_file_error(broken("\"k\":\"rapid\"", "\"k\":\"jump\""))
                  .starts_with(": at /groups/0/cases/0/expect/0/records/0: "));
}

TEST(Loader, ARecordWithoutItsLine) {
  EXPECT_EQ(vector_file_error(broken("\"b\":1,", "")),
            ": at /groups/0/cases/0/expect/0/records/0: A record of the corpus carries b, its "
            "source line.");
}

TEST(Loader, ABadBase64) {
  for (const char* text : {"abc", "YQ", "YR==", "YQ==\\n", "Y Q=", "YQ=a", "="}) {
    EXPECT_EQ(
        vector_file_error(broken("\"G00 X2\\n\"", std::string("{\"base64\":\"") + text + "\"}")),
        ": at /groups/0/cases/0/program/base64: This is not base64.")
        << text;
  }
}

TEST(Loader, AnIdTwiceInAFile) {
  std::string text = broken("\"provenance\":\"hand\"}", "\"provenance\":\"hand\"},X");
  const std::size_t begin = text.find("{\"id\"");
  const std::size_t end = text.find(",X");
  text.replace(end + 1, 1, text.substr(begin, end - begin));
  EXPECT_EQ(vector_file_error(text), ": at /groups/0/cases/1/id: The id t.a.000001 stands twice.");
}

TEST(Loader, AnUnknownAlarm) {
  EXPECT_EQ(vector_file_error(broken("{\"k\":\"end\",\"to\":{\"x\":\"1\"}}]",
                                     "{\"k\":\"rapid\",\"b\":1,\"to\":{\"x\":\"1\"}}],"
                                     "\"alarm\":{\"any_of\":[{\"class\":\"bang\",\"b\":1}]}")),
            ": at /groups/0/cases/0/expect/0/alarm/any_of/0/class: There is no alarm class bang.");
}

TEST(Loader, NoEndingAndTwoEndings) {
  const std::string message =
      ": at /groups/0/cases/0/expect/0: An expectation ends with one of: an end record, an alarm, "
      "not_covered.";
  EXPECT_EQ(vector_file_error(broken(",\n{\"k\":\"end\",\"to\":{\"x\":\"1\"}}", "")), message);
  EXPECT_EQ(vector_file_error(broken("{\"x\":\"1\"}}]}", "{\"x\":\"1\"}}],\"not_covered\":true}")),
            message);
}

TEST(Loader, NoExpectation) {
  std::string text(kGoodVectorFile);
  const std::size_t begin = text.find("\"expect\":[") + 10;
  text.erase(begin, text.find("\"tags\"") - begin);
  text.insert(begin, "],");
  EXPECT_EQ(vector_file_error(text),
            ": at /groups/0/cases/0/expect: A case needs at least one expectation.");
}

TEST(Loader, AnUnknownReading) {
  const std::string message =
      vector_file_error(broken("[{\"records\"", "[{\"when\":{\"gsk.no\":\"1\"},\"records\""));
  EXPECT_TRUE(message.starts_with(": at /groups/0/cases/0/expect/0/when/gsk.no: ")) << message;
}

TEST(Loader, ABadProfile) {
  const std::string message =
      vector_file_error(broken("\"profile\":{}", "\"profile\":{\"units\":\"yards\"}"));
  EXPECT_TRUE(message.starts_with(": at /groups/0/profile: ")) << message;
}

TEST(Loader, AFileThatIsNotThere) {
  EXPECT_TRUE(corpus_error([] {
                oracle::read_vector_file("/nowhere/x.json");
              }).starts_with("/nowhere/x.json cannot be read: No such file"));
}

// A corpus of two files; `second` replaces the text of one of them.
std::string corpus_error_with(std::string_view second, std::string_view retired = "",
                              std::string_view files = "\"vectors/a.json\",\"vectors/b.json\"") {
  const ScratchFolder scratch;
  scratch.write("manifest.json",
                "{\"format\":1,\"version\":\"2026.1.0\",\"license\":\"CC0-1.0\","
                "\"files\":[" +
                    std::string(files) + "],\"retired\":[" + std::string(retired) + "]}");
  scratch.write("vectors/a.json", kGoodVectorFile);
  scratch.write("vectors/b.json", second);
  const std::string message = corpus_error(
      [&] { oracle::Corpus(scratch.path().string()).for_each([](const oracle::Case&) {}); });
  const std::string folder = scratch.path().string();
  return message.starts_with(folder) ? message.substr(folder.size()) : message;
}

TEST(Corpus, TwoGoodFiles) {
  EXPECT_EQ(corpus_error_with(broken("t.a.000001", "t.a.000002")), "");
}

TEST(Corpus, AnIdInTwoFiles) {
  EXPECT_EQ(corpus_error_with(kGoodVectorFile),
            "/vectors/b.json: The id t.a.000001 stands in vectors/a.json too.");
}

TEST(Corpus, ARetiredId) {
  EXPECT_EQ(corpus_error_with(broken("t.a.000001", "t.a.000002"), "\"t.a.000002\""),
            "/vectors/b.json: The id t.a.000002 is retired and cannot be used again.");
}

TEST(Corpus, AFileThatTheManifestDoesNotList) {
  EXPECT_EQ(corpus_error_with(broken("t.a.000001", "t.a.000002"), "", "\"vectors/a.json\""),
            "/manifest.json: at /files: The list is not that of the *.json files below vectors/. "
            "List each of them once.");
}

// Two files, each in the folder of a dialect; the ids that a reader of `dialects` gives out, or its
// error.
std::string read_of(const std::vector<std::string>& dialects, std::string_view rs274) {
  const ScratchFolder scratch;
  scratch.write("manifest.json",
                R"({"format":1,"version":"2026.1.0","license":"CC0-1.0","files":)"
                R"(["vectors/gsk988ta/a.json","vectors/rs274/b.json"],"retired":[]})");
  scratch.write("vectors/gsk988ta/a.json", kGoodVectorFile);
  scratch.write("vectors/rs274/b.json", rs274);
  const std::string folder = scratch.path().string();
  std::string ids;
  const std::string message = corpus_error([&] {
    const oracle::Corpus corpus(folder);
    oracle::CaseReader reader(corpus, oracle::Detail::whole, dialects);
    while (const auto test = reader.next()) ids += test->id + " ";
  });
  return message.starts_with(folder) ? message.substr(folder.size()) : message + ids;
}

TEST(Corpus, OfOneDialectOnlyItsFilesAreRead) {
  EXPECT_EQ(read_of({"gsk988ta"}, "no vectors"), "t.a.000001 ");
  EXPECT_TRUE(read_of({}, "no vectors").starts_with("/vectors/rs274/b.json"));
}

TEST(Corpus, AFileInTheFolderOfAnotherDialect) {
  EXPECT_EQ(read_of({}, broken("t.a.000001", "t.a.000002")),
            "/vectors/rs274/b.json: The dialect is gsk988ta, and the folder is that of rs274.");
}

TEST(Corpus, AFolderThatIsNone) {
  EXPECT_TRUE(
      corpus_error([] { oracle::Corpus("/nowhere"); }).starts_with("/nowhere is no corpus"));
}

}  // namespace
}  // namespace gonogo::testing
