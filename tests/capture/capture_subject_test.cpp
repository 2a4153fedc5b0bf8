// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_subject.hpp"
#include "tests/has.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace gonogo::oracle {
namespace {

namespace fs = std::filesystem;

class CaptureSubject : public ::testing::Test {
 protected:
  CaptureSubject() {
    std::string name = "/tmp/gonogo-capture-XXXXXX";
    folder_ = ::mkdtemp(name.data());
  }
  ~CaptureSubject() override { fs::remove_all(folder_); }

  void write(const std::string& file, std::string_view text) const {
    std::ofstream(folder_ / file, std::ios::binary) << text;
  }
  RunEnd run(const std::string& id) {
    records_.clear();
    auto subject = make_capture_subject(folder_.string(), {});
    subject->configure(reference::Profile());
    return subject->run(id, "", [this](const reference::Record& record) {
      records_.push_back(record);
      return true;
    });
  }
  fs::path folder_;
  std::vector<reference::Record> records_;
};

constexpr std::string_view kManifest =
    R"({"programs":[{"file":"0001.nc","id":"a.1","header_lines":3,"start":{"x":"0","z":"0"}}]})";

TEST_F(CaptureSubject, ACaseWithoutAFileIsSkipped) {
  const RunEnd end = run("a.1");
  EXPECT_EQ(end.kind, RunEnd::Kind::skip);
  EXPECT_EQ(end.feature, "capture");
}

TEST_F(CaptureSubject, RecordsLoseTheHeadersLines) {
  write("manifest.json", kManifest);
  write("a.1.jsonl",
        "{\"k\":\"rapid\",\"b\":2,\"to\":{\"x\":\"0\"}}\n"
        "{\"k\":\"rapid\",\"b\":3,\"to\":{\"z\":\"0\"}}\n"
        "{\"k\":\"rapid\",\"b\":4,\"to\":{\"x\":\"25\"}}\n"
        "{\"k\":\"alarm\",\"class\":\"syntax\",\"b\":5}\n");
  const RunEnd end = run("a.1");
  EXPECT_EQ(end.kind, RunEnd::Kind::alarm);
  EXPECT_EQ(end.alarm.block, 2U);
  ASSERT_EQ(records_.size(), 1U);
  EXPECT_EQ(records_[0].block, 1U);
}

// Amid the program or after it, a line of the header is none.
TEST_F(CaptureSubject, ARecordOfTheHeaderDoesNotComeAfterTheProgramHasBegun) {
  write("manifest.json", kManifest);
  const std::string before = "{\"k\":\"rapid\",\"b\":2,\"to\":{\"x\":\"0\",\"z\":\"0\"}}\n";
  const std::string first = "{\"k\":\"rapid\",\"b\":4,\"to\":{\"x\":\"25\"}}\n";
  const std::string end =
      "{\"k\":\"end\",\"to\":{\"x\":\"25\",\"y\":\"0\",\"z\":\"0\",\"a\":\"0\",\"c\":\"0\"}}\n";
  write("a.1.jsonl", before + first + end);
  EXPECT_EQ(run("a.1").kind, RunEnd::Kind::ok);
  write("a.1.jsonl", before + first + before + end);
  EXPECT_EQ(run("a.1").kind, RunEnd::Kind::protocol);
  write("a.1.jsonl", before + first + end + before);
  EXPECT_EQ(run("a.1").kind, RunEnd::Kind::protocol);
}

TEST_F(CaptureSubject, AHeaderThatDoesNotLeadToTheStartIsAFault) {
  write("manifest.json", kManifest);
  write("a.1.jsonl",
        "{\"k\":\"rapid\",\"b\":2,\"to\":{\"x\":\"0\",\"z\":\"7\"}}\n"
        "{\"k\":\"rapid\",\"b\":4,\"to\":{\"x\":\"25\"}}\n");
  const RunEnd end = run("a.1");
  EXPECT_EQ(end.kind, RunEnd::Kind::protocol);
  EXPECT_TRUE(has(end.message, "The header ends at z7"));
}

TEST_F(CaptureSubject, AnAlarmInTheHeaderIsNoneOfTheProgram) {
  write("manifest.json", kManifest);
  write("a.1.jsonl", "{\"k\":\"alarm\",\"class\":\"syntax\",\"b\":1}\n");
  EXPECT_TRUE(run("a.1").alarm.before_program);
  write("a.1.jsonl", "{\"k\":\"alarm\",\"class\":\"syntax\",\"b\":4}\n");
  EXPECT_FALSE(run("a.1").alarm.before_program);
  write("0001.csv", "t,x,z\n0,0,0\nalarm,syntax,1\n");
  fs::remove(folder_ / "a.1.jsonl");
  EXPECT_TRUE(run("a.1").alarm.before_program);
}

// An `end` has no line, and says nothing of whether motions have one.
TEST_F(CaptureSubject, LinesAreComparedWhereMotionsHaveThem) {
  const std::string end =
      "{\"k\":\"end\",\"to\":{\"x\":\"0\",\"y\":\"0\",\"z\":\"0\",\"a\":\"0\",\"c\":\"0\"}}\n";
  for (const char* name : {"a.jsonl", "b.jsonl", "c.jsonl"}) write(name, end);
  EXPECT_FALSE(make_capture_subject(folder_.string(), {})->info().features.contains("blocks"));
  write("b.jsonl", "{\"k\":\"rapid\",\"b\":1,\"to\":{\"x\":\"0\"}}\n" + end);
  EXPECT_TRUE(make_capture_subject(folder_.string(), {})->info().features.contains("blocks"));
}

// One trace with lines makes the others no fault.
TEST_F(CaptureSubject, LinesAreComparedOnlyWhereEveryTraceHasThem) {
  write("a.jsonl", "{\"k\":\"rapid\",\"b\":1,\"to\":{\"x\":\"0\"}}\n");
  write("b.jsonl", "{\"k\":\"rapid\",\"to\":{\"x\":\"0\"}}\n");
  write("c.jsonl", "{\"k\":\"alarm\",\"class\":\"syntax\"}\n");
  EXPECT_FALSE(make_capture_subject(folder_.string(), {})->info().features.contains("blocks"));
  write("b.jsonl", "{\"k\":\"rapid\",\"b\":2,\"to\":{\"x\":\"0\"}}\n");
  EXPECT_TRUE(make_capture_subject(folder_.string(), {})->info().features.contains("blocks"));
}

TEST_F(CaptureSubject, TraversesToTheStartWithoutLineNumbersAreTheHeaders) {
  write("manifest.json", kManifest);
  write("a.1.jsonl",
        "{\"k\":\"rapid\",\"to\":{\"x\":\"0\"}}\n{\"k\":\"rapid\",\"to\":{\"z\":\"0\"}}\n"
        "{\"k\":\"rapid\",\"to\":{\"x\":\"25\"}}\n");
  EXPECT_EQ(run("a.1").kind, RunEnd::Kind::ok);
  ASSERT_EQ(records_.size(), 1U);
  EXPECT_EQ(records_[0].to[reference::Axis::x], Number(25));
}

TEST_F(CaptureSubject, TheNumberOfTheProgramIsANameToo) {
  write("manifest.json", kManifest);
  write("0001.csv", "t,x,z\n0,0,0\n");
  const RunEnd end = run("a.1");
  EXPECT_EQ(end.kind, RunEnd::Kind::ok);
  EXPECT_NE(end.sampled, nullptr);
  EXPECT_EQ(end.notes, "Sampled axis positions: 0001.csv");
}

TEST_F(CaptureSubject, ABadFileIsAFaultOfTheProtocol) {
  write("a.1.csv", "t,x,z\n0,0\n");
  const RunEnd samples = run("a.1");
  EXPECT_EQ(samples.kind, RunEnd::Kind::protocol);
  EXPECT_TRUE(has(samples.message, "line 2, column 3"));
  write("a.2.jsonl", "{\"k\":\"rapid\",\"to\":{\"x\":1}}\n");
  EXPECT_EQ(run("a.2").kind, RunEnd::Kind::protocol);
}

TEST_F(CaptureSubject, TheDescriptionBesideTheFilesCounts) {
  write("subject.json",
        R"({"protocol":1,"subject":{"name":"mill 3","version":"7.1"},"dialects":["rs274"],)"
        R"("numeric":{"kind":"fixed","resolution":"0.0005"}})");
  const auto subject = make_capture_subject(folder_.string(), {});
  EXPECT_EQ(subject->info().name, "mill 3");
  EXPECT_EQ(*subject->info().resolution, *Number::parse("0.0005"));
  EXPECT_TRUE(subject->info().declares("rs274", "arc"));
  EXPECT_FALSE(subject->info().declares("gsk988ta", "g94"));
  EXPECT_FALSE(subject->keeps_state());
}

TEST_F(CaptureSubject, AFolderThatIsNotThereCannotBeUsed) {
  EXPECT_THROW(make_capture_subject("/nowhere/at/all", {}), SubjectUnusable);
  write("manifest.json", "{}");
  EXPECT_THROW(make_capture_subject(folder_.string(), {}), SubjectUnusable);
}

}  // namespace
}  // namespace gonogo::oracle
