// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/subject.hpp"

#include <array>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "expanders/gsk/interpreter.hpp"

namespace gonogo::expanders::gsk {
namespace {

constexpr std::string_view kDescription =
    R"({"protocol":1,"subject":{"name":"gonogo-gsk","version":"0.1.0"},)"
    R"("dialects":{"gsk988ta":["basic","arc","g90","g92","g94","g110","g112","g114","g116"]},)"
    R"("features":["blocks","m","bytes"],)"
    R"("numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"0.001","chord":"0"},)"
    R"("max_in_flight":1})";

struct Handle {
  Configuration configuration;
  const gonogo_sink_v1* sink;
  Fault fault;
  Fixed last_feed = 0;  // for the fault that lets it survive
};

void note(const gonogo_sink_v1& sink, std::string_view message) {
  if (sink.note != nullptr) {
    sink.note(sink.context, GONOGO_NOTE_ERROR, {message.data(), message.size()});
  }
}

int guarded(const gonogo_sink_v1* sink, auto&& work) noexcept {
  try {
    return work();
  } catch (const std::exception& error) {
    if (sink != nullptr) note(*sink, error.what());
  } catch (...) {
    if (sink != nullptr) note(*sink, "An unknown exception stopped the expander.");
  }
  return GONOGO_ERROR;
}

gonogo_text describe() {
  return {kDescription.data(), kDescription.size()};
}

int create(Fault fault, gonogo_text text, const gonogo_sink_v1* sink, void** handle) {
  if (handle == nullptr) return GONOGO_ERROR;
  *handle = nullptr;
  if (sink == nullptr || sink->record == nullptr) return GONOGO_ERROR;
  return guarded(sink, [&]() -> int {
    auto made = std::make_unique<Handle>(Handle{{}, sink, fault});
    std::string message;
    switch (read_configuration({text.data, text.size}, made->configuration, message)) {
      case ConfigurationResult::kMalformed:
        note(*sink, message);
        return GONOGO_ERROR;
      case ConfigurationResult::kUnsupported:
        note(*sink, message);
        return GONOGO_UNSUPPORTED;
      case ConfigurationResult::kRead:
        break;
    }
    *handle = made.release();
    return GONOGO_OK;
  });
}

template <Fault kFault>
int create_with(gonogo_text text, const gonogo_sink_v1* sink, void** handle) {
  return create(kFault, text, sink, handle);
}

int run(void* handle, gonogo_text program) {
  if (handle == nullptr) return GONOGO_ERROR;
  auto& subject = *static_cast<Handle*>(handle);
  return guarded(subject.sink, [&]() -> int {
    Interpreter interpreter(subject.configuration, *subject.sink, subject.fault);
    State& state = interpreter.machine().state;
    if (subject.last_feed != 0) state.feed = subject.last_feed;
    const gonogo_answer answer = interpreter.run({program.data, program.size});
    if (subject.fault == Fault::kFeedSurvivesReset) subject.last_feed = state.feed;
    return answer;
  });
}

// Every run starts from power-on: nothing is left to reset.
int reset(void* handle) {
  return handle == nullptr ? GONOGO_ERROR : GONOGO_OK;
}

void destroy(void* handle) {
  delete static_cast<Handle*>(handle);
}

template <Fault kFault>
constexpr gonogo_subject_v1 kSubject{GONOGO_SUBJECT_ABI,
                                     sizeof(gonogo_subject_v1),
                                     &describe,
                                     &create_with<kFault>,
                                     &run,
                                     &reset,
                                     &destroy};

template <std::size_t... kIndex>
constexpr std::array<const gonogo_subject_v1*, sizeof...(kIndex)> make_subjects(
    std::index_sequence<kIndex...>) {
  return {&kSubject<static_cast<Fault>(kIndex)>...};
}

constexpr auto kSubjects = make_subjects(std::make_index_sequence<kFaults + 1>{});

}  // namespace

const gonogo_subject_v1& subject(Fault fault) {
  return *kSubjects[static_cast<std::size_t>(fault)];
}

}  // namespace gonogo::expanders::gsk
