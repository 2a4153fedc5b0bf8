// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/capture/capture_subject.hpp"

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
  EXPECT_NE(samples.message.find("line 2, column 3"), std::string::npos) << samples.message;
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
