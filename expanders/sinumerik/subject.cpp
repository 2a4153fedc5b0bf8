// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/subject.hpp"

#include "expanders/common/subject_glue.hpp"
#include "expanders/sinumerik/interpreter.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

constexpr ParameterRow kParameters[] = {
    {"CIRCLE_ERROR_CONST", kOne / 100, 0, kReach},
    {"CIRCLE_ERROR_FACTOR", kOne / 1000, 0, kReach},
};

struct Sinumerik {
  using Configuration = MachineProfile;
  using Fault = expanders::Fault;
  using Memory = Parameters;  // of the last run, for the fault that lets them survive

  static constexpr std::size_t kFaults = sinumerik::kFaults.size();
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-sinumerik","version":"0.1.0"},)"
      R"("dialects":{"sinumerik840d":["basic","arc","cr","ar","polar","planes","helix","cip","ct",)"
      R"("expressions","rotary"],)"
      R"("sinumerik802s":["basic","arc","cr","ar","polar","planes","helix","cip","ct",)"
      R"("expressions","rotary","frames","lcyc82","lcyc75"]},"features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"0.001","chord":"0"},)"
      R"("max_in_flight":1})";

  static ProfileResult read(std::string_view json, MachineProfile& profile, std::string& message) {
    return read_profile(json, profiles(), profile, message);
  }

  static gonogo_answer run(const MachineProfile& profile, const gonogo_sink_v1& sink, Fault fault,
                           Memory& parameters, std::string_view program) {
    Interpreter interpreter(profile, sink, fault);
    interpreter.state().parameters = parameters;
    const gonogo_answer answer = interpreter.run(program);
    if (fault == "parameters-survive-reset"_fault) parameters = interpreter.state().parameters;
    return answer;
  }
};

}  // namespace

std::span<const ProfileTable> profiles() {
  static const auto kProfiles = [] {
    ProfileTable plain;
    plain.standard.dialect = "sinumerik840d";
    plain.motions = "none|0|1|2|3";
    plain.parameters = kParameters;
    plain.readings = std::span(kReadings).first(kReadingsOf840D);
    plain.reach = kReach;
    ProfileTable with_cycles = plain;
    with_cycles.standard.dialect = "sinumerik802s";
    with_cycles.own_keys = "tools";
    with_cycles.readings = kReadings;
    return std::array{plain, with_cycles};
  }();
  return kProfiles;
}

const gonogo_subject_v1& subject(Fault fault) {
  return SubjectGlue<Sinumerik>::subject(fault);
}

}  // namespace gonogo::expanders::sinumerik
