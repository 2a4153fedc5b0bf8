// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/called_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <set>
#include <vector>

#include "cli/program_file.hpp"
#include "grammar/line_source.hpp"
#include "grammar/parser.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;
using grammar::ControlKind;

constexpr std::size_t kMostFiles = 100;

struct StoredText {
  std::vector<std::string> lines;  // from the first `sub` to the last `endsub`
  std::size_t first = 0;           // the line of the file with which they begin
};

// What is called and what is defined, so far.
class Labels {
 public:
  // The O word of the line, where it has one.
  std::optional<ControlKind> read(std::string_view line) {
    const std::string_view block =
        line.substr(std::min(line.find_first_not_of(" \t/"), line.size()));
    if (!block.starts_with('o') && !block.starts_with('O') && !block.starts_with('N') &&
        !block.starts_with('n')) {
      return std::nullopt;
    }
    block_.clear();
    if (grammar::parse_block(grammar::Dialect::rs274, line, block_) || !block_.control) {
      return std::nullopt;
    }
    const grammar::Control& control = *block_.control;
    if (control.kind == ControlKind::sub) defined_.insert(control.label);
    if (control.kind == ControlKind::call) calls_.push_back(control.label);
    return control.kind;
  }
  // The next label that is called and stands nowhere yet; empty: none.
  std::string next_missing() {
    while (!calls_.empty()) {
      std::string label = std::move(calls_.front());
      calls_.pop_front();
      if (defined_.insert(label).second) return label;
    }
    return "";
  }

 private:
  grammar::Block block_;
  std::set<std::string> defined_;
  std::deque<std::string> calls_;
};

void read_lines(std::string_view text, Labels& labels, StoredText* kept) {
  grammar::MemorySource bytes(text);
  grammar::LineSource source(bytes);
  grammar::Line line;
  std::size_t end = 0;
  while (source.next(line)) {
    const std::optional<ControlKind> kind = labels.read(line.text);
    if (kept == nullptr) continue;
    if (kept->lines.empty() && kind != ControlKind::sub) continue;
    if (kept->lines.empty()) kept->first = line.number;
    kept->lines.emplace_back(line.text);
    if (kind == ControlKind::endsub) end = kept->lines.size();
  }
  if (kept != nullptr) kept->lines.resize(end);
}

// The file of "<name>" or "100"; empty for a label that names none in the folder.
fs::path file_of(const fs::path& folder, std::string_view label) {
  if (label.starts_with('<')) label = label.substr(1, label.size() - 2);
  const bool is_plain = !label.empty() && std::ranges::all_of(label, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  });
  return is_plain ? folder / (std::string(label) + ".ngc") : fs::path();
}

// The text up to a last % that closes it.
std::string_view without_closing_mark(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  const bool closes =
      last != std::string_view::npos && last > 0 && text[last] == '%' && text[last - 1] == '\n';
  return closes ? text.substr(0, last) : text;
}

// The subroutines that stand in files of their own, in the order of their calls.
std::string text_behind(const std::string& path, std::string_view head, Labels& labels) {
  std::string behind;
  auto line = static_cast<std::size_t>(std::ranges::count(head, '\n'));
  if (!head.ends_with('\n')) ++line;
  std::size_t files = 0;
  for (std::string label; !(label = labels.next_missing()).empty();) {
    const fs::path file = file_of(fs::path(path).parent_path(), label);
    std::error_code fault;
    if (!fs::is_regular_file(file, fault) || ++files > kMostFiles) continue;
    StoredText text;
    read_lines(read_file(file.string(), kNcProgram, kMostWithCalls), labels, &text);
    if (text.lines.empty()) continue;
    for (const std::string& one : text.lines) behind += one + '\n';
    fmt::print(stderr, "o{} stands in {}: lines {} to {} there are lines {} to {} here.\n", label,
               file.string(), text.first, text.first + text.lines.size() - 1, line + 1,
               line + text.lines.size());
    line += text.lines.size();
  }
  return behind;
}

}  // namespace

bool add_called_files(const std::string& dialect, const std::string& path, std::string& program) {
  if (dialect != "rs274" || program.size() > kMostWithCalls) return false;
  if (program.find('o') == std::string::npos && program.find('O') == std::string::npos)
    return false;
  Labels labels;
  read_lines(program, labels, nullptr);
  const std::string_view head = without_closing_mark(program);
  const std::string behind = text_behind(path, head, labels);
  if (behind.empty()) return false;
  program.insert(head.size(), (head.ends_with('\n') ? "" : "\n") + behind);
  return true;
}

}  // namespace gonogo::cli
