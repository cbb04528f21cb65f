/* The inside of records and replays, shared by the files of lib/record.
 *
 * format.c lays records in a row and finds them again; header.c and step_record.c visit what is in them;
 * predictive_coding.c and step_codec.c write a step as bits, from what the steps before it predict;
 * inputs.c tells a scene what it is told, live or replayed, and sees what the record was not told. On
 * these stand writing (record.c, its calls in recorded_inputs.c; resume.c goes on with a log) and reading (log_reader.c opens
 * one, check.c looks for what is wrong, replay.c steps and seeks); session_records.c does both for sessions. */
#ifndef VBSS_RECORD_RECORD_H
#define VBSS_RECORD_RECORD_H

#include <vblast_ss/record.h>

#include "base/stream.h"
#include "record/compression.h"
#include "scene/api/inspect.h"

/* ---- format.c: a front, then records, each with its length, one section and a checksum, which covers
 * the checksum before it: no record can be changed, lost or moved unseen. */

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
#define LOG_STEP VBSS_CODE('S', 'T', 'E', 'P')
#define LOG_END VBSS_CODE('E', 'N', 'D', 'S')
#define LOG_SESSION_HASH VBSS_CODE('s', 'e', 's', 's')
#define LOG_SESSION_SNAPSHOT VBSS_CODE('s', 't', 'a', 't')

typedef struct log_writer {
    uint8_t *bytes;
    size_t capacity, used;
    uint32_t format;
    bool is_handed_out; /* what is used is the host's until the next record */
    uint64_t checksum;  /* checksum of the last record */
    uint64_t
        bytes_since_session_snapshot; /* by so many bytes since a session's state was put in it */
} log_writer;
void vbss_log_write_preamble(log_writer *log);
size_t vbss_log_free_bytes(const log_writer *log);
/* What is visited between these two is a record. For it there must be room. */
void vbss_log_begin_record(log_writer *log, vbss_stream *stream);
vbss_result vbss_log_end_record(log_writer *log, const vbss_stream *stream);
/* A coded step of that many bytes, at most LOG_MAX_CODED_BYTES, which are written where the first one says. */
uint8_t *vbss_log_begin_coded_step(log_writer *log);
void vbss_log_end_coded_step(log_writer *log, size_t count);
static inline size_t log_record_bytes(const vbss_stream *measured)
{
    return LOG_PREFIX_BYTES + measured->position + LOG_CHECKSUM_BYTES;
}

/* What is wrong with a log, and where. */
typedef struct log_fault {
    vbss_result result; /* VBSS_OK: nothing */
    size_t position;
    const char *problem; /* a constant text */
} log_fault;
typedef struct log_reader {
    vbss_context *context;
    const uint8_t *bytes;
    size_t count, position; /* at: where the next record begins */
    uint64_t checksum;
    uint32_t format;
    struct log_coder
        *coder;       /* of the steps before; readers at different places have different ones */
    log_fault *fault; /* where to put what is wrong; NULL: the context is told */
} log_reader;
/* The record that the reader has passed last. */
typedef struct log_record {
    const uint8_t *payload;
    size_t length, position; /* at: where the record begins */
    uint32_t code;
    bool is_coded; /* a step as bits, no section */
} log_record;
vbss_result vbss_log_read_preamble(log_reader *log);
/* The next record that matters; unchanged on failure, which is told with its byte. */
vbss_result vbss_log_next(log_reader *log, log_record *found);
/* The next record, whatever it is. */
vbss_result vbss_log_next_any(log_reader *log, log_record *found);
/* Whether all of the record was visited without a problem; told otherwise. */
vbss_result vbss_log_check_all_read(const log_reader *log, const log_record *found,
                                    const vbss_stream *stream);
vbss_result vbss_log_fail_corrupt(const log_reader *log, size_t position, const char *problem);
/* Over the next record unread, if its length can be read. */
bool vbss_log_skip_record(log_reader *log);

/* ---- header.c: how a log begins */

typedef struct log_blob {
    uint8_t *bytes;
    uint32_t count;
} log_blob;
typedef struct log_header {
    vbss_context *context;
    uint32_t library_version, hash_interval, input_capacity;
    log_blob build_info, note; /* the text without its end, which stands behind it all the same */
    vbss_scene_config scene;
} log_header;
/* When reading, blobs are allocated here. */
void vbss_log_visit_header(vbss_stream *stream, log_header *header);

/* ---- snapshots.c */

/* The scene after that many steps; its bytes stay where they are. */
typedef struct log_snapshot {
    uint64_t number;
    uint32_t count;
    uint32_t compressed_bytes; /* of the bytes that stand in the log; 0: these are not packed */
    const uint8_t *bytes;      /* in the log that is read */
    uint8_t *destination;      /* where to save it in the log that is written */
} log_snapshot;
void vbss_log_visit_snapshot(vbss_stream *stream, log_snapshot *snapshot);
/* That of a session beside it. */
void vbss_log_visit_session_snapshot(vbss_stream *stream, log_snapshot *snapshot);
/* Of the record of a snapshot of so many bytes, at most. */
size_t vbss_log_max_snapshot_bytes(size_t count);
struct record_object;
/* Saves what is in the slot, `count` bytes, for whose record there must be room. */
vbss_result vbss_log_write_snapshot(struct record_object *r, uint32_t code, const vbss_slot *slot,
                                    size_t count);
/* The bytes of a snapshot that was read, valid until they are released. */
typedef struct log_snapshot_data {
    const uint8_t *bytes;
    uint8_t *allocated; /* NULL: they stand in the log */
    uint32_t count;
} log_snapshot_data;
vbss_result vbss_log_decompress_snapshot(vbss_context *context, const log_snapshot *snapshot,
                                         log_snapshot_data *data);
void vbss_log_release_snapshot(vbss_context *context, log_snapshot_data *data);
vbss_result vbss_log_restore_scene(vbss_context *context, vbss_scene *scene,
                                   const log_snapshot *snapshot);

vbss_result vbss_log_make_blob(vbss_context *context, log_blob *blob, const void *bytes,
                               size_t count);
void vbss_log_free_header(log_header *header);
/* Whether the scene has the configuration of the log, but for capacities; VBSS_ERROR_CORRUPT, told. */
vbss_result vbss_log_compare_config(const log_header *header, const scene_info *scene);

/* ---- inputs.c: what a host tells a scene */

enum { LOG_INPUT_KINDS = VBSS_INPUT_EXCHANGE + 1 };
typedef struct log_input_shape {
    uint32_t words, numbers;
} log_input_shape;
extern const log_input_shape vbss_log_input_shapes[LOG_INPUT_KINDS];
/* Tells it to the scene; id: of what came to be, may be NULL. */
vbss_result vbss_log_apply_input(vbss_scene *scene, uint8_t kind, const vbss_log_input *input,
                                 uint32_t *id);
vbss_result vbss_log_find_grasper(vbss_scene *scene, uint32_t body, vbss_grasper **grasper);

/* ---- step_record.c */

typedef struct log_step {
    uint64_t number, has_hash, hash; /* hashed: 1, or 0 and no hash */
    double h;
    uint32_t input_count, input_capacity;
    uint8_t *kinds;
    vbss_log_input *inputs;
    uint32_t event_count, event_capacity;
    uint32_t (*events)[4]; /* the scene's own when written */
} log_step;
void vbss_log_visit_step(vbss_stream *stream, log_step *step);
/* The last record: number of steps and, if nothing was told since, the hash after them. */
void vbss_log_visit_end(vbss_stream *stream, log_step *step);
vbss_result vbss_log_allocate_inputs(vbss_context *context, log_step *step);
void vbss_log_free_inputs(vbss_context *context, log_step *step);
/* Those of the scene after its step; and room for those that are read. */
void vbss_log_borrow_events(log_step *step, const scene_info *scene);
vbss_result vbss_log_allocate_events(vbss_context *context, log_step *step, uint32_t capacity);
void vbss_log_free_events(vbss_context *context, log_step *step);

/* ---- record.c and recorded_inputs.c: writing */

typedef struct record_object {
    uint32_t hash_table[LOG_HASH_TABLE_SIZE]; /* for packing */
    vbss_context *context;
    vbss_scene *scene; /* a handle: it may end before the record */
    uint32_t hash_interval;
    log_writer log;
    struct log_coder *coder;
    size_t end_bytes;              /* kept free for the end */
    log_step step;                 /* the next, as far as it is known */
    scene_edit_counts known_edits; /* the scene as the record left it */
    size_t max_event_bytes;        /* and for the events of a step, in either form */
    uint32_t snapshot_interval;
    bool snapshot_due, ended;
    bool snapshot_is_last; /* what was noted last of the scene is a snapshot */
} record_object;
vbss_result vbss_record_edit(vbss_record *handle, record_object **record);
/* What a host asks for, checked. */
vbss_result vbss_record_read_config(vbss_context *context, const vbss_record_config *config,
                                    vbss_record_config *own);
/* The record of a scene with room for what its steps need, of which nothing is written; and behind a handle,
 * or freed if `result` is a failure. */
vbss_result vbss_record_make(vbss_scene *scene, uint32_t hash_interval, uint32_t input_capacity,
                             record_object **record);
vbss_result vbss_record_allocate_log(record_object *r, size_t start_bytes, size_t snapshot_bytes,
                                     const vbss_record_config *config);
vbss_result vbss_record_create_handle(record_object *r, vbss_result result, vbss_record **record);
/* Whether the scene is there and the record knows all that was done to it. */
vbss_result vbss_record_check_ready(const record_object *r);

/* ---- log_reader.c and replay.c: reading */

typedef struct replay_object {
    vbss_context *context;
    log_header header;
    log_snapshot first_snapshot;  /* with which it begins */
    log_reader log, start;        /* begin: before the first step */
    struct log_coder *scan_coder; /* for readers that do not outlive a call */
    log_step step;                /* what was read last */
    log_reader
        inspection; /* where reading without a scene is: after that many steps, and seconds */
    uint64_t inspected_steps;
    double inspected_time;
    vbss_scene *scene; /* a handle; NULL: not begun */
    vbss_replay_report report;
    vbss_result stop_result; /* VBSS_OK unless the outcome is VBSS_REPLAY_STOPPED */
} replay_object;
vbss_result vbss_replay_edit(vbss_replay *handle, replay_object **replay);
/* All before the first step. */
vbss_result vbss_replay_open_log(replay_object *p);
void vbss_replay_close_log(replay_object *p);
/* The step, snapshot or end that follows on so many steps; what it is stands in `found`. */
vbss_result vbss_log_read_record(log_reader *log, uint64_t steps_before, log_step *step,
                                 log_snapshot *snapshot, log_record *found);
/* A reader at a place where a step stands alone: the begin, or behind a snapshot. */
log_reader vbss_log_reader_at(const log_reader *start, struct log_coder *coder);
/* The same, over snapshots. */
vbss_result vbss_log_read_step(log_reader *log, uint64_t steps_before, log_step *step, bool *end);
/* Brings the scene to after that step, which is in the log. */
vbss_result vbss_replay_seek_step(replay_object *p, uint64_t step);
/* Brings the replay, not the scene, back to where it was. */
void vbss_replay_roll_back(replay_object *p, const replay_object *before);

/* ---- session_records.c */

/* A session after that step of the log: a hash of its task, its events so far. */
typedef struct log_session_hash {
    uint64_t number, hash, events;
} log_session_hash;
/* A mark for which there is no room is left out. */
vbss_result vbss_log_write_session_hash(record_object *r, log_session_hash *entry);
/* That behind the step that was replayed last; false: there is none. */
bool vbss_log_find_session_hash(const replay_object *p, log_session_hash *entry);
/* The state of a session behind a snapshot of its scene that was just written. As it grows with the trial, it is left out until
 * the log has grown by more; and where there is no room. */
vbss_result vbss_log_write_session_snapshot(record_object *r, const vbss_slot *session);
/* The newest one at or before that step, which must be in the log; its bytes are NULL: there is none. */
vbss_result vbss_log_find_session_snapshot(const replay_object *p, uint64_t step,
                                           log_snapshot *snapshot);

#endif
