// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/subject.hpp"

#include <string_view>

#include "expanders/common/subject_glue.hpp"
#include "expanders/gsk/interpreter.hpp"

namespace gonogo::expanders::gsk {
namespace {

struct Gsk {
  using Configuration = gsk::Configuration;
  using Fault = gsk::Fault;
  using Memory = Fixed;  // the last feed, for the fault that lets it survive

  static constexpr std::size_t kFaults = gsk::kFaults;
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-gsk","version":"0.1.0"},)"
      R"("dialects":{"gsk988ta":["basic","arc","g90","g92","g94","g110","g112","g114","g116"]},)"
      R"("features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"0.001","chord":"0"},)"
      R"("max_in_flight":1})";

  static ConfigurationResult read(std::string_view json, Configuration& configuration,
                                  std::string& message) {
    return read_configuration(json, configuration, message);
  }

  static gonogo_answer run(const Configuration& configuration, const gonogo_sink_v1& sink,
                           Fault fault, Memory& last_feed, std::string_view program) {
    Interpreter interpreter(configuration, sink, fault);
    State& state = interpreter.machine().state;
    if (last_feed != 0) state.feed = last_feed;
    const gonogo_answer answer = interpreter.run(program);
    if (fault == Fault::kFeedSurvivesReset) last_feed = state.feed;
    return answer;
  }
};

}  // namespace

const gonogo_subject_v1& subject(Fault fault) {
  return SubjectGlue<Gsk>::subject(fault);
}

}  // namespace gonogo::expanders::gsk
