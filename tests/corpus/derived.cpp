// SPDX-License-Identifier: GPL-3.0-or-later
#include "derived.hpp"

#include <gtest/gtest.h>

#include "corpus_testing.hpp"

namespace gonogo::testing {
namespace {

using reference::Axis;
using reference::Record;
using reference::RecordKind;

std::string position_text(const std::string& prefix, reference::AxisSet axes,
                          const reference::Position& at) {
  std::string out;
  for (const Axis axis : reference::kAllAxes) {
    if (axes.has(axis)) out += " " + prefix + reference::letter(axis) + at[axis].text();
  }
  return out;
}

std::string line_of(const Record& record) {
  std::string out;
  if (record.kind != RecordKind::end) out += std::to_string(record.block) + " ";
  out += reference::name(record.kind);
  if (record.kind == RecordKind::m) return out + " " + std::to_string(record.m);
  if (record.kind == RecordKind::dwell) return out + " " + record.seconds.text();
  if (record.kind == RecordKind::arc) {
    const reference::PlaneAxes axes = reference::axes_of(record.plane);
    reference::Position centre;
    centre[axes.p] = record.centre[0];
    centre[axes.q] = record.centre[1];
    out += " G" + std::to_string(reference::plane_code(record.plane)) + " " +
           std::to_string(record.rot) + position_text("c", {axes.p, axes.q}, centre);
  }
  out += position_text("", record.axes, record.to);
  if (record.kind == RecordKind::feed || record.kind == RecordKind::arc) {
    out += " f" + record.feed.text();
    if (record.feed_mode == reference::FeedMode::per_revolution) out += "/rev";
  }
  if (record.kind == RecordKind::thread) out += " lead" + record.lead.text();
  return out;
}

}  // namespace

Lines records_of(const std::string& id, std::size_t expectation) {
  Lines lines;
  for (const Record& record : checked_in_expectation(id, expectation).records) {
    lines.push_back(line_of(record));
  }
  return lines;
}

Lines operator+(Lines a, const Lines& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace gonogo::testing
