// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/results.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

namespace gonogo::checker {
namespace {

constexpr std::array<std::string_view, 4> kGo = {"pass-exact", "pass-rounded", "pass-tolerance",
                                                 "pass-properties"};
constexpr std::array<std::string_view, 3> kNeither = {"xfail", "skip", "advice"};
constexpr std::array<std::string_view, 18> kNoGo = {"fail.geometry",
                                                    "fail.order",
                                                    "fail.feed",
                                                    "fail.region",
                                                    "fail.reading",
                                                    "fail.overrun",
                                                    "fail.alarm-missing",
                                                    "fail.alarm-spurious",
                                                    "fail.alarm-class",
                                                    "fail.alarm-late",
                                                    "fail.declaration",
                                                    "state-leak",
                                                    "crash",
                                                    "timeout",
                                                    "out-of-memory",
                                                    "protocol",
                                                    "unmapped-alarm",
                                                    "xpass"};
constexpr std::array<std::string_view, 2> kUndecided = {"oracle-gap", "oracle-error"};

}  // namespace

bool is_judged(std::string_view verdict) {
  const auto decision = decision_of(verdict);
  return decision == Decision::go || decision == Decision::no_go;
}

std::optional<Decision> decision_of(std::string_view verdict) {
  const auto is_in = [&](const auto& names) {
    return std::ranges::find(names, verdict) != names.end();
  };
  if (is_in(kGo)) return Decision::go;
  if (is_in(kNoGo)) return Decision::no_go;
  if (is_in(kNeither)) return Decision::neither;
  if (is_in(kUndecided)) return Decision::undecided;
  return std::nullopt;
}

ResultsFile::ResultsFile(std::string path) : path_(std::move(path)), in_(path_, std::ios::binary) {
  if (!in_) throw Fault(path_ + " cannot be opened.");
  if (std::filesystem::is_directory(path_)) {
    throw Fault(path_ + " is a folder: name the results.jsonl in it.");
  }
  if (!read_line()) throw Fault(path_ + " is empty: a results file begins with its header.");
  header_ = parse_json(text_);
  const auto format = header_.integer_of("format");
  if (format != 1 && format != 2) throw Fault(path_ + " is of another format than 1 and 2.");
}

void ResultsFile::fault(const std::string& sentence) {
  faults_.push_back("line " + std::to_string(number_) + ": " + sentence);
}

bool ResultsFile::read_line() {
  if (!std::getline(in_, text_)) return false;
  ++number_;
  if (in_.eof()) fault("The line has no end: the file is cut off.");
  return true;
}

bool ResultsFile::next(Json& line) {
  if (footer_ || !read_line()) return false;
  try {
    line = parse_json(text_);
    if (line.find("id") == nullptr && line.find("totals") != nullptr) {
      footer_ = line;
      check_footer();
      if (read_line()) fault("A line follows the footer.");
      return false;
    }
    note_case(line);
    return true;
  } catch (const Fault& wrong) {
    throw Fault(path_ + ", line " + std::to_string(number_) + ": " + wrong.what());
  }
}

void ResultsFile::note_case(const Json& line) {
  const std::string& id = line.text_of("id");
  if (cases_ > 0 && id == last_id_) fault("The case " + id + " is there a second time.");
  if (cases_ > 0 && id < last_id_) fault("The case " + id + " is not in the order of ids.");
  last_id_ = id;
  ++cases_;
  const std::string& verdict = line.text_of("verdict");
  const auto decision = decision_of(verdict);
  if (!decision) fault("The verdict " + verdict + " is unknown.");
  ++totals_[verdict];
  bool& judged = judged_[line.text_of("dialect")];
  judged = judged || is_judged(verdict);
  if (decision == Decision::undecided) {
    unexpected_gap_ =
        unexpected_gap_ || verdict == "oracle-error" || line.find("expected") == nullptr;
  }
  // The hash is over the line as it stands, without these members.
  std::string hashed = "{";
  for (std::size_t i = 0; i < line.members.size(); ++i) {
    const auto& [key, value] = line.members[i];
    if (key == "us" || key == "attempts" || key == "notes") continue;
    if (hashed.size() > 1) hashed += ',';
    hashed += '"' + key + "\":" + text_.substr(value.begin, value.end - value.begin);
  }
  hash_.update(hashed + "}\n");
}

void ResultsFile::check_footer() {
  const std::string& stated = footer_->text_of("sha256");
  const std::string hash = hash_.hex();
  if (stated != hash) {
    fault("The footer says that the case lines have the SHA-256 " + stated + "; they have " + hash +
          ".");
  }
  std::map<std::string, std::size_t> totals;
  for (const auto& [verdict, count] : footer_->member("totals", Json::Kind::object).members) {
    totals[verdict] = static_cast<std::size_t>(count.integer());
  }
  if (totals != totals_) fault("The totals of the footer are not those of the lines.");
  std::size_t judged = 0;
  for (const auto& [verdict, count] : totals_) {
    if (is_judged(verdict)) judged += count;
  }
  if (static_cast<std::size_t>(footer_->integer_of("judged")) != judged) {
    fault("The footer counts another number of judged cases than the lines have.");
  }
  if (const Json* cases = footer_->find("cases");
      cases != nullptr && static_cast<std::size_t>(cases->integer()) != cases_) {
    fault("The footer counts another number of cases than the file has.");
  }
  check_decision();
  check_head();
}

namespace {

// 18,000
std::string grouped(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ',');
  return digits;
}

// Fewer than a tenth were judged of fifty fresh programs of a dialect or more.
bool answers_by_heart(const Json& footer) {
  const Json* fresh = footer.find("fresh");
  if (fresh == nullptr) return false;
  return std::ranges::any_of(fresh->members, [](const JsonMember& dialect) {
    const auto programs = dialect.value.integer_of("programs");
    return programs >= 50 && 10 * dialect.value.integer_of("judged") < programs;
  });
}

}  // namespace

void ResultsFile::check_decision() {
  const bool no_go = std::ranges::any_of(
      totals_, [](const auto& total) { return decision_of(total.first) == Decision::no_go; });
  const Json* stale = footer_->find("stale");
  const bool is_stale = stale != nullptr && !stale->items.empty();
  const bool unjudged =
      judged_.empty() ||
      std::ranges::any_of(judged_, [](const auto& dialect) { return !dialect.second; });
  const std::string_view decision = no_go || is_stale ? "NO-GO"
                                    : unjudged || unexpected_gap_ || answers_by_heart(*footer_)
                                        ? "UNDECIDED"
                                        : "GO";
  if (footer_->text_of("decision") != decision) {
    fault("The footer decides " + footer_->text_of("decision") + "; the lines make it " +
          std::string(decision) + ".");
  }
}

// Decision and counts; the features that it names are not derived here.
void ResultsFile::check_head() {
  const Json* head = footer_->find("head");
  if (head == nullptr || !head->is(Json::Kind::text)) return;
  std::size_t go = 0;
  std::size_t no_go = 0;
  for (const auto& [verdict, count] : totals_) {
    if (decision_of(verdict) == Decision::go) go += count;
    if (decision_of(verdict) == Decision::no_go) no_go += count;
  }
  const std::string& decision = footer_->text_of("decision");
  const std::string counts =
      (no_go == 0 ? " " : " " + grouped(go) + " of ") + grouped(go + no_go) + " judged";
  const bool begins =
      head->text.starts_with(decision + ":") || head->text.starts_with(decision + " for ");
  if (begins && head->text.find(counts) != std::string::npos) return;
  fault("The head line of the footer does not say " + decision + " and" + counts + ".");
}

}  // namespace gonogo::checker
