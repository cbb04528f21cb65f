/**
 * @file record.h
 * @brief Records a scene in a log (initial state, inputs of the host, hashes) and replays the log.
 *
 * A *record* writes the log. It begins with a snapshot of the scene. Once it is attached to the scene
 * (#vbss_scene_set_recorder), it logs every edit and step that functions of the scene and its bodies
 * make. The library writes no files: the host takes the new bytes of the log and appends them to its
 * own file.
 *
 * A *replay* reads a log, complete or truncated, with a scene or without. It restores the initial
 * state in a scene of the same configuration, applies the recorded inputs, steps the scene and
 * compares hashes. It reports the end of the log or the first step that differs.
 * docs/reference/session-log.md describes the format. Steps are coded without loss as differences from a
 * prediction from earlier steps. Logs of format 2, which is uncoded, can be read, replayed and
 * continued.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_RECORD_H
#define VBLAST_SS_RECORD_H

#include <vblast_ss/base.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/scene.h>
#include <vblast_ss/scene_event.h>
#include <vblast_ss/thread.h>

/** Writes the log of one scene. */
typedef struct vbss_record vbss_record;

/** Reads a log. */
typedef struct vbss_replay vbss_replay;

/** Configuration of a record. Fill it with #vbss_record_config_init, then change fields. */
typedef struct vbss_record_config {
    uint32_t struct_size; /**< Size of this struct in bytes, set by the init function. */
    /** Number of steps between hashes of the state, 1 to 1e9; default 1. */
    uint32_t hash_interval;
    /** Largest number of inputs before a step, 0 to 65536; default 64. */
    uint32_t input_capacity;
    uint32_t note_bytes; /**< Size of the note, at most 2^24; default 0. */
    /** Size of the buffer for bytes that the host has not taken yet, without the beginning of the
     * log, bytes, 4096 to 2^30; default 2^20. A step is coded in at most 274 bytes when two rigid
     * bodies move, and 332 when two graspers move and open. Smooth movements take about a tenth of
     * that in the log. */
    uint64_t buffer_bytes;
    /** Data of the host that the log stores, such as a description of its scene; default NULL,
     * allowed when note_bytes is 0. The library copies it. */
    const void *note;
    /** Number of steps between snapshots of the scene in the log, 0 to 1e9; default 2000. With 0
     * there is only the first snapshot. #vbss_replay_seek starts from snapshots. A snapshot that
     * does not fit in the buffer is written after a later step. */
    uint32_t snapshot_interval;
    uint32_t reserved; /**< Zero. */
} vbss_record_config;

/** Kind of an input: a VBSS_RECORD_INPUT_ constant. */
typedef int32_t vbss_record_input_kind;

/** The constants of #vbss_record_input_kind, with their words and their numbers. The log format uses the
 * same constants. */
enum {
    /** Words: body, 1 if turned. Numbers: position (3), orientation (4). */
    VBSS_RECORD_INPUT_RIGID_TARGET = 1,
    VBSS_RECORD_INPUT_PIN =
        2, /**< Words: thread, node, body, 1 if at a point. Numbers: point (3). */
    VBSS_RECORD_INPUT_UNPIN = 3, /**< Words: pin. */
    /** Words: thread, kind, node. Numbers: position (3), direction (3), force (3), stiffness,
     * damping, mass. */
    VBSS_RECORD_INPUT_ATTACH = 4,
    /** Words: thread, attachment, 1 if directed. Numbers: target (3), direction (3). */
    VBSS_RECORD_INPUT_ATTACHMENT_TARGET = 5,
    VBSS_RECORD_INPUT_DETACH = 6, /**< Words: thread, attachment. */
    VBSS_RECORD_INPUT_CUT = 7,    /**< Words: thread. Numbers: arc length. */
    /** Words: grasper, 1 if turned. Numbers: position (3), orientation (4). */
    VBSS_RECORD_INPUT_GRASPER_TARGET = 8,
    VBSS_RECORD_INPUT_SET_OPENING = 9, /**< Words: grasper. Numbers: opening. */
    VBSS_RECORD_INPUT_EXCHANGE = 10,   /**< Words: grasper, kind. */
    /** A change of scene_settings.h. Words: #vbss_scene_setting, body (0 where the setting has none), and
     * two words of the setting. Numbers: those of the setting. */
    VBSS_RECORD_INPUT_SETTING = 11,
    /** #vbss_scene_make_hole. Words: body, drain, triangle. Numbers: arc length, weights (3). */
    VBSS_RECORD_INPUT_HOLE = 12,
    VBSS_RECORD_INPUT_REMOVE = 13, /**< #vbss_scene_remove. Words: body. */
    /** #vbss_drain_attach. Words: drain, kind, node. Numbers: position (3), force (3), stiffness. */
    VBSS_RECORD_INPUT_DRAIN_ATTACH = 14,
    /** #vbss_drain_set_attachment_target. Words: drain, attachment. Numbers: target (3). */
    VBSS_RECORD_INPUT_DRAIN_TARGET = 15,
    VBSS_RECORD_INPUT_DRAIN_DETACH = 16, /**< #vbss_drain_detach. Words: drain, attachment. */
    /** #vbss_thread_set_roll. Words: thread, attachment. Numbers: roll. */
    VBSS_RECORD_INPUT_ROLL = 17
};

/** Change of a running scene: a VBSS_SCENE_SETTING_ constant. */
typedef int32_t vbss_scene_setting;

/** The constants of #vbss_scene_setting: functions of scene_settings.h, with the third and fourth word of
 * an input, if it has any, and its numbers. */
enum {
    VBSS_SCENE_SETTING_GRAVITY = 1,  /**< #vbss_scene_set_gravity. Numbers: gravity (3). */
    VBSS_SCENE_SETTING_FRICTION = 2, /**< #vbss_scene_set_friction. Numbers: friction. */
    VBSS_SCENE_SETTING_THREAD_FRICTION =
        3, /**< #vbss_scene_set_thread_friction. Numbers: friction. */
    /** #vbss_scene_set_coupling. Numbers: stiffness, damping, turning stiffness, turning damping. */
    VBSS_SCENE_SETTING_COUPLING = 4,
    VBSS_SCENE_SETTING_SPEED_LIMIT = 5, /**< #vbss_scene_set_speed_limit. Numbers: limit. */
    VBSS_SCENE_SETTING_FILTER = 6,      /**< #vbss_scene_set_filter. Words: category, mask. */
    /** #vbss_scene_apply_force. Words: 1 if at a point, 1 with a torque. Numbers: force (3), point
     * (3), torque (3). */
    VBSS_SCENE_SETTING_FORCE = 7,
    /** #vbss_scene_set_rigid_velocity. Words: 1 if turned. Numbers: velocity (3), angular velocity
     * (3). */
    VBSS_SCENE_SETTING_VELOCITY = 8,
    /** #vbss_scene_set_rigid_pose. Words: 1 if turned. Numbers: position (3), orientation (4). */
    VBSS_SCENE_SETTING_POSE = 9,
    /** #vbss_scene_set_budgets. Numbers: step budget, call budget, operations per us. */
    VBSS_SCENE_SETTING_BUDGETS = 10
};

/** One input of the host. */
typedef struct vbss_record_input {
    vbss_record_input_kind kind; /**< Kind of the input. */
    uint32_t word_count;         /**< Number of valid entries in `words`. */
    uint32_t number_count;       /**< Number of valid entries in `numbers`. */
    uint32_t reserved;           /**< Zero. */
    uint32_t words[4];           /**< Words; #vbss_record_input_kind lists their meanings. */
    double numbers[12];          /**< Numbers; #vbss_record_input_kind lists their meanings. */
} vbss_record_input;

/** Kind of an event in a log: a VBSS_RECORD_EVENT_ constant, or a #vbss_scene_event_kind other than
 * TRUNCATED and PAUSED. A log stores an event as four words: kind, two bodies, and the last word. For
 * most kinds the last word is the `id` of #vbss_scene_event. For GRASP, RELEASE, TORN and SLIP of a
 * thread or a needle, and for CUT, it is the arc length in um. Logs have no DEFERRED, CAUGHT_UP and
 * OVERDUE. */
typedef int32_t vbss_record_event_kind;

/** The constants of #vbss_record_event_kind that are no #vbss_scene_event_kind. */
enum {
    /** TRUNCATED or PAUSED: 0, 0, and the share of the step that was left out, in 65536ths. */
    VBSS_RECORD_EVENT_TIME_LOST = 3,
    /** Events of a step exceeded event_capacity: 0, 0, and the number of lost events. */
    VBSS_RECORD_EVENT_LOST = 4
};

/** A step as the log describes it. */
typedef struct vbss_replay_logged_step {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    uint32_t hashed;      /**< 1: `hash` is valid. */
    uint64_t number;      /**< Number of the step, from 1 on. */
    uint64_t hash;        /**< Hash of the scene after the step; 0 if it was not hashed. */
    uint64_t position;    /**< Byte of the log just after this step. */
    double h;             /**< Length of the step, s. */
    double time; /**< Sum of the lengths of the steps up to this one, s: the clock of the hands. */
    const vbss_record_input *inputs; /**< Inputs before the step, in their order. */
    /** x 4: the events of the step, as #vbss_record_event_kind describes them. */
    const uint32_t *events;
    uint32_t input_count; /**< Number of inputs. */
    uint32_t event_count; /**< Number of events; each has four words. */
    /** Part of `h` that the scene has left out, s, by its #VBSS_RECORD_EVENT_TIME_LOST events. Each is up to
     * h / 65536 too small. A step may report the time of an earlier paused step. */
    double time_lost;
} vbss_replay_logged_step;

/** Contents and faults of a log. The counts cover its good part, before the first fault. */
typedef struct vbss_record_log_report {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    /** VBSS_OK, or the result of the first fault; VBSS_ERROR_TRUNCATED when the log is truncated. */
    vbss_result result;
    uint32_t ended;       /**< 1: the log has its end record. */
    uint32_t fault_count; /**< Number of faults. The arrays below hold the first eight. */
    uint64_t log_bytes;   /**< Size of the log. */
    uint64_t good_bytes;  /**< Size of its good part, which can be replayed. */
    uint64_t steps;       /**< Number of complete steps. */
    uint64_t inputs;      /**< Number of inputs before these steps. */
    uint64_t events;      /**< Number of events in these steps. */
    uint64_t snapshots;   /**< Number of snapshots, the first one included. */
    double time;          /**< Sum of the lengths of these steps, s: the clock of the hands. */
    uint64_t fault_positions[8];   /**< Positions of the faults, as bytes of the log. */
    const char *fault_problems[8]; /**< Descriptions of the faults, constant English strings. */
    /** VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or VBSS_ERROR_DATA_VERSION. */
    vbss_result fault_results[8];
    /** Part of `time` that the scene has left out, s; see #vbss_replay_logged_step.time_lost. */
    double time_lost;
} vbss_record_log_report;

/** General information on a log. */
typedef struct vbss_replay_info {
    uint32_t struct_size; /**< Bytes of this struct that the library filled. */
    /** Version of the library that wrote the log, as #VBSS_VERSION_NUM. */
    uint32_t library_version;
    uint32_t hash_interval;  /**< Number of steps between hashes. */
    uint32_t note_bytes;     /**< Size of the note. */
    uint64_t snapshot_bytes; /**< Size of the first snapshot, unpacked. */
    uint64_t log_bytes;      /**< Size of the log, truncated and damaged parts included. */
    /** Build information of the library that wrote the log; valid as long as the replay lives. */
    const char *build_info;
    const void *note; /**< The host's note; never NULL; valid as long as the replay lives. */
} vbss_replay_info;

/** Outcome of a replay: a VBSS_REPLAY_OUTCOME_ constant. */
typedef int32_t vbss_replay_outcome;

/** The constants of #vbss_replay_outcome. */
enum {
    VBSS_REPLAY_OUTCOME_STEPPED = 0, /**< The replay has not ended; all hashes so far agree. */
    VBSS_REPLAY_OUTCOME_ENDED = 1, /**< The log has ended with its end record; all hashes agree. */
    VBSS_REPLAY_OUTCOME_DIFFERS = 2, /**< The state after `step` is not the recorded one. */
    /** The call has failed: the log is truncated or damaged, or the scene refused a step. */
    VBSS_REPLAY_OUTCOME_STOPPED = 3
};

/** Position and outcome of a replay. */
typedef struct vbss_replay_report {
    uint32_t struct_size;        /**< Bytes of this struct that the library filled. */
    vbss_replay_outcome outcome; /**< Outcome so far. */
    uint64_t step; /**< Number of the last step that was made, from 1 on; 0: no step. */
    /** Number of the last step whose recorded hash agrees; 0: only the initial state agrees. The
     * first step that differs comes after this one, and not after `step`. */
    uint64_t agreed_step;
    uint64_t recorded_hash; /**< Recorded hash after `step`; 0 if none was recorded. */
    uint64_t found_hash;    /**< Hash of the replayed scene after `step`; 0 if none was recorded. */
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
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_config_init(vbss_record_config *config, uint32_t struct_size);

/**
 * Returns the default configuration that #vbss_record_config_init fills.
 *
 * @return the struct, with its size
 * @threads any thread, any time
 * @since 1.0
 */
static inline vbss_record_config vbss_record_config_default(void)
{
    vbss_record_config vbss_filled;
    (void)vbss_record_config_init(&vbss_filled, (uint32_t)sizeof vbss_filled);
    return vbss_filled;
}

/**
 * Begins the log of a scene with the version of the library, the scene's configuration and a
 * snapshot of its state. The call allocates all memory that steps need.
 *
 * @param scene        the scene; after it is destroyed, only #vbss_record_take and
 *         #vbss_record_destroy are useful
 * @param config   configuration; NULL for the defaults
 * @param[out] record  the new record; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_CAPACITY (a snapshot of 3 GiB),
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_create(vbss_scene *scene, const vbss_record_config *config,
                                        vbss_record **record);

/**
 * Destroys a record. Bytes that were not taken are lost; a log without an end record counts as
 * truncated.
 *
 * @param record  the record; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_destroy(vbss_record *record);

/**
 * Continues a log, complete or truncated. The call brings the scene of the replay to the last
 * complete step, as #vbss_replay_seek does, and creates a record that appends to the log. The host
 * first truncates its file at `position`. A damaged log is refused. To continue its good part
 * (#vbss_record_check_log), open a replay of that part alone.
 *
 * @param replay         a replay that has begun; the record does not log its later steps
 * @param config         configuration; NULL for the defaults. Only buffer_bytes and
 *         snapshot_interval are used; the log determines the rest.
 * @param[out] record    the new record; NULL when the call fails. It has no bytes to take yet.
 * @param[out] position  byte of the log at which the host appends the bytes that it takes
 * @return VBSS_OK, VBSS_ERROR_CORRUPT (also: the steps differ from the recorded ones),
 *         VBSS_ERROR_DATA_VERSION (also: another version of the library began the log),
 *         VBSS_ERROR_CAPACITY (the scene keeps more events than the recorded one),
 *         VBSS_ERROR_WRONG_STATE (the replay has not begun), or a result of #vbss_replay_step,
 *         #vbss_scene_restore or #vbss_record_create
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_resume(vbss_replay *replay, const vbss_record_config *config,
                                        vbss_record **record, uint64_t *position);

/**
 * Returns the bytes that were added to the log since the last call, for the host to store or send.
 * They form complete steps.
 *
 * @param record      the record
 * @param[out] bytes  the bytes, valid until the next call that records something; never NULL
 * @param[out] count  number of bytes; 0 when there are no new ones
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_take(vbss_record *record, const uint8_t **bytes, uint64_t *count);

/**
 * Attaches a record to its scene. From then on the record logs every edit of the scene and of bodies in
 * it, and every step, whatever function makes them. An edit belongs to the step that follows; one that
 * fails is not logged. A scene has at most one record attached; another one takes its place.
 *
 * Adding a body, #vbss_scene_restore, #vbss_thread_set_state and #vbss_drain_set_state have no input of
 * their own: the log receives a snapshot of the scene after them, for which they may allocate memory. A
 * replay follows them in a scene of #vbss_replay_load_scene.
 *
 * An edit or step of the scene then has further errors, and changes nothing with them.
 * VBSS_ERROR_CAPACITY: input_capacity is exhausted, or the buffer has no room for the step, until
 * #vbss_record_take. VBSS_ERROR_WRONG_STATE: the scene was changed while the record was not attached.
 * VBSS_ERROR_OUT_OF_MEMORY: there is no memory for the snapshot. #vbss_record_end and
 * #vbss_record_destroy detach the record.
 *
 * @param scene   the scene
 * @param record  a record of this scene that knows its state: no edit came between its creation or
 *         its last step and this call. NULL detaches.
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a record of another context),
 *         VBSS_ERROR_INCOMPATIBLE (a record of another scene), VBSS_ERROR_WRONG_STATE (one that has
 *         ended, or that does not know the state) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_scene_set_recorder(vbss_scene *scene, vbss_record *record);

/**
 * Applies an input to the recorded scene and logs it, whether the record is attached or not. For inputs
 * that come from another log (#vbss_replay_read).
 *
 * @param record   the record
 * @param input    the input; `word_count` and `number_count` are not used
 * @param[out] id  identifier of a new pin or attachment, or number of a new piece; may be NULL
 * @return a result of the function of the input, as a scene with this record attached returns it;
 *         VBSS_ERROR_INVALID_HANDLE (also: the scene was destroyed), VBSS_ERROR_NULL_ARGUMENT,
 *         VBSS_ERROR_OUT_OF_RANGE (also: a kind or a setting that does not exist),
 *         VBSS_ERROR_NOT_FINITE (any number of the input), VBSS_ERROR_WRONG_STATE (as
 *         #vbss_scene_set_recorder), VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_apply_input(vbss_record *record, const vbss_record_input *input,
                                             uint32_t *id);

/**
 * Ends the log; the end record always fits in the buffer. With inputs since the last step the log
 * ends without them and without a last hash. Afterwards only #vbss_record_take and
 * #vbss_record_destroy succeed.
 *
 * @param record  the record
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_WRONG_STATE (it has ended before) or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_end(vbss_record *record);

/**
 * Opens a log and checks its beginning. The rest is checked when it is read.
 *
 * @param context      owner
 * @param bytes        the log; it must stay valid and unchanged while the replay lives
 * @param count        its size
 * @param[out] replay  the new replay; NULL when the call fails
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED (the
 *         beginning is incomplete), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION,
 *         VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; error texts name the byte
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_create(vbss_context *context, const uint8_t *bytes, uint64_t count,
                                        vbss_replay **replay);

/**
 * Destroys a replay; the host keeps the scene.
 *
 * @param replay  the replay; NULL does nothing
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_destroy(vbss_replay *replay);

/**
 * Returns general information on the log.
 *
 * @param replay       the replay
 * @param[out] info        receives the information
 * @param struct_size  `sizeof *info` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_get_info(vbss_replay *replay, vbss_replay_info *info,
                                          uint32_t struct_size);

/**
 * Returns the configuration of the recorded scene, with which the host can create an equal one. Its
 * pointers to the parameters of the baseline and to the options of the solver are valid as long as
 * the replay lives. A log of an older library has budgets in operations: the returned options give the
 * same operations at the default of 500 per us.
 *
 * @param replay          the replay
 * @param[in,out] config an initialised configuration; the call sets every field
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_get_scene_config(vbss_replay *replay, vbss_scene_config *config);

/**
 * Reads a log to its end without a scene.
 *
 * @param replay      the replay; its position does not change
 * @param[out] steps  number of complete steps, also when the call fails because of later bytes
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED (the
 *         log has no end), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_ARITHMETIC_MODE
 *         or VBSS_ERROR_BUSY; error texts name the byte
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_check(vbss_replay *replay, uint64_t *steps);

/**
 * Restores the initial state of the record in a scene and moves the replay to before its first
 * step. A replay can begin more than once. On failure the scene is unchanged.
 *
 * @param replay  the replay
 * @param scene   a scene of the same context with the configuration of the recorded one and equal
 *         bodies added in the same order; capacities may differ, except those of pins and grasps
 * @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the scene is of another context),
 *         VBSS_ERROR_CORRUPT (another scene; the error text names the field), VBSS_ERROR_CAPACITY,
 *         VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_begin(vbss_replay *replay, vbss_scene *scene);

/**
 * Creates the recorded scene from the first snapshot of the log, as #vbss_scene_load does, and begins
 * the replay in it. The host destroys the scene, after the replay or before.
 *
 * @param replay      the replay
 * @param[out] scene  the new scene; NULL when the call fails
 * @return as #vbss_scene_load and #vbss_replay_begin; VBSS_ERROR_DATA_VERSION for a log of an older
 *         library, whose snapshots do not describe their scene
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_load_scene(vbss_replay *replay, vbss_scene **scene);

/**
 * Replays the next step: applies its inputs, steps the scene and compares the hash. The call
 * allocates nothing. After the end, a difference or a failure, further calls do nothing and return
 * the same result until #vbss_replay_begin.
 *
 * @param replay       the replay, which has begun
 * @param[out] report  receives the report, also when the log cannot be read or the scene refuses
 *         the step
 * @param struct_size  `sizeof *report` as the caller was compiled
 * @return VBSS_OK, also for a step that differs and for the end; VBSS_ERROR_TRUNCATED (all complete
 *         steps were replayed, the end is missing), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION,
 *         with texts that name the byte; any error of an input or of #vbss_scene_step;
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_WRONG_STATE (it has not begun) or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_step(vbss_replay *replay, vbss_replay_report *report,
                                      uint32_t struct_size);

/**
 * Moves the replay and its scene to just after a step: restores the newest snapshot at or before
 * it, replays the steps that follow and compares their hashes. #vbss_replay_step then continues
 * with the same bits as without the seek. When the log does not have the step, scene and replay are
 * unchanged.
 *
 * @param replay       the replay, which has begun
 * @param step         number of the step; 0: the initial state
 * @param[out] report  receives the report, as in #vbss_replay_step
 * @param struct_size  `sizeof *report` as the caller was compiled
 * @return as #vbss_replay_step and #vbss_scene_restore; VBSS_ERROR_NOT_FOUND if the log ends before
 *         the step
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_seek(vbss_replay *replay, uint64_t step,
                                      vbss_replay_report *report, uint32_t struct_size);

/**
 * Reads a step from the log without a scene; the position of the replay does not change. Reading
 * steps in ascending order is fast. To read an earlier step, the call reads the log from its
 * beginning.
 *
 * @param replay       the replay
 * @param number       number of the step, from 1 on
 * @param[out] step    receives the step; its arrays are valid until the next call for this replay
 * @param struct_size  `sizeof *step` as the caller was compiled
 * @return VBSS_OK, VBSS_ERROR_NOT_FOUND (the log ends before it), VBSS_ERROR_TRUNCATED (the log
 *         is truncated before it), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION,
 *         VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
 *         VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_replay_read(vbss_replay *replay, uint64_t number,
                                      vbss_replay_logged_step *step, uint32_t struct_size);

/**
 * Checks a whole log, which may be any bytes, and reports its contents, its faults and their
 * positions. After a fault the check continues at the next record that can be found.
 *
 * @param context      context whose allocator supplies temporary memory
 * @param bytes        the log
 * @param count        its size
 * @param[out] report  receives the report
 * @param struct_size  `sizeof *report` as the caller was compiled
 * @return VBSS_OK, whatever faults the log has; VBSS_ERROR_INVALID_HANDLE,
 *         VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_CORRUPT (the log states a
 *         size larger than any memory), VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or
 *         VBSS_ERROR_BUSY
 * @threads one thread at a time per context
 * @since 1.0
 */
VBSS_API vbss_result vbss_record_check_log(vbss_context *context, const uint8_t *bytes,
                                           uint64_t count, vbss_record_log_report *report,
                                           uint32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
