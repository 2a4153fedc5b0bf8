/* SPDX-License-Identifier: MIT-0
 *
 * The C interface between the gauge and a subject: an implementation of canned cycles that is
 * to be judged. A subject fills in one gonogo_subject_v1; the gauge calls it.
 *
 * Rules
 *  - Every structure begins with its size, so that either side may be older than the other.
 *  - One handle is used by one thread at a time; several handles may live in a process.
 *  - Each side frees only what it allocated. Texts and records passed to a callback, and texts
 *    returned by `describe`, belong to the side that made them; those of a callback are valid
 *    until the callback returns, the description for the life of the process.
 *  - No exception, exit, abort or longjmp crosses the border. An alarm is not an error.
 *  - Lengths are millimetres and true lengths (X of a lathe is a radius); angles are degrees.
 */
#ifndef GONOGO_SUBJECT_H
#define GONOGO_SUBJECT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GONOGO_SUBJECT_ABI 1u

/* Bytes, not terminated by a zero. */
typedef struct gonogo_text {
  const char* data;
  size_t size;
} gonogo_text;

/* How a number is given. */
enum gonogo_number_form {
  GONOGO_NUMBER_ABSENT = 0,   /* the field is not there */
  GONOGO_NUMBER_TEXT = 1,     /* `text`: decimal ("12.5", "1e-3"), rational ("11/3") or hex float */
  GONOGO_NUMBER_BINARY64 = 2  /* `binary64`: taken as the exact value of the double; finite */
};

typedef struct gonogo_number {
  uint32_t form; /* enum gonogo_number_form */
  double binary64;
  gonogo_text text;
} gonogo_number;

enum gonogo_record_kind {
  GONOGO_RAPID = 1,
  GONOGO_FEED = 2,
  GONOGO_ARC = 3,
  GONOGO_ARC3 = 4,
  GONOGO_THREAD = 5,
  GONOGO_DWELL = 6,
  GONOGO_M = 7,
  GONOGO_END = 8
};

enum gonogo_axis { GONOGO_X = 0, GONOGO_Y = 1, GONOGO_Z = 2, GONOGO_A = 3, GONOGO_C = 4 };
#define GONOGO_AXES 5

enum gonogo_feed_mode { GONOGO_FEED_PER_MINUTE = 0, GONOGO_FEED_PER_REVOLUTION = 1 };

/* One record of the trace. Fields that the kind does not use are left at zero. */
typedef struct gonogo_record_v1 {
  uint32_t struct_size;
  uint32_t kind;                  /* enum gonogo_record_kind */
  uint64_t block;                 /* 1-based source line that caused it; 0: not known */
  gonogo_number to[GONOGO_AXES];  /* end point; absent axes did not move */
  gonogo_number via[GONOGO_AXES]; /* ARC3: intermediate point */
  gonogo_number f;                /* FEED, ARC, ARC3: path speed */
  uint32_t feed_mode;             /* enum gonogo_feed_mode */
  uint32_t plane;                 /* ARC: 17, 18 or 19 */
  gonogo_number centre[2];        /* ARC: first and second axis of the plane (G18: Z, X) */
  int32_t rot;                    /* ARC: turns; positive counterclockwise seen from +third axis */
  gonogo_number lead;             /* THREAD: mm a revolution along the longer axis */
  gonogo_number start;            /* THREAD: spindle angle, degrees */
  gonogo_number seconds;          /* DWELL */
  int32_t m;                      /* M: the function's number */
} gonogo_record_v1;

/* What stopped a program. */
typedef struct gonogo_alarm_v1 {
  uint32_t struct_size;
  uint64_t block;     /* 1-based source line; 0: not known */
  gonogo_text native; /* the subject's own number or text */
  gonogo_text klass;  /* the gauge's class, e.g. "value-sign"; empty: left to the alarm map */
  char word;          /* address of the word at fault, 0 when there is none */
} gonogo_alarm_v1;

enum gonogo_note_level { GONOGO_NOTE_INFO = 0, GONOGO_NOTE_WARNING = 1, GONOGO_NOTE_ERROR = 2 };

/* Where a subject puts what it produces. */
typedef struct gonogo_sink_v1 {
  uint32_t struct_size;
  void* context;
  /* 0: go on. Anything else: stop at once and return GONOGO_STOPPED from `run`. */
  int (*record)(void* context, const gonogo_record_v1* record);
  void (*alarm)(void* context, const gonogo_alarm_v1* alarm);
  void (*note)(void* context, int level, gonogo_text message);
} gonogo_sink_v1;

/* What `create` and `run` answer. */
enum gonogo_answer {
  GONOGO_OK = 0,
  GONOGO_ALARM = 1,       /* run: the sink's `alarm` was called, once */
  GONOGO_STOPPED = 2,     /* run: the sink asked for it */
  GONOGO_UNSUPPORTED = 3, /* create: a key or reading of the profile that is not implemented;
                             run: a feature of the program; `note` says which */
  GONOGO_ERROR = 4        /* something else; `note` says what */
};

typedef struct gonogo_subject_v1 {
  uint32_t abi;         /* GONOGO_SUBJECT_ABI */
  uint32_t struct_size; /* sizeof(gonogo_subject_v1) */
  /* The same JSON object as the reply to `start` in the pipe protocol. */
  gonogo_text (*describe)(void);
  /* `configuration`: {"dialect": "...", "profile": {...}} as in the pipe protocol's `configure`.
     The sink stays valid until `destroy`. */
  int (*create)(gonogo_text configuration, const gonogo_sink_v1* sink, void** handle);
  int (*run)(void* handle, gonogo_text program);
  /* Back to the state right after `create`. */
  int (*reset)(void* handle);
  void (*destroy)(void* handle);
} gonogo_subject_v1;

/* What a shared library exports: the newest interface it has that is at most `abi`, or null. */
const gonogo_subject_v1* gonogo_get_subject(uint32_t abi);

#ifdef __cplusplus
}
#endif
#endif
