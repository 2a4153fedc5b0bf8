// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/line_source.hpp"

#include <gtest/gtest.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <utility>
#include <vector>

#include "grammar/file_source.hpp"

namespace gonogo::grammar {
namespace {

// Gives the text in pieces of at most `most` bytes, the first one of at most `first`.
class PiecewiseSource : public ByteSource {
 public:
  PiecewiseSource(std::string_view text, std::size_t first, std::size_t most)
      : rest_(text), next_(first), most_(most) {}
  std::size_t read(char* data, std::size_t capacity) override {
    EXPECT_FALSE(ended_) << "read again after the end";
    const std::size_t count = std::min({capacity, rest_.size(), next_});
    std::copy_n(rest_.data(), count, data);
    rest_.remove_prefix(count);
    next_ = most_;
    ended_ = count == 0;
    return count;
  }

 private:
  std::string_view rest_;
  std::size_t next_;
  std::size_t most_;
  bool ended_ = false;
};

std::vector<std::string> lines_of(ByteSource& bytes) {
  LineSource source(bytes);
  std::vector<std::string> out;
  Line line;
  while (source.next(line)) {
    out.emplace_back(line.text);
    EXPECT_EQ(line.number, out.size());
    EXPECT_FALSE(line.too_long);
  }
  EXPECT_FALSE(source.next(line)) << "the end stays the end";
  return out;
}

std::vector<std::string> lines_of(std::string_view text) {
  MemorySource bytes(text);
  return lines_of(bytes);
}

using Lines = std::vector<std::string>;

TEST(LineSource, LfCrlfAndCrEndALine) {
  EXPECT_EQ(lines_of("a\nb\r\nc\rd\n"), (Lines{"a", "b", "c", "d"}));
}

TEST(LineSource, BlankLinesCount) {
  EXPECT_EQ(lines_of("\n\r\n\r\r\na"), (Lines{"", "", "", "", "a"}));
  EXPECT_EQ(lines_of("a\n\rb"), (Lines{"a", "", "b"}));  // LF CR is two ends
}

TEST(LineSource, TheLastLineNeedsNoEnd) {
  EXPECT_EQ(lines_of("a\nb"), (Lines{"a", "b"}));
  EXPECT_EQ(lines_of("a"), (Lines{"a"}));
}

TEST(LineSource, AnEndIsNoLineOfItsOwn) {
  EXPECT_EQ(lines_of(""), Lines{});
  EXPECT_EQ(lines_of("a\n"), (Lines{"a"}));
  EXPECT_EQ(lines_of("a\r\n"), (Lines{"a"}));
  EXPECT_EQ(lines_of("a\r"), (Lines{"a"}));
}

TEST(LineSource, BytesOfAnyValuePass) {
  EXPECT_EQ(lines_of(std::string_view("a\0b\xFF\n\x1A", 6)),
            (Lines{std::string("a\0b\xFF", 4), "\x1A"}));
}

TEST(LineSource, WhereTheChunksEndDoesNotMatter) {
  const std::string_view text = "N1\r\n\r\nG0 X1\n\rab\r\r\n\n\nlast";
  const Lines want{"N1", "", "G0 X1", "", "ab", "", "", "", "last"};
  for (std::size_t first = 1; first <= text.size(); ++first) {
    for (std::size_t most = 1; most <= text.size(); ++most) {
      PiecewiseSource bytes(text, first, most);
      EXPECT_EQ(lines_of(bytes), want) << first << ' ' << most;
    }
  }
}

TEST(LineSource, LinesOfEveryLengthEndAtTheFirstEnd) {
  // Ends are looked for in stretches of some hundred bytes: CR before LF, both in one or apart.
  std::string text;
  std::vector<std::string> want;
  for (std::size_t size = 0; size < 700; size += 3) {
    for (const std::string_view end : {"\n", "\r", "\r\n"}) {
      want.emplace_back(size, 'x');
      text += want.back();
      text += end;
      if (end == "\r") {  // else a blank line's LF would belong to it
        want.emplace_back("y");
        text += "y\n";
      }
    }
  }
  EXPECT_EQ(lines_of(text), want);
}

TEST(FileSource, IsReadFromTheBeginningByEachThatReadsIt) {
  std::FILE* const file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  std::fputs("G1\nG2\n", file);
  std::fflush(file);
  const int descriptor = ::fileno(file);
  FileSource one(descriptor);
  FileSource other(descriptor);
  char first = 0;
  EXPECT_EQ(one.read(&first, 1), 1U);
  EXPECT_EQ(lines_of(other), (std::vector<std::string>{"G1", "G2"}));
  char second = 0;
  EXPECT_EQ(one.read(&second, 1), 1U);
  EXPECT_EQ(std::string({first, second}), "G1");
  std::fclose(file);
}

// For any pieces in which the bytes come.
TEST(LineSource, ACarriageReturnAloneMayBeABlank) {
  for (std::size_t most = 1; most <= 6; ++most) {
    PiecewiseSource bytes("G1\rG2\r\nG3\r\r\nG4\n\rG5\r", most, most);
    LineSource source(bytes);
    source.take_cr_for_blank();
    Lines lines;
    for (Line line; source.next(line);) lines.emplace_back(line.text);
    EXPECT_EQ(lines, (Lines{"G1 G2", "G3 ", "G4", " G5"})) << most;
    EXPECT_TRUE(source.has_lone_cr()) << most;
  }
}

// Known with the line that it ends, for what stands behind it decides what the line is.
TEST(LineSource, ACarriageReturnAloneIsSeenWithItsLine) {
  for (std::size_t most = 1; most <= 6; ++most) {
    PiecewiseSource bytes("G1\r\nG2\rG3\r", most, most);
    LineSource source(bytes);
    std::vector<std::pair<std::string, bool>> seen;
    for (Line line; source.next(line);) seen.emplace_back(line.text, source.has_lone_cr());
    const decltype(seen) want = {{"G1", false}, {"G2", true}, {"G3", true}};
    EXPECT_EQ(seen, want) << most;
  }
  MemorySource ends("G1\r");
  LineSource source(ends);
  for (Line line; source.next(line);) EXPECT_FALSE(source.has_lone_cr());
}

TEST(LineSource, LinesLongerThanAChunkAreWhole) {
  const std::string a(200000, 'a');
  const std::string b(70000, 'b');
  EXPECT_EQ(lines_of(a + "\n" + b + "\r\n" + a), (Lines{a, b, a}));
}

struct Shape {
  std::uint64_t number;
  std::size_t size;
  bool too_long;
  friend bool operator==(const Shape&, const Shape&) = default;
};

std::vector<Shape> shapes_of(ByteSource& bytes) {
  LineSource source(bytes);
  std::vector<Shape> out;
  for (Line line; source.next(line);) out.push_back({line.number, line.text.size(), line.too_long});
  return out;
}

TEST(LineSource, ALineOfTheMaximumIsNotTooLong) {
  for (const char* end : {"\n", "\r\n", "\r", ""}) {
    const std::string text = std::string(kMaximumLine, 'x') + end;
    MemorySource bytes(text);
    EXPECT_EQ(shapes_of(bytes), (std::vector<Shape>{{1, kMaximumLine, false}})) << end;
  }
}

TEST(LineSource, ALineAboveTheMaximumIsDroppedAndTheNextOnesAreWhole) {
  for (const std::size_t excess : {std::size_t{1}, std::size_t{70000}, 3 * kMaximumLine}) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
      const std::string text = "a" + std::string(end) + std::string(kMaximumLine + excess, 'x') +
                               end + "bb" + end + end + "ccc";
      const std::vector<Shape> want{
          {1, 1, false}, {2, kMaximumLine, true}, {3, 2, false}, {4, 0, false}, {5, 3, false}};
      for (const std::size_t piece : {std::size_t{997}, text.size()}) {
        PiecewiseSource bytes(text, piece, piece);
        EXPECT_EQ(shapes_of(bytes), want) << excess << ' ' << piece;
      }
    }
  }
}

TEST(LineSource, ALineAboveTheMaximumMayBeTheLast) {
  const std::string text(kMaximumLine + 100000, 'x');
  MemorySource bytes(text);
  EXPECT_EQ(shapes_of(bytes), (std::vector<Shape>{{1, kMaximumLine, true}}));
}

// Endless: memory must stay bounded, and the error must come before the line has ended.
class EndlessSource : public ByteSource {
 public:
  std::size_t read(char* data, std::size_t capacity) override {
    EXPECT_LE(capacity, kMaximumLine + (std::size_t{1} << 16));
    std::fill_n(data, capacity, 'x');
    return capacity;
  }
};

TEST(LineSource, AnEndlessLineIsReportedAtOnce) {
  EndlessSource bytes;
  LineSource source(bytes);
  Line line;
  ASSERT_TRUE(source.next(line));
  EXPECT_TRUE(line.too_long);
}

// A pipe that never ends a line ends the text at some point.
TEST(LineSource, ALineWithoutEndEndsTheText) {
  EndlessSource bytes;
  LineSource lines(bytes);
  Line line;
  ASSERT_TRUE(lines.next(line));
  EXPECT_TRUE(line.too_long);
  EXPECT_FALSE(lines.next(line));
  EXPECT_FALSE(lines.next(line));
}

TEST(DescriptorSource, ReadsAPipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "a\nb", 3), 3);
  ::close(ends[1]);
  DescriptorSource bytes(ends[0]);
  EXPECT_EQ(lines_of(bytes), (Lines{"a", "b"}));
  ::close(ends[0]);
}

int interrupted_pipe = -1;

TEST(DescriptorSource, ReadsOnAfterASignal) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  interrupted_pipe = ends[1];
  struct sigaction action {};  // without SA_RESTART: the read that waits is interrupted
  action.sa_handler = [](int) { (void)!::write(interrupted_pipe, "a", 1); };
  ASSERT_EQ(::sigaction(SIGALRM, &action, nullptr), 0);
  const itimerval soon{{0, 0}, {0, 20000}};
  ASSERT_EQ(::setitimer(ITIMER_REAL, &soon, nullptr), 0);

  DescriptorSource bytes(ends[0]);
  char byte = 0;
  EXPECT_EQ(bytes.read(&byte, 1), 1U);
  EXPECT_EQ(byte, 'a');
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(DescriptorSource, ReportsWhatTheSystemSays) {
  DescriptorSource bytes(-1);
  char byte = 0;
  try {
    bytes.read(&byte, 1);
    FAIL() << "no error";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::bad_file_descriptor);
  }
}

}  // namespace
}  // namespace gonogo::grammar
