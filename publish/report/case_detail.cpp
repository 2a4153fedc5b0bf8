// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/case_detail.hpp"

#include "oracle/records/finding_text.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/json_value.hpp"
#include "publish/report/page_paths.hpp"
#include "publish/report/sheet.hpp"

namespace gonogo::oracle::report {
namespace {

constexpr std::size_t kStepsOfTurn = 32;  // of a failure in space
constexpr std::size_t kStepsOfPass = 16;

// Kind, block, and the text, which has the clause of a record of the reference, or the clause
// alone.
Json motions_json(const Path& path, std::string Motion::*told) {
  Json motions = Json::array();
  for (const Motion& motion : path.motions) {
    motions.push_back(Json::array({motion.kind, motion.block, motion.*told}));
  }
  return motions;
}

// Place of the record that the message speaks of: the one with the text of `want`, if possible in
// the block.
std::optional<std::size_t> wanted_record(const Path& path, const std::string& want,
                                         std::uint64_t block) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < path.motions.size(); ++i) {
    if (want.empty() || path.motions[i].text != want) continue;
    if (path.motions[i].block == block) return i;
    if (!found) found = i;
  }
  return found;
}

// The place counts all samples, and the trace holds those that a drawing needs, with
// their places.
std::optional<std::size_t> departing_motion(const Json& line) {
  const auto record = count_of(line, "record");
  if (!record || !line.contains("sampled")) return record;
  const Json trace = line.value("trace", Json::array());
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (count_of(trace[i], "x-sample") == record) return i;
  }
  return std::nullopt;
}

// Where the departure is marked: the witness; what it leaves open, and all when there is none,
// comes from the end of the subject's record, else of the reference's.
std::optional<Point3> departure(const Json& line, const Path& reference, const Path& subject,
                                std::optional<std::size_t> wanted) {
  std::optional<Point3> end;
  if (auto record = departing_motion(line); record && *record < subject.motions.size()) {
    end = subject.motions[*record].points.back();
  } else if (wanted) {
    end = reference.motions[*wanted].points.back();
  }
  if (auto witness = line.find("witness"); witness != line.end()) {
    if (auto point = read_point(*witness, end.value_or(Point3{}))) return point;
  }
  return end;
}

void add_paths(Json& detail, const Json& line, const std::string& program,
               std::string_view subject_name) {
  const std::string dialect = text_of(line, "dialect");
  const auto profile = case_profile(dialect, line.value("profile", Json::object()));
  if (const auto* fault = std::get_if<std::string>(&profile)) {
    detail["note"] = "The reference path cannot be computed: " + *fault;
    return;
  }
  const auto& machine = std::get<reference::Profile>(profile);
  const DrawnPath reference = reference_path(machine, program);
  const DrawnPath subject = subject_path(machine.initial.at, line.value("trace", Json::array()));
  const auto wanted =
      wanted_record(reference.path, text_of(line, "want"), count_of(line, "b").value_or(0));
  Sheet sheet;
  sheet.title = text_of(line, "id");
  sheet.dialect = dialect;
  sheet.verdict = text_of(line, "verdict");
  sheet.subject = subject_name;
  sheet.lathe = is_lathe(dialect);
  sheet.reference = &reference.path;
  sheet.departing = &subject.path;
  sheet.witness = departure(line, reference.path, subject.path, wanted);
  if (wanted) sheet.expected = reference.path.motions[*wanted].points.back();
  sheet.expected_motion = wanted;
  sheet.departing_motion = departing_motion(line);
  sheet.block = count_of(line, "b").value_or(0);
  sheet.limits = limits_of_program(machine, program);
  detail["svg"] = svg_sheet(sheet);
  detail["lathe"] = sheet.lathe;
  detail["moves"] = {{"r", moves_json(reference.path, kStepsOfTurn)},
                     {"s", moves_json(subject.path, kStepsOfTurn)}};
  if (!sheet.limits.empty()) detail["limits"] = limits_json(sheet.limits);
  if (sheet.witness) detail["at"] = {sheet.witness->x, sheet.witness->y, sheet.witness->z};
  detail["reference"] = motions_json(reference.path, &Motion::text);
  detail["trace"] = motions_json(subject.path, &Motion::text);
  if (wanted) detail["wanted"] = *wanted;
  if (!line.contains("sampled")) {
    Json times = case_times(machine, program, line.value("trace", Json::array()),
                            {wanted, departing_motion(line)});
    if (!times.is_null()) detail["times"] = std::move(times);
  }
  if (reference.path.cut) detail["referenceCut"] = true;
  if (subject.path.cut) detail["traceCut"] = true;
  if (!reference.note.empty()) detail["referenceNote"] = reference.note;
  if (!subject.note.empty()) detail["traceNote"] = subject.note;
}

}  // namespace

std::optional<std::string> program_bytes(const Json& line) {
  auto program = line.find("program");
  if (program == line.end()) return std::nullopt;
  if (program->is_string()) {
    auto text = program->get<std::string>();
    // A failure of readings is found when all cases have been run; its program is not kept.
    if (text.empty() && text_of(line, "verdict") == "fail.reading") return std::nullopt;
    return text;
  }
  return decode_base64(text_of(*program, "base64"));
}

Json pass_detail(const CorpusCase& test) {
  Json detail = {{"comment", test.comment}, {"profile", test.profile}, {"program", test.program}};
  const auto profile = case_profile(test.dialect, test.profile);
  const auto* machine = std::get_if<reference::Profile>(&profile);
  const auto program = program_bytes(detail);
  if (machine == nullptr || !program) return detail;
  const DrawnPath reference = reference_path(*machine, *program);
  detail["lathe"] = is_lathe(test.dialect);
  detail["moves"] = {{"r", moves_json(reference.path, kStepsOfPass)}};
  if (auto limits = limits_of_program(*machine, *program); !limits.empty()) {
    detail["limits"] = limits_json(limits);
  }
  detail["motions"] = motions_json(reference.path, &Motion::clause);
  return detail;
}

Json case_detail(const Json& line, std::string_view subject_name, bool with_paths) {
  Json detail = line;
  detail.erase("trace");
  const Json profile = line.value("profile", Json::object());
  if (std::string machine = other_machine(profile.dump()); !machine.empty()) {
    detail["machine"] = std::move(machine);
  }
  if (std::string steps = want_and_got(text_of(line, "want"), text_of(line, "got"));
      !steps.empty()) {
    detail["steps"] = std::move(steps);
  }
  const auto program = program_bytes(line);
  if (!program) {
    detail.erase("program");
    detail["note"] = "The results file holds no program for this case.";
  } else if (!with_paths) {
    detail["note"] =
        "The drawing is left out to keep this page small. Run the command for this case with "
        "--report DIR to get it.";
  } else {
    add_paths(detail, line, *program, subject_name);
  }
  return detail;
}

}  // namespace gonogo::oracle::report
