// SPDX-License-Identifier: GPL-3.0-or-later
//
// The expander gsk, which comes to a stop in the middle of its programs for as long as the file that
// GONOGO_HOLD names exists, so that a test finds a shard there.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "expanders/registry.hpp"

namespace {

constexpr int kProgramsBeforeTheStop = 100;

int (*expander_run)(void* handle, gonogo_text program) = nullptr;

bool is_held() {
  const char* file = std::getenv("GONOGO_HOLD");
  return file != nullptr && std::filesystem::exists(file);
}

int run(void* handle, gonogo_text program) {
  using namespace std::chrono_literals;
  static int programs = 0;
  if (++programs > kProgramsBeforeTheStop) {
    while (is_held()) std::this_thread::sleep_for(20ms);
  }
  return expander_run(handle, program);
}

gonogo_subject_v1 held(gonogo_subject_v1 expander) {
  expander_run = expander.run;
  expander.run = run;
  return expander;
}

}  // namespace

const gonogo_subject_v1* gonogo_get_subject(uint32_t abi) {
  static const gonogo_subject_v1 subject = held(*gonogo::expanders::find("gsk"));
  return abi >= subject.abi ? &subject : nullptr;
}
