// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/expected_paths.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "capture/number_json.hpp"
#include "capture/sampled_path.hpp"
#include "oracle/judge/judge_session.hpp"
#include "reference/clause.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(const Position& point) {
  Json list = Json::array();
  for (const reference::Axis axis : reference::kAllAxes) list.push_back(json_of(point[axis]));
  return list;
}

const char* kind_name(const PathPiece& piece) {
  switch (piece.kind()) {
    case PieceKind::line:
      return "line";
    case PieceKind::traverse:
      return "traverse";
    case PieceKind::round:
      return piece.motion().record.kind == RecordKind::arc ? "arc" : "circle";
    case PieceKind::dwell:
      return "dwell";
    case PieceKind::stand:
      return "stand";
    case PieceKind::open:
      return "open";
  }
  return "open";
}

Json piece_json(const PathPiece& piece) {
  Json json;
  const Record& record = piece.motion().record;
  json["k"] = kind_name(piece);
  if (piece.kind() == PieceKind::open) {
    json["why"] = piece.text();
    return json;
  }
  if (record.block != 0) json["b"] = record.block;
  json["from"] = point_json(piece.motion().from);
  json["to"] = point_json(record.to);
  if (piece.kind() == PieceKind::dwell) json["s"] = json_of(record.seconds);
  if (piece.has_feed()) json["f"] = json_of(record.feed);
  if (record.kind == RecordKind::arc) {
    const reference::PlaneAxes axes = reference::axes_of(record.plane);
    json["axes"] = {reference::index(axes.p), reference::index(axes.q)};
    json["c"] = {json_of(record.centre[0]), json_of(record.centre[1])};
    json["rot"] = record.rot;
  }
  return json;
}

// How the program ends: with which alarm, if any.
Json end_json(const reference::Profile& profile, const ProgramText& program) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  Json end = Json::object();
  while (const reference::Item* item = expander.next()) {
    const auto* report = std::get_if<reference::AlarmReport>(item);
    if (report == nullptr) continue;
    end["b"] = report->block;
    for (const reference::AdmittedClass& one : reference::admitted_classes(*report)) {
      end["classes"].push_back(reference::name(one.alarm));
    }
    const reference::ClauseId clause = reference::best_supported(*report).clause;
    end["silent"] = clause != reference::kNoClause &&
                    reference::clause(clause).basis() == reference::Basis::silent;
    return end;
  }
  return end;
}

Json way_json(const reference::Profile& profile, const ProgramText& program) {
  Tolerances tolerances;
  tolerances.tolerance = profile.resolution();
  SampledPath path(profile, program, tolerances, reference::kEveryAxis, 1);
  Json way;
  way["pieces"] = Json::array();
  for (std::size_t i = 0; const PathPiece* piece = path.piece(i); ++i) {
    way["pieces"].push_back(piece_json(*piece));
    path.drop_before(i);
  }
  way["end"] = end_json(profile, program);
  return way;
}

}  // namespace

std::string expected_paths(const reference::Profile& profile, std::string_view program) {
  Json json;
  json["tolerance"] = json_of(profile.resolution());
  json["start"] = point_json(profile.initial.at);
  json["ways"] = Json::array();
  const Assignments assignments = assignments_of(profile, program);
  if (!assignments.too_many) {
    for (const reference::ReadingChoice& choice : assignments.choices) {
      reference::Profile assigned = profile;
      assigned.readings = choice;
      Json way = way_json(assigned, program);
      if (std::ranges::find(json["ways"], way) == json["ways"].end()) {
        json["ways"].push_back(std::move(way));
      }
    }
  }
  return json.dump();
}

}  // namespace gonogo::oracle
