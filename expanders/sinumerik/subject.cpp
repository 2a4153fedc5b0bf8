// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/subject.hpp"

#include <string_view>

#include "expanders/common/subject_glue.hpp"
#include "expanders/sinumerik/interpreter.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

struct Sinumerik {
  using Configuration = sinumerik::Configuration;
  using Fault = sinumerik::Fault;
  using Memory = Parameters;  // of the last run, for the fault that lets them survive

  static constexpr std::size_t kFaults = sinumerik::kFaults;
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-sinumerik","version":"0.1.0"},)"
      R"("dialects":{"sinumerik840d":["basic","arc","cr","ar","polar","planes","helix","cip","ct",)"
      R"("expressions","rotary"],)"
      R"("sinumerik802s":["basic","arc","cr","ar","polar","planes","helix","cip","ct",)"
      R"("expressions","rotary","frames","lcyc82","lcyc75"]},"features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"0.001","chord":"0"},)"
      R"("max_in_flight":1})";

  static ConfigurationResult read(std::string_view json, Configuration& configuration,
                                  std::string& message) {
    return read_configuration(json, configuration, message);
  }

  static gonogo_answer run(const Configuration& configuration, const gonogo_sink_v1& sink,
                           Fault fault, Memory& parameters, std::string_view program) {
    Interpreter interpreter(configuration, sink, fault);
    State& state = interpreter.machine().state;
    state.parameters = parameters;
    const gonogo_answer answer = interpreter.run(program);
    if (fault == Fault::kParametersSurviveReset) parameters = state.parameters;
    return answer;
  }
};

}  // namespace

const gonogo_subject_v1& subject(Fault fault) {
  return SubjectGlue<Sinumerik>::subject(fault);
}

}  // namespace gonogo::expanders::sinumerik
