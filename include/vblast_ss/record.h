/**
 * @file record.h
 * @brief A log of a scene: where it began, what the host told it, hashes; and its replay.
 *
 * A *record* writes the log. It begins with a snapshot of the scene; from then on the host moves, pins, cuts
 * and steps the scene by the functions of this header, which do what those of scene.h, thread.h and grasper.h
 * do and note it. The library writes no files: the host takes what the log has grown by and appends it to its own.
 *
 * A *replay* reads a log, complete or cut off, with a scene or without. It brings a scene that was made alike to where the record
 * began, tells it what the host told it then, steps it, and compares hashes: it ends, or names the
 * first step that differs. Page docs/session-log.md has the format. Steps are coded as differences from what
 * the steps before predict, to the bit; logs of format 2, which were not, are read, replayed and continued.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_RECORD_H
#define VBLAST_SS_RECORD_H

#include <vblast_ss/base.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/scene.h>
#include <vblast_ss/thread.h>

/** Writes the log of one scene. */
typedef struct vbss_record vbss_record;

/** Reads a log. */
typedef struct vbss_replay vbss_replay;

/** How to write a log. Fill it with #vbss_record_config_init, then change what you need. */
typedef struct vbss_record_config {
    uint32_t struct_size;    /**< Size of this struct in bytes, set by the init function. */
    uint32_t hash_interval;  /**< The state is hashed every so many steps, 1 to 1e9; default 1. */
    uint32_t input_capacity; /**< Most inputs before a step, 0 to 65536; default 64. */
    uint32_t note_bytes;     /**< Size of the note, at most 2^24; default 0. */
    /** Room for what the host has not taken yet, beyond the begin of the log, in bytes, 4096 to 2^30;
     * default 2^20. A step needs room for its largest form: 274 where two rigid bodies move, 332 where
     * two graspers move and open. Smooth movements take about a tenth of that in the log. */
    uint64_t buffer_bytes;
    /** Anything the host wants to find in the log again, such as what its scene is made from; NULL
     * (default) when note_bytes is 0. Copied. */
    const void *note;
    /** A snapshot of the scene is put in the log every so many steps, 0 to 1e9; 0: only at the begin; default 2000.
     * #vbss_replay_seek goes on from them. One that finds no room in the buffer waits for a later step that has it. */
    uint32_t snapshot_interval;
    uint32_t reserved; /**< Zero. */
} vbss_record_config;

/** What a host has told a scene: a VBSS_INPUT_ constant. */
typedef int32_t vbss_input_kind;

/** The constants of #vbss_input_kind, with the words and numbers of each. They are numbers of the format. */
enum {
    VBSS_INPUT_MOVE_RIGID = 1, /**< Body, whether turned; position 3, orientation 4. */
    VBSS_INPUT_PIN = 2,        /**< Thread, node, body, whether at a point; point 3. */
    VBSS_INPUT_UNPIN = 3,      /**< Pin. */
    /** Thread, kind, node; position 3, direction 3, force 3, stiffness, damping, mass. */
    VBSS_INPUT_ATTACH = 4,
    VBSS_INPUT_MOVE = 5,   /**< Thread, attachment, whether directed; target 3, direction 3. */
    VBSS_INPUT_DETACH = 6, /**< Thread, attachment. */
    VBSS_INPUT_CUT = 7,    /**< Thread; arc length. */
    VBSS_INPUT_MOVE_GRASPER = 8, /**< Grasper, whether turned; position 3, orientation 4. */
    VBSS_INPUT_SET_OPENING = 9,  /**< Grasper; opening. */
    VBSS_INPUT_EXCHANGE = 10     /**< Grasper, kind. */
};

/** One thing that a host has told a scene. */
typedef struct vbss_log_input {
    vbss_input_kind kind;  /**< What. */
    uint32_t word_count;   /**< Of the words below. */
    uint32_t number_count; /**< Of the numbers below. */
    uint32_t reserved;     /**< Zero. */
    uint32_t words[4];     /**< As #vbss_input_kind says. */
    double numbers[12];    /**< The same. */
} vbss_log_input;

/** What a log says of a step. */
typedef struct vbss_log_step {
    uint32_t struct_size;         /**< Bytes of this struct that the library filled. */
    uint32_t hashed;              /**< 1: the hash is there. */
    uint64_t number;              /**< From 1 on. */
    uint64_t hash;                /**< Of the scene after it; 0 if it was not hashed. */
    uint64_t position;            /**< Byte of the log at which what follows it begins. */
    double h;                     /**< Its length, s. */
    double time;                  /**< Sum of the lengths up to it, s: the clock of the hands. */
    const vbss_log_input *inputs; /**< What was told before it, in that order. */
    const uint32_t *events;       /**< x 4, as in #VBSS_SCENE_VIEW_EVENTS: what happened in it. */
    uint32_t input_count;         /**< Of inputs. */
    uint32_t event_count;         /**< Of events: four words each. */
    /** Part of `h` that the scene has left out, s, by #VBSS_EVENT_CLAMPED. Each such event is up to h / 65536 too small. A
     * paused step may be reported in a later one. */
    double time_lost;
} vbss_log_step;

/** What is in a log, and what is wrong with it. The counts are those of its good part, before the first fault. */
typedef struct vbss_log_report {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    vbss_result result; /**< VBSS_OK, or of the first fault; VBSS_ERROR_TRUNCATED: it is cut off. */
    uint32_t ended;     /**< 1: the end is there. */
    uint32_t fault_count;          /**< Of faults, of which the first eight are told below. */
    uint64_t log_bytes;            /**< Size of the log. */
    uint64_t good_bytes;           /**< Of its good part, which replays. */
    uint64_t steps;                /**< Complete ones. */
    uint64_t inputs;               /**< Told before them. */
    uint64_t events;               /**< In them. */
    uint64_t snapshots;            /**< With that at the begin. */
    double time;                   /**< Sum of their lengths, s: the clock of the hands. */
    uint64_t fault_positions[8];   /**< Bytes of the log. */
    const char *fault_problems[8]; /**< Constant texts, in English. */
    /** VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or VBSS_ERROR_DATA_VERSION. */
    vbss_result fault_results[8];
    double
        time_lost; /**< Part of `time` that the scene has left out, s: see #vbss_log_step.time_lost. */
} vbss_log_report;

/** What a log says about itself. */
typedef struct vbss_replay_info {
    uint32_t struct_size;     /**< Bytes of this struct that the library filled. */
    uint32_t library_version; /**< Of the library that wrote it, as #VBSS_VERSION_NUM. */
    uint32_t hash_interval;   /**< As it was recorded. */
    uint32_t note_bytes;      /**< Size of the note. */
    uint64_t snapshot_bytes;  /**< Size of the snapshot it begins with, unpacked. */
    uint64_t log_bytes;       /**< Size of the log, what may be cut off or damaged included. */
    const char *build_info;   /**< Of the library that wrote it; lives as long as the replay. */
    const void *note;         /**< The host's note; never NULL; lives as long as the replay. */
} vbss_replay_info;

/** How far a replay is: a VBSS_REPLAY_ constant. */
typedef int32_t vbss_replay_outcome;

/** The constants of #vbss_replay_outcome. */
enum {
    VBSS_REPLAY_STEPPED = 0, /**< On its way; all hashes so far agree. */
    VBSS_REPLAY_ENDED = 1,   /**< The log has ended as it should; all hashes agree. */
    VBSS_REPLAY_DIFFERS = 2, /**< The state after `step` is not the recorded one. */
    VBSS_REPLAY_STOPPED =
        3 /**< The call has failed: the log is cut off or damaged, or a step is refused. */
};

/** Where a replay is, and what it has found. */
typedef struct vbss_replay_report {
    uint32_t struct_size;        /**< Bytes of this struct that the library filled. */
    vbss_replay_outcome outcome; /**< How far it is. */
    uint64_t step;               /**< Number of the last step that was made, from 1 on; 0: none. */
    /** Number of the last step whose hash was recorded and agrees; 0: only the begin does. The first
     * step that differs comes after it and is `step` at the latest. */
    uint64_t agreed_step;
    uint64_t recorded_hash; /**< After `step`; 0 where none was recorded. */
    uint64_t found_hash;    /**< Of the scene that is replayed; 0 where none was recorded. */
    uint64_t position;      /**< Byte of the log at which the next record begins. */
} vbss_replay_report;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Fills a configuration with the defaults.
 *
 * @param[out] config  the configuration to fill
 * @param struct_size  `sizeof *config` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads any thread, any time
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_config_init(vbss_record_config *config, uint32_t struct_size);

/**
 * Begins the log of a scene: what library writes it, the scene's configuration and a snapshot of its
 * state. All memory that steps need is allocated here.
 *
 * @param scene        the scene; it may be destroyed before the record, which is then only good for
 *                     taking what is left
 * @param config       how; NULL for the defaults
 * @param[out] record  the new record; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_CAPACITY (a snapshot of 3 GiB),
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_create(vbss_scene *scene, const vbss_record_config *config,
                                        vbss_record **record);

/**
 * Destroys a record. What was not taken is lost; a log whose end was not recorded counts as cut off.
 *
 * @param record  the record; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_destroy(vbss_record *record);

/**
 * Goes on with a log, complete or cut off: brings the scene of the replay to its last complete step, as
 * #vbss_replay_seek does, and makes a record that appends to it. The host first cuts its file off at `position`.
 * A damaged log is refused; its good part (#vbss_log_check) can be gone on with by a replay of that alone.
 *
 * @param replay         a replay that has begun; what it replays afterwards is past the record
 * @param config         how; NULL for the defaults. Only buffer_bytes and snapshot_interval count; the rest is as
 *                       the log has it.
 * @param[out] record    the new record; NULL when the call fails. Nothing is in it to be taken yet.
 * @param[out] position  byte of the log at which what it takes is to be appended
 * @return VBSS_OK, VBSS_ERROR_CORRUPT (also: the steps are not made as they were recorded),
 *         VBSS_ERROR_DATA_VERSION (also: begun by another version of the library), VBSS_ERROR_CAPACITY (the scene
 *         keeps more events than that of the log), VBSS_ERROR_OUT_OF_RANGE (the replay has not begun), what
 *         #vbss_replay_step and #vbss_scene_restore return, or what #vbss_record_create does
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_resume(vbss_replay *replay, const vbss_record_config *config,
                                        vbss_record **record, uint64_t *position);

/**
 * Hands out what the log has grown by since it was asked last, to be appended to a file or sent. It
 * consists of complete steps.
 *
 * @param record      the record
 * @param[out] bytes  the bytes, valid until the next call that records something; never NULL
 * @param[out] count  how many; 0 when there is nothing new
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_take(vbss_record *record, const uint8_t **bytes, uint64_t *count);

/**
 * #vbss_scene_move_rigid of the recorded scene. Like the functions below it fails without changing
 * anything as that does, and further with VBSS_ERROR_OUT_OF_RANGE after #vbss_record_end, or when the scene,
 * or a thread, drain or grasper in it, was changed past the record since (then begin a new one), and with
 * VBSS_ERROR_CAPACITY when input_capacity is exhausted. An input belongs to the step that follows.
 *
 * @param record       the record
 * @param body         a rigid body, neither a free one nor a grasper
 * @param position     of the origin of its frame, m, each at most 1e3
 * @param orientation  w, x, y, z, of any length from 1e-100 to 1e100; NULL leaves it
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the scene was destroyed), VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE, VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_move_rigid(vbss_record *record, uint32_t body,
                                            const double position[3], const double *orientation);

/**
 * #vbss_grasper_move of a grasper in the recorded scene.
 *
 * @param record       the record
 * @param body         number of the grasper in the scene
 * @param position     of the tip, m, each at most 1e3
 * @param orientation  w, x, y, z, of any length from 1e-100 to 1e100; NULL leaves what was told
 * @return as #vbss_record_move_rigid
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_move_grasper(vbss_record *record, uint32_t body,
                                              const double position[3], const double *orientation);

/**
 * #vbss_grasper_set_opening of a grasper in the recorded scene.
 *
 * @param record   the record
 * @param body     number of the grasper in the scene
 * @param opening  of the handle, 0 closed to 1 open
 * @return as #vbss_record_move_rigid
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_set_opening(vbss_record *record, uint32_t body, double opening);

/**
 * #vbss_grasper_exchange of a grasper in the recorded scene.
 *
 * @param record  the record
 * @param body    number of the grasper in the scene
 * @param kind    what it shall be
 * @return as #vbss_record_move_rigid
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_exchange(vbss_record *record, uint32_t body,
                                          vbss_grasper_kind kind);

/**
 * #vbss_scene_pin_thread of the recorded scene.
 *
 * @param record    the record
 * @param thread    number of the thread in the scene
 * @param node      0 to its number of nodes - 1
 * @param body      number of a rigid body; 0: the world
 * @param point     m, in the frame of the body, each at most 1e3; NULL: where the node is now
 * @param[out] pin  names the pin, from 1 on, never used again
 * @return as #vbss_record_move_rigid; VBSS_ERROR_CAPACITY also: pins, or the thread's attachments
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_pin_thread(vbss_record *record, uint32_t thread, uint32_t node,
                                            uint32_t body, const double *point, uint32_t *pin);

/**
 * #vbss_scene_unpin_thread of the recorded scene.
 *
 * @param record  the record
 * @param pin     its name
 * @return as #vbss_record_move_rigid
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_unpin_thread(vbss_record *record, uint32_t pin);

/**
 * #vbss_scene_cut_thread of the recorded scene.
 *
 * @param record      the record
 * @param thread      number of the thread in the scene
 * @param arc_length  of the cut from the thread's node 0, unstretched, m, within its length and not at an end
 * @param[out] piece  number of the new body
 * @return as #vbss_record_move_rigid; VBSS_ERROR_CAPACITY also: no cuts left
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_cut_thread(vbss_record *record, uint32_t thread, double arc_length,
                                            uint32_t *piece);

/**
 * #vbss_thread_attach to a thread of the recorded scene.
 *
 * @param record      the record
 * @param thread      number of the thread in the scene
 * @param attachment  what
 * @param[out] id     names the attachment, from 1 on, never used again in this thread
 * @return as #vbss_record_move_rigid; VBSS_ERROR_CAPACITY also: the thread's attachments; further
 *         VBSS_ERROR_STRUCT_SIZE or VBSS_ERROR_UNKNOWN_FIELD
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_attach(vbss_record *record, uint32_t thread,
                                        const vbss_thread_attachment *attachment, uint32_t *id);

/**
 * #vbss_thread_move of an attachment of a thread of the recorded scene.
 *
 * @param record     the record
 * @param thread     number of the thread in the scene
 * @param id         the attachment, not a MASS
 * @param target     PIN, CLAMP, SPRING: position, m; FORCE: the force, N
 * @param direction  CLAMP: of any length from 1e-100 to 1e100; NULL leaves it
 * @return as #vbss_record_move_rigid
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_move_attachment(vbss_record *record, uint32_t thread, uint32_t id,
                                                 const double target[3], const double *direction);

/**
 * #vbss_thread_detach from a thread of the recorded scene.
 *
 * @param record  the record
 * @param thread  number of the thread in the scene
 * @param id      the attachment
 * @return as #vbss_record_move_rigid
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_detach(vbss_record *record, uint32_t thread, uint32_t id);

/**
 * #vbss_scene_step of the recorded scene; appends the inputs since the last step, the length of this one, its
 * events and, when they are due, the hash of the state and a snapshot. Nothing is allocated. When the step fails the log and the
 * scene are as they were, and the inputs belong to the step that succeeds.
 *
 * @param record  the record
 * @param h       s, 1e-7 to 0.1
 * @return as #vbss_record_move_rigid and #vbss_scene_step; VBSS_ERROR_CAPACITY also, before anything is
 *         done: the log's room, so that #vbss_record_take comes first
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_step(vbss_record *record, double h);

/**
 * Ends the log; there is always room for it. Inputs since the last step are not part of the log, which
 * then ends without a last hash. Afterwards there is only #vbss_record_take.
 *
 * @param record  the record
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_OUT_OF_RANGE (it has ended before) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_record_end(vbss_record *record);

/**
 * Opens a log and checks how it begins; whatever follows is checked when it is read.
 *
 * @param context      owner
 * @param bytes        the log; must stay as it is while the replay lives
 * @param count        its size
 * @param[out] replay  the new replay; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED (the begin
 *         is not complete), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY or
 *         VBSS_ERROR_BUSY; texts name the byte
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_create(vbss_context *context, const uint8_t *bytes, uint64_t count,
                                        vbss_replay **replay);

/**
 * Destroys a replay; the scene is the host's as before.
 *
 * @param replay  the replay; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_destroy(vbss_replay *replay);

/**
 * What the log says about itself.
 *
 * @param replay       the replay
 * @param[out] info    receives it
 * @param struct_size  `sizeof *info` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_get_info(vbss_replay *replay, vbss_replay_info *info,
                                          uint32_t struct_size);

/**
 * The configuration of the recorded scene, to make one like it.
 *
 * @param replay          the replay
 * @param[in,out] config  an initialised configuration; every field of it is set
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_get_scene_config(vbss_replay *replay, vbss_scene_config *config);

/**
 * Reads a log to its end without a scene.
 *
 * @param replay      the replay, which stays where it is
 * @param[out] steps  complete steps in it, also when the call fails with what comes after them
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED (it has no
 *         end), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY;
 *         texts name the byte
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_check(vbss_replay *replay, uint64_t *steps);

/**
 * Brings a scene to where the record began, and the replay before its first step; also to replay once
 * more. On failure the scene is as it was.
 *
 * @param replay  the replay
 * @param scene   a scene of the same context, made like the recorded one: the same configuration but for
 *                capacities (those of pins and grasps are the same as well), the same bodies added in the same order
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: of another context), VBSS_ERROR_CORRUPT (another
 *         scene; a text names the field), VBSS_ERROR_CAPACITY, VBSS_ERROR_DATA_VERSION,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_begin(vbss_replay *replay, vbss_scene *scene);

/**
 * Replays the next step: tells the scene what it was told, steps it and compares the hash. Nothing is
 * allocated. Where it has ended, differs or has failed it stays: the call does nothing and returns the
 * same again until #vbss_replay_begin.
 *
 * @param replay       the replay, which has begun
 * @param[out] report  receives what was found, also when the log cannot be read or the step not be made
 * @param struct_size  `sizeof *report` as the caller was compiled
 * @return VBSS_OK, also for a step that differs and for the end; VBSS_ERROR_TRUNCATED (all complete steps
 *         were replayed, the end is missing), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, with texts that
 *         name the byte; what an input or #vbss_scene_step was refused with;
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_OUT_OF_RANGE (it has not begun) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_step(vbss_replay *replay, vbss_replay_report *report,
                                      uint32_t struct_size);

/**
 * Brings the replay and its scene to after a step: restores the newest snapshot at or before it, makes the steps
 * from there on and compares their hashes. #vbss_replay_step goes on from there to the same bits as without. When
 * the log does not have the step, scene and replay stay as they are.
 *
 * @param replay       the replay, which has begun
 * @param step         number of the step; 0: the begin
 * @param[out] report  receives what was found, as in #vbss_replay_step
 * @param struct_size  `sizeof *report` as the caller was compiled
 * @return as #vbss_replay_step and #vbss_scene_restore; VBSS_ERROR_OUT_OF_RANGE also: the log ends before the step
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_seek(vbss_replay *replay, uint64_t step,
                                      vbss_replay_report *report, uint32_t struct_size);

/**
 * What the log says of a step, without a scene; the replay stays where it is. Quickly done for the step after the
 * one that was read last; for one before it the log is read from its begin.
 *
 * @param replay       the replay
 * @param number       of the step, from 1 on
 * @param[out] step    receives it; its arrays are valid until the next call for this replay
 * @param struct_size  `sizeof *step` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_OUT_OF_RANGE (the log ends before it), VBSS_ERROR_TRUNCATED (it is cut off before it),
 *         VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_replay_read(vbss_replay *replay, uint64_t number, vbss_log_step *step,
                                      uint32_t struct_size);

/**
 * Walks through all of a log, which may be any bytes, and says what is in it, what is wrong, and where.
 * What follows a fault is looked at as far as records can be found there.
 *
 * @param context      for the memory that this takes meanwhile
 * @param bytes        the log
 * @param count        its size
 * @param[out] report  receives what was found
 * @param struct_size  `sizeof *report` as the caller was compiled
 * @return VBSS_OK, whatever is wrong; VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_CORRUPT (larger than any memory), VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 0.1
 */
VBSS_API vbss_result vbss_log_check(vbss_context *context, const uint8_t *bytes, uint64_t count,
                                    vbss_log_report *report, uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
