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

#include "expanders/common/planted.hpp"
#include "expanders/common/profile_reader.hpp"
#include "expanders/faults.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders {

/// What `Maker` gives:
///   Configuration, Fault (an enumeration from 0, no fault, without gaps), kFaults (without 0),
///   kDescription (the reply of `describe`),
///   Memory (what a planted fault may carry from one run to the next),
///   static ConfigurationResult read(std::string_view json, Configuration&, std::string& message),
///   static gonogo_answer run(const Configuration&, const gonogo_sink_v1&, Planted<Fault>, Memory&,
///   std::string_view program).
template <typename Maker>
class SubjectGlue {
 public:
  using Fault = typename Maker::Fault;

  static const gonogo_subject_v1& subject(Fault fault) {
    static constexpr auto kSubjects = make_subjects(std::make_index_sequence<Maker::kFaults + 1>{});
    return *kSubjects[static_cast<std::size_t>(fault)];
  }

  /// How often runs of this process have met the fault.
  static FaultCount count(Fault fault) { return counter(fault).count(); }

 private:
  struct Handle {
    typename Maker::Configuration configuration;
    const gonogo_sink_v1* sink;
    Fault fault;
    typename Maker::Memory memory{};
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

  static gonogo_text describe() { return {Maker::kDescription.data(), Maker::kDescription.size()}; }

  static int create(Fault fault, gonogo_text text, const gonogo_sink_v1* sink, void** handle) {
    if (handle == nullptr) return GONOGO_ERROR;
    *handle = nullptr;
    if (sink == nullptr || sink->record == nullptr) return GONOGO_ERROR;
    return guarded(sink, [&]() -> int {
      auto made = std::make_unique<Handle>(Handle{{}, sink, fault});
      std::string message;
      const ConfigurationResult result =
          Maker::read({text.data, text.size}, made->configuration, message);
      if (result != ConfigurationResult::kRead) {
        note(*sink, message);
        return result == ConfigurationResult::kMalformed ? GONOGO_ERROR : GONOGO_UNSUPPORTED;
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
      const Planted<Fault> planted(subject.fault, met);
      const int answer = Maker::run(subject.configuration, *subject.sink, planted, subject.memory,
                                    {program.data, program.size});
      if (met.reached != 0) counter(subject.fault).add(met);
      return answer;
    });
  }

  static MetCounter& counter(Fault fault) {
    static std::array<MetCounter, Maker::kFaults + 1> all;
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

/// The maker of an interpreter that gives kFaultCount, kDescription, `static profiles()`, and
/// Memory with `recall(memory)` and `memory()`.
template <typename Interpreter>
struct MakerOf {
  using Configuration = MachineProfile;
  using Fault = expanders::Fault;
  using Memory = typename Interpreter::Memory;

  static constexpr std::size_t kFaults = Interpreter::kFaultCount;
  static constexpr std::string_view kDescription = Interpreter::kDescription;

  static ProfileResult read(std::string_view json, MachineProfile& profile, std::string& message) {
    return read_profile(json, Interpreter::profiles(), profile, message);
  }

  static gonogo_answer run(const MachineProfile& profile, const gonogo_sink_v1& sink,
                           Planted<Fault> planted, Memory& memory, std::string_view program) {
    Interpreter interpreter(profile, sink, planted);
    interpreter.recall(memory);
    const gonogo_answer answer = interpreter.run(program);
    memory = interpreter.memory();
    return answer;
  }
};

}  // namespace gonogo::expanders
