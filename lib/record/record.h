/* Internal interface of records and replays, shared by the files of lib/record.
 *
 * format.c has the layout of a log. header.c, step_record.c and snapshots.c serialise the payloads
 * of its records; compression.c compresses snapshots. step_codec.c codes a step as bits, with
 * numbers as residuals of a prediction (predictive_coding.c). inputs.c applies inputs to a scene,
 * both live and in a replay.
 *
 * Logs are written by record.c and recorder.c, and continued by resume.c. They are read by
 * log_reader.c and check.c without a scene, and by replay.c with one. session_records.c writes and
 * reads the records of sessions. */
#ifndef VBSS_RECORD_RECORD_H
#define VBSS_RECORD_RECORD_H

#include <vblast_ss/record.h>

#include "base/stream.h"
#include "record/compression.h"
#include "scene/api/inspect.h"

/* ---- format.c
 *
 * A log is a preamble followed by records. Each record has its length, a payload and a checksum.
 * The checksum also covers the checksum before it, so no record can be changed, removed or moved
 * unnoticed. */

/* No section is larger, so that its length is not taken for a coded step. */
#define LOG_MAX_SNAPSHOT_BYTES 0xbffff000u
/* Since this format steps are coded and snapshots packed. */
enum { LOG_FORMAT_COMPRESSED = 3 };
enum {
    LOG_PREAMBLE_BYTES = 8,
    LOG_PREFIX_BYTES = 8,
    LOG_CODED_PREFIX_BYTES = 4,
    LOG_CHECKSUM_BYTES = 8,
    LOG_MAX_CODED_BYTES = 0x3fff
};
#define LOG_HEADER VBSS_CODE('H', 'E', 'A', 'D')
#define LOG_SNAPSHOT VBSS_CODE('S', 'N', 'A', 'P')
#define LOG_REPLACEMENT VBSS_CODE('R', 'E', 'P', 'L')
#define LOG_STEP VBSS_CODE('S', 'T', 'E', 'P')
#define LOG_END VBSS_CODE('E', 'N', 'D', 'S')
#define LOG_SESSION_HASH VBSS_CODE('s', 'e', 's', 's')
#define LOG_SESSION_SNAPSHOT VBSS_CODE('s', 't', 'a', 't')

/* The log under construction: the bytes since the host took them last. */
typedef struct log_writer {
    uint8_t *bytes;
    size_t capacity, used;
    uint32_t format;
    bool is_handed_out; /* the host has taken the bytes; the next record overwrites them */
    uint64_t checksum;  /* checksum of the last record */
    uint64_t bytes_since_session_snapshot;
} log_writer;

void vbss_log_write_preamble(log_writer *log);
size_t vbss_log_free_bytes(const log_writer *log);
/* Between these two calls, visitors of the stream write the payload. There must be room for it. */
void vbss_log_begin_record(log_writer *log, vbss_stream *stream);
vbss_result vbss_log_end_record(log_writer *log, const vbss_stream *stream);
/* Between these two calls, the caller writes a coded step to the returned address: `count` bytes,
 * at most LOG_MAX_CODED_BYTES. */
uint8_t *vbss_log_begin_coded_step(log_writer *log);
void vbss_log_end_coded_step(log_writer *log, size_t count);
/* Size of the record of a payload that was measured. */
static inline size_t log_record_bytes(const vbss_stream *measured)
{
    return LOG_PREFIX_BYTES + measured->position + LOG_CHECKSUM_BYTES;
}

/* A fault of a log. */
typedef struct log_fault {
    vbss_result result;  /* VBSS_OK: no fault */
    size_t position;     /* byte of the log */
    const char *problem; /* a string literal */
} log_fault;

/* A position in a log. */
typedef struct log_reader {
    vbss_context *context;
    const uint8_t *bytes;
    size_t count, position; /* size of the log; where the next record begins */
    uint64_t checksum;      /* checksum of the last record */
    uint32_t format;
    struct log_coder *coder; /* history of the steps so far; a reader elsewhere has another */
    log_fault *fault;        /* receives a fault; NULL: faults are errors of the context */
} log_reader;

/* A record that a reader has found. */
typedef struct log_record {
    const uint8_t *payload;
    size_t length, position; /* bytes of the payload; where the record begins */
    uint32_t code;
    bool is_coded; /* the payload is a coded step; otherwise a section */
} log_record;

/* The following functions return VBSS_OK, VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or
 * VBSS_ERROR_DATA_VERSION. On failure they report a fault with its position, and the reader stays
 * where it is. */

vbss_result vbss_log_read_preamble(log_reader *log);
/* Finds the next record that this library knows. Others are skipped if they are optional. */
vbss_result vbss_log_next(log_reader *log, log_record *found);
/* Finds the next record of any code. */
vbss_result vbss_log_next_any(log_reader *log, log_record *found);
/* Fails unless a stream has read the whole payload. An error of the stream is passed on. */
vbss_result vbss_log_check_all_read(const log_reader *log, const log_record *found,
                                    const vbss_stream *stream);
/* Reports a fault. Returns VBSS_ERROR_CORRUPT. */
vbss_result vbss_log_fail_corrupt(const log_reader *log, size_t position, const char *problem);

/* Skips the next record without a check of its contents. Returns false if its length is invalid. */
bool vbss_log_skip_record(log_reader *log);

/* ---- header.c */

typedef struct log_blob {
    uint8_t *bytes;
    uint32_t count;
} log_blob;

typedef struct log_header {
    vbss_context *context;
    uint32_t library_version, hash_interval, input_capacity;
    log_blob build_info, note; /* a zero follows the text, but is not counted */
    vbss_scene_config scene;
    vbss_baseline_config baseline; /* what scene.baseline points to */
    vbss_solver_options solver;    /* what scene.solver points to */
} log_header;

/* A reading stream allocates the blobs; vbss_log_free_header frees them. */
void vbss_log_visit_header(vbss_stream *stream, log_header *header);

/* ---- snapshots.c */

/* A snapshot in a log. */
typedef struct log_snapshot {
    uint64_t number;           /* number of steps before it */
    uint32_t count;            /* size of the uncompressed snapshot, bytes */
    uint32_t compressed_bytes; /* its size in the log; 0: it is not compressed */
    const uint8_t *bytes;      /* its bytes in the log; set by a reading stream */
    uint8_t *destination;      /* where to save it in the log; set by a writing stream */
} log_snapshot;

/* Visits the snapshot of a scene after an edit that no input can describe, such as the addition of a
 * body. It replaces the state before the inputs of the next step. */
void vbss_log_visit_replacement(vbss_stream *stream, log_snapshot *snapshot);
/* Visits the snapshot of a scene. */
void vbss_log_visit_snapshot(vbss_stream *stream, log_snapshot *snapshot);
/* Visits the snapshot of a session. */
void vbss_log_visit_session_snapshot(vbss_stream *stream, log_snapshot *snapshot);
/* Largest size of the record of a snapshot of `count` bytes. */
size_t vbss_log_max_snapshot_bytes(size_t count);
struct record_object;
/* Writes a snapshot of the object in a slot. `code` is LOG_SNAPSHOT or LOG_SESSION_SNAPSHOT,
 * `count` the size of the snapshot. There must be room for its record. */
vbss_result vbss_log_write_snapshot(struct record_object *r, uint32_t code, const vbss_slot *slot,
                                    size_t count);
/* The uncompressed bytes of a snapshot, valid until they are released. */
typedef struct log_snapshot_data {
    const uint8_t *bytes;
    uint8_t *allocated; /* memory of the bytes; NULL: they are part of the log */
    uint32_t count;
} log_snapshot_data;
vbss_result vbss_log_decompress_snapshot(vbss_context *context, const log_snapshot *snapshot,
                                         log_snapshot_data *data);
void vbss_log_release_snapshot(vbss_context *context, log_snapshot_data *data);
/* Restores a snapshot. A scene that was loaded from the log is loaded again if it has other bodies. */
vbss_result vbss_log_restore_scene(vbss_context *context, vbss_scene *scene, bool is_loaded,
                                   const log_snapshot *snapshot);

/* Copies bytes into an allocated blob; NULL: leaves them zero. Returns VBSS_OK or
 * VBSS_ERROR_OUT_OF_MEMORY. */
vbss_result vbss_log_make_blob(vbss_context *context, log_blob *blob, const void *bytes,
                               size_t count);
void vbss_log_free_header(log_header *header);
/* Returns VBSS_ERROR_CORRUPT unless the scene has the configuration of the log. Capacities may
 * differ. */
vbss_result vbss_log_compare_config(const log_header *header, const scene_info *scene);

/* ---- inputs.c: inputs, which are the calls of a host between steps */

enum { LOG_INPUT_KINDS = VBSS_RECORD_INPUT_ROLL + 1 };
/* How many words and numbers an input of a kind has. */
typedef struct log_input_shape {
    uint32_t words, numbers;
} log_input_shape;
extern const log_input_shape vbss_log_input_shapes[LOG_INPUT_KINDS];
/* Applies an input to the scene. `id` receives the number of a new pin, attachment or piece; may be
 * NULL. Returns the result of the scene's function. */
vbss_result vbss_log_apply_input(vbss_scene *scene, uint8_t kind, const vbss_record_input *input,
                                 uint32_t *id);

/* ---- step_record.c */

typedef struct log_step {
    uint64_t number, has_hash, hash; /* number from 1 on; 1 or 0; hash of the scene after it */
    double h;                        /* length, s */
    uint32_t input_count, input_capacity;
    uint8_t *kinds;
    vbss_record_input *inputs;
    uint32_t event_count, event_capacity;
    uint32_t (*events)[4];    /* four words each; borrowed from the scene for writing */
    log_snapshot replacement; /* read before the step: replaces the state; bytes NULL: none */
} log_step;

void vbss_log_visit_step(vbss_stream *stream, log_step *step);
/* Visits the last record: the number of steps, and the hash of the scene if it was not changed
 * since the last step. */
void vbss_log_visit_end(vbss_stream *stream, log_step *step);
vbss_result vbss_log_allocate_inputs(vbss_context *context, log_step *step);
void vbss_log_free_inputs(vbss_context *context, log_step *step);
/* Points to the events of the scene's last step. */
void vbss_log_borrow_events(log_step *step, const scene_info *scene);
/* Allocates memory for events that are read. */
vbss_result vbss_log_allocate_events(vbss_context *context, log_step *step, uint32_t capacity);
void vbss_log_free_events(vbss_context *context, log_step *step);

/* ---- record.c and recorded_inputs.c: writing */

typedef struct record_object {
    uint32_t hash_table[LOG_HASH_TABLE_SIZE]; /* scratch of the compression */
    vbss_context *context;
    vbss_scene *scene; /* a handle, because the scene may be destroyed before the record */
    uint32_t hash_interval;
    log_writer log;
    struct log_coder *coder;
    size_t end_bytes;              /* reserved for the end record */
    log_step step;                 /* the next step, with its inputs so far */
    scene_edit_counts known_edits; /* edits that the record knows */
    size_t max_event_bytes;        /* reserved for the events of a step */
    uint32_t snapshot_interval;
    bool is_replaced; /* a replacement was written since the last step */
    bool snapshot_due, ended;
    bool snapshot_is_last; /* the last record of the scene is a snapshot */
} record_object;

vbss_result vbss_record_edit(vbss_record *handle, record_object **record);
/* Reads and checks a configuration of the host; NULL: the defaults. */
vbss_result vbss_record_read_config(vbss_context *context, const vbss_record_config *config,
                                    vbss_record_config *own);
/* Allocates the record of a scene, without the log. On failure `record` may be set as well;
 * vbss_record_create_handle then frees it. */
vbss_result vbss_record_make(vbss_scene *scene, uint32_t hash_interval, uint32_t input_capacity,
                             record_object **record);
/* Allocates the buffer of the log, with `start_bytes` for its start. `snapshot_bytes` is the size
 * of the first snapshot. */
vbss_result vbss_record_allocate_log(record_object *r, size_t start_bytes, size_t snapshot_bytes,
                                     const vbss_record_config *config);
/* Puts the record behind a handle if `result` is VBSS_OK. On any failure it frees the record, and
 * returns the failure. */
vbss_result vbss_record_create_handle(record_object *r, vbss_result result, vbss_record **record);
/* Returns VBSS_OK if the scene exists and all its changes were recorded. */
vbss_result vbss_record_check_ready(const record_object *r);

/* Returns VBSS_OK if the log has room for a step of `h` seconds with the inputs so far. */
vbss_result vbss_record_check_step(const record_object *r, double h);
/* Makes room for a replacement, before the edit. It may allocate. */
vbss_result vbss_record_reserve_replacement(record_object *r);
/* Writes a replacement with the scene as it is now. The inputs since the last step are part of it. */
vbss_result vbss_record_append_replacement(record_object *r);
/* Writes the step that the scene has just made. */
vbss_result vbss_record_append_step(record_object *r, double h);

/* ---- recorder.c: the hook of the scene */

/* Attaches the record to its scene. Returns the hook that was attached before. */
vbss_edit_hook vbss_record_attach_hook(record_object *r);
void vbss_record_restore_hook(record_object *r, const vbss_edit_hook *before);
/* Detaches the record if it is attached. */
void vbss_record_detach_hook(record_object *r);

/* ---- log_reader.c and replay.c: reading */

typedef struct replay_object {
    vbss_context *context;
    log_header header;
    log_snapshot first_snapshot;
    log_reader log, start;        /* current position of the replay; before the first step */
    struct log_coder *scan_coder; /* for readers that live within one call */
    log_step step;                /* the last step that was read */
    /* Position of reading without a scene, with the number of steps and the time (s) before it. */
    log_reader inspection;
    uint64_t inspected_steps;
    double inspected_time;
    vbss_scene *scene; /* a handle; NULL before vbss_replay_begin */
    bool is_loaded;    /* the scene was loaded from the log */
    vbss_replay_report report;
    vbss_result stop_result; /* VBSS_OK unless the outcome is VBSS_REPLAY_OUTCOME_STOPPED */
} replay_object;

vbss_result vbss_replay_edit(vbss_replay *handle, replay_object **replay);
/* Reads the log up to the first step, and allocates the memory that steps need. */
vbss_result vbss_replay_open_log(replay_object *p);
void vbss_replay_close_log(replay_object *p);
/* Reads the next step, snapshot or end; the code of `found` says which. `steps_before` is the
 * number of steps so far. */
vbss_result vbss_log_read_record(log_reader *log, uint64_t steps_before, log_step *step,
                                 log_snapshot *snapshot, log_record *found);
/* A reader at the same position as `start`, with an empty history in `coder`. The next step there
 * must be standalone: it is the first step, or follows a snapshot. */
log_reader vbss_log_reader_at(const log_reader *start, struct log_coder *coder);
/* Reads the next step and skips snapshots. `end` is set at the end of the log. */
vbss_result vbss_log_read_step(log_reader *log, uint64_t steps_before, log_step *step, bool *end);
/* Brings the replay and its scene to a step of the log: restores the newest snapshot up to there,
 * and replays the rest. */
vbss_result vbss_replay_seek_step(replay_object *p, uint64_t step);
/* A position of a replay: all that changes while it plays, but its scene. */
typedef struct replay_position {
    log_reader log;
    vbss_replay_report report;
    vbss_result stop_result;
} replay_position;

replay_position vbss_replay_get_position(const replay_object *p);
/* Restores the replay, but not its scene, to an earlier position. */
void vbss_replay_roll_back(replay_object *p, const replay_position *before);

/* ---- session_records.c */

/* The state of a session after a step. */
typedef struct log_session_hash {
    uint64_t number, hash, events; /* step; hash of the task; number of events so far */
    uint64_t aids;                 /* VBSS_SESSION_AID_ bits that are on */
} log_session_hash;

/* Writes a session hash. It is left out if the log has no room for it. */
vbss_result vbss_log_write_session_hash(record_object *r, log_session_hash *entry);
/* Finds the session hash after the step that was replayed last. Returns false if there is none. */
bool vbss_log_find_session_hash(const replay_object *p, log_session_hash *entry);
/* Writes the snapshot of a session after that of its scene, if the scene's is the last record. The
 * snapshot of a session grows with the trial. It is therefore left out until the log has grown by a
 * multiple of its size. It is also left out if the log has no room for it. */
vbss_result vbss_log_write_session_snapshot(record_object *r, const vbss_slot *session);
/* Finds the newest snapshot of a session at or before a step of the log. If there is none, its
 * bytes are NULL. */
vbss_result vbss_log_find_session_snapshot(const replay_object *p, uint64_t step,
                                           log_snapshot *snapshot);

#endif
