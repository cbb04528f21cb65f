"""record.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""
from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_uint32, c_uint64, c_uint8, c_void_p
from enum import IntEnum
from typing import Any, ClassVar, NamedTuple

from .base import Result, vbss_context
from .scene import vbss_scene, vbss_scene_config
from .thread import vbss_thread_attachment


class InputKind(IntEnum):
    """The constants of vbss_input_kind, with the words and numbers of each. They are numbers of
    the format."""
    MOVE_RIGID = 1
    """Body, whether turned; position 3, orientation 4."""
    PIN = 2
    """Thread, node, body, whether at a point; point 3."""
    UNPIN = 3
    """Pin."""
    ATTACH = 4
    """Thread, kind, node; position 3, direction 3, force 3, stiffness, damping, mass."""
    MOVE = 5
    """Thread, attachment, whether directed; target 3, direction 3."""
    DETACH = 6
    """Thread, attachment."""
    CUT = 7
    """Thread; arc length."""
    MOVE_GRASPER = 8
    """Grasper, whether turned; position 3, orientation 4."""
    SET_OPENING = 9
    """Grasper; opening."""
    EXCHANGE = 10
    """Grasper, kind."""


class ReplayOutcome(IntEnum):
    """The constants of vbss_replay_outcome."""
    STEPPED = 0
    """On its way; all hashes so far agree."""
    ENDED = 1
    """The log has ended as it should; all hashes agree."""
    DIFFERS = 2
    """The state after `step` is not the recorded one."""
    STOPPED = 3
    """The call has failed: the log is cut off or damaged, or a step is refused."""


class vbss_record(ctypes.Structure):
    """Writes the log of one scene."""


class vbss_replay(ctypes.Structure):
    """Reads a log."""


class vbss_record_config(ctypes.Structure):
    """How to write a log. Fill it with vbss_record_config_init, then change what you need.

    hash_interval: The state is hashed every so many steps, 1 to 1e9; default 1.

    input_capacity: Most inputs before a step, 0 to 65536; default 64.

    note_bytes: Size of the note, at most 2^24; default 0.

    buffer_bytes: Room for what the host has not taken yet, beyond the begin of the log, in
    bytes, 4096 to 2^30; default 2^20. A step needs room for its largest form: 274 where two
    rigid bodies move, 332 where two graspers move and open. Smooth movements take about a tenth
    of that in the log.

    note: Anything the host wants to find in the log again, such as what its scene is made from;
    NULL (default) when note_bytes is 0. Copied.

    snapshot_interval: A snapshot of the scene is put in the log every so many steps, 0 to 1e9;
    0: only at the begin; default 2000. vbss_replay_seek goes on from them. One that finds no
    room in the buffer waits for a later step that has it."""
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


class vbss_log_input(ctypes.Structure):
    """One thing that a host has told a scene.

    kind: What.

    word_count: Of the words below.

    number_count: Of the numbers below.

    words: As vbss_input_kind says.

    numbers: The same."""
    kind: int
    word_count: int
    number_count: int
    reserved: int
    words: Any
    numbers: Any
    _kinds_: ClassVar[dict[str, Any]] = {"kind": InputKind}
    _fields_ = [
        ("kind", c_int32),
        ("word_count", c_uint32),
        ("number_count", c_uint32),
        ("reserved", c_uint32),
        ("words", c_uint32 * 4),
        ("numbers", c_double * 12),
    ]


class vbss_log_step(ctypes.Structure):
    """What a log says of a step.

    hashed: 1: the hash is there.

    number: From 1 on.

    hash: Of the scene after it; 0 if it was not hashed.

    position: Byte of the log at which what follows it begins.

    h: Its length, s.

    time: Sum of the lengths up to it, s: the clock of the hands.

    inputs: What was told before it, in that order.

    events: x 4, as in VBSS_SCENE_VIEW_EVENTS: what happened in it.

    input_count: Of inputs.

    event_count: Of events: four words each.

    time_lost: Part of `h` that the scene has left out, s, by VBSS_EVENT_CLAMPED. Each such
    event is up to h / 65536 too small. A paused step may be reported in a later one."""
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
        ("inputs", POINTER(vbss_log_input)),
        ("events", POINTER(c_uint32)),
        ("input_count", c_uint32),
        ("event_count", c_uint32),
        ("time_lost", c_double),
    ]


class LogStep(NamedTuple):
    """What a log says of a step. Fields as vbss_log_step says."""
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


class vbss_log_report(ctypes.Structure):
    """What is in a log, and what is wrong with it. The counts are those of its good part, before
    the first fault.

    result: VBSS_OK, or of the first fault; VBSS_ERROR_TRUNCATED: it is cut off.

    ended: 1: the end is there.

    fault_count: Of faults, of which the first eight are told below.

    log_bytes: Size of the log.

    good_bytes: Of its good part, which replays.

    steps: Complete ones.

    inputs: Told before them.

    events: In them.

    snapshots: With that at the begin.

    time: Sum of their lengths, s: the clock of the hands.

    fault_positions: Bytes of the log.

    fault_problems: Constant texts, in English.

    fault_results: VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or VBSS_ERROR_DATA_VERSION.

    time_lost: Part of `time` that the scene has left out, s: see vbss_log_step.time_lost."""
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


class LogReport(NamedTuple):
    """What is in a log, and what is wrong with it. The counts are those of its good part, before
    the first fault. Fields as vbss_log_report says."""
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
    """What a log says about itself.

    library_version: Of the library that wrote it, as VBSS_VERSION_NUM.

    hash_interval: As it was recorded.

    note_bytes: Size of the note.

    snapshot_bytes: Size of the snapshot it begins with, unpacked.

    log_bytes: Size of the log, what may be cut off or damaged included.

    build_info: Of the library that wrote it; lives as long as the replay.

    note: The host's note; never NULL; lives as long as the replay."""
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
    """What a log says about itself. Fields as vbss_replay_info says."""
    library_version: int
    hash_interval: int
    note_bytes: int
    snapshot_bytes: int
    log_bytes: int
    build_info: str
    note: Any


class vbss_replay_report(ctypes.Structure):
    """Where a replay is, and what it has found.

    outcome: How far it is.

    step: Number of the last step that was made, from 1 on; 0: none.

    agreed_step: Number of the last step whose hash was recorded and agrees; 0: only the begin
    does. The first step that differs comes after it and is `step` at the latest.

    recorded_hash: After `step`; 0 where none was recorded.

    found_hash: Of the scene that is replayed; 0 where none was recorded.

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
    """Where a replay is, and what it has found. Fields as vbss_replay_report says."""
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
    "vbss_record_move_rigid": (c_int32, (POINTER(vbss_record), c_uint32, POINTER(c_double),
        POINTER(c_double))),
    "vbss_record_move_grasper": (c_int32, (POINTER(vbss_record), c_uint32, POINTER(c_double),
        POINTER(c_double))),
    "vbss_record_set_opening": (c_int32, (POINTER(vbss_record), c_uint32, c_double)),
    "vbss_record_exchange": (c_int32, (POINTER(vbss_record), c_uint32, c_int32)),
    "vbss_record_pin_thread": (c_int32, (POINTER(vbss_record), c_uint32, c_uint32, c_uint32,
        POINTER(c_double), POINTER(c_uint32))),
    "vbss_record_unpin_thread": (c_int32, (POINTER(vbss_record), c_uint32)),
    "vbss_record_cut_thread": (c_int32, (POINTER(vbss_record), c_uint32, c_double,
        POINTER(c_uint32))),
    "vbss_record_attach": (c_int32, (POINTER(vbss_record), c_uint32,
        POINTER(vbss_thread_attachment), POINTER(c_uint32))),
    "vbss_record_move_attachment": (c_int32, (POINTER(vbss_record), c_uint32, c_uint32,
        POINTER(c_double), POINTER(c_double))),
    "vbss_record_detach": (c_int32, (POINTER(vbss_record), c_uint32, c_uint32)),
    "vbss_record_step": (c_int32, (POINTER(vbss_record), c_double)),
    "vbss_record_end": (c_int32, (POINTER(vbss_record),)),
    "vbss_replay_create": (c_int32, (POINTER(vbss_context), POINTER(c_uint8), c_uint64,
        POINTER(POINTER(vbss_replay)))),
    "vbss_replay_destroy": (c_int32, (POINTER(vbss_replay),)),
    "vbss_replay_get_info": (c_int32, (POINTER(vbss_replay), POINTER(vbss_replay_info), c_uint32)),
    "vbss_replay_get_scene_config": (c_int32, (POINTER(vbss_replay), POINTER(vbss_scene_config))),
    "vbss_replay_check": (c_int32, (POINTER(vbss_replay), POINTER(c_uint64))),
    "vbss_replay_begin": (c_int32, (POINTER(vbss_replay), POINTER(vbss_scene))),
    "vbss_replay_step": (c_int32, (POINTER(vbss_replay), POINTER(vbss_replay_report), c_uint32)),
    "vbss_replay_seek": (c_int32, (POINTER(vbss_replay), c_uint64, POINTER(vbss_replay_report),
        c_uint32)),
    "vbss_replay_read": (c_int32, (POINTER(vbss_replay), c_uint64, POINTER(vbss_log_step),
        c_uint32)),
    "vbss_log_check": (c_int32, (POINTER(vbss_context), POINTER(c_uint8), c_uint64,
        POINTER(vbss_log_report), c_uint32)),
}
