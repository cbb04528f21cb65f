"""record.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_uint8, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Result, vbss_context
from .scene import vbss_scene, vbss_scene_config


class RecordInputKind(IntEnum):
    """The constants of vbss_record_input_kind, with their words and their numbers. The log format
    uses the same constants."""
    RIGID_TARGET = 1
    """Words: body, 1 if turned. Numbers: position (3), orientation (4)."""
    PIN = 2
    """Words: thread, node, body, 1 if at a point. Numbers: point (3)."""
    UNPIN = 3
    """Words: pin."""
    ATTACH = 4
    """Words: thread, kind, node. Numbers: position (3), direction (3), force (3), stiffness,
    damping, mass."""
    ATTACHMENT_TARGET = 5
    """Words: thread, attachment, 1 if directed. Numbers: target (3), direction (3)."""
    DETACH = 6
    """Words: thread, attachment."""
    CUT = 7
    """Words: thread. Numbers: arc length."""
    GRASPER_TARGET = 8
    """Words: grasper, 1 if turned. Numbers: position (3), orientation (4)."""
    SET_OPENING = 9
    """Words: grasper. Numbers: opening."""
    EXCHANGE = 10
    """Words: grasper, kind."""
    SETTING = 11
    """A change of scene_settings.h. Words: vbss_scene_setting, body (0 where the setting has
    none), and two words of the setting. Numbers: those of the setting."""
    HOLE = 12
    """vbss_scene_make_hole. Words: body, drain, triangle. Numbers: arc length, weights (3)."""
    REMOVE = 13
    """vbss_scene_remove. Words: body."""
    DRAIN_ATTACH = 14
    """vbss_drain_attach. Words: drain, kind, node. Numbers: position (3), force (3), stiffness."""
    DRAIN_TARGET = 15
    """vbss_drain_set_attachment_target. Words: drain, attachment. Numbers: target (3)."""
    DRAIN_DETACH = 16
    """vbss_drain_detach. Words: drain, attachment."""
    ROLL = 17
    """vbss_thread_set_roll. Words: thread, attachment. Numbers: roll."""


class SceneSetting(IntEnum):
    """The constants of vbss_scene_setting: functions of scene_settings.h, with the third and
    fourth word of an input, if it has any, and its numbers."""
    GRAVITY = 1
    """vbss_scene_set_gravity. Numbers: gravity (3)."""
    FRICTION = 2
    """vbss_scene_set_friction. Numbers: friction."""
    THREAD_FRICTION = 3
    """vbss_scene_set_thread_friction. Numbers: friction."""
    COUPLING = 4
    """vbss_scene_set_coupling. Numbers: stiffness, damping, turning stiffness, turning damping."""
    SPEED_LIMIT = 5
    """vbss_scene_set_speed_limit. Numbers: limit."""
    FILTER = 6
    """vbss_scene_set_filter. Words: category, mask."""
    FORCE = 7
    """vbss_scene_apply_force. Words: 1 if at a point, 1 with a torque. Numbers: force (3), point
    (3), torque (3)."""
    VELOCITY = 8
    """vbss_scene_set_rigid_velocity. Words: 1 if turned. Numbers: velocity (3), angular velocity
    (3)."""
    POSE = 9
    """vbss_scene_set_rigid_pose. Words: 1 if turned. Numbers: position (3), orientation (4)."""
    BUDGETS = 10
    """vbss_scene_set_budgets. Numbers: step budget, call budget, operations per us."""


class RecordEventKind(IntEnum):
    """The constants of vbss_record_event_kind that are no vbss_scene_event_kind."""
    TIME_LOST = 3
    """TRUNCATED or PAUSED: 0, 0, and the share of the step that was left out, in 65536ths."""
    LOST = 4
    """Events of a step exceeded event_capacity: 0, 0, and the number of lost events."""


class ReplayOutcome(IntEnum):
    """The constants of vbss_replay_outcome."""
    STEPPED = 0
    """The replay has not ended; all hashes so far agree."""
    ENDED = 1
    """The log has ended with its end record; all hashes agree."""
    DIFFERS = 2
    """The state after `step` is not the recorded one."""
    STOPPED = 3
    """The call has failed: the log is truncated or damaged, or the scene refused a step."""


class vbss_record(ctypes.Structure):
    """Writes the log of one scene."""


class vbss_replay(ctypes.Structure):
    """Reads a log."""


class vbss_record_config(ctypes.Structure):
    """Configuration of a record. Fill it with vbss_record_config_init, then change fields.

    hash_interval: Number of steps between hashes of the state, 1 to 1e9; default 1.

    input_capacity: Largest number of inputs before a step, 0 to 65536; default 64.

    note_bytes: Size of the note, at most 2^24; default 0.

    buffer_bytes: Size of the buffer for bytes that the host has not taken yet, without the
    beginning of the log, bytes, 4096 to 2^30; default 2^20. A step is coded in at most 274
    bytes when two rigid bodies move, and 332 when two graspers move and open. Smooth movements
    take about a tenth of that in the log.

    note: Data of the host that the log stores, such as a description of its scene; default
    NULL, allowed when note_bytes is 0. The library copies it.

    snapshot_interval: Number of steps between snapshots of the scene in the log, 0 to 1e9;
    default 2000. With 0 there is only the first snapshot. vbss_replay_seek starts from
    snapshots. A snapshot that does not fit in the buffer is written after a later step."""
    struct_size: int
    hash_interval: int
    input_capacity: int
    note_bytes: int
    buffer_bytes: int
    note: Any
    snapshot_interval: int
    reserved: int
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("hash_interval", c_uint32),
        ("input_capacity", c_uint32),
        ("note_bytes", c_uint32),
        ("buffer_bytes", c_uint64),
        ("note", c_void_p),
        ("snapshot_interval", c_uint32),
        ("reserved", c_uint32),
    ]


class vbss_record_input(ctypes.Structure):
    """One input of the host.

    kind: Kind of the input.

    word_count: Number of valid entries in `words`.

    number_count: Number of valid entries in `numbers`.

    words: Words; vbss_record_input_kind lists their meanings.

    numbers: Numbers; vbss_record_input_kind lists their meanings."""
    kind: int
    word_count: int
    number_count: int
    reserved: int
    words: Any
    numbers: Any
    _kinds_: ClassVar[dict[str, Any]] = {"kind": RecordInputKind}
    _fields_ = [
        ("kind", c_int32),
        ("word_count", c_uint32),
        ("number_count", c_uint32),
        ("reserved", c_uint32),
        ("words", c_uint32 * 4),
        ("numbers", c_double * 12),
    ]


class vbss_replay_logged_step(ctypes.Structure):
    """A step as the log describes it.

    hashed: 1: `hash` is valid.

    number: Number of the step, from 1 on.

    hash: Hash of the scene after the step; 0 if it was not hashed.

    position: Byte of the log just after this step.

    h: Length of the step, s.

    time: Sum of the lengths of the steps up to this one, s: the clock of the hands.

    inputs: Inputs before the step, in their order.

    events: x 4: the events of the step, as vbss_record_event_kind describes them.

    input_count: Number of inputs.

    event_count: Number of events; each has four words.

    time_lost: Part of `h` that the scene has left out, s, by its VBSS_RECORD_EVENT_TIME_LOST
    events. Each is up to h / 65536 too small. A step may report the time of an earlier paused
    step."""
    struct_size: int
    hashed: int
    number: int
    hash: int
    position: int
    h: float
    time: float
    inputs: Any
    events: Any
    input_count: int
    event_count: int
    time_lost: float
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("hashed", c_uint32),
        ("number", c_uint64),
        ("hash", c_uint64),
        ("position", c_uint64),
        ("h", c_double),
        ("time", c_double),
        ("inputs", POINTER(vbss_record_input)),
        ("events", POINTER(c_uint32)),
        ("input_count", c_uint32),
        ("event_count", c_uint32),
        ("time_lost", c_double),
    ]


class ReplayLoggedStep(NamedTuple):
    """A step as the log describes it. Fields as vbss_replay_logged_step says."""
    hashed: int
    number: int
    hash: int
    position: int
    h: float
    time: float
    inputs: Any
    events: Any
    input_count: int
    event_count: int
    time_lost: float


class vbss_record_log_report(ctypes.Structure):
    """Contents and faults of a log. The counts cover its good part, before the first fault.

    result: VBSS_OK, or the result of the first fault; VBSS_ERROR_TRUNCATED when the log is
    truncated.

    ended: 1: the log has its end record.

    fault_count: Number of faults. The arrays below hold the first eight.

    log_bytes: Size of the log.

    good_bytes: Size of its good part, which can be replayed.

    steps: Number of complete steps.

    inputs: Number of inputs before these steps.

    events: Number of events in these steps.

    snapshots: Number of snapshots, the first one included.

    time: Sum of the lengths of these steps, s: the clock of the hands.

    fault_positions: Positions of the faults, as bytes of the log.

    fault_problems: Descriptions of the faults, constant English strings.

    fault_results: VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or VBSS_ERROR_DATA_VERSION.

    time_lost: Part of `time` that the scene has left out, s; see
    vbss_replay_logged_step.time_lost."""
    struct_size: int
    result: int
    ended: int
    fault_count: int
    log_bytes: int
    good_bytes: int
    steps: int
    inputs: int
    events: int
    snapshots: int
    time: float
    fault_positions: Any
    fault_problems: Any
    fault_results: Any
    time_lost: float
    _kinds_: ClassVar[dict[str, Any]] = {"result": Result}
    _fields_ = [
        ("struct_size", c_uint32),
        ("result", c_int32),
        ("ended", c_uint32),
        ("fault_count", c_uint32),
        ("log_bytes", c_uint64),
        ("good_bytes", c_uint64),
        ("steps", c_uint64),
        ("inputs", c_uint64),
        ("events", c_uint64),
        ("snapshots", c_uint64),
        ("time", c_double),
        ("fault_positions", c_uint64 * 8),
        ("fault_problems", c_char_p * 8),
        ("fault_results", c_int32 * 8),
        ("time_lost", c_double),
    ]


class RecordLogReport(NamedTuple):
    """Contents and faults of a log. The counts cover its good part, before the first fault. Fields
    as vbss_record_log_report says."""
    result: Result
    ended: int
    fault_count: int
    log_bytes: int
    good_bytes: int
    steps: int
    inputs: int
    events: int
    snapshots: int
    time: float
    fault_positions: tuple[int, ...]
    fault_problems: Any
    fault_results: tuple[int, ...]
    time_lost: float


class vbss_replay_info(ctypes.Structure):
    """General information on a log.

    library_version: Version of the library that wrote the log, as VBSS_VERSION_NUM.

    hash_interval: Number of steps between hashes.

    note_bytes: Size of the note.

    snapshot_bytes: Size of the first snapshot, unpacked.

    log_bytes: Size of the log, truncated and damaged parts included.

    build_info: Build information of the library that wrote the log; valid as long as the replay
    lives.

    note: The host's note; never NULL; valid as long as the replay lives."""
    struct_size: int
    library_version: int
    hash_interval: int
    note_bytes: int
    snapshot_bytes: int
    log_bytes: int
    build_info: Any
    note: Any
    _kinds_: ClassVar[dict[str, Any]] = {}
    _fields_ = [
        ("struct_size", c_uint32),
        ("library_version", c_uint32),
        ("hash_interval", c_uint32),
        ("note_bytes", c_uint32),
        ("snapshot_bytes", c_uint64),
        ("log_bytes", c_uint64),
        ("build_info", c_char_p),
        ("note", c_void_p),
    ]


class ReplayInfo(NamedTuple):
    """General information on a log. Fields as vbss_replay_info says."""
    library_version: int
    hash_interval: int
    note_bytes: int
    snapshot_bytes: int
    log_bytes: int
    build_info: str
    note: Any


class vbss_replay_report(ctypes.Structure):
    """Position and outcome of a replay.

    outcome: Outcome so far.

    step: Number of the last step that was made, from 1 on; 0: no step.

    agreed_step: Number of the last step whose recorded hash agrees; 0: only the initial state
    agrees. The first step that differs comes after this one, and not after `step`.

    recorded_hash: Recorded hash after `step`; 0 if none was recorded.

    found_hash: Hash of the replayed scene after `step`; 0 if none was recorded.

    position: Byte of the log at which the next record begins."""
    struct_size: int
    outcome: int
    step: int
    agreed_step: int
    recorded_hash: int
    found_hash: int
    position: int
    _kinds_: ClassVar[dict[str, Any]] = {"outcome": ReplayOutcome}
    _fields_ = [
        ("struct_size", c_uint32),
        ("outcome", c_int32),
        ("step", c_uint64),
        ("agreed_step", c_uint64),
        ("recorded_hash", c_uint64),
        ("found_hash", c_uint64),
        ("position", c_uint64),
    ]


class ReplayReport(NamedTuple):
    """Position and outcome of a replay. Fields as vbss_replay_report says."""
    outcome: ReplayOutcome
    step: int
    agreed_step: int
    recorded_hash: int
    found_hash: int
    position: int


FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "vbss_record_config_init": (c_int32, (POINTER(vbss_record_config), c_uint32)),
    "vbss_record_create": (c_int32, (POINTER(vbss_scene), POINTER(vbss_record_config),
        POINTER(POINTER(vbss_record)))),
    "vbss_record_destroy": (c_int32, (POINTER(vbss_record),)),
    "vbss_record_resume": (c_int32, (POINTER(vbss_replay), POINTER(vbss_record_config),
        POINTER(POINTER(vbss_record)), POINTER(c_uint64))),
    "vbss_record_take": (c_int32, (POINTER(vbss_record), POINTER(POINTER(c_uint8)),
        POINTER(c_uint64))),
    "vbss_scene_set_recorder": (c_int32, (POINTER(vbss_scene), POINTER(vbss_record))),
    "vbss_record_apply_input": (c_int32, (POINTER(vbss_record), POINTER(vbss_record_input),
        POINTER(c_uint32))),
    "vbss_record_end": (c_int32, (POINTER(vbss_record),)),
    "vbss_replay_create": (c_int32, (POINTER(vbss_context), POINTER(c_uint8), c_uint64,
        POINTER(POINTER(vbss_replay)))),
    "vbss_replay_destroy": (c_int32, (POINTER(vbss_replay),)),
    "vbss_replay_get_info": (c_int32, (POINTER(vbss_replay), POINTER(vbss_replay_info), c_uint32)),
    "vbss_replay_get_scene_config": (c_int32, (POINTER(vbss_replay), POINTER(vbss_scene_config))),
    "vbss_replay_check": (c_int32, (POINTER(vbss_replay), POINTER(c_uint64))),
    "vbss_replay_begin": (c_int32, (POINTER(vbss_replay), POINTER(vbss_scene))),
    "vbss_replay_load_scene": (c_int32, (POINTER(vbss_replay), POINTER(POINTER(vbss_scene)))),
    "vbss_replay_step": (c_int32, (POINTER(vbss_replay), POINTER(vbss_replay_report), c_uint32)),
    "vbss_replay_seek": (c_int32, (POINTER(vbss_replay), c_uint64, POINTER(vbss_replay_report),
        c_uint32)),
    "vbss_replay_read": (c_int32, (POINTER(vbss_replay), c_uint64, POINTER(vbss_replay_logged_step),
        c_uint32)),
    "vbss_record_check_log": (c_int32, (POINTER(vbss_context), POINTER(c_uint8), c_uint64,
        POINTER(vbss_record_log_report), c_uint32)),
}
