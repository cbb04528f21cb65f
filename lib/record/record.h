/* The inside of records and replays, shared by the files of lib/record.
 *
 * format.c lays records in a row and finds them again; head.c and steps.c visit what is in them;
 * inputs.c tells a scene what it is told, live or replayed, and sees what the record was not told. On
 * these stand writing (record.c, its calls in told.c) and reading (log.c opens one, replay.c steps). */
#ifndef VBSS_RECORD_RECORD_H
#define VBSS_RECORD_RECORD_H

#include <vblast_ss/record.h>

#include "scene/scene.h"

/* ---- format.c: a front, then records, each with its length, one section and a checksum, which covers
 * the checksum before it: no record can be changed, lost or moved unseen. */

enum { LOG_FRONT = 8, LOG_BEFORE = 8, LOG_AFTER = 8 };
#define LOG_HEAD VBSS_CODE('H', 'E', 'A', 'D')
#define LOG_SNAPSHOT VBSS_CODE('S', 'N', 'A', 'P')
#define LOG_STEP VBSS_CODE('S', 'T', 'E', 'P')
#define LOG_END VBSS_CODE('E', 'N', 'D', 'S')

typedef struct log_writer {
    uint8_t *bytes;
    size_t capacity, used;
    bool taken;     /* what is used is the host's until the next record */
    uint64_t chain; /* checksum of the last record */
} log_writer;
void vbss_log_begin(log_writer *log);
size_t vbss_log_room(const log_writer *log);
/* What is visited between these two is a record. For it there must be room. */
void vbss_log_open(log_writer *log, vbss_stream *stream);
vbss_result vbss_log_seal(log_writer *log, const vbss_stream *stream);
static inline size_t log_record_bytes(const vbss_stream *measured)
{
    return LOG_BEFORE + measured->position + LOG_AFTER;
}

typedef struct log_reader {
    vbss_context *context;
    const uint8_t *bytes;
    size_t count, at; /* at: where the next record begins */
    uint64_t chain;
} log_reader;
/* The record that the reader has passed last. */
typedef struct log_found {
    const uint8_t *payload;
    size_t length, at; /* at: where the record begins */
    uint32_t code;
} log_found;
vbss_result vbss_log_read_front(log_reader *log);
/* The next record that matters; unchanged on failure, which is told with its byte. */
vbss_result vbss_log_next(log_reader *log, log_found *found);
/* Whether all of the record was visited without a problem; told otherwise. */
vbss_result vbss_log_read_all(const log_reader *log, const log_found *found,
                              const vbss_stream *stream);
vbss_result vbss_log_corrupt(const log_reader *log, size_t at, const char *problem);

/* ---- head.c: how a log begins */

typedef struct log_blob {
    uint8_t *bytes;
    uint32_t count;
} log_blob;
typedef struct log_head {
    vbss_context *context;
    uint32_t library_version, hash_interval, input_capacity;
    log_blob build_info, note; /* the text without its end, which stands behind it all the same */
    vbss_scene_config scene;
    log_blob snapshot;
} log_head;
/* When reading, blobs are allocated here. */
void vbss_log_visit_head(vbss_stream *stream, log_head *head);
void vbss_log_visit_snapshot(vbss_stream *stream, log_head *head);
vbss_result vbss_log_make_blob(vbss_context *context, log_blob *blob, const void *bytes,
                               size_t count);
void vbss_log_free_head(log_head *head);
/* Whether the scene has the configuration of the log, but for capacities; VBSS_ERROR_CORRUPT, told. */
vbss_result vbss_log_compare_config(const log_head *head, const scene_object *s);

/* ---- inputs.c: what a host tells a scene */

/* Numbers of the format: never changed. */
enum {
    INPUT_MOVE_RIGID = 1, /* words: body, turned; numbers: position, orientation */
    INPUT_PIN = 2,        /* words: thread, node, body, placed; numbers: point */
    INPUT_UNPIN = 3,      /* words: pin */
    /* words: thread, kind, node; numbers: position, direction, force, stiffness, damping, mass */
    INPUT_ATTACH = 4,
    INPUT_MOVE = 5,   /* words: thread, attachment, directed; numbers: target, direction */
    INPUT_DETACH = 6, /* words: thread, attachment */
    /* since version 2 of STEP */
    INPUT_CUT = 7,          /* words: thread; numbers: arc length */
    INPUT_MOVE_GRASPER = 8, /* words: body, turned; numbers: position, orientation */
    INPUT_SET_OPENING = 9,  /* words: body; numbers: opening */
    INPUT_EXCHANGE = 10,    /* words: body, kind */
    INPUT_KINDS = 11
};
typedef struct log_input {
    uint32_t words[4];
    double numbers[12];
} log_input;
typedef struct log_input_shape {
    uint32_t words, numbers;
} log_input_shape;
extern const log_input_shape vbss_log_input_shapes[INPUT_KINDS];
/* Tells it to the scene; id: of what came to be, may be NULL. */
vbss_result vbss_log_tell(vbss_scene *scene, uint8_t kind, const log_input *input, uint32_t *id);
vbss_result vbss_log_find_thread(vbss_scene *scene, uint32_t body, vbss_thread **thread);
vbss_result vbss_log_find_grasper(vbss_scene *scene, uint32_t body, vbss_grasper **grasper);
/* Changes whenever the scene or a thread in it does. */
typedef struct log_edits {
    uint64_t scene, threads, graspers;
} log_edits;
log_edits vbss_log_edits_of(const scene_object *s);

/* ---- steps.c */

typedef struct log_step {
    uint64_t number, hashed, hash; /* hashed: 1, or 0 and no hash */
    double h;
    uint32_t input_count, input_capacity;
    uint8_t *kinds;
    log_input *inputs;
} log_step;
void vbss_log_visit_step(vbss_stream *stream, log_step *step);
/* The last record: number of steps and, if nothing was told since, the hash after them. */
void vbss_log_visit_end(vbss_stream *stream, log_step *step);
vbss_result vbss_log_make_inputs(vbss_context *context, log_step *step);
void vbss_log_free_inputs(vbss_context *context, log_step *step);

/* ---- record.c and told.c: writing */

typedef struct record_object {
    vbss_context *context;
    vbss_scene *scene; /* a handle: it may end before the record */
    uint32_t hash_interval;
    log_writer log;
    size_t end_bytes; /* kept free for the end */
    log_step step;    /* the next, as far as it is known */
    log_edits seen;   /* the scene as the record left it */
    bool ended;
} record_object;
vbss_result vbss_record_edit(vbss_record *handle, record_object **record);
/* Whether the scene is there and the record knows all that was done to it. */
vbss_result vbss_record_ready(const record_object *r, scene_object **scene);

/* ---- log.c and replay.c: reading */

typedef struct replay_object {
    vbss_context *context;
    log_head head;
    log_reader log, begin; /* begin: before the first step */
    log_step step;         /* the next, when it is read */
    vbss_scene *scene;     /* a handle; NULL: not begun */
    vbss_replay_report report;
    vbss_result stopped; /* VBSS_OK unless the outcome is VBSS_REPLAY_STOPPED */
} replay_object;
vbss_result vbss_replay_edit(vbss_replay *handle, replay_object **replay);
/* The step or end that follows on the one before; read into `step`. */
vbss_result vbss_log_read_step(log_reader *log, uint64_t steps_before, log_step *step, bool *end);

#endif
