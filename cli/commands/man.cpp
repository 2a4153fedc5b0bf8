// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo man: the manual page, from the same words as the help.
#include <fmt/format.h>

#include <cctype>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/version.hpp"

namespace gonogo::cli {
namespace {

// Text of a manual page: no line of it is a request, and dashes are those that one types.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
      out += fmt::format("\\&{}", c);
    } else {
      out += c;
    }
  }
  return out;
}

std::string sentence(std::string_view text) {
  std::string out(text);
  if (out.empty()) return out;
  out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out.back() == '.' ? out : out + ".";
}

// The word for a value: "--block N" and the like would need a name each; the help has none either.
std::string value_of(const OptionText& option) {
  if (!option.takes_value || option.argument) return {};
  if (option.choices.empty()) return " \\fIVALUE\\fR";
  return fmt::format(" {}", roff(fmt::format("{}", fmt::join(option.choices, "|"))));
}

std::string synopsis(const CommandText& command, const std::string& path) {
  std::string out = fmt::format("\\fB{}\\fR", roff(path));
  for (const OptionText& option : command.options) {
    if (option.argument) {
      out += fmt::format(" \\fI{}\\fR{}", roff(option.name), option.repeated ? "..." : "");
    } else if (option.needed) {
      out += fmt::format(" \\fB{}\\fR{}", roff(option.name), value_of(option));
    }
  }
  if (!command.commands.empty()) return out + " \\fICOMMAND\\fR [\\fIOPTIONS\\fR]";
  return out + " [\\fIOPTIONS\\fR]";
}

void append_command(const CommandText& command, const std::string& path, std::string& out) {
  out += fmt::format(".SS {}\n{}\n.PP\n{}\n", roff(path), synopsis(command, path),
                     roff(sentence(command.text)));
  for (const OptionText& option : command.options) {
    if (option.name == "--help") continue;
    out += fmt::format(".TP\n{}{}\\fR{}\n{}\n", option.argument ? "\\fI" : "\\fB",
                       roff(option.name), value_of(option), roff(option.text));
  }
  for (const CommandText& inner : command.commands) {
    append_command(inner, path + " " + inner.name, out);
  }
}

constexpr std::string_view kBefore = R"roff(.SH DESCRIPTION
GoNoGo holds a formal, executable reading of what controller manuals say that
their canned cycles do, and tells whether somebody else's implementation of the
same cycles is GO or NO\-GO: same path, same order, same feeds, same alarms.
.PP
Every command has \fB\-\-help\fR.
)roff";

constexpr std::string_view kAfter = R"roff(.SH EXIT STATUS
.TP
\fB0\fR
GO; the command did what it was asked to do.
.TP
\fB1\fR
NO\-GO, or an alarm of the program.
.TP
\fB2\fR
Wrong use; the message says what to write instead.
.TP
\fB3\fR
Undecided, incomplete, not covered, or output that could not be written in full.
.SH ENVIRONMENT
.TP
\fBGONOGO_CORPUS\fR
The folder of the corpus, instead of the one that came with the program.
.SH EXAMPLES
.TP
The motions of a program, each with its clause:
\fBgonogo explain taper.nc \-\-dialect gsk988ta\fR
.TP
An expander that speaks the pipe protocol:
\fBgonogo certify \-\-subject "pipe:./my\-expander \-\-pipe" \-\-dialect gsk988ta\fR
.SH SEE ALSO
The guides and references that come with the program, docs/README.md first.
)roff";

std::string page(const CommandText& program) {
  std::string out = fmt::format(
      ".TH GONOGO 1 \"\" \"gonogo {}\" \"User Commands\"\n.SH NAME\ngonogo \\- the master gauge "
      "for CNC canned cycles\n.SH SYNOPSIS\n\\fBgonogo\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.br\n"
      "\\fBgonogo\\fR [\\fB\\-\\-help\\fR|\\fB\\-\\-version\\fR]\n",
      roff(kVersion));
  out += kBefore;
  out += ".SH COMMANDS\n";
  for (const CommandText& command : program.commands) {
    append_command(command, "gonogo " + command.name, out);
  }
  out += kAfter;
  return out;
}

}  // namespace

void add_man(CommandLine& line) {
  Command command = line.program().add_command("man", "Write the manual page");
  command.run([&line] {
    Output output;
    output.text() = page(line.description());
    output.flush();
    return kGo;
  });
}

}  // namespace gonogo::cli
