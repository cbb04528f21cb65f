// Written by bindings/rust/generate.py from the public headers: do not edit.
use super::defaults;
use crate::sys;

/// Configuration of a session. Fill it with vbss_session_config_init, then set the numbers of the
/// bodies.
#[derive(Debug, Clone)]
pub struct SessionConfig {
    pub(crate) raw: sys::vbss_session_config,
}

impl Default for SessionConfig {
    fn default() -> Self {
        SessionConfig { raw: defaults(sys::vbss_session_config_init) }
    }
}

impl SessionConfig {
    /// The defaults of the library.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of the thread in the scene. Its node 0 is at the swage; its last node is the end of
    /// the tail.
    pub fn thread(mut self, value: u32) -> Self {
        self.raw.thread = value;
        self
    }

    /// Number of the needle in the scene.
    pub fn needle(mut self, value: u32) -> Self {
        self.raw.needle = value;
        self
    }

    /// Number of the drain in the scene.
    pub fn drain(mut self, value: u32) -> Self {
        self.raw.drain = value;
        self
    }

    /// Numbers of the left and the right grasper in the scene.
    pub fn tools(mut self, value: [u32; 2]) -> Self {
        self.raw.tools = value;
        self
    }

    /// Number of a third grasper, which cuts; default 0: a tool is exchanged for shears.
    pub fn shears(mut self, value: u32) -> Self {
        self.raw.shears = value;
        self
    }

    /// Largest number of events that are kept, the newest ones; 8 to 65536; default 1024.
    pub fn event_capacity(mut self, value: u32) -> Self {
        self.raw.event_capacity = value;
        self
    }

    /// Number of steps between inputs of the knot detector, 1 to 1000; default 4. The detector's
    /// own step_budget bounds the work of an input.
    pub fn knot_interval(mut self, value: u32) -> Self {
        self.raw.knot_interval = value;
        self
    }

    /// Number of steps between hashes of the task in the log, for replays to compare; 1 to 1e9;
    /// default 100. Steps with events are hashed too. Used only with a record.
    pub fn hash_interval(mut self, value: u32) -> Self {
        self.raw.hash_interval = value;
        self
    }

    /// Time limit from the needle's appearance on, s, 1e-3 to 1e6; default 600.
    pub fn time_limit(mut self, value: f64) -> Self {
        self.raw.time_limit = value;
        self
    }

    /// Time for which a fact must differ before it changes, s, 0 to 10; default 0.05.
    pub fn dwell(mut self, value: f64) -> Self {
        self.raw.dwell = value;
        self
    }

    /// Dwell time of throws and of faults of the knot, s, 0 to 10; default 0.1. A half hitch takes
    /// 20 times as long.
    pub fn throw_dwell(mut self, value: f64) -> Self {
        self.raw.throw_dwell = value;
        self
    }

    /// Shortest permitted tail, m, 0 to 1; default 15e-3.
    pub fn tail_low(mut self, value: f64) -> Self {
        self.raw.tail_low = value;
        self
    }

    /// Longest permitted tail, m, tail_low to 1; default 20e-3.
    pub fn tail_high(mut self, value: f64) -> Self {
        self.raw.tail_high = value;
        self
    }

    /// Hysteresis of both limits: a tail that is set stays set up to this far beyond them, m, 0 to
    /// 1; default 1e-3.
    pub fn tail_margin(mut self, value: f64) -> Self {
        self.raw.tail_margin = value;
        self
    }

    /// Largest distance from the end at which a tail counts as grasped, m, 0 to 1; default 0.01.
    pub fn tail_reach(mut self, value: f64) -> Self {
        self.raw.tail_reach = value;
        self
    }

    /// Largest gap of the slit at which a throw becomes seated, m, 0 to 1; default 0.5e-3. Edges
    /// that have crossed do not gape.
    pub fn seat_gap(mut self, value: f64) -> Self {
        self.raw.seat_gap = value;
        self
    }

    /// Gap at which a throw is no longer seated, m, seat_gap to 1; default 1e-3.
    pub fn seat_release(mut self, value: f64) -> Self {
        self.raw.seat_release = value;
        self
    }

    /// Tension of both limbs that seats a throw, N, 0 to 1e3; default 0.5.
    pub fn seat_force(mut self, value: f64) -> Self {
        self.raw.seat_force = value;
        self
    }

    /// Share of torn anchors at which the drain counts as torn off, 0 to 1; default 0.5.
    pub fn avulsed_share(mut self, value: f64) -> Self {
        self.raw.avulsed_share = value;
        self
    }

    /// Tension at which the thread breaks, N, 0 to 1e6; default 0: it never breaks.
    pub fn break_force(mut self, value: f64) -> Self {
        self.raw.break_force = value;
        self
    }

    /// Measure of the gap that seats throws and that status, events and metrics report; default
    /// LIPS.
    pub fn gap_measure(mut self, value: sys::vbss_session_gap) -> Self {
        self.raw.gap_measure = value;
        self
    }

    /// 1: the session coaches (session_coaching.h); default 0. The hashes in logs do not depend on it, but
    /// the state of a session that coaches can be restored only to one that coaches, too.
    pub fn coaching(mut self, value: u32) -> Self {
        self.raw.coaching = value;
        self
    }

    /// Share of lost time above which TIME_LOST is an event and `is_lossy` is set, 0 to 1; default
    /// 0.02. A trial shorter than 1 s counts as 1 s.
    pub fn lost_share(mut self, value: f64) -> Self {
        self.raw.lost_share = value;
        self
    }

    /// Exercise that the session trains in place of the whole task (session_exercise.h); default
    /// NONE. The state of an exercise can be restored only to a session with the same one.
    pub fn exercise(mut self, value: sys::vbss_session_exercise) -> Self {
        self.raw.exercise = value;
        self
    }
}
