// SPDX-License-Identifier: GPL-3.0-or-later
//
// The examples through the C interface itself: several handles in a process, each with its own
// sink.
#include <dlfcn.h>

#include <string>
#include <thread>

#include "libraries.hpp"
#include "subjects/library_file.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kConfiguration = R"({"dialect":"rs274","profile":{}})";

gonogo_text text_of(std::string_view text) {
  return {text.data(), text.size()};
}

// A handle and what it has given: the x of every record.
class Probe {
 public:
  explicit Probe(const gonogo_subject_v1& subject, std::size_t most = 1000)
      : subject_(subject), most_(most) {
    answer_ = subject_.create(text_of(kConfiguration), &sink_, &handle_);
  }
  ~Probe() { subject_.destroy(handle_); }
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  int created() const { return answer_; }
  int run(std::string_view program) { return subject_.run(handle_, text_of(program)); }
  int reset() { return subject_.reset(handle_); }
  void set_most(std::size_t most) { most_ = most; }
  std::vector<double> take() { return std::exchange(xs_, {}); }
  const std::string& last_class() const { return class_; }

 private:
  static int record(void* context, const gonogo_record_v1* record) {
    Probe& probe = *static_cast<Probe*>(context);
    const gonogo_number& x = record->to[GONOGO_X];
    probe.xs_.push_back(x.form == GONOGO_NUMBER_TEXT
                            ? std::stod(std::string(x.text.data, x.text.size))
                            : x.binary64);
    return probe.xs_.size() < probe.most_ ? 0 : 1;
  }
  static void alarm(void* context, const gonogo_alarm_v1* alarm) {
    static_cast<Probe*>(context)->class_.assign(alarm->klass.data, alarm->klass.size);
  }
  static void note(void*, int, gonogo_text) {}

  const gonogo_subject_v1& subject_;
  gonogo_sink_v1 sink_{sizeof(gonogo_sink_v1), this, record, alarm, note};
  std::size_t most_;
  void* handle_ = nullptr;
  int answer_ = GONOGO_ERROR;
  std::vector<double> xs_;
  std::string class_;
};

class TwoHandles : public ::testing::TestWithParam<const char*> {
 protected:
  const gonogo_subject_v1& subject_ = load_library(library(GetParam()));
};

TEST_P(TwoHandles, KnowNothingOfEachOther) {
  Probe one(subject_);
  Probe two(subject_);
  ASSERT_EQ(one.created(), GONOGO_OK);
  ASSERT_EQ(two.created(), GONOGO_OK);
  EXPECT_EQ(one.run("G91 G0 X1\nX1\nM2\n"), GONOGO_OK);
  EXPECT_EQ(two.run("G0 X5\nX7\nM2\n"), GONOGO_OK);
  EXPECT_EQ(one.take(), (std::vector<double>{1, 2}));
  EXPECT_EQ(two.take(), (std::vector<double>{5, 7}));
}

TEST_P(TwoHandles, RunInTwoThreads) {
  std::vector<std::thread> threads;
  std::vector<std::vector<double>> got(2);
  for (std::size_t i = 0; i < 2; ++i) {
    threads.emplace_back([&, i] {
      Probe probe(subject_);
      std::string program = "G91 G0 X0\n";
      for (int line = 0; line < 500; ++line) program += i == 0 ? "X1\n" : "X-2\n";
      probe.run(program);
      got[i] = probe.take();
    });
  }
  for (std::thread& thread : threads) thread.join();
  ASSERT_EQ(got[0].size(), 501u);
  ASSERT_EQ(got[1].size(), 501u);
  EXPECT_EQ(got[0].back(), 500);
  EXPECT_EQ(got[1].back(), -1000);
}

TEST_P(TwoHandles, ASinkThatStopsEndsTheRun) {
  Probe probe(subject_, 3);
  EXPECT_EQ(probe.run("G0 X1\nX2\nX3\nX4\nX5\n"), GONOGO_STOPPED);
  EXPECT_EQ(probe.take().size(), 3u);
}

TEST_P(TwoHandles, ResetForgetsEverything) {
  Probe probe(subject_);
  probe.run("G20 G91 G0 X1\nM2\n");
  probe.take();
  ASSERT_EQ(probe.reset(), GONOGO_OK);
  EXPECT_EQ(probe.run("G0 X5\nX5\nM2\n"), GONOGO_OK);
  EXPECT_EQ(probe.take(), (std::vector<double>{5, 5}));
}

TEST_P(TwoHandles, AnAlarmIsAnAnswerAndTheHandleGoesOn) {
  Probe probe(subject_);
  EXPECT_EQ(probe.run("G1 X5\n"), GONOGO_ALARM);
  EXPECT_EQ(probe.last_class(), "feed-missing");
  ASSERT_EQ(probe.reset(), GONOGO_OK);
  EXPECT_EQ(probe.run("G1 X5 F100\nM2\n"), GONOGO_OK);
}

TEST_P(TwoHandles, TheVersionIsNegotiated) {
  void* loaded = dlopen(library(GetParam()).c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(loaded, nullptr) << dlerror();
  const auto get =
      reinterpret_cast<decltype(&gonogo_get_subject)>(dlsym(loaded, "gonogo_get_subject"));
  ASSERT_NE(get, nullptr);
  EXPECT_EQ(get(0), nullptr);  // nothing is as old as that
  EXPECT_NE(get(1), nullptr);
  ASSERT_NE(get(7), nullptr);  // a newer gauge gets the newest that there is
  EXPECT_EQ(get(7)->abi, GONOGO_SUBJECT_ABI);
  dlclose(loaded);
}

INSTANTIATE_TEST_SUITE_P(Examples, TwoHandles, ::testing::Values("C", "CXX"),
                         [](const auto& named) { return std::string(named.param); });

}  // namespace
}  // namespace gonogo::oracle
