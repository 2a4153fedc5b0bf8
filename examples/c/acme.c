/* SPDX-License-Identifier: MIT-0
 *
 * A subject in C. It expands straight lines of RS274: G0 and G1 with X, Y and Z, F, G20 and G21,
 * G90 and G91, M2 and M30. What else stands in a program it does not support, and says so.
 */
#include <gonogo/subject.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NO_MOTION = -1, TRAVERSE = 0, STRAIGHT = 1 };
enum { MOTION_GROUP = 1 }; /* of block.groups */

typedef struct machine {
  const gonogo_sink_v1* sink;
  double at[3]; /* mm */
  double feed;  /* mm/min */
  double unit;  /* mm in one unit of the program */
  int incremental;
  int motion;
} machine;

/* One line of the program. A word that stands twice is an alarm. */
typedef struct block {
  uint64_t line;
  double feed_unit;   /* F counts in the unit before the block */
  unsigned long seen; /* a bit a letter */
  unsigned groups;    /* a bit a group of G codes */
  double value[26];
} block;

static gonogo_text text_of(const char* text) {
  gonogo_text made = {text, strlen(text)};
  return made;
}

static int not_supported(const machine* m, const char* feature) {
  m->sink->note(m->sink->context, GONOGO_NOTE_ERROR, text_of(feature));
  return GONOGO_UNSUPPORTED;
}

static int alarm_at(const machine* m, const block* b, const char* klass, char word) {
  gonogo_alarm_v1 alarm = {sizeof alarm, b->line, text_of(klass), text_of(klass), word};
  m->sink->alarm(m->sink->context, &alarm);
  return GONOGO_ALARM;
}

static int has(const block* b, char letter) {
  return (b->seen >> (letter - 'A') & 1) != 0;
}

/* The next character that is no blank, in upper case; 0 at the end. */
static char next_of(const char** at, const char* end) {
  while (*at < end && (**at == ' ' || **at == '\t')) ++*at;
  if (*at == end) return 0;
  return (char)(**at >= 'a' && **at <= 'z' ? **at - 32 : **at);
}

/* A number, without strtod's own ideas (0X10 is no number of a program). */
static int read_number(const char** at, const char* end, double* value) {
  char digits[64];
  size_t size = 0;
  int any = 0;
  for (char c; (c = next_of(at, end)) != 0 && size + 1 < sizeof digits; ++*at) {
    if (!((c >= '0' && c <= '9') || c == '.' || (size == 0 && (c == '-' || c == '+')))) break;
    if (c == '.' && memchr(digits, '.', size) != NULL) break;
    any = any || (c >= '0' && c <= '9');
    digits[size++] = c;
  }
  digits[size] = 0;
  *value = strtod(digits, NULL);
  return any;
}

/* Whole digits; they have no meaning. */
static int read_line_number(const char** at, const char* end) {
  int any = 0;
  for (char c; (c = next_of(at, end)) >= '0' && c <= '9'; ++*at) any = 1;
  return any;
}

static int take_g(machine* m, block* b, double number) {
  static const double codes[] = {0, 1, 20, 21, 90, 91}; /* two a group */
  unsigned group;
  unsigned i = 0;
  while (i < 6 && codes[i] != number) ++i;
  if (i == 6) {
    char code[40];
    snprintf(code, sizeof code, "G%g", number);
    return not_supported(m, code);
  }
  group = 1u << (i / 2);
  if ((b->groups & group) != 0) return alarm_at(m, b, "duplicate-word", 'G');
  b->groups |= group;
  if (i < 2) m->motion = (int)i;
  if (i == 2) m->unit = 25.4;
  if (i == 3) m->unit = 1;
  if (i > 3) m->incremental = i == 5;
  return GONOGO_OK;
}

static int read_block(machine* m, block* b, const char* at, const char* end) {
  for (char letter; (letter = next_of(&at, end)) != 0;) {
    char name[2] = {letter, 0};
    double number = 0;
    ++at;
    if (strchr("NGXYZFM", letter) == NULL) return not_supported(m, name);
    if (!(letter == 'N' ? read_line_number(&at, end) : read_number(&at, end, &number)))
      return not_supported(m, name);
    if (letter == 'G') {
      int answer = take_g(m, b, number);
      if (answer != GONOGO_OK) return answer;
      continue;
    }
    if (letter == 'M' && number != 2 && number != 30) return not_supported(m, name);
    if (letter == 'N' && b->seen + b->groups != 0) return not_supported(m, name);
    if (has(b, letter)) return alarm_at(m, b, "duplicate-word", letter);
    b->seen |= 1ul << (letter - 'A');
    b->value[letter - 'A'] = number;
  }
  return GONOGO_OK;
}

static int move(machine* m, const block* b) {
  gonogo_record_v1 record;
  memset(&record, 0, sizeof record);
  record.struct_size = sizeof record;
  record.kind = m->motion == TRAVERSE ? GONOGO_RAPID : GONOGO_FEED;
  record.block = b->line;
  for (int axis = 0; axis < 3; ++axis) {
    char letter = (char)('X' + axis);
    if (!has(b, letter)) continue;
    double way = b->value[letter - 'A'] * m->unit;
    m->at[axis] = m->incremental ? m->at[axis] + way : way;
    record.to[axis].form = GONOGO_NUMBER_BINARY64;
    record.to[axis].binary64 = m->at[axis];
  }
  if (m->motion == STRAIGHT) {
    record.f.form = GONOGO_NUMBER_BINARY64;
    record.f.binary64 = m->feed;
  }
  return m->sink->record(m->sink->context, &record) == 0 ? GONOGO_OK : GONOGO_STOPPED;
}

static int execute(machine* m, const block* b) {
  int moves;
  if (has(b, 'F')) m->feed = b->value['F' - 'A'] * b->feed_unit;
  if (m->feed < 0) return alarm_at(m, b, "value-sign", 'F');
  moves = has(b, 'X') || has(b, 'Y') || has(b, 'Z');
  if (!moves && (b->groups & MOTION_GROUP) == 0) return GONOGO_OK;
  if (m->motion == NO_MOTION) return alarm_at(m, b, "missing-word", 'G');
  if (m->motion == STRAIGHT && m->feed == 0) return alarm_at(m, b, "feed-missing", 'F');
  if (!moves) return GONOGO_OK;
  return move(m, b);
}

static gonogo_text describe(void) {
  return text_of(
      "{\"protocol\":1,\"subject\":{\"name\":\"acme-c\",\"version\":\"1.0.0\"},"
      /* It does a part of the feature "basic": without "dialects" what is skipped is not claimed. */
      "\"features\":[\"blocks\"],"
      "\"numeric\":{\"kind\":\"binary64\"}}");
}

static int reset(void* handle) {
  machine* m = handle;
  const gonogo_sink_v1* sink = m->sink;
  memset(m, 0, sizeof *m);
  m->sink = sink;
  m->unit = 1;
  m->motion = NO_MOTION;
  return GONOGO_OK;
}

static int create(gonogo_text configuration, const gonogo_sink_v1* sink, void** handle) {
  static const char expected[] = "{\"dialect\":\"rs274\",\"profile\":{}}";
  machine m = {0};
  m.sink = sink;
  if (configuration.size != sizeof expected - 1 ||
      memcmp(configuration.data, expected, configuration.size) != 0) {
    return not_supported(&m, "Only rs274 with its default profile is implemented.");
  }
  *handle = malloc(sizeof m);
  if (*handle == NULL) return GONOGO_ERROR;
  memcpy(*handle, &m, sizeof m);
  return reset(*handle);
}

/* LF, CR and CRLF end a line. */
static int run(void* handle, gonogo_text program) {
  machine* m = handle;
  const char* at = program.data;
  const char* end = program.data + program.size;
  block b = {0};
  b.line = 1;
  for (uint64_t line = 1; at < end; ++line) {
    const char* stop = at;
    int answer;
    while (stop < end && *stop != '\n' && *stop != '\r') ++stop;
    memset(&b, 0, sizeof b);
    b.line = line;
    b.feed_unit = m->unit;
    answer = read_block(m, &b, at, stop);
    if (answer == GONOGO_OK) answer = execute(m, &b);
    if (answer != GONOGO_OK) return answer;
    if (has(&b, 'M')) return GONOGO_OK; /* M2 or M30: the end of the program */
    at = stop + (end - stop > 1 && stop[0] == '\r' && stop[1] == '\n' ? 2 : 1);
  }
  return alarm_at(m, &b, "program-end", 0);
}

static void destroy(void* handle) {
  free(handle);
}

const gonogo_subject_v1* gonogo_get_subject(uint32_t abi) {
  static const gonogo_subject_v1 subject = {
      GONOGO_SUBJECT_ABI, sizeof subject, describe, create, run, reset, destroy};
  return abi >= GONOGO_SUBJECT_ABI ? &subject : NULL;
}
