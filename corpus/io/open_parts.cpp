// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference says a program twice: with a path for each step that is left open, and with the
// step itself in its place. What the first has where the second has the step is the open part.
#include "corpus/io/open_parts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "grammar/line_source.hpp"
#include "reference/descriptor.hpp"
#include "reference/dialect.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {
namespace {

using reference::axes_of;
using reference::HelixPocket;
using reference::Item;
using reference::letter;
using reference::Number;
using reference::Plane;
using reference::PlaneAxes;
using reference::PocketLevel;
using reference::PocketMilling;
using reference::Record;
using reference::ThreadMilling;

// What a step says of itself, as the keys of a JSON object.
class Conditions {
 public:
  explicit Conditions(Plane plane) : axes_(axes_of(plane)) {
    out_ = "{\"plane\":\"G" + std::to_string(reference::plane_code(plane)) + '"';
  }
  Conditions& number(std::string_view key, const Number& value) {
    name(key);
    value.append_json(out_);
    return *this;
  }
  Conditions& flag(std::string_view key, bool value) {
    name(key);
    out_ += value ? "true" : "false";
    return *this;
  }
  Conditions& centre(const std::array<Number, 2>& at) {
    name("centre");
    out_ += std::string("{\"") + letter(axes_.p) + "\":";
    at[0].append_json(out_);
    out_ += std::string(",\"") + letter(axes_.q) + "\":";
    at[1].append_json(out_);
    out_ += '}';
    return *this;
  }
  // Which way round, and the feed of the cuts.
  Conditions& cut(int sense, const Number& feed, reference::FeedMode mode) {
    name("rot");
    out_ += std::to_string(sense);
    number("f", feed);
    if (mode == reference::FeedMode::per_revolution) out_ += ",\"fm\":\"rev\"";
    return *this;
  }
  std::string text() { return out_ + '}'; }

 private:
  void name(std::string_view key) {
    out_ += ",\"";
    out_ += key;
    out_ += "\":";
  }
  PlaneAxes axes_;
  std::string out_;
};

std::string conditions_of(const PocketLevel& level) {
  return Conditions(level.plane)
      .centre(level.centre)
      .number("depth", level.depth)
      .number("radius", level.pocket_radius)
      .number("tool_radius", level.tool_radius)
      .number("step", level.step)
      .cut(level.sense, level.feed, level.feed_mode)
      .text();
}

std::string conditions_of(const HelixPocket& pocket) {
  return Conditions(pocket.plane)
      .centre(pocket.centre)
      .number("from", pocket.r_plane)
      .number("depth", pocket.bottom)
      .number("path_radius", pocket.radius)
      .number("turns", pocket.turns)
      .flag("flat_turn", pocket.flat)
      .cut(pocket.sense, pocket.feed, pocket.feed_mode)
      .text();
}

std::string conditions_of(const ThreadMilling& thread) {
  return Conditions(thread.plane)
      .centre(thread.centre)
      .flag("external", thread.external)
      .number("from", thread.r_plane)
      .number("depth", thread.bottom)
      .number("initial_plane", thread.initial_plane)
      .number("lead", thread.lead)
      .number("start_radius", thread.start_radius)
      .number("tool_radius", thread.tool_radius)
      .number("height", thread.height)
      .number("infeed", thread.infeed)
      .number("run_out_length", thread.runout_length)
      .number("run_out_angle", thread.runout_angle)
      .cut(thread.sense, thread.feed, thread.feed_mode)
      .text();
}

std::string conditions_of(const PocketMilling& pocket) {
  return Conditions(pocket.plane)
      .centre(pocket.centre)
      .number("cosine", pocket.direction[0])
      .number("sine", pocket.direction[1])
      .number("clearance", pocket.clearance)
      .number("reference_plane", pocket.reference_plane)
      .number("retract", pocket.retract)
      .number("depth", pocket.floor)
      .number("length", pocket.length)
      .number("width", pocket.width)
      .number("corner_radius", pocket.corner_radius)
      .number("allowance", pocket.allowance)
      .number("tool_radius", pocket.tool_radius)
      .number("infeed", pocket.infeed)
      .flag("finishing", pocket.finishing)
      .flag("contour_only", pocket.contour_only)
      .number("plunge_f", pocket.depth_feed)
      .cut(pocket.sense, pocket.plane_feed, pocket.feed_mode)
      .text();
}

// A record by its text, or a step that stands for any number of records.
struct Element {
  std::string record;
  std::optional<OpenPart> step;
};

std::vector<Element> elements_of(const reference::Profile& profile, std::string_view program) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::judged);
  std::vector<Element> elements;
  const auto add = [&](const char* name, const auto& step) {
    elements.push_back({{}, OpenPart{0, 0, step.clause, name, conditions_of(step)}});
  };
  while (const Item* item = expander.next()) {
    if (auto* record = std::get_if<Record>(item)) {
      append_json(*record, elements.emplace_back().record);
    } else if (auto* level = std::get_if<PocketLevel>(item)) {
      add("pocket-level", *level);
    } else if (auto* helix = std::get_if<HelixPocket>(item)) {
      add("helical-pocket", *helix);
    } else if (auto* thread = std::get_if<ThreadMilling>(item)) {
      add("thread", *thread);
    } else if (auto* pocket = std::get_if<PocketMilling>(item)) {
      add("pocket", *pocket);
    }
  }
  return elements;
}

}  // namespace

// Each step takes as few records as what follows it allows; where that leads no further, the last
// step before it takes one more.
std::vector<OpenPart> open_parts(const reference::Profile& profile, std::string_view program,
                                 const std::vector<Record>& records) {
  const auto codes = reference::find_dialect(profile.dialect)->descriptor->codes;
  if (std::ranges::none_of(codes, &reference::Code::is_open_path)) return {};
  std::vector<Element> elements = elements_of(profile, program);
  std::vector<OpenPart> parts;
  std::size_t after_step = 0;  // the element behind the last step
  std::size_t next = 0;
  const auto take_step = [&](std::size_t at) {
    if (next == elements.size() || !elements[next].step) return false;
    parts.push_back(std::move(*elements[next].step));
    parts.back().from = parts.back().to = at;
    after_step = ++next;
    return true;
  };
  std::string text;
  for (std::size_t at = 0; at < records.size();) {
    if (take_step(at)) continue;
    text.clear();
    append_json(records[at], text);
    if (next < elements.size() && elements[next].record == text) {
      ++next;
      ++at;
    } else if (!parts.empty()) {
      next = after_step;
      at = ++parts.back().to;
    } else {
      throw CorpusError("The reference says the path in two ways.");
    }
  }
  take_step(records.size());
  if (next != elements.size()) throw CorpusError("The reference says the path in two ways.");
  return parts;
}

}  // namespace gonogo::oracle
