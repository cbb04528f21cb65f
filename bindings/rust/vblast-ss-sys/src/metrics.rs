// Written by bindings/rust/generate.py from the public headers: do not edit.
use std::os::raw::{c_char};
#[allow(unused_imports)]
use crate::*;


/// A tool: a VBSS_METRICS_TOOL_ constant.
pub type vbss_metrics_tool = i32;

/// Test whose verdict on tightness counts in the score: a VBSS_METRICS_TEST_ constant.
pub type vbss_metrics_tightness_test = i32;

/// Kind of an event: a VBSS_METRICS_EVENT_ constant.
pub type vbss_metrics_event_kind = i32;

/// Relation of a throw to the throw before: a VBSS_METRICS_RELATION_ constant.
pub type vbss_metrics_relation = i32;

/// Tightness of a knot in the points of FLS: a VBSS_METRICS_TIGHTNESS_ constant.
pub type vbss_metrics_tightness = i32;

/// Reason for a penalty: a VBSS_METRICS_PENALTY_ constant.
pub type vbss_metrics_penalty_kind = i32;

/// An array: a VBSS_METRICS_VIEW_ constant.
pub type vbss_metrics_field = i32;

// The constants of vbss_metrics_tool.
/// The left tool.
pub const VBSS_METRICS_TOOL_LEFT: vbss_metrics_tool = 0;
/// The right tool.
pub const VBSS_METRICS_TOOL_RIGHT: vbss_metrics_tool = 1;
/// No tool, or an unknown one; for events only.
pub const VBSS_METRICS_TOOL_NONE: vbss_metrics_tool = 2;

// The constants of vbss_metrics_tightness_test.
/// The knot bears a force for a time without slipping.
pub const VBSS_METRICS_TEST_PULL: vbss_metrics_tightness_test = 0;
/// The strain of both sides (Qi et al. 2017).
pub const VBSS_METRICS_TEST_STRAIN: vbss_metrics_tightness_test = 1;

// Bits for the parts of a sample.
/// The position of the left tool is valid.
pub const VBSS_METRICS_HAS_LEFT: u32 = 1;
/// The position of the right tool is valid.
pub const VBSS_METRICS_HAS_RIGHT: u32 = 2;
/// The force on the left tool is valid.
pub const VBSS_METRICS_HAS_LEFT_FORCE: u32 = 4;
/// The force on the right tool is valid.
pub const VBSS_METRICS_HAS_RIGHT_FORCE: u32 = 8;

// The constants of vbss_metrics_event_kind. Each says whether it can be undone. An event that is
// reported again replaces its predecessor.
/// The clock starts. Can be undone.
pub const VBSS_METRICS_EVENT_NEEDLE_APPEARS: vbss_metrics_event_kind = 1;
/// The phase `number` of the task begins.
pub const VBSS_METRICS_EVENT_PHASE: vbss_metrics_event_kind = 2;
/// The needle has passed through at mark `number` (0, 1), off by `angle` and `axial`. Undone:
/// the puncture was withdrawn and counts as an attempt.
pub const VBSS_METRICS_EVENT_PUNCTURE: vbss_metrics_event_kind = 3;
/// Tail `number` (0, 1) is `amount` m long. Can be undone.
pub const VBSS_METRICS_EVENT_TAIL: vbss_metrics_event_kind = 4;
/// Tail `number` (0, 1) was cut; `amount` m are left. Can be undone.
pub const VBSS_METRICS_EVENT_TAIL_CUT: vbss_metrics_event_kind = 5;
/// The slit gapes from `position` to `other`; its widest gap is `amount` m. Can be undone.
pub const VBSS_METRICS_EVENT_GAP: vbss_metrics_event_kind = 6;
/// Throw `number` (0 next to the tissue) is tied, with `wraps`, `handedness` and `relation`. A
/// repeated event corrects them. Undone: the throw was untied.
pub const VBSS_METRICS_EVENT_THROW: vbss_metrics_event_kind = 7;
/// `tool` took over the needle. Can be undone.
pub const VBSS_METRICS_EVENT_TRANSFER: vbss_metrics_event_kind = 8;
/// `tool` should have taken over the needle, and did not. Can be undone.
pub const VBSS_METRICS_EVENT_TRANSFER_MISSED: vbss_metrics_event_kind = 9;
/// The host's object `number` was dropped. Can be undone.
pub const VBSS_METRICS_EVENT_DROP: vbss_metrics_event_kind = 10;
/// A penalty that the host defines: `number` identifies it, and it costs `amount` points. Can
/// be undone.
pub const VBSS_METRICS_EVENT_HOST: vbss_metrics_event_kind = 11;
/// The drain was torn off. The score becomes zero. Can be undone.
pub const VBSS_METRICS_EVENT_AVULSED: vbss_metrics_event_kind = 12;
/// The thread broke, or was cut early. The score becomes zero. Can be undone.
pub const VBSS_METRICS_EVENT_BROKEN: vbss_metrics_event_kind = 13;
/// The trainee was assisted, by aid `number`. The score becomes zero. Can be undone.
pub const VBSS_METRICS_EVENT_ASSISTED: vbss_metrics_event_kind = 14;

// The constants of vbss_metrics_relation.
/// The relation is not known.
pub const VBSS_METRICS_RELATION_UNKNOWN: vbss_metrics_relation = 0;
/// There is no throw before.
pub const VBSS_METRICS_RELATION_FIRST: vbss_metrics_relation = 1;
/// The throw has the opposite handedness.
pub const VBSS_METRICS_RELATION_SQUARE: vbss_metrics_relation = 2;
/// The throw has the same handedness.
pub const VBSS_METRICS_RELATION_GRANNY: vbss_metrics_relation = 3;

// The constants of vbss_metrics_tightness.
/// The knot was not pulled, or the pull test is incomplete.
pub const VBSS_METRICS_TIGHTNESS_UNKNOWN: vbss_metrics_tightness = -1;
/// The knot holds.
pub const VBSS_METRICS_TIGHTNESS_TIGHT: vbss_metrics_tightness = 0;
/// The knot slips.
pub const VBSS_METRICS_TIGHTNESS_SLIPS: vbss_metrics_tightness = 10;
/// The knot comes apart.
pub const VBSS_METRICS_TIGHTNESS_UNTIED: vbss_metrics_tightness = 20;

// Bits of the flags of a report.
/// The needle has appeared.
pub const VBSS_METRICS_FLAG_STARTED: u32 = 1;
/// Both tails are cut, and the time has stopped.
pub const VBSS_METRICS_FLAG_STOPPED: u32 = 2;
/// The deviation from the first mark is known.
pub const VBSS_METRICS_FLAG_PUNCTURE_0: u32 = 4;
/// The deviation from the second mark is known.
pub const VBSS_METRICS_FLAG_PUNCTURE_1: u32 = 8;
/// The gap is known.
pub const VBSS_METRICS_FLAG_GAP: u32 = 16;
/// The length of the first tail is known.
pub const VBSS_METRICS_FLAG_TAIL_0: u32 = 32;
/// The length of the second tail is known.
pub const VBSS_METRICS_FLAG_TAIL_1: u32 = 64;
/// vbss_metrics_finish was called.
pub const VBSS_METRICS_FLAG_FINISHED: u32 = 128;
/// The drain was torn off.
pub const VBSS_METRICS_FLAG_AVULSED: u32 = 256;
/// The thread broke.
pub const VBSS_METRICS_FLAG_BROKEN: u32 = 512;
/// The time has run out.
pub const VBSS_METRICS_FLAG_TIMEOUT: u32 = 1024;
/// The score is that of a whole trial: stopped, with deviations, gap and tightness known, or
/// zero for good. Without this bit the score assumes that nothing more is found.
pub const VBSS_METRICS_FLAG_FINAL: u32 = 2048;
/// More than `lost_share` of the time is lost. Time and score include it and do not compare with those of other
/// trials.
pub const VBSS_METRICS_FLAG_TIME_LOST: u32 = 4096;
/// The trainee was assisted: there is no score.
pub const VBSS_METRICS_FLAG_ASSISTED: u32 = 8192;

// The constants of vbss_metrics_penalty_kind.
/// A puncture is off its mark by `measure` mm.
pub const VBSS_METRICS_PENALTY_DEVIATION: vbss_metrics_penalty_kind = 1;
/// The slit gapes by `measure` mm.
pub const VBSS_METRICS_PENALTY_GAP: vbss_metrics_penalty_kind = 2;
/// The knot slips (`measure` is 10) or is untied (20).
pub const VBSS_METRICS_PENALTY_TIGHTNESS: vbss_metrics_penalty_kind = 3;
/// `measure` throws are missing.
pub const VBSS_METRICS_PENALTY_THROWS: vbss_metrics_penalty_kind = 4;
/// A throw has the same handedness as the one before.
pub const VBSS_METRICS_PENALTY_GRANNY: vbss_metrics_penalty_kind = 5;
/// A puncture was withdrawn.
pub const VBSS_METRICS_PENALTY_ATTEMPT: vbss_metrics_penalty_kind = 6;
/// Something was dropped.
pub const VBSS_METRICS_PENALTY_DROP: vbss_metrics_penalty_kind = 7;
/// A needle transfer was missed.
pub const VBSS_METRICS_PENALTY_TRANSFER: vbss_metrics_penalty_kind = 8;
/// A penalty of the host of `measure` points.
pub const VBSS_METRICS_PENALTY_HOST: vbss_metrics_penalty_kind = 9;
/// The time has run out; it costs all remaining points.
pub const VBSS_METRICS_PENALTY_TIMEOUT: vbss_metrics_penalty_kind = 10;
/// The drain was torn off; it costs all remaining points.
pub const VBSS_METRICS_PENALTY_AVULSED: vbss_metrics_penalty_kind = 11;
/// The thread broke; it costs all remaining points.
pub const VBSS_METRICS_PENALTY_BROKEN: vbss_metrics_penalty_kind = 12;
/// The trial ended before both tails were cut; it costs all remaining points.
pub const VBSS_METRICS_PENALTY_INCOMPLETE: vbss_metrics_penalty_kind = 13;
/// More than `lost_share` of the time was lost; `measure` is the lost time, s. It costs no
/// points.
pub const VBSS_METRICS_PENALTY_TIME_LOST: vbss_metrics_penalty_kind = 14;
/// The trainee was assisted; it costs all remaining points.
pub const VBSS_METRICS_PENALTY_ASSISTED: vbss_metrics_penalty_kind = 15;

// The `phase` argument for the whole task.
/// From the needle's appearance until both tails were cut; without a needle, the whole
/// recording.
pub const VBSS_METRICS_PHASE_ALL: i32 = -1;

// Bits for the measures of motion that could be computed.
/// `ldj_length` and `ldj_speed` are valid.
pub const VBSS_METRICS_HAS_LDJ: u32 = 1;
/// `sparc` is valid: the motion lasts at most 40.96 s.
pub const VBSS_METRICS_HAS_SPARC: u32 = 2;
/// `movement_sparc` is valid.
pub const VBSS_METRICS_HAS_MOVEMENTS: u32 = 4;
/// `correlation` is valid.
pub const VBSS_METRICS_HAS_CORRELATION: u32 = 8;

// The constants of vbss_metrics_field. Row i belongs to the time of the first sample plus i / 100
// s.
/// x 1 double: speed of the left tool, m/s; 0 where it was not seen.
pub const VBSS_METRICS_VIEW_LEFT_SPEED: vbss_metrics_field = 0;
/// x 1 double: speed of the right tool, m/s; 0 where it was not seen.
pub const VBSS_METRICS_VIEW_RIGHT_SPEED: vbss_metrics_field = 1;
/// x 1 double: |jerk|^2 of the left tool, m^2/s^6; 0 where it was not seen for 0.25 s without a
/// gap.
pub const VBSS_METRICS_VIEW_LEFT_JERK: vbss_metrics_field = 2;
/// x 1 double: |jerk|^2 of the right tool, m^2/s^6; 0 where it was not seen for 0.25 s without
/// a gap.
pub const VBSS_METRICS_VIEW_RIGHT_JERK: vbss_metrics_field = 3;
/// x 1 double: largest |force| on the left tool in that hundredth of a second, N.
pub const VBSS_METRICS_VIEW_LEFT_FORCE: vbss_metrics_field = 4;
/// x 1 double: largest |force| on the right tool in that hundredth of a second, N.
pub const VBSS_METRICS_VIEW_RIGHT_FORCE: vbss_metrics_field = 5;

/// The measurement of one trial.
#[repr(C)]
pub struct vbss_metrics {
    _private: [u8; 0],
    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,
}

/// Configuration of a measurement. Fill it with vbss_metrics_config_init, then change fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_config {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// The test whose tightness counts in the score; default VBSS_METRICS_TEST_PULL. Both are always
    /// reported.
    pub tightness_test: vbss_metrics_tightness_test,
    /// Largest number of throw records, undone throws included, 1 to 4096; default 64.
    pub throw_capacity: u32,
    /// Largest number of phase visits, 1 to 65536; default 256.
    pub phase_capacity: u32,
    /// Largest number of transfers, attempts, drops and faults, 1 to 65536; default 256.
    pub incident_capacity: u32,
    /// Throws that the knot should have, 0 to 64; default 3.
    pub throws_wanted: u32,
    /// Longest motion that can be stored, s, 1 to 7200; default 600.
    pub duration: f64,
    /// Radius of the cylinder that carries the marks, m, 1e-4 to 1; default 6.5e-3.
    pub drain_radius: f64,
    /// Axial stiffness EA of the thread, N, 1e-3 to 1e9; default 427 (silk, 0.25 mm).
    pub stiffness: f64,
    /// Force of the pull test, N, 1e-3 to 1e3; default 2.
    pub pull_force: f64,
    /// Time that the knot must bear the pull, s, 0 to 1e3; default 1.
    pub pull_time: f64,
    /// Length of tail drawn in above which the knot slips, m, 1e-6 to 1; default 1e-3.
    pub slip_limit: f64,
    /// VBSS_METRICS_TEST_STRAIN: strain above which a knot is tight, 0 to 1; default 0, which means
    /// pull_force / stiffness.
    pub strain_threshold: f64,
    /// Speed below which a tool becomes idle, m/s, 0 to 1; default 5e-3.
    pub idle_speed: f64,
    /// Speed above which an idle tool moves again, m/s, idle_speed to 1; default 6e-3.
    pub idle_release: f64,
    /// Time from which the score is zero, s, 1e-3 to 1e6; default 600.
    pub max_time: f64,
    /// Points per mm of deviation from a mark, 0 to 1e6; default 10.
    pub weight_deviation: f64,
    /// Points per mm of gap, 0 to 1e6; default 10.
    pub weight_gap: f64,
    /// Points per point of tightness (0, 10, 20), 0 to 1e6; default 1.
    pub weight_tightness: f64,
    /// Points per missing throw, 0 to 1e6; default 0.
    pub weight_throw: f64,
    /// Points per throw that makes a granny, 0 to 1e6; default 0.
    pub weight_granny: f64,
    /// Points per puncture that was withdrawn, 0 to 1e6; default 0.
    pub weight_attempt: f64,
    /// Points per drop, 0 to 1e6; default 0.
    pub weight_drop: f64,
    /// Points per missed needle transfer, 0 to 1e6; default 0.
    pub weight_transfer: f64,
    /// Factor of the points of the host's penalties, 0 to 1e6; default 1.
    pub weight_host: f64,
    /// Largest speed of a hand, m/s, 0 to 1e6; default 2, for the upper limbs by ISO 13855. A
    /// sample that is farther from the last one than this speed allows, plus 1 mm for noise, is
    /// an outlier: see vbss_metrics_add_sample. With 0 no sample is an outlier.
    pub max_speed: f64,
    /// Share of lost time above which VBSS_METRICS_FLAG_TIME_LOST is set, 0 to 1; default 0.02. A
    /// trial shorter than 1 s counts as 1 s.
    pub lost_share: f64,
}

/// Positions of the tools and forces on them. Fill it with vbss_metrics_sample_init, then set the
/// known parts.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_sample {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// VBSS_METRICS_HAS_ bits; default 0.
    pub valid: u32,
    /// Step number of the simulator; it is only passed on.
    pub step: u64,
    /// Time of the sample, s, at most 1e9 in magnitude, after the last sample.
    pub time: f64,
    /// Positions of the left and the right tip, m, each coordinate at most 1e3 in magnitude.
    pub position: [[f64; 3]; 2],
    /// Forces on the left and the right tool, N, each component at most 1e6 in magnitude.
    pub force: [[f64; 3]; 2],
    /// Time that the simulation has left out since its clock began, s, at most 1e9 and not less
    /// than in the last sample; default 0. It is part of `time`.
    pub time_lost: f64,
}

/// An event. Fill it with vbss_metrics_event_init, then set the fields of its kind.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_event {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// Kind of the event; the default 0 is refused.
    pub kind: vbss_metrics_event_kind,
    /// The tool that was used; default VBSS_METRICS_TOOL_NONE.
    pub tool: vbss_metrics_tool,
    /// Meaning depends on the kind; for throws 0 to 63; default 0.
    pub number: u32,
    /// 1: the event is undone; default 0.
    pub undone: u32,
    /// THROW: wraps, 1 single, 2 double, at most 64; default 0: not known.
    pub wraps: i32,
    /// THROW: +1 right-handed, -1 left-handed, 0 not known (default).
    pub handedness: i32,
    /// THROW: relation to the throw before; default UNKNOWN.
    pub relation: vbss_metrics_relation,
    /// Step number of the simulator; it is only passed on.
    pub step: u64,
    /// Time, s, at most 1e9 in magnitude, not before that of the last input.
    pub time: f64,
    /// Position of the event, m, each coordinate at most 1e3 in magnitude.
    pub position: [f64; 3],
    /// Force at the event, N, each component at most 1e6 in magnitude.
    pub force: [f64; 3],
    /// GAP: point on the other side, m, each coordinate at most 1e3 in magnitude.
    pub other: [f64; 3],
    /// PUNCTURE: offset about the axis, rad, -pi to pi.
    pub angle: f64,
    /// PUNCTURE: offset along the axis, m, at most 1e3 in magnitude.
    pub axial: f64,
    /// Meaning depends on the kind; 0 to 1e6.
    pub amount: f64,
}

/// A reading of the pull test. Fill it with vbss_metrics_pull_init, then set its fields.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_pull {
    /// Size of this struct in bytes, set by the init function.
    pub struct_size: u32,
    /// 1: a new test begins, and the results of an earlier one are discarded; default 0.
    pub begins: u32,
    /// 1 (default): the knot is still there; 0: its topology is lost.
    pub tied: u32,
    /// Zero.
    pub reserved: u32,
    /// Step number of the simulator; it is only passed on.
    pub step: u64,
    /// Time, s, at most 1e9 in magnitude, not before that of the last input.
    pub time: f64,
    /// Strain of the thread between the knot and each tool, -1 to 1.
    pub strain: [f64; 2],
    /// Force with which each tool pulls, N, 0 to 1e6.
    pub force: [f64; 2],
    /// Tail drawn into the knot since the test began, m, at most 1e3.
    pub drawn_in: f64,
}

/// The results of a trial so far. An unknown value is 0, and its bit is not set.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_report {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// VBSS_METRICS_FLAG_ bits: which values are known, and how the trial ended.
    pub flags: u32,
    /// Tightness by the pull test.
    pub tightness_pull: vbss_metrics_tightness,
    /// Tightness by the strain when both tools pull.
    pub tightness_strain: vbss_metrics_tightness,
    /// Number of throws in the knot.
    pub throw_count: u32,
    /// Number of throws that are square to the one before.
    pub square_count: u32,
    /// Number of throws that make a granny with the one before.
    pub granny_count: u32,
    /// Number of throws whose relation is not known.
    pub unknown_count: u32,
    /// Number of records for vbss_metrics_get_throw, undone throws included.
    pub throw_records: u32,
    /// Number of visits for vbss_metrics_get_phase.
    pub phase_count: u32,
    /// Number of penalties for vbss_metrics_get_penalty.
    pub penalty_count: u32,
    /// Number of needle transfers.
    pub transfers: u32,
    /// Number of missed needle transfers.
    pub transfers_missed: u32,
    /// Number of withdrawn punctures at each mark.
    pub attempts: [u32; 2],
    /// Number of drops.
    pub drops: u32,
    /// Number of penalties of the host.
    pub host_penalties: u32,
    /// Zero.
    pub reserved: u32,
    /// Number of samples accepted.
    pub samples: u64,
    /// Number of ticks of motion evaluated so far, for the tool that has more of them.
    pub ticks: u64,
    /// Number of ticks not measured because `duration` was used up.
    pub ticks_lost: u64,
    /// Time from the needle's appearance until both tails were cut, or until now, s, on the clock
    /// of the hands. It includes `time_lost`.
    pub time: f64,
    /// Deviation of each puncture from its mark, along the drain, mm.
    pub deviation_mm: [f64; 2],
    /// Gap between the two points of the event GAP, mm.
    pub gap_mm: f64,
    /// Gap where the slit gapes most, mm.
    pub gap_largest_mm: f64,
    /// Length of each tail, after the cut if it was cut, mm.
    pub tail_mm: [f64; 2],
    /// Longest time for which the knot bore the pull, s.
    pub pull_held: f64,
    /// Largest strain that both sides reached.
    pub pull_strain: f64,
    /// Largest length of tail drawn in, mm.
    pub drawn_in_mm: f64,
    /// max_time - time - penalties, not below zero.
    pub score: f64,
    /// Sum of the penalties.
    pub penalties: f64,
    /// Samples of the left and the right tool left out as outliers.
    pub outliers: [u64; 2],
    /// How often outliers lasted for more than 0.1 s, so that a new run began, for each tool.
    pub jumps: [u32; 2],
    /// Part of `time` that the simulation left out, s.
    pub time_lost: f64,
    /// Time that was simulated, s: `time` minus `time_lost`.
    pub time_simulated: f64,
}

/// A throw that was tied. Records are in the order of their first events.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_throw {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Position in the knot; 0 is next to the tissue.
    pub number: u32,
    /// 1: the throw is tied; 0: it was untied.
    pub standing: u32,
    /// The tool that tied it.
    pub tool: vbss_metrics_tool,
    /// Number of wraps: 1 single, 2 double, 0 not known.
    pub wraps: i32,
    /// +1 right-handed, -1 left-handed, 0 not known.
    pub handedness: i32,
    /// Relation to the throw before.
    pub relation: vbss_metrics_relation,
    /// Zero.
    pub reserved: u32,
    /// Step of its first event.
    pub step: u64,
    /// Time of its first event, s.
    pub time: f64,
    /// Time at which it was untied, s; 0 while it is tied.
    pub undone_time: f64,
    /// Position of the throw, m.
    pub position: [f64; 3],
    /// Force at the throw, N.
    pub force: [f64; 3],
}

/// A visit of a phase. A phase may be visited more than once.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_phase {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// The host's number of the phase.
    pub number: u32,
    /// 1: another phase has begun; 0: `end` is the current time, or the end of the trial.
    pub ended: u32,
    /// Zero.
    pub reserved: u32,
    /// Step at which the phase began.
    pub step: u64,
    /// Time at which the phase began, s.
    pub begin: f64,
    /// Time at which the phase ended, s.
    pub end: f64,
}

/// One reason why the score is not max_time - time. Faults that cost no points are listed too.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_penalty {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// Kind of the penalty.
    pub kind: vbss_metrics_penalty_kind,
    /// Number of the mark, throw or other object, as in the event.
    pub number: u32,
    /// The tool that was used.
    pub tool: vbss_metrics_tool,
    /// Step of the penalty.
    pub step: u64,
    /// Time of the penalty, s.
    pub time: f64,
    /// Size of the fault; its meaning depends on the kind.
    pub measure: f64,
    /// Points that it costs.
    pub amount: f64,
    /// Position, m.
    pub position: [f64; 3],
    /// Force, N.
    pub force: [f64; 3],
    /// Description, a constant string; never NULL.
    pub text: *const c_char,
}

/// Motion of one tool, and the force on it.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_motion {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// VBSS_METRICS_HAS_ bits.
    pub valid: u32,
    /// Number of movements between rests that last 0.2 s to 40.96 s.
    pub movement_count: u32,
    /// Zero.
    pub reserved: u32,
    /// Time in which the tool was seen, s.
    pub time: f64,
    /// Time in which the tool was not seen, s.
    pub unseen_time: f64,
    /// Length of the path, m.
    pub path_length: f64,
    /// Mean speed, m/s.
    pub mean_speed: f64,
    /// Peak speed, m/s.
    pub peak_speed: f64,
    /// Time in which the tool was idle, s.
    pub idle_time: f64,
    /// Idle share of `time`, 0 to 1.
    pub idle_share: f64,
    /// Log dimensionless jerk by length, -ln(T^5/L^2 integral of |jerk|^2); higher is smoother.
    pub ldj_length: f64,
    /// Log dimensionless jerk by peak speed, -ln(T^3/v_peak^2 integral of |jerk|^2); higher is
    /// smoother.
    pub ldj_speed: f64,
    /// Spectral arc length of the whole motion as one movement.
    pub sparc: f64,
    /// Mean spectral arc length over the movements.
    pub movement_sparc: f64,
    /// Largest force, N.
    pub force_peak: f64,
    /// Integral of the magnitude of the force over time, N s.
    pub force_integral: f64,
}

/// Joint motion of both tools.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct vbss_metrics_bimanual {
    /// Bytes of this struct that the library filled.
    pub struct_size: u32,
    /// VBSS_METRICS_HAS_CORRELATION, or 0.
    pub valid: u32,
    /// Time in which both tools were seen, s.
    pub time: f64,
    /// Pearson's correlation of their speeds, -1 to 1.
    pub correlation: f64,
    /// Time in which both tools moved, s.
    pub both_moving_time: f64,
    /// Time in which exactly one tool moved, s.
    pub one_moving_time: f64,
    /// Time in which both tools were idle, s.
    pub still_time: f64,
    /// `both_moving_time` as a share of `time`, 0 to 1.
    pub both_moving_share: f64,
}

extern "C" {
    /// Fills a configuration with the defaults.
    ///
    /// @param config  the configuration to fill
    /// @param struct_size  `sizeof *config` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_metrics_config_init(config: *mut vbss_metrics_config, struct_size: u32) -> vbss_result;
    /// Fills a sample with the defaults: no part is valid.
    ///
    /// @param sample  the sample to fill
    /// @param struct_size  `sizeof *sample` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_metrics_sample_init(sample: *mut vbss_metrics_sample, struct_size: u32) -> vbss_result;
    /// Fills an event with the defaults; the host sets its kind.
    ///
    /// @param event   the event to fill
    /// @param struct_size  `sizeof *event` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_metrics_event_init(event: *mut vbss_metrics_event, struct_size: u32) -> vbss_result;
    /// Fills a reading of the pull test with the defaults: tied, without force.
    ///
    /// @param pull    the reading to fill
    /// @param struct_size  `sizeof *pull` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_metrics_pull_init(pull: *mut vbss_metrics_pull, struct_size: u32) -> vbss_result;
    /// Creates an empty measurement and allocates all memory that it needs.
    ///
    /// @param context       owner
    /// @param config        configuration; NULL for the defaults
    /// @param metrics  the new measurement; NULL when the call fails
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE, VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_OUT_OF_MEMORY or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_create(context: *mut vbss_context, config: *const vbss_metrics_config, metrics: *mut *mut vbss_metrics) -> vbss_result;
    /// Destroys a measurement.
    ///
    /// @param metrics  the measurement; NULL does nothing
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_destroy(metrics: *mut vbss_metrics) -> vbss_result;
    /// Adds a sample. A tool that was not seen for more than 0.1 s starts a new run where it reappears;
    /// the gap adds no path. A position that the hand cannot have reached with `max_speed` is an
    /// outlier. It is counted and left out, and the curve bridges it like a lost sample. Later positions
    /// that are nearer to the outlier are outliers, too. After 0.1 s of outliers the tool has jumped: it
    /// counts as not seen for that time, and a new run starts at its position. The call allocates
    /// nothing; motion beyond `duration` is counted as lost.
    ///
    /// @param metrics  the measurement
    /// @param sample   the sample
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards),
    /// VBSS_ERROR_WRONG_STATE (the measurement has finished), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed then
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_add_sample(metrics: *mut vbss_metrics, sample: *const vbss_metrics_sample) -> vbss_result;
    /// Adds an event, also after vbss_metrics_finish.
    ///
    /// @param metrics  the measurement
    /// @param event    the event
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards),
    /// VBSS_ERROR_NOT_FOUND (the event to undo is not in force), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_CAPACITY, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed
    /// then
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_add_event(metrics: *mut vbss_metrics, event: *const vbss_metrics_event) -> vbss_result;
    /// Adds a reading of the pull test, also after vbss_metrics_finish.
    ///
    /// @param metrics  the measurement
    /// @param pull     the reading
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_UNKNOWN_FIELD, VBSS_ERROR_OUT_OF_RANGE (also: time runs backwards), VBSS_ERROR_NOT_FINITE,
    /// VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY; nothing has changed then
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_add_pull(metrics: *mut vbss_metrics, pull: *const vbss_metrics_pull) -> vbss_result;
    /// Ends the samples: computes the motion up to the last one and refuses further samples. A second
    /// call does nothing.
    ///
    /// @param metrics  the measurement
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_ARITHMETIC_MODE or VBSS_ERROR_BUSY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_finish(metrics: *mut vbss_metrics) -> vbss_result;
    /// Returns the results of the trial so far.
    ///
    /// @param metrics      the measurement
    /// @param report  receives the report
    /// @param struct_size  `sizeof *report` as the caller was compiled; fields that the library does not
    /// know become zero
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_STRUCT_SIZE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_report(metrics: *mut vbss_metrics, report: *mut vbss_metrics_report, struct_size: u32) -> vbss_result;
    /// Returns one record of a throw.
    ///
    /// @param metrics          the measurement
    /// @param index            0 to throw_records - 1
    /// @param record      receives the record
    /// @param struct_size      `sizeof *record` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such record)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_throw(metrics: *mut vbss_metrics, index: u32, record: *mut vbss_metrics_throw, struct_size: u32) -> vbss_result;
    /// Returns one visit of a phase.
    ///
    /// @param metrics      the measurement
    /// @param index        0 to phase_count - 1
    /// @param phase   receives the visit
    /// @param struct_size  `sizeof *phase` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such visit)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_phase(metrics: *mut vbss_metrics, index: u32, phase: *mut vbss_metrics_phase, struct_size: u32) -> vbss_result;
    /// Returns one penalty. Their sum is max_time - time - score, unless it exceeds max_time - time; the
    /// score is zero then.
    ///
    /// @param metrics       the measurement
    /// @param index         0 to penalty_count - 1
    /// @param penalty  receives the penalty
    /// @param struct_size   `sizeof *penalty` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_NOT_FOUND (no such penalty)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_penalty(metrics: *mut vbss_metrics, index: u32, penalty: *mut vbss_metrics_penalty, struct_size: u32) -> vbss_result;
    /// Returns the motion of a tool. The call takes some ms for a minute of motion; do not call it in
    /// every step.
    ///
    /// @param metrics      the measurement
    /// @param tool         VBSS_METRICS_TOOL_LEFT or VBSS_METRICS_TOOL_RIGHT
    /// @param phase        index of a visit of a phase, or VBSS_METRICS_PHASE_ALL
    /// @param motion  receives the motion
    /// @param struct_size  `sizeof *motion` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_OUT_OF_RANGE (no such tool), VBSS_ERROR_NOT_FOUND (no such visit) or
    /// VBSS_ERROR_ARITHMETIC_MODE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_motion(metrics: *mut vbss_metrics, tool: vbss_metrics_tool, phase: i32, motion: *mut vbss_metrics_motion, struct_size: u32) -> vbss_result;
    /// Returns the joint motion of both tools.
    ///
    /// @param metrics        the measurement
    /// @param phase          index of a visit of a phase, or VBSS_METRICS_PHASE_ALL
    /// @param bimanual  receives the joint motion
    /// @param struct_size    `sizeof *bimanual` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE,
    /// VBSS_ERROR_NOT_FOUND (no such visit) or VBSS_ERROR_ARITHMETIC_MODE
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_bimanual(metrics: *mut vbss_metrics, phase: i32, bimanual: *mut vbss_metrics_bimanual, struct_size: u32) -> vbss_result;
    /// Returns a view of an array.
    ///
    /// @param metrics      the measurement
    /// @param field        the array
    /// @param view    receives the view
    /// @param struct_size  `sizeof *view` as the caller was compiled
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE or
    /// VBSS_ERROR_OUT_OF_RANGE (no such field)
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_view(metrics: *mut vbss_metrics, field: vbss_metrics_field, view: *mut vbss_view, struct_size: u32) -> vbss_result;
    /// Computes the offset of a place on a cylinder from a mark on it, as the event of a puncture needs
    /// it.
    ///
    /// @param axis         direction of the axis through `centre`, of any length
    /// @param centre       a point on the axis, m
    /// @param mark         the mark, m; only its direction from the axis and its position along it
    /// matter
    /// @param place        the place, m; only its direction from the axis and its position along it
    /// matter
    /// @param angle   from mark to place about the axis, right-handed, -pi to pi, rad
    /// @param axial   from mark to place along the axis, m
    /// @return VBSS_OK, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_NOT_FINITE, or VBSS_ERROR_OUT_OF_RANGE (numbers above 1e3, no
    /// axis, mark or place on it)
    /// @threads any thread, any time
    /// @since 1.0
    pub fn vbss_metrics_get_offset(axis: *const f64, centre: *const f64, mark: *const f64, place: *const f64, angle: *mut f64, axial: *mut f64) -> vbss_result;
    /// Saves the whole measurement.
    ///
    /// @param metrics       the measurement
    /// @param bytes    receives the snapshot; NULL with capacity 0 asks for its size, which logs no error
    /// @param capacity      size of `bytes`
    /// @param written  bytes written, or bytes needed with VBSS_ERROR_CAPACITY
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT or VBSS_ERROR_CAPACITY
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_save(metrics: *mut vbss_metrics, bytes: *mut u8, capacity: u64, written: *mut u64) -> vbss_result;
    /// Restores a snapshot of a measurement with the same configuration, completely or not at all.
    ///
    /// @param metrics  the measurement
    /// @param bytes    the snapshot
    /// @param count    its size
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_TRUNCATED,
    /// VBSS_ERROR_CORRUPT (also: the snapshot has another configuration),
    /// VBSS_ERROR_DATA_VERSION, VBSS_ERROR_CAPACITY, VBSS_ERROR_OUT_OF_MEMORY or
    /// VBSS_ERROR_BUSY; on failure nothing has changed
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_restore(metrics: *mut vbss_metrics, bytes: *const u8, count: u64) -> vbss_result;
    /// Returns a hash of the whole measurement; equal logs give equal hashes on every machine. The cost
    /// grows with the length of the trial; do not call it in every step.
    ///
    /// @param metrics    the measurement
    /// @param hash  receives the hash
    /// @return VBSS_OK, VBSS_ERROR_INVALID_HANDLE or VBSS_ERROR_NULL_ARGUMENT
    /// @threads one thread at a time per context
    /// @since 1.0
    pub fn vbss_metrics_get_hash(metrics: *mut vbss_metrics, hash: *mut u64) -> vbss_result;
}
