// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/subject.hpp"

#include "expanders/common/subject_glue.hpp"
#include "expanders/gsk/interpreter.hpp"

namespace gonogo::expanders::gsk {
namespace {

constexpr ParameterRow kParameters[] = {
    {"3410", kOne / 100},
    {"5920", 0, 0, kFullTurn},
    {"5921"},
    {"3403.6", -1, 0, kOne},
};

struct Gsk {
  using Configuration = MachineProfile;
  using Fault = expanders::Fault;
  using Memory = Fixed;  // the last feed, for the fault that lets it survive

  static constexpr std::size_t kFaults = gsk::kFaults.size();
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-gsk","version":"0.1.0"},)"
      R"("dialects":{"gsk988ta":["basic","arc","g90","g92","g94","g110","g112","g114","g116"]},)"
      R"("features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"0.001","chord":"0"},)"
      R"("max_in_flight":1})";

  static ProfileResult read(std::string_view json, MachineProfile& profile, std::string& message) {
    return read_profile(json, profiles(), profile, message);
  }

  static gonogo_answer run(const MachineProfile& profile, const gonogo_sink_v1& sink, Fault fault,
                           Memory& last_feed, std::string_view program) {
    Interpreter interpreter(profile, sink, fault);
    State& state = interpreter.state();
    if (last_feed != 0) state.feed = last_feed;
    const gonogo_answer answer = interpreter.run(program);
    if (fault == "feed-survives-reset"_fault) last_feed = state.feed;
    return answer;
  }
};

}  // namespace

std::span<const ProfileTable> profiles() {
  static const auto kProfiles = [] {
    ProfileTable table;
    table.standard.dialect = "gsk988ta";
    table.standard.x_diameter = true;
    table.standard.motion = 0;
    table.standard.plane = 18;
    table.own_keys = "increment|x_diameter|reference_point";
    table.motions = "0|1|2|3";
    table.parameters = kParameters;
    table.readings = kReadings;
    return std::array{table};
  }();
  return kProfiles;
}

const gonogo_subject_v1& subject(Fault fault) {
  return SubjectGlue<Gsk>::subject(fault);
}

}  // namespace gonogo::expanders::gsk
