// SPDX-License-Identifier: GPL-3.0-or-later
#include "hunt/signature.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "oracle/corpus/sha256.hpp"
#include "program/modes.hpp"

namespace gonogo::hunt {
namespace {

using oracle::VerdictKind;

// The value of a key in the text of a record or an alarm.
std::string member(const std::string& text, const std::string& key) {
  const std::string begin = "\"" + key + "\":\"";
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find('"', from) - from);
}

// What the text of a verdict is about: the class of an alarm, the kind of a record, "end".
std::string about(const std::string& text) {
  const std::string alarm = member(text, "class");
  if (!alarm.empty()) return alarm;
  const std::string kind = member(text, "k");
  return !kind.empty() ? kind : text == "end" ? text : std::string();
}

// The sentence without what changes from run to run: numbers, quoted parts.
std::string constant_part(const std::string& message) {
  constexpr std::size_t kMost = 80;
  std::string text;
  bool quoted = false;
  for (const char c : message) {
    if (c == '"' || c == '`') quoted = !quoted;
    if (!quoted && (c < '0' || c > '9')) text += c;
    if (text.size() == kMost) break;
  }
  return text;
}

bool broke_down(VerdictKind kind) {
  return kind >= VerdictKind::crash && kind <= VerdictKind::protocol;
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

Signature signature_of(const oracle::Verdict& verdict, const generate::GeneratedProgram& program) {
  Signature signature;
  signature.dialect = program.profile.dialect;
  signature.kind = verdict.kind;
  signature.clause = reference::clause_name(verdict.clause);
  if (broke_down(verdict.kind) || verdict.kind == VerdictKind::oracle_error) {
    signature.what = constant_part(verdict.message);
    return signature;
  }
  signature.what = fmt::format("{}/{}", about(verdict.want), about(verdict.got));
  signature.code = program::ProgramText(program.profile, program.text).code_at(verdict.block);
  return signature;
}

}  // namespace gonogo::hunt
