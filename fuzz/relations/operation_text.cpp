// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operations as programs: what each dialect writes for a motion, and for the cycles that do whole
// operations.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fuzz/relations/operation.hpp"

namespace gonogo::relations {
namespace {

enum class HoleCycles : std::uint8_t { none, codes, parameters };

struct Words {
  std::string_view dialect;
  std::string_view lathe_head;  // empty: no such machine
  std::string_view mill_head;
  bool x_diameter;
  std::string_view per_minute;
  std::string_view per_revolution;  // empty: the gauge does not read it
  std::string_view radius;          // of an arc
  std::string_view dwell;           // seconds behind it, or milliseconds
  bool dwell_in_ms;
  // Code of the cycle and word of its taper; empty: there is none.
  std::string_view face;
  std::string_view turn;
  std::string_view face_taper;
  std::string_view turn_taper;
  HoleCycles holes;
};

constexpr auto kWords = std::to_array<Words>({
    {"gsk988ta", "G18 G21 M3 S500", "", true, "G98", "G99", "R", "G04 X", false, "G94", "G90", "R",
     "R", HoleCycles::none},
    {"hnc21t", "G90 G21 G36 M3 S500", "", true, "G94", "G95", "R", "G04 P", true, "G81", "G80", "K",
     "I", HoleCycles::none},
    {"sinumerik802s", "G18 G90 G71 M3 S500", "G17 G90 G71 M3 S500", false, "G94", "G95",
     "CR=", "G4 F", false, "", "", "", "", HoleCycles::parameters},
    {"sinumerik840d", "G18 G90 G71 M3 S500", "G17 G90 G71 M3 S500", false, "G94", "G95",
     "CR=", "G4 F", false, "", "", "", "", HoleCycles::none},
    {"rs274", "G18 G90 G91.1 G21 G40 G80 M3 S500", "G17 G90 G91.1 G21 G40 G80 M3 S500", false,
     "G94", "", "R", "G4 P", false, "", "", "", "", HoleCycles::codes},
});

const Words* words_of(std::string_view dialect) {
  const auto* const found = std::ranges::find(kWords, dialect, &Words::dialect);
  return found == kWords.end() ? nullptr : found;
}

// The cycle of a hole, where the dialect has one cycle for it.
std::string_view hole_code(const Words& words, HoleKind kind) {
  constexpr auto kCodes =
      std::to_array<std::string_view>({"G81", "G82", "G83", "G73", "G85", "G89"});
  if (words.holes == HoleCycles::codes) return kCodes[static_cast<std::size_t>(kind)];
  const bool is_drilled = kind == HoleKind::drill || kind == HoleKind::dwell_drill;
  return words.holes == HoleCycles::parameters && is_drilled ? "LCYC82" : "";
}

std::string_view pass_code(const Words& words, OperationKind kind) {
  if (kind == OperationKind::face) return words.face;
  return kind == OperationKind::turn ? words.turn : std::string_view();
}

bool has_cycle(const Words& words, const Operation& operation) {
  return operation.kind == OperationKind::holes ? !hole_code(words, operation.hole).empty()
                                                : !pass_code(words, operation.kind).empty();
}

class Writer {
 public:
  Writer(const Words& words, const OperationList& list, bool has_cycles)
      : words_(words), is_mill_(list.machine == MachineKind::mill), has_cycles_(has_cycles) {
    line("{}", is_mill_ ? words.mill_head : words.lathe_head);
  }

  // False: it cannot be written.
  bool add(const Operation& operation) {
    if (operation.per_revolution && words_.per_revolution.empty()) return false;
    line("{}", operation.per_revolution ? words_.per_revolution : words_.per_minute);
    feed_ = " F" + operation.feed.text();
    const bool with_cycle = has_cycles_ && has_cycle(words_, operation);
    switch (operation.kind) {
      case OperationKind::contour:
        contour(operation);
        return true;
      case OperationKind::face:
      case OperationKind::turn:
        with_cycle ? pass_cycle(operation) : pass(operation);
        return true;
      case OperationKind::holes:
        if (!with_cycle && is_pecked(operation.hole)) return false;
        if (!with_cycle) {
          holes(operation);
        } else if (words_.holes == HoleCycles::parameters) {
          holes_by_parameters(operation);
        } else {
          holes_by_code(operation);
        }
        return true;
    }
    return false;
  }
  std::string end() {
    line("M30");
    return std::move(text_);
  }

 private:
  template <typename... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    text_ += fmt::format(format, std::forward<Values>(values)...) + "\n";
  }
  std::string x(const Number& radius) const {
    return " X" + (words_.x_diameter && !is_mill_ ? Number(2) * radius : radius).text();
  }
  std::string p(const Number& at) const { return is_mill_ ? x(at) : " Z" + at.text(); }
  std::string q(const Number& at) const { return is_mill_ ? " Y" + at.text() : x(at); }
  std::string place(const PlanePoint& at) const { return p(at.p) + q(at.q); }
  void dwell(const Number& seconds) {
    line("{}{}", words_.dwell, (words_.dwell_in_ms ? Number(1000) * seconds : seconds).text());
  }

  void cut(const PlanePoint& from, const Cut& cut) {
    if (cut.rot == 0) {
      line("G1{}{}", place(cut.to), feed_);
      return;
    }
    const std::string_view code = cut.rot > 0 ? "G3" : "G2";
    if (cut.by_radius) {
      line("{}{} {}{}{}", code, place(cut.to), words_.radius, cut.radius.text(), feed_);
      return;
    }
    const std::string along_p = (cut.centre.p - from.p).text();
    const std::string along_q = (cut.centre.q - from.q).text();
    line("{}{} {}{} {}{}{}", code, place(cut.to), is_mill_ ? "I" : "K", along_p,
         is_mill_ ? "J" : "I", along_q, feed_);
  }

  void contour(const Operation& operation) {
    if (is_mill_) line("G0 Z{}", operation.level.text());
    line("G0{}", place(operation.start));
    if (is_mill_) line("G1 Z{}{}", operation.depth.text(), feed_);
    PlanePoint at = operation.start;
    for (const Cut& each : operation.cuts) {
      cut(at, each);
      at = each.to;
    }
    if (is_mill_) line("G0 Z{}", operation.level.text());
  }

  // Along the one axis to where the cut begins, to the corner, out along the other, and back.
  void pass(const Operation& operation) {
    const bool is_face = operation.kind == OperationKind::face;
    line("G0{}", place(operation.start));
    if (is_face) {
      line("G0{}", p(operation.end.p + operation.taper));
    } else {
      line("G0{}", q(operation.end.q + operation.taper));
    }
    line("G1{}{}", place(operation.end), feed_);
    line("G1{}{}", is_face ? p(operation.start.p) : q(operation.start.q), feed_);
    line("G0{}", is_face ? q(operation.start.q) : p(operation.start.p));
  }
  void pass_cycle(const Operation& operation) {
    line("G0{}", place(operation.start));
    const std::string_view word =
        operation.kind == OperationKind::face ? words_.face_taper : words_.turn_taper;
    const std::string_view code = pass_code(words_, operation.kind);
    // hnc.modal.words: that of the last cycle may be in force again, if it was the same cycle.
    const bool is_tapered = operation.taper.sign() != 0;
    const bool is_written = is_tapered || (code == tapered_ && words_.dialect == "hnc21t");
    tapered_ = is_tapered ? code : std::string_view();
    const std::string taper =
        is_written ? fmt::format(" {}{}", word, operation.taper.text()) : std::string();
    line("{}{}{}{}", code, place(operation.end), taper, feed_);
    line("G0{}", place(operation.start));
  }

  void holes(const Operation& operation) {
    const Number& back = operation.ends_at_r ? operation.r : operation.level;
    line("G0 Z{}", operation.level.text());
    for (const PlanePoint& at : operation.places) {
      line("G0{}", place(at));
      line("G0 Z{}", operation.r.text());
      line("G1 Z{}{}", operation.depth.text(), feed_);
      if (operation.dwell.sign() > 0) dwell(operation.dwell);
      // G85 feeds out to the R plane, G89 to where it ends (NGC-G85-01, NGC-G89-01).
      if (operation.hole == HoleKind::ream) line("G1 Z{}{}", operation.r.text(), feed_);
      const bool is_fed = operation.hole == HoleKind::bore;
      line("{} Z{}{}", is_fed ? "G1" : "G0", back.text(), is_fed ? feed_ : std::string());
    }
  }
  void holes_by_code(const Operation& operation) {
    line("G0 Z{}", operation.level.text());
    std::string words = fmt::format(
        "{} {}{} Z{} R{}", operation.ends_at_r ? "G99" : "G98", hole_code(words_, operation.hole),
        place(operation.places.front()), operation.depth.text(), operation.r.text());
    if (operation.peck.sign() > 0) words += " Q" + operation.peck.text();
    if (operation.dwell.sign() > 0) words += " P" + operation.dwell.text();
    line("{}{}", words, feed_);
    for (std::size_t i = 1; i < operation.places.size(); ++i) {
      line("{}", place(operation.places[i]).substr(1));
    }
    line("G80");
  }
  void holes_by_parameters(const Operation& operation) {
    line("G0 Z{}", operation.level.text());
    line("{}", feed_.substr(1));
    for (const PlanePoint& at : operation.places) {
      line("G0{}", place(at));
      line("R101={} R102=0 R103={} R104={} R105={}",
           (operation.ends_at_r ? operation.r : operation.level).text(), operation.r.text(),
           operation.depth.text(), operation.dwell.text());
      line("{}", hole_code(words_, operation.hole));
    }
  }

  const Words& words_;
  const bool is_mill_;
  const bool has_cycles_;
  std::string_view tapered_;  // code of the last cycle, if it had a taper
  std::string feed_;
  std::string text_;
};

}  // namespace

bool has_cycle_for(const OperationList& list, std::string_view dialect) {
  const Words* const words = words_of(dialect);
  return words != nullptr && std::ranges::any_of(list.operations, [&](const Operation& each) {
           return has_cycle(*words, each);
         });
}

std::string written(const OperationList& list, const Notation& notation) {
  const Words* const words = words_of(notation.dialect);
  if (words == nullptr) return {};
  const bool is_mill = list.machine == MachineKind::mill;
  if ((is_mill ? words->mill_head : words->lathe_head).empty()) return {};
  Writer writer(*words, list, notation.has_cycles);
  for (const Operation& operation : list.operations) {
    if (!writer.add(operation)) return {};
  }
  return writer.end();
}

}  // namespace gonogo::relations
