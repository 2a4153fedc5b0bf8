// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/subject.hpp"

#include <string_view>

#include "expanders/common/subject_glue.hpp"
#include "expanders/ngc/interpreter.hpp"

namespace gonogo::expanders::ngc {
namespace {

struct Ngc {
  using Configuration = ngc::Configuration;
  using Fault = ngc::Fault;
  using Memory = FeedRate;  // the last feed, for the fault that lets it survive

  static constexpr std::size_t kFaults = ngc::kFaults;
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-ngc","version":"0.1.0"},)"
      R"("dialects":{"rs274":["basic","arc","arc-r","planes","helix","arc-distance","turns",)"
      R"("lines",)"
      R"("g81","g73","g83","g84","g74","g85","g86","cycle-modal","cycle-steps","cycle-planes",)"
      R"("g33","g33.1","g76","rotary","feed-modes","linuxcnc","polar-words"]},)"
      R"("features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.0001","feed_resolution":"0.0001","chord":"0"},)"
      R"("readings":["*"],"max_in_flight":1})";

  static ConfigurationResult read(std::string_view json, Configuration& configuration,
                                  std::string& message) {
    return read_configuration(json, configuration, message);
  }

  static gonogo_answer run(const Configuration& configuration, const gonogo_sink_v1& sink,
                           const Faults& planted, Memory& last_feed, std::string_view program) {
    Interpreter interpreter(configuration, sink, planted);
    State& state = interpreter.machine().state;
    state.feed = interpreter.machine().alters("feed-survives-reset"_fault, state.feed,
                                              last_feed.linear != 0 ? last_feed : state.feed);
    const gonogo_answer answer = interpreter.run(program);
    last_feed = state.feed;
    return answer;
  }
};

}  // namespace

const gonogo_subject_v1& subject(Fault fault) {
  return SubjectGlue<Ngc>::subject(fault);
}

FaultCount count(Fault fault) {
  return SubjectGlue<Ngc>::count(fault);
}

}  // namespace gonogo::expanders::ngc
