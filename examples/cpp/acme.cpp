// SPDX-License-Identifier: MIT-0
//
// A subject in C++ that computes in whole nanometres and gives its numbers as decimals, so that the
// gauge sees exactly what it computed. It expands straight lines of RS274: G0 and G1 with X, Y and
// Z, F, G20 and G21, G90 and G91, M2 and M30; what else stands in a program it does not support.
#include <gonogo/subject.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <string>
#include <string_view>

namespace {

constexpr std::int64_t kMillimetre = 1'000'000;  // nanometres
constexpr int kMostDigits = 12;                  // of a number: no overflow, also in inches

struct NotSupported {
  std::string feature;
};
struct Alarm {
  std::string_view klass;
  char word;
};
struct Stopped {};

gonogo_text text_of(std::string_view text) {
  return {text.data(), text.size()};
}

std::string decimal(std::int64_t nanometres) {
  std::string digits = std::to_string(nanometres < 0 ? -nanometres : nanometres);
  if (digits.size() < 7) digits.insert(0, 7 - digits.size(), '0');
  digits.insert(digits.size() - 6, ".");
  return nanometres < 0 ? '-' + digits : digits;
}

// The words of one line, blanks dropped, letters in upper case.
class Words {
 public:
  explicit Words(std::string_view line) {
    for (char c : line) {
      if (c == ' ' || c == '\t') continue;
      text_ += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  // The letter of the next word; 0 at the end.
  char letter() { return at_ < text_.size() ? text_[at_++] : '\0'; }
  // Its number in millionths.
  std::int64_t number(char letter) {
    const bool is_whole = letter == 'N';  // digits alone
    const bool negative = !is_whole && take('-');
    if (!negative && !is_whole) take('+');
    std::int64_t value = 0;
    int digits = 0;
    int decimals = -1;  // no point yet
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '.' && decimals < 0 && !is_whole) {
        decimals = 0;
      } else if (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) {
        value = 10 * value + (text_[at_] - '0');
        if (decimals >= 0) ++decimals;
        if (++digits > kMostDigits) throw NotSupported{"long numbers"};
      } else {
        break;
      }
    }
    if (digits == 0 || decimals > 6) throw NotSupported{std::string(1, letter)};
    for (int i = decimals < 0 ? 0 : decimals; i < 6; ++i) value *= 10;
    return negative ? -value : value;
  }

 private:
  bool take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string text_;
  std::size_t at_ = 0;
};

class Machine {
 public:
  explicit Machine(const gonogo_sink_v1& sink) : sink_(sink) {}

  void run(std::string_view program) {
    for (line_ = 1; !program.empty() && !ended_; ++line_) {
      const std::size_t end = std::min(program.find_first_of("\r\n"), program.size());
      block(program.substr(0, end));
      program.remove_prefix(end);
      program.remove_prefix(program.substr(0, 2) == "\r\n" ? 2 : program.empty() ? 0 : 1);
    }
    if (ended_) return;
    line_ = line_ > 1 ? line_ - 1 : 1;  // the last one
    throw Alarm{"program-end", 0};
  }

  void alarm(const Alarm& alarm) const {
    const gonogo_alarm_v1 told = {sizeof told, line_, text_of(alarm.klass), text_of(alarm.klass),
                                  alarm.word};
    sink_.alarm(sink_.context, &told);
  }

 private:
  using Values = std::map<char, std::int64_t>;

  void block(std::string_view line) {
    Words words(line);
    Values values;
    was_inches_ = inches_;  // F counts in the unit before the block
    any_g_ = false;
    std::array<bool, 3> groups{};
    while (const char letter = words.letter()) {
      if (std::string_view("NGXYZFM").find(letter) == std::string_view::npos) {
        throw NotSupported{std::string(1, letter)};
      }
      const std::int64_t value = words.number(letter);
      if (letter == 'G') {
        g_code(value, groups);
      } else {
        take(letter, value, values);
      }
    }
    execute(values, groups[0]);
  }

  void take(char letter, std::int64_t value, Values& values) const {
    const bool first = values.empty() && !any_g_;
    if (letter == 'N' && !first) throw NotSupported{"N inside a block"};
    if (letter == 'M' && value != 2 * kMillimetre && value != 30 * kMillimetre) {
      throw NotSupported{"M"};
    }
    if (letter == 'F') value = length(value, was_inches_);
    if (!values.emplace(letter, value).second) throw Alarm{"duplicate-word", letter};
  }

  void g_code(std::int64_t millionths, std::array<bool, 3>& groups) {
    const std::int64_t code = millionths % kMillimetre == 0 ? millionths / kMillimetre : -1;
    int group = 0;
    switch (code) {
      case 0:
      case 1:
        motion_ = static_cast<int>(code);
        break;
      case 20:
      case 21:
        group = 1;
        inches_ = code == 20;
        break;
      case 90:
      case 91:
        group = 2;
        incremental_ = code == 91;
        break;
      default:
        throw NotSupported{"G" + decimal(millionths)};
    }
    any_g_ = true;
    bool& seen = groups[static_cast<std::size_t>(group)];
    if (seen) throw Alarm{"duplicate-word", 'G'};
    seen = true;
  }

  static std::int64_t length(std::int64_t millionths, bool inches) {
    if (!inches) return millionths;
    if (millionths % 5 != 0) throw NotSupported{"inches below the nanometre"};
    return millionths / 5 * 127;
  }

  // `names_motion`: the block has a G0 or a G1.
  void execute(const Values& values, bool names_motion) {
    ended_ = values.find('M') != values.end();
    if (auto f = values.find('F'); f != values.end()) feed_ = f->second;
    if (feed_ < 0) throw Alarm{"value-sign", 'F'};
    const bool moves = values.count('X') + values.count('Y') + values.count('Z') > 0;
    if (!moves && !names_motion) return;
    if (!motion_) throw Alarm{"missing-word", 'G'};
    if (*motion_ == 1 && feed_ == 0) throw Alarm{"feed-missing", 'F'};
    if (moves) move(values);
  }

  void move(const Values& values) {
    gonogo_record_v1 record{};
    record.struct_size = sizeof record;
    record.kind = *motion_ == 0 ? GONOGO_RAPID : GONOGO_FEED;
    record.block = line_;
    std::array<std::string, 4> texts;  // valid until the sink returns
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto word = values.find("XYZ"[axis]);
      if (word == values.end()) continue;
      at_[axis] = length(word->second, inches_) + (incremental_ ? at_[axis] : 0);
      texts[axis] = decimal(at_[axis]);
      record.to[axis] = {GONOGO_NUMBER_TEXT, 0, text_of(texts[axis])};
    }
    if (*motion_ == 1) {
      texts[3] = decimal(feed_);
      record.f = {GONOGO_NUMBER_TEXT, 0, text_of(texts[3])};
    }
    if (sink_.record(sink_.context, &record) != 0) throw Stopped{};
  }

  const gonogo_sink_v1& sink_;
  std::uint64_t line_ = 0;
  std::array<std::int64_t, 3> at_{};
  std::int64_t feed_ = 0;
  bool inches_ = false;
  bool was_inches_ = false;  // before this block
  bool any_g_ = false;       // in this block
  bool incremental_ = false;
  bool ended_ = false;
  std::optional<int> motion_;
};

gonogo_answer note(const gonogo_sink_v1& sink, gonogo_answer answer, std::string_view text) {
  sink.note(sink.context, GONOGO_NOTE_ERROR, text_of(text));
  return answer;
}

// A handle: nothing is kept from run to run.
struct Handle {
  const gonogo_sink_v1* sink;
};

gonogo_text describe() {
  return text_of(R"({"protocol":1,"subject":{"name":"acme-cpp","version":"1.0.0"},)"
                 // A part of "basic" only: without "dialects" what is skipped is not claimed.
                 R"("features":["blocks"],)"
                 R"("numeric":{"kind":"fixed","resolution":"0.000001"}})");
}

int create(gonogo_text configuration, const gonogo_sink_v1* sink, void** handle) {
  constexpr std::string_view kExpected = R"({"dialect":"rs274","profile":{}})";
  if (std::string_view(configuration.data, configuration.size) != kExpected) {
    return note(*sink, GONOGO_UNSUPPORTED, "Only rs274 with its default profile is implemented.");
  }
  *handle = new (std::nothrow) Handle{sink};
  return *handle == nullptr ? GONOGO_ERROR : GONOGO_OK;
}

// No exception leaves the library.
int run(void* handle, gonogo_text program) {
  const gonogo_sink_v1& sink = *static_cast<Handle*>(handle)->sink;
  Machine machine(sink);
  try {
    machine.run({program.data, program.size});
    return GONOGO_OK;
  } catch (const Alarm& alarm) {
    machine.alarm(alarm);
    return GONOGO_ALARM;
  } catch (const NotSupported& missing) {
    return note(sink, GONOGO_UNSUPPORTED, missing.feature);
  } catch (const Stopped&) {
    return GONOGO_STOPPED;
  } catch (const std::exception& error) {
    return note(sink, GONOGO_ERROR, error.what());
  }
}

int reset(void*) {
  return GONOGO_OK;
}

void destroy(void* handle) {
  delete static_cast<Handle*>(handle);
}

}  // namespace

const gonogo_subject_v1* gonogo_get_subject(std::uint32_t abi) {
  static const gonogo_subject_v1 subject = {
      GONOGO_SUBJECT_ABI, sizeof subject, describe, create, run, reset, destroy};
  return abi >= GONOGO_SUBJECT_ABI ? &subject : nullptr;
}
