// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/interpreter.hpp"

namespace gonogo::expanders::hnc {
namespace {

// In the order of AlarmKind.
constexpr AlarmNumbers kNumbers{"SYN01", "SYN02", "SYN03", "SYN04", "SYN05", "VAL01",
                                "VAL02", "VAL03", "",      "PTH02", "PTH05", "",
                                "",      "PTH06", "MOD01", "MOD02", "",      "PTH01",
                                "",      "",      "",      "",      "PTH03", "PTH04"};

/// Codes of one group exclude each other.
enum class Group : GroupNumber {
  kMotion,
  kOnce,      // for their block
  kDistance,  // G90, G91
  kUnits,     // G20, G21
  kDiameter,  // G36, G37
  kFrame,     // G54 to G59
  kFeedMode,  // G94, G95
  kPlane,     // G17 to G19
  kRadius,    // G40 to G42
  kSpindle,   // G96, G97
  kPathMode,  // G61, G64
  kFree       // any number of them
};

constexpr CodeRow kRows[] = {
    {Group::kMotion, Support::kFull, "0 1 2 3 32 74 75 80 81 82"},
    {Group::kMotion, Support::kOutside, "71 72 73 76"},
    {Group::kOnce, Support::kFull, "4 92"},
    {Group::kOnce, Support::kOutside, "28 29 65"},
    {Group::kDistance, Support::kFull, "90 91"},
    {Group::kUnits, Support::kFull, "20 21"},
    {Group::kDiameter, Support::kFull, "36 37"},
    {Group::kFrame, Support::kFull, "54 55 56 57 58 59"},
    {Group::kFeedMode, Support::kFull, "94 95"},
    {Group::kPlane, Support::kFull, "17 18 19"},
    {Group::kRadius, Support::kNoEffect, "40"},
    {Group::kRadius, Support::kOutside, "41 42"},
    {Group::kSpindle, Support::kNoEffect, "96 97"},
    {Group::kPathMode, Support::kNoEffect, "61 64"},
    {Group::kFree, Support::kOutside, "46 52 53 70 98 99"},
};
constexpr CodeTable kCodes{kRows};

// Words of the macro language that begin a statement or a function.
constexpr std::string_view kMacroWords[] = {
    "IF",  "ELSE", "ENDIF", "WHILE", "ENDW", "DO",   "END", "GOTO", "CALL", "AR", "SIN",
    "COS", "TAN",  "ATAN",  "ABS",   "INT",  "SQRT", "EXP", "SIGN", "PI",   "RL", "RC"};

}  // namespace

Motion motion_of(int code) {
  switch (code) {
    case 32:
      return Motion::kThread;
    case 74:
      return Motion::kDrill;
    case 75:
      return Motion::kGroove;
    case 80:
      return Motion::kTurn;
    case 81:
      return Motion::kFace;
    case 82:
      return Motion::kThreadCycle;
    default:
      return static_cast<Motion>(code);
  }
}

Machine::Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink,
                 Planted<Fault> planted)
    : expanders::Machine(machine_profile, sink, state.position, planted) {
  state.position = profile.position;
  if (!follows("hnc.offset.initial=none"_reading)) state.frame = &profile.offsets[0];
  state.inch = profile.inch;
  state.diameter = profile.x_diameter;
  state.feed = profile.feed;
  state.motion = motion_of(profile.motion);
}

Interpreter::Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink,
                         Planted<Fault> planted)
    : LetterInterpreter(machine_, kNumbers), machine_(profile, sink, planted) {}

Interpreter::Lines Interpreter::lines() const {
  const bool lost = machine_.has("blank-lines-not-counted"_fault);
  return {lost ? Counting::kWithoutBlank : Counting::kAll, machine_.has("alarm-next-block"_fault)};
}

LetterBlock::Manner Interpreter::manner() const {
  return {.codes = kCodes,
          .free_group = static_cast<GroupNumber>(Group::kFree),
          .macro_words = kMacroWords,
          .named_by_tape_mark = true,
          .block_skip = machine_.profile.block_skip};
}

bool Interpreter::is_apart() const {
  return block().code(Group::kOnce) != nullptr;
}

// The motion code in force once the block is read.
Motion Interpreter::coming_motion() const {
  const Code* code = block().code(Group::kMotion);
  return code == nullptr ? machine_.state.motion : motion_of(code->tenths / 10);
}

// Words that this expander has a use for, or may ignore, under a motion code; an empty set is
// that of G00 and G01. HNC-MOD-05: the cycles take in each other's words.
AddressSet Interpreter::words_of(Motion motion) const {
  constexpr AddressSet kPlain{"XUZW"};
  constexpr AddressSet kCycle{"XUZWIKRECAPJQ"};
  if (block().has_code(Group::kOnce, 4)) return AddressSet{"P"};
  if (is_apart()) return kPlain;
  switch (motion) {
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return AddressSet{"XUZWRIK"};
    case Motion::kThread:
      return AddressSet{"XUZWJREPCQKI"};
    default:
      return is_cycle(motion) ? kCycle : kPlain;
  }
}

// A program with Y outside of the turning cycles is one for a mill; words that a control may
// chamfer, round or offset by; words that shape the thread of G32.
void Interpreter::check_coverage() {
  constexpr AddressSet kAnywhere{"FMSTYV"};
  const Motion motion = coming_motion();
  for (const char address : {'Y', 'V'}) {
    if (block().has(address) && !is_cycle(motion)) machine_.lacking = address;
  }
  const char stray =
      block().unknown_code() ? char{0} : stray_word(block(), words_of(motion), kAnywhere);
  if (stray != 0) machine_.lacking = stray;
  if (motion != Motion::kThread || is_apart()) return;
  for (const char address : {'R', 'E', 'P', 'C', 'Q', 'K', 'I'}) {
    if (!block().has(address)) continue;
    const Decimal& number = block().number(address);
    if (number.value != 0 || number.finer) machine_.lacking = "G32";
  }
}

void Interpreter::check_words() {
  const Code* plane = block().code(Group::kPlane);
  if (plane != nullptr && plane->tenths != 180) {  // HNC-MOD-05
    machine_.complain(AlarmKind::kPlaneNotAllowed, 'G', block().code_position(Group::kPlane));
  }
  for (const char address : {'Y', 'V'}) {
    if (block().has(address)) machine_.complain(AlarmKind::kUndefinedCode, address, block());
  }
  hnc::check_words(machine_, block());
}

void Interpreter::take_modal_codes() {
  State& state = machine_.state;
  if (const Code* code = block().code(Group::kUnits)) take_units(code->tenths == 200);
  if (const Code* code = block().code(Group::kDiameter)) state.diameter = code->tenths == 360;
  if (const Code* code = block().code(Group::kDistance)) state.incremental = code->tenths == 910;
  if (const Code* code = block().code(Group::kFeedMode)) {
    const bool changes = state.per_revolution != (code->tenths == 950);
    state.per_revolution = code->tenths == 950;
    if (changes && machine_.follows("hnc.feed-change=deleted"_reading)) {
      state.feed = state.store.feed = 0;
    }
  }
  if (const Code* code = block().code(Group::kFrame)) {
    state.frame = &machine_.profile.offsets[code->tenths / 10u - 54];
  }
}

// An F that was programmed keeps its length or, by reading hnc.feed-units, its number; so do the
// lengths of a cycle by hnc.retained.
void Interpreter::take_units(bool inch) {
  State& state = machine_.state;
  const bool changes = state.inch != inch;
  state.inch = inch;
  if (!changes) return;
  const auto keep_number = [&](Fixed& length) {
    length = static_cast<Fixed>(inch ? scaled(length, 254, 10) : scaled(length, 10, 254));
  };
  if (machine_.follows("hnc.retained=number"_reading)) {
    for (CycleStore* store : {&state.store, &state.kept}) {
      for (Retained* word : {&store->taper, &store->withdrawal, &store->infeed, &store->run_out_z,
                             &store->run_out_x}) {
        keep_number(word->value);
      }
    }
  }
  if (!state.feed_programmed || !machine_.follows("hnc.feed-units=number"_reading)) return;
  keep_number(state.feed);
  keep_number(state.store.feed);
}

// HNC-MOD-01: another command forgets the words of the one in force; the same code is none, or as
// the reading says one.
void Interpreter::take_motion() {
  State& state = machine_.state;
  const Motion coming = coming_motion();
  state.named = block().code(Group::kMotion) != nullptr;
  if (coming == state.motion) {
    const bool clears = state.named && is_cycle(coming);
    if (clears && machine_.follows("hnc.rewrite=clear"_reading)) state.store = {};
    return;
  }
  const Motion before = state.motion;
  if (machine_.has("cycle-survives-rapid"_fault) && is_cycle(before) && coming == Motion::kRapid) {
    return;
  }
  const CycleStore left = state.store;
  state.store = {};
  state.motion = coming;
  take_up_words(machine_, before, left);
  const bool plain = coming == Motion::kRapid || coming == Motion::kLine;
  const bool was_plain = before == Motion::kRapid || before == Motion::kLine;
  if (machine_.has("taper-leaks-past-rapid"_fault) && (plain || was_plain)) {
    state.store.taper = left.taper;
  }
  if (machine_.has("withdrawal-leaks-into-groove"_fault) && before == Motion::kDrill &&
      coming == Motion::kGroove) {
    state.store.withdrawal = left.withdrawal;
    state.store.infeed = left.infeed;
  }
}

// F, and J of threads: the feed or the lead, by the motion code in force.
void Interpreter::take_speed() {
  if (!is_thread(machine_.state.motion)) return take_feed();
  const bool both = machine_.follows("hnc.lead.unit=units-tpi"_reading);
  const bool converts = both || machine_.follows("hnc.lead.unit=units"_reading);
  const bool inch_lead = machine_.state.inch && converts;
  const bool by_j = block().has('J');
  // HNC-G82-07, HNC-G82-08
  if (block().has('F') && by_j) {
    const char later = block().position('F') < block().position('J') ? 'J' : 'F';
    machine_.complain(AlarmKind::kConflictingWords, later, block());
  }
  take_lead('F', inch_lead);
  if (!by_j) return;
  take_lead('J', !machine_.has("inch-lead-as-millimetres"_fault));
  if (both || machine_.follows("hnc.lead.unit=tpi"_reading)) take_thread_count();
}

// J as threads to the inch.
void Interpreter::take_thread_count() {
  const Fixed count = block().number('J').value;
  if (count <= 0) return;
  const Wide lead = scaled(254 * kOne / 10, kOne, count);
  if (!fits(lead)) return machine_.complain(AlarmKind::kValueOutOfRange, 'J', block());
  machine_.state.store.lead = static_cast<Fixed>(lead);
}

void Interpreter::take_lead(char address, bool in_inches) {
  if (!block().has(address)) return;
  const Fixed written = block().number(address).value;
  if (written <= 0) return machine_.complain(AlarmKind::kValueSign, address, block());
  Fixed& lead = machine_.state.store.lead;
  lead = in_inches ? static_cast<Fixed>(scaled(written, 254, 10)) : written;
  if (address == 'F' && machine_.follows("hnc.g32.lead=feed"_reading)) store_feed(written);
}

void Interpreter::take_feed() {
  if (!block().has('F')) return;
  const Fixed written = block().number('F').value;
  if (written < 0) return machine_.complain(AlarmKind::kValueSign, 'F', block());
  const bool repeats = block().code(Group::kMotion) == nullptr;
  const bool in_cycle = is_cycle(machine_.state.motion);
  if (in_cycle && repeats && machine_.has("cycle-feed-stuck"_fault)) return;
  store_feed(written);
}

// HNC-MOD-04: reading hnc.modal.f decides whether a cycle's feed is the ordinary one.
void Interpreter::store_feed(Fixed written) {
  State& state = machine_.state;
  const bool cycle = is_cycle(state.motion);
  state.feed_programmed = true;
  const bool in_inches = state.inch && !machine_.has("inch-feed"_fault);
  const bool own = cycle && machine_.follows("hnc.modal.f=forgotten"_reading);
  (own ? state.store.feed : state.feed) =
      in_inches ? static_cast<Fixed>(scaled(written, 254, 10)) : written;
}

// One of the codes in force takes the words of the block.
void Interpreter::prepare(Plan& plan) {
  take_modal_codes();
  take_motion();
  take_speed();
  if (block().has_code(Group::kOnce, 4)) return prepare_dwell(machine_, block(), plan);
  if (block().has_code(Group::kOnce, 92)) return prepare_rename(machine_, block(), plan);
  switch (machine_.state.motion) {
    case Motion::kRapid:
    case Motion::kLine:
      return prepare_line(machine_, block(), plan);
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return prepare_arc(machine_, block(), plan);
    case Motion::kThread:
      return prepare_thread(machine_, block(), plan);
    case Motion::kDrill:
      return prepare_drill(machine_, block(), plan);
    case Motion::kGroove:
      return prepare_groove(machine_, block(), plan);
    case Motion::kTurn:
      return prepare_turn_cycle(machine_, block(), plan);
    case Motion::kFace:
      return prepare_face_cycle(machine_, block(), plan);
    case Motion::kThreadCycle:
      return prepare_thread_cycle(machine_, block(), plan);
  }
}

}  // namespace gonogo::expanders::hnc
