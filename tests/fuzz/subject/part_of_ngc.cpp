// SPDX-License-Identifier: GPL-3.0-or-later
//
// The expander ngc as a library that does a part of its dialect, and says so: positions, cuts and
// arcs by their centre. A program with anything else it skips, by a look at its words that has
// nothing of the gauge's. PLANTED_FAULT is the name of one of the expander's faults.
#include <regex>
#include <string>
#include <string_view>

#include "expanders/registry.hpp"

namespace {

int (*expander_create)(gonogo_text, const gonogo_sink_v1*, void**) = nullptr;
int (*expander_run)(void* handle, gonogo_text program) = nullptr;
const gonogo_sink_v1* notes = nullptr;  // of the last handle; the tests have one

gonogo_text describe() {
  constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"part-of-ngc","version":"1"},)"
      R"("dialects":{"rs274":["basic","arc"]},"features":["blocks","m","bytes"],"readings":["*"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.0001","feed_resolution":"0.0001","chord":"0"}})";
  return {kDescription.data(), kDescription.size()};
}

// Cycles, threads, offsets, parameters, calculations.
bool has_other(const std::string& text) {
  static const std::regex kOther(
      R"([Gg][ \t]*0*(10|28|30|33|38|43|5[35-9]|7[346]|8[1-9]|92)(?!\d)|[#[])");
  static const std::regex kComment(R"(\([^)\n]*\)|;[^\n]*)");
  return std::regex_search(std::regex_replace(text, kComment, ""), kOther);
}

int create(gonogo_text configuration, const gonogo_sink_v1* sink, void** handle) {
  notes = sink;
  return expander_create(configuration, sink, handle);
}

int run(void* handle, gonogo_text program) {
  if (!has_other(std::string(program.data, program.size))) return expander_run(handle, program);
  constexpr std::string_view kWhat = "other codes";
  notes->note(notes->context, GONOGO_NOTE_ERROR, {kWhat.data(), kWhat.size()});
  return GONOGO_UNSUPPORTED;
}

gonogo_subject_v1 part(gonogo_subject_v1 expander) {
  expander_create = expander.create;
  expander_run = expander.run;
  expander.describe = describe;
  expander.create = create;
  expander.run = run;
  return expander;
}

}  // namespace

const gonogo_subject_v1* gonogo_get_subject(uint32_t abi) {
  static const gonogo_subject_v1 subject = part(*gonogo::expanders::find("ngc", PLANTED_FAULT));
  return abi >= subject.abi ? &subject : nullptr;
}
