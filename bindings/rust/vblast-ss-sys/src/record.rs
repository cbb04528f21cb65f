// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char, c_void};
#[allow(unused_imports)]
use crate::*;


/// Kind of an input: a VBSS_RECORD_INPUT_ constant.
pub type vbss_record_input_kind = i32;

/// Change of a running scene: a VBSS_SCENE_SETTING_ constant.
pub type vbss_scene_setting = i32;

/// Kind of an event in a log: a VBSS_RECORD_EVENT_ constant, or a vbss_scene_event_kind other than
/// TRUNCATED and PAUSED. A log stores an event as four words: kind, two bodies, and the last word. For
/// most kinds the last word is the `id` of vbss_scene_event. For GRASP, RELEASE, TORN and SLIP of a
/// thread or a needle, and for CUT, it is the arc length in um. Logs have no DEFERRED, CAUGHT_UP and
/// OVERDUE.
pub type vbss_record_event_kind = i32;

/// Outcome of a replay: a VBSS_REPLAY_OUTCOME_ constant.
pub type vbss_replay_outcome = i32;

// The constants of vbss_record_input_kind, with their words and their numbers. The log format uses the
// same constants.
/// Words: body, 1 if turned. Numbers: position (3), orientation (4).
pub const VBSS_RECORD_INPUT_RIGID_TARGET: vbss_record_input_kind = 1;
/// Words: thread, node, body, 1 if at a point. Numbers: point (3).
pub const VBSS_RECORD_INPUT_PIN: vbss_record_input_kind = 2;
/// Words: pin.
pub const VBSS_RECORD_INPUT_UNPIN: vbss_record_input_kind = 3;
/// Words: thread, kind, node. Numbers: position (3), direction (3), force (3), stiffness,
/// damping, mass.
pub const VBSS_RECORD_INPUT_ATTACH: vbss_record_input_kind = 4;
/// Words: thread, attachment, 1 if directed. Numbers: target (3), direction (3).
pub const VBSS_RECORD_INPUT_ATTACHMENT_TARGET: vbss_record_input_kind = 5;
/// Words: thread, attachment.
pub const VBSS_RECORD_INPUT_DETACH: vbss_record_input_kind = 6;
/// Words: thread. Numbers: arc length.
pub const VBSS_RECORD_INPUT_CUT: vbss_record_input_kind = 7;
/// Words: grasper, 1 if turned. Numbers: position (3), orientation (4).
pub const VBSS_RECORD_INPUT_GRASPER_TARGET: vbss_record_input_kind = 8;
/// Words: grasper. Numbers: opening.
pub const VBSS_RECORD_INPUT_SET_OPENING: vbss_record_input_kind = 9;
/// Words: grasper, kind.
pub const VBSS_RECORD_INPUT_EXCHANGE: vbss_record_input_kind = 10;
/// A change of scene_settings.h. Words: vbss_scene_setting, body (0 where the setting has none), and
/// two words of the setting. Numbers: those of the setting.
pub const VBSS_RECORD_INPUT_SETTING: vbss_record_input_kind = 11;
/// vbss_scene_make_hole. Words: body, drain, triangle. Numbers: arc length, weights (3).
pub const VBSS_RECORD_INPUT_HOLE: vbss_record_input_kind = 12;
/// vbss_scene_remove. Words: body.
pub const VBSS_RECORD_INPUT_REMOVE: vbss_record_input_kind = 13;
/// vbss_drain_attach. Words: drain, kind, node. Numbers: position (3), force (3), stiffness.
pub const VBSS_RECORD_INPUT_DRAIN_ATTACH: vbss_record_input_kind = 14;
/// vbss_drain_set_attachment_target. Words: drain, attachment. Numbers: target (3).
pub const VBSS_RECORD_INPUT_DRAIN_TARGET: vbss_record_input_kind = 15;
/// vbss_drain_detach. Words: drain, attachment.
pub const VBSS_RECORD_INPUT_DRAIN_DETACH: vbss_record_input_kind = 16;
/// vbss_thread_set_roll. Words: thread, attachment. Numbers: roll.
pub const VBSS_RECORD_INPUT_ROLL: vbss_record_input_kind = 17;

// The constants of vbss_scene_setting: functions of scene_settings.h, with the third and fourth word of
// an input, if it has any, and its numbers.
/// vbss_scene_set_gravity. Numbers: gravity (3).
pub const VBSS_SCENE_SETTING_GRAVITY: vbss_scene_setting = 1;
/// vbss_scene_set_friction. Numbers: friction.
pub const VBSS_SCENE_SETTING_FRICTION: vbss_scene_setting = 2;
/// vbss_scene_set_thread_friction. Numbers: friction.
pub const VBSS_SCENE_SETTING_THREAD_FRICTION: vbss_scene_setting = 3;
/// vbss_scene_set_coupling. Numbers: stiffness, damping, turning stiffness, turning damping.
pub const VBSS_SCENE_SETTING_COUPLING: vbss_scene_setting = 4;
/// vbss_scene_set_speed_limit. Numbers: limit.
pub const VBSS_SCENE_SETTING_SPEED_LIMIT: vbss_scene_setting = 5;
/// vbss_scene_set_filter. Words: category, mask.
pub const VBSS_SCENE_SETTING_FILTER: vbss_scene_setting = 6;
/// vbss_scene_apply_force. Words: 1 if at a point, 1 with a torque. Numbers: force (3), point
/// (3), torque (3).
pub const VBSS_SCENE_SETTING_FORCE: vbss_scene_setting = 7;
/// vbss_scene_set_rigid_velocity. Words: 1 if turned. Numbers: velocity (3), angular velocity
/// (3).
pub const VBSS_SCENE_SETTING_VELOCITY: vbss_scene_setting = 8;
/// vbss_scene_set_rigid_pose. Words: 1 if turned. Numbers: position (3), orientation (4).
pub const VBSS_SCENE_SETTING_POSE: vbss_scene_setting = 9;
/// vbss_scene_set_budgets. Numbers: step budget, call budget, operations per us.
pub const VBSS_SCENE_SETTING_BUDGETS: vbss_scene_setting = 10;

// The constants of vbss_record_event_kind that are no vbss_scene_event_kind.
/// TRUNCATED or PAUSED: 0, 0, and the share of the step that was left out, in 65536ths.
pub const VBSS_RECORD_EVENT_TIME_LOST: vbss_record_event_kind = 3;
/// Events of a step exceeded event_capacity: 0, 0, and the number of lost events.
pub const VBSS_RECORD_EVENT_LOST: vbss_record_event_kind = 4;

// The constants of vbss_replay_outcome.
/// The replay has not ended; all hashes so far agree.
pub const VBSS_REPLAY_OUTCOME_STEPPED: vbss_replay_outcome = 0;
/// The log has ended with its end record; all hashes agree.
pub const VBSS_REPLAY_OUTCOME_ENDED: vbss_replay_outcome = 1;
/// The state after `step` is not the recorded one.
pub const VBSS_REPLAY_OUTCOME_DIFFERS: vbss_replay_outcome = 2;
/// The call has failed: the log is truncated or damaged, or the scene refused a step.
pub const VBSS_REPLAY_OUTCOME_STOPPED: vbss_replay_outcome = 3;

/// Writes the log of one scene.
#[repr(C)]
pub struct vbss_record {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Reads a log.
#[repr(C)]
pub struct vbss_replay {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a record. Fill it with vbss_record_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_record_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Number of steps between hashes of the state, 1 to 1e9; default 1.
    pub hash_interval: u32,
    /// Largest number of inputs before a step, 0 to 65536; default 64.
    pub input_capacity: u32,
    /// Size of the note, at most 2^24; default 0.
    pub note_bytes: u32,
    /// Size of the buffer for bytes that the host has not taken yet, without the beginning of the
    /// log, bytes, 4096 to 2^30; default 2^20. A step is coded in at most 274 bytes when two rigid
    /// bodies move, and 332 when two graspers move and open. Smooth movements take about a tenth of
    /// that in the log.
    pub buffer_bytes: u64,
    /// Data of the host that the log stores, such as a description of its scene; default NULL,
    /// allowed when note_bytes is 0. The library copies it.
    pub note: *const c_void,
    /// Number of steps between snapshots of the scene in the log, 0 to 1e9; default 2000. With 0
    /// there is only the first snapshot. vbss_replay_seek starts from snapshots. A snapshot that
    /// does not fit in the buffer is written after a later step.
    pub snapshot_interval: u32,
    /// Zero.
    pub reserved: u32,
}

/// One input of the host.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_record_input {
    /// Kind of the input.
    pub kind: vbss_record_input_kind,
    /// Number of valid entries in `words`.
    pub word_count: u32,
    /// Number of valid entries in `numbers`.
    pub number_count: u32,
    /// Zero.
    pub reserved: u32,
    /// Words; vbss_record_input_kind lists their meanings.
    pub words: [u32; 4],
    /// Numbers; vbss_record_input_kind lists their meanings.
    pub numbers: [f64; 12],
}

/// A step as the log describes it.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_replay_logged_step {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// 1: `hash` is valid.
    pub hashed: u32,
    /// Number of the step, from 1 on.
    pub number: u64,
    /// Hash of the scene after the step; 0 if it was not hashed.
    pub hash: u64,
    /// Byte of the log just after this step.
    pub position: u64,
    /// Length of the step, s.
    pub h: f64,
    /// Sum of the lengths of the steps up to this one, s: the clock of the hands.
    pub time: f64,
    /// Inputs before the step, in their order.
    pub inputs: *const vbss_record_input,
    /// x 4: the events of the step, as vbss_record_event_kind describes them.
    pub events: *const u32,
    /// Number of inputs.
    pub input_count: u32,
    /// Number of events; each has four words.
    pub event_count: u32,
    /// Part of `h` that the scene has left out, s, by its VBSS_RECORD_EVENT_TIME_LOST events. Each is up to
    /// h / 65536 too small. A step may report the time of an earlier paused step.
    pub time_lost: f64,
}

/// Contents and faults of a log. The counts cover its good part, before the first fault.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_record_log_report {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// VBSS_OK, or the result of the first fault; VBSS_ERROR_TRUNCATED when the log is truncated.
    pub result: vbss_result,
    /// 1: the log has its end record.
    pub ended: u32,
    /// Number of faults. The arrays below hold the first eight.
    pub fault_count: u32,
    /// Size of the log.
    pub log_bytes: u64,
    /// Size of its good part, which can be replayed.
    pub good_bytes: u64,
    /// Number of complete steps.
    pub steps: u64,
    /// Number of inputs before these steps.
    pub inputs: u64,
    /// Number of events in these steps.
    pub events: u64,
    /// Number of snapshots, the first one included.
    pub snapshots: u64,
    /// Sum of the lengths of these steps, s: the clock of the hands.
    pub time: f64,
    /// Positions of the faults, as bytes of the log.
    pub fault_positions: [u64; 8],
    /// Descriptions of the faults, constant English strings.
    pub fault_problems: [*const c_char; 8],
    /// VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or VBSS_ERROR_DATA_VERSION.
    pub fault_results: [vbss_result; 8],
    /// Part of `time` that the scene has left out, s; see vbss_replay_logged_step.time_lost.
    pub time_lost: f64,
}

/// General information on a log.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_replay_info {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Version of the library that wrote the log, as VBSS_VERSION_NUM.
    pub library_version: u32,
    /// Number of steps between hashes.
    pub hash_interval: u32,
    /// Size of the note.
    pub note_bytes: u32,
    /// Size of the first snapshot, unpacked.
    pub snapshot_bytes: u64,
    /// Size of the log, truncated and damaged parts included.
    pub log_bytes: u64,
    /// Build information of the library that wrote the log; valid as long as the replay lives.
    pub build_info: *const c_char,
    /// The host's note; never NULL; valid as long as the replay lives.
    pub note: *const c_void,
}

/// Position and outcome of a replay.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_replay_report {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Outcome so far.
    pub outcome: vbss_replay_outcome,
    /// Number of the last step that was made, from 1 on; 0: no step.
    pub step: u64,
    /// Number of the last step whose recorded hash agrees; 0: only the initial state agrees. The
    /// first step that differs comes after this one, and not after `step`.
    pub agreed_step: u64,
    /// Recorded hash after `step`; 0 if none was recorded.
    pub recorded_hash: u64,
    /// Hash of the replayed scene after `step`; 0 if none was recorded.
    pub found_hash: u64,
    /// Byte of the log at which the next record begins.
    pub position: u64,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_record_config_init(config: *mut vbss_record_config, struct_size: u32) -> vbss_result;
    /// Begins the log of a scene with the version of the library, the scene's configuration and a
    /// snapshot of its state. The call allocates all memory that steps need.
    ///
    /// @param scene        the scene; after it is destroyed, only vbss_record_take and
    /// vbss_record_destroy are useful
    /// @param config   configuration; NULL for the defaults
    /// @param record  the new record; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_CAPACITY (a snapshot of 3 GiB),
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_record_create(scene: *mut vbss_scene, config: *const vbss_record_config, record: *mut *mut vbss_record) -> vbss_result;
    /// Destroys a record. Bytes that were not taken are lost; a log without an end record counts as
    /// truncated.
    ///
    /// @param record  the record; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_record_destroy(record: *mut vbss_record) -> vbss_result;
    /// Continues a log, complete or truncated. The call brings the scene of the replay to the last
    /// complete step, as vbss_replay_seek does, and creates a record that appends to the log. The host
    /// first truncates its file at `position`. A damaged log is refused. To continue its good part
    /// (vbss_record_check_log), open a replay of that part alone.
    ///
    /// @param replay         a replay that has begun; the record does not log its later steps
    /// @param config         configuration; NULL for the defaults. Only buffer_bytes and
    /// snapshot_interval are used; the log determines the rest.
    /// @param record    the new record; NULL when the call fails. It has no bytes to take yet.
    /// @param position  byte of the log at which the host appends the bytes that it takes
    /// @return VBSS_OK, VBSS_ERROR_CORRUPT (also: the steps differ from the recorded ones),
    /// VBSS_ERROR_DATA_VERSION (also: another version of the library began the log),
    /// VBSS_ERROR_CAPACITY (the scene keeps more events than the recorded one),
    /// VBSS_ERROR_WRONG_STATE (the replay has not begun), or a result of vbss_replay_step,
    /// vbss_scene_restore or vbss_record_create
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_record_resume(replay: *mut vbss_replay, config: *const vbss_record_config, record: *mut *mut vbss_record, position: *mut u64) -> vbss_result;
    /// Returns the bytes that were added to the log since the last call, for the host to store or send.
    /// They form complete steps.
    ///
    /// @param record      the record
    /// @param bytes  the bytes, valid until the next call that records something; never NULL
    /// @param count  number of bytes; 0 when there are no new ones
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_record_take(record: *mut vbss_record, bytes: *mut *const u8, count: *mut u64) -> vbss_result;
    /// Attaches a record to its scene. From then on the record logs every edit of the scene and of bodies in
    /// it, and every step, whatever function makes them. An edit belongs to the step that follows; one that
    /// fails is not logged. A scene has at most one record attached; another one takes its place.
    ///
    /// Adding a body, vbss_scene_restore, vbss_thread_set_state and vbss_drain_set_state have no input of
    /// their own: the log receives a snapshot of the scene after them, for which they may allocate memory. A
    /// replay follows them in a scene of vbss_replay_load_scene.
    ///
    /// An edit or step of the scene then has further errors, and changes nothing with them.
    /// VBSS_ERROR_CAPACITY: input_capacity is exhausted, or the buffer has no room for the step, until
    /// vbss_record_take. VBSS_ERROR_WRONG_STATE: the scene was changed while the record was not attached.
    /// VBSS_ERROR_OUT_OF_MEMORY: there is no memory for the snapshot. vbss_record_end and
    /// vbss_record_destroy detach the record.
    ///
    /// @param scene   the scene
    /// @param record  a record of this scene that knows its state: no edit came between its creation or
    /// its last step and this call. NULL detaches.
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: a record of another context),
    /// VBSS_ERROR_INCOMPATIBLE (a record of another scene), VBSS_ERROR_WRONG_STATE (one that has
    /// ended, or that does not know the state) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_scene_set_recorder(scene: *mut vbss_scene, record: *mut vbss_record) -> vbss_result;
    /// Applies an input to the recorded scene and logs it, whether the record is attached or not. For inputs
    /// that come from another log (vbss_replay_read).
    ///
    /// @param record   the record
    /// @param input    the input; `word_count` and `number_count` are not used
    /// @param id  identifier of a new pin or attachment, or number of a new piece; may be NULL
    /// @return a result of the function of the input, as a scene with this record attached returns it;
    /// VBSS_ERROR_INVALID_HANDLE (also: the scene was destroyed), VBSS_ERROR_NULL_ARGUMENT,
    /// VBSS_ERROR_OUT_OF_RANGE (also: a kind or a setting that does not exist),
    /// VBSS_ERROR_NOT_FINITE (any number of the input), VBSS_ERROR_WRONG_STATE (as
    /// vbss_scene_set_recorder), VBSS_ERROR_CAPACITY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_record_apply_input(record: *mut vbss_record, input: *const vbss_record_input, id: *mut u32) -> vbss_result;
    /// Ends the log; the end record always fits in the buffer. With inputs since the last step the log
    /// ends without them and without a last hash. Afterwards only vbss_record_take and
    /// vbss_record_destroy succeed.
    ///
    /// @param record  the record
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_WRONG_STATE (it has ended before) or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_record_end(record: *mut vbss_record) -> vbss_result;
    /// Opens a log and checks its beginning. The rest is checked when it is read.
    ///
    /// @param context      owner
    /// @param bytes        the log; it must stay valid and unchanged while the replay lives
    /// @param count        its size
    /// @param replay  the new replay; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED (the
    /// beginning is incomplete), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY; error texts name the byte
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_create(context: *mut vbss_context, bytes: *const u8, count: u64, replay: *mut *mut vbss_replay) -> vbss_result;
    /// Destroys a replay; the host keeps the scene.
    ///
    /// @param replay  the replay; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_destroy(replay: *mut vbss_replay) -> vbss_result;
    /// Returns general information on the log.
    ///
    /// @param replay       the replay
    /// @param info        receives the information
    /// @param struct_size  `sizeof *info` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_get_info(replay: *mut vbss_replay, info: *mut vbss_replay_info, struct_size: u32) -> vbss_result;
    /// Returns the configuration of the recorded scene, with which the host can create an equal one. Its
    /// pointers to the parameters of the baseline and to the options of the solver are valid as long as
    /// the replay lives. A log of an older library has budgets in operations: the returned options give the
    /// same operations at the default of 500 per us.
    ///
    /// @param replay          the replay
    /// @param\[in,out\] config an initialised configuration; the call sets every field
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_get_scene_config(replay: *mut vbss_replay, config: *mut vbss_scene_config) -> vbss_result;
    /// Reads a log to its end without a scene.
    ///
    /// @param replay      the replay; its position does not change
    /// @param steps  number of complete steps, also when the call fails because of later bytes
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED (the
    /// log has no end), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_ARITHMETIC_MODE
    /// or VBSS_ERROR_BUSY; error texts name the byte
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_check(replay: *mut vbss_replay, steps: *mut u64) -> vbss_result;
    /// Restores the initial state of the record in a scene and moves the replay to before its first
    /// step. A replay can begin more than once. On failure the scene is unchanged.
    ///
    /// @param replay  the replay
    /// @param scene   a scene of the same context with the configuration of the recorded one and equal
    /// bodies added in the same order; capacities may differ, except those of pins and grasps
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE (also: the scene is of another context),
    /// VBSS_ERROR_CORRUPT (another scene; the error text names the field), VBSS_ERROR_CAPACITY,
    /// VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_begin(replay: *mut vbss_replay, scene: *mut vbss_scene) -> vbss_result;
    /// Creates the recorded scene from the first snapshot of the log, as vbss_scene_load does, and begins
    /// the replay in it. The host destroys the scene, after the replay or before.
    ///
    /// @param replay      the replay
    /// @param scene  the new scene; NULL when the call fails
    /// @return as vbss_scene_load and vbss_replay_begin; VBSS_ERROR_DATA_VERSION for a log of an older
    /// library, whose snapshots do not describe their scene
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_load_scene(replay: *mut vbss_replay, scene: *mut *mut vbss_scene) -> vbss_result;
    /// Replays the next step: applies its inputs, steps the scene and compares the hash. The call
    /// allocates nothing. After the end, a difference or a failure, further calls do nothing and return
    /// the same result until vbss_replay_begin.
    ///
    /// @param replay       the replay, which has begun
    /// @param report  receives the report, also when the log cannot be read or the scene refuses
    /// the step
    /// @param struct_size  `sizeof *report` as the caller was compiled
    /// @return VBSS_OK, also for a step that differs and for the end; VBSS_ERROR_TRUNCATED (all complete
    /// steps were replayed, the end is missing), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION,
    /// with texts that name the byte; any error of an input or of vbss_scene_step;
    /// VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_WRONG_STATE (it has not begun) or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_step(replay: *mut vbss_replay, report: *mut vbss_replay_report, struct_size: u32) -> vbss_result;
    /// Moves the replay and its scene to just after a step: restores the newest snapshot at or before
    /// it, replays the steps that follow and compares their hashes. vbss_replay_step then continues
    /// with the same bits as without the seek. When the log does not have the step, scene and replay are
    /// unchanged.
    ///
    /// @param replay       the replay, which has begun
    /// @param step         number of the step; 0: the initial state
    /// @param report  receives the report, as in vbss_replay_step
    /// @param struct_size  `sizeof *report` as the caller was compiled
    /// @return as vbss_replay_step and vbss_scene_restore; VBSS_ERROR_NOT_FOUND if the log ends before
    /// the step
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_seek(replay: *mut vbss_replay, step: u64, report: *mut vbss_replay_report, struct_size: u32) -> vbss_result;
    /// Reads a step from the log without a scene; the position of the replay does not change. Reading
    /// steps in ascending order is fast. To read an earlier step, the call reads the log from its
    /// beginning.
    ///
    /// @param replay       the replay
    /// @param number       number of the step, from 1 on
    /// @param step    receives the step; its arrays are valid until the next call for this replay
    /// @param struct_size  `sizeof *step` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NOT_FOUND (the log ends before it), VBSS_ERROR_TRUNCATED (the log
    /// is truncated before it), VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION,
    /// VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_replay_read(replay: *mut vbss_replay, number: u64, step: *mut vbss_replay_logged_step, struct_size: u32) -> vbss_result;
    /// Checks a whole log, which may be any bytes, and reports its contents, its faults and their
    /// positions. After a fault the check continues at the next record that can be found.
    ///
    /// @param context      context whose allocator supplies temporary memory
    /// @param bytes        the log
    /// @param count        its size
    /// @param report  receives the report
    /// @param struct_size  `sizeof *report` as the caller was compiled
    /// @return VBSS_OK, whatever faults the log has; VBSS_ERROR_INVALID_HANDLE,
    /// VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE, VBSS_ERROR_CORRUPT (the log states a
    /// size larger than any memory), VBSS_ERROR_OUT_OF_MEMORY, VBSS_ERROR_ARITHMETIC_MODE or
    /// VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_record_check_log(context: *mut vbss_context, bytes: *const u8, count: u64, report: *mut vbss_record_log_report, struct_size: u32) -> vbss_result;
}
