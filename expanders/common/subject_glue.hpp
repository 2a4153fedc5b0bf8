// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface around a maker's interpreter: life of a handle, borders, one table a fault.
#pragma once

#include <array>
#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "expanders/common/machine_profile.hpp"
#include "expanders/common/planted.hpp"
#include "expanders/faults.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders {

/// What `Interpreter` gives: kFaultCount, kDescription (the reply of `describe`), `static
/// profiles()`, and Memory (what a planted fault may carry from one run to the next) with
/// `recall(memory)` and `memory()`.
template <typename Interpreter>
class SubjectGlue {
 public:
  static const gonogo_subject_v1& subject(Fault fault) {
    static constexpr auto kSubjects = make_subjects(std::make_index_sequence<kCount>{});
    return *kSubjects[static_cast<std::size_t>(fault)];
  }

  /// How often runs of this process have met the fault.
  static FaultCount count(Fault fault) { return counter(fault).count(); }

 private:
  static constexpr std::size_t kCount = Interpreter::kFaultCount + 1;  // with none

  struct Handle {
    MachineProfile profile;
    const gonogo_sink_v1* sink;
    Fault fault;
    typename Interpreter::Memory memory{};
  };

  static void note(const gonogo_sink_v1& sink, std::string_view message) {
    if (sink.note != nullptr) {
      sink.note(sink.context, GONOGO_NOTE_ERROR, {message.data(), message.size()});
    }
  }

  static int guarded(const gonogo_sink_v1* sink, auto&& work) noexcept {
    try {
      return work();
    } catch (const std::exception& error) {
      if (sink != nullptr) note(*sink, error.what());
    } catch (...) {
      if (sink != nullptr) note(*sink, "An unknown exception stopped the expander.");
    }
    return GONOGO_ERROR;
  }

  static gonogo_text describe() {
    return {Interpreter::kDescription.data(), Interpreter::kDescription.size()};
  }

  static int create(Fault fault, gonogo_text text, const gonogo_sink_v1* sink, void** handle) {
    if (handle == nullptr) return GONOGO_ERROR;
    *handle = nullptr;
    if (sink == nullptr || sink->record == nullptr) return GONOGO_ERROR;
    return guarded(sink, [&]() -> int {
      auto made = std::make_unique<Handle>(Handle{{}, sink, fault});
      std::string message;
      const ProfileResult result =
          read_profile({text.data, text.size}, Interpreter::profiles(), made->profile, message);
      if (result != ProfileResult::kRead) {
        note(*sink, message);
        return result == ProfileResult::kMalformed ? GONOGO_ERROR : GONOGO_UNSUPPORTED;
      }
      *handle = made.release();
      return GONOGO_OK;
    });
  }

  template <Fault kFault>
  static int create_with(gonogo_text text, const gonogo_sink_v1* sink, void** handle) {
    return create(kFault, text, sink, handle);
  }

  static int run(void* handle, gonogo_text program) {
    if (handle == nullptr) return GONOGO_ERROR;
    auto& subject = *static_cast<Handle*>(handle);
    return guarded(subject.sink, [&]() -> int {
      Met met;
      Interpreter interpreter(subject.profile, *subject.sink, Planted<Fault>(subject.fault, met));
      interpreter.recall(subject.memory);
      const int answer = interpreter.run({program.data, program.size});
      subject.memory = interpreter.memory();
      if (met.reached != 0) counter(subject.fault).add(met);
      return answer;
    });
  }

  static MetCounter& counter(Fault fault) {
    static std::array<MetCounter, kCount> all;
    return all[static_cast<std::size_t>(fault)];
  }

  // Every run starts from power-on: nothing is left to reset.
  static int reset(void* handle) { return handle == nullptr ? GONOGO_ERROR : GONOGO_OK; }

  static void destroy(void* handle) { delete static_cast<Handle*>(handle); }

  template <Fault kFault>
  static constexpr gonogo_subject_v1 kSubject{GONOGO_SUBJECT_ABI,
                                              sizeof(gonogo_subject_v1),
                                              &describe,
                                              &create_with<kFault>,
                                              &run,
                                              &reset,
                                              &destroy};

  template <std::size_t... kIndex>
  static constexpr std::array<const gonogo_subject_v1*, sizeof...(kIndex)> make_subjects(
      std::index_sequence<kIndex...>) {
    return {&kSubject<static_cast<Fault>(kIndex)>...};
  }
};

}  // namespace gonogo::expanders
