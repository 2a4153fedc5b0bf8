// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/signature.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "corpus/io/sha256.hpp"
#include "fuzz/program/modes.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::hunt {
namespace {

constexpr std::string_view kOfEarlierBlock = " of an earlier block";

// " Y": the first axis along which two motions of one kind end apart. Another may be another
// mistake.
std::string axis_apart(const std::string& want, const std::string& got) {
  const auto due = nlohmann::json::parse(want, nullptr, false);
  const auto came = nlohmann::json::parse(got, nullptr, false);
  const bool have_ends = due.is_object() && came.is_object() && due.contains("to") &&
                         came.contains("to") && due["to"].is_object() && came["to"].is_object();
  if (!have_ends || due.value("k", "") != came.value("k", "")) return {};
  for (const char* const axis : {"x", "y", "z", "a", "c"}) {
    const bool have_both = due["to"].contains(axis) && came["to"].contains(axis);
    if (have_both && due["to"][axis] != came["to"][axis])
      return {' ', static_cast<char>(*axis - 'a' + 'A')};
  }
  return {};
}

}  // namespace

std::string Signature::text() const {
  std::string out(name(kind));
  for (const std::string& part : {clause, what}) {
    if (!part.empty()) out += " " + part;
  }
  return code.empty() ? out : out + " in " + code;
}

std::string Signature::hash() const {
  constexpr std::size_t kDigits = 8;
  oracle::Sha256 hash;
  hash.update(dialect + "\n" + text());
  return hash.hex().substr(0, kDigits);
}

bool Signature::is_surplus() const {
  return kind == oracle::VerdictKind::fail_overrun || what.ends_with(kOfEarlierBlock);
}

std::string Signature::undue_alarm() const {
  using enum oracle::VerdictKind;
  if (kind != fail_alarm_spurious && kind != fail_alarm_class) return {};
  return what.substr(what.find('/') + 1);
}

Signature signature_of(const oracle::Verdict& verdict, const generate::GeneratedProgram& program) {
  Signature signature;
  signature.dialect = program.profile.dialect;
  signature.kind = verdict.kind;
  signature.clause = reference::clause_name(verdict.clause);
  signature.what = oracle::departed_about(verdict.kind, verdict.want, verdict.got, verdict.message);
  if (oracle::is_breakdown(verdict.kind)) return signature;
  // The reference is at a later block: what it has there is chance.
  if (oracle::is_of_earlier_block(verdict.want, verdict.got)) {
    signature.what += kOfEarlierBlock;
  } else if (verdict.kind == oracle::VerdictKind::fail_geometry) {
    signature.what += axis_apart(verdict.want, verdict.got);
  }
  signature.code = program::ProgramText(program.profile, program.text).code_at(verdict.block);
  return signature;
}

std::string kind_in_text(const std::string& text) {
  if (text.empty()) return "none";
  for (const std::string_view key : {"\"class\":\"", "\"k\":\""}) {
    const std::size_t at = text.find(key);
    if (at == std::string::npos) continue;
    const std::size_t from = at + key.size();
    return text.substr(from, text.find('"', from) - from);
  }
  return text == "an answer" ? "answer" : "breakdown";
}

}  // namespace gonogo::hunt
