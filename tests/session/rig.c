#include "rig.h"

#include <math.h>
#include <string.h>

#define LENGTH 0.15
#define TAIL 17e-3

/* ---- life */

void rig_make(rig *r)
{
    vbss_metrics_config c;
    memset(r, 0, sizeof *r);
    r->context = harness_context(&r->memory);
    expect_ok(session_scene_still(r->context, &r->scene));
    expect_ok(vbss_metrics_config_init(&c, sizeof c));
    c.duration = 60.0;
    expect_ok(vbss_metrics_create(r->context, &c, &r->metrics));
    r->scene.config.metrics = r->metrics;
    r->observation.thread = r->scene.config.thread;
    r->observation.thread_length = LENGTH;
    r->observation.gap = r->observation.max_gap = r->observation.signed_gap = 3e-3;
    r->observation.drain_radius = 6.5e-3;
    for (int i = 0; i < SESSION_TOOLS; i++) {
        r->observation.tools[i].held_arc = -1.0;
    }
}

void rig_start(rig *r)
{
    expect_ok(vbss_session_create(r->scene.scene, &r->scene.config, &r->session));
    expect_ok(vbss_session_open(r->session, &r->s));
    rig_run(r, RIG_STEP);
    rig_expect(r, VBSS_SESSION_EVENT_APPEARED, 0, 0);
    rig_expect_phase(r, VBSS_SESSION_PHASE_LOADING, 0);
}

void rig_begin(rig *r)
{
    rig_make(r);
    rig_start(r);
}

void rig_begin_coached(rig *r)
{
    rig_make(r);
    r->scene.config.coaching = 1;
    rig_start(r);
}

void rig_end(rig *r)
{
    harness_context_end(r->context, &r->memory);
}

/* ---- steps and events */

void rig_run(rig *r, double seconds)
{
    session_object *s = r->s;
    for (uint32_t n = (uint32_t)(seconds / RIG_STEP + 0.5); n > 0; n--) {
        s->time += s->steps > 0 ? RIG_STEP : 0.0;
        s->steps++;
        s->events_before_step = s->event_count;
        s->observation = r->observation;
        vbss_session_update_progress(s, &s->observation);
        vbss_session_update_coach(s, &s->observation);
        expect_ok(vbss_session_feed_metrics(s, &s->observation));
    }
}

/* The coach's are expected by their own tests. */
static bool read_event(rig *r, vbss_session_event *e)
{
    while (vbss_session_get_event(r->session, r->read, e, sizeof *e) == VBSS_OK) {
        if (e->kind != VBSS_SESSION_EVENT_GOAL && e->kind != VBSS_SESSION_EVENT_MISTAKE) {
            return true;
        }
        r->read++;
    }
    return false;
}

const vbss_session_event *rig_expect_at(rig *r, vbss_session_event_kind kind, uint32_t number,
                                        uint32_t undone, const char *name, const char *file,
                                        int line)
{
    static vbss_session_event e;
    if (!read_event(r, &e)) {
        print_error("event %s %u is missing\n", name, number);
        _fail(file, line);
    }
    if (e.kind != kind || e.number != number || e.undone != undone || e.ordinal != r->read) {
        print_error("event %s %u (undone %u) was expected, %d %u (undone %u) came at %g s\n", name,
                    number, undone, e.kind, e.number, e.undone, e.time);
        _fail(file, line);
    }
    r->read++;
    return &e;
}

void rig_expect_quiet_at(rig *r, const char *file, int line)
{
    vbss_session_event e;
    if (read_event(r, &e)) {
        print_error("event %d %u (undone %u) at %g s was not expected\n", e.kind, e.number,
                    e.undone, e.time);
        _fail(file, line);
    }
}

vbss_session_status rig_status(const rig *r)
{
    vbss_session_status status;
    expect_ok(vbss_session_get_status(r->session, &status, sizeof status));
    return status;
}

vbss_session_coaching rig_coaching(const rig *r)
{
    vbss_session_coaching coaching;
    expect_ok(vbss_session_get_coaching(r->session, &coaching, sizeof coaching));
    return coaching;
}

void rig_expect_goal_at(const rig *r, vbss_session_goal goal, vbss_metrics_tool tool,
                        const char *file, int line)
{
    const vbss_session_coaching c = rig_coaching(r);
    if (c.goal != goal || c.tool != tool || c.sentence == NULL || c.sentence[0] == '\0') {
        print_error("goal %d of tool %d was expected, not %d of %d: %s\n", goal, tool, c.goal,
                    c.tool, c.sentence);
        _fail(file, line);
    }
}

/* ---- what is seen */

void rig_take(rig *r, uint32_t tool)
{
    r->observation.tools[tool].has_needle = true;
}

void rig_drop(rig *r, uint32_t tool)
{
    r->observation.tools[tool].has_needle = false;
}

static session_hole_observation *find(rig *r, uint32_t id)
{
    for (uint32_t i = 0; i < r->observation.hole_count; i++) {
        if (r->observation.holes[i].id == id) {
            return &r->observation.holes[i];
        }
    }
    fail_msg("there is no hole %u", id);
    return NULL;
}

void rig_pierce(rig *r, uint32_t id, uint32_t mark, double axial)
{
    session_hole_observation *hole = &r->observation.holes[r->observation.hole_count++];
    *hole = (session_hole_observation){.id = id, .mark = mark, .distance_from_tip = 1e-3};
    hole->axial[mark] = axial;
}

void rig_thread_through(rig *r, uint32_t id, double arc)
{
    session_hole_observation *hole = find(r, id);
    hole->thread = r->observation.thread;
    hole->arc = arc;
}

void rig_leave(rig *r, uint32_t id)
{
    session_hole_observation *hole = find(r, id);
    *hole = r->observation.holes[--r->observation.hole_count];
}

void rig_set_throw(rig *r, uint32_t number, int32_t wraps, int32_t handedness,
                   vbss_metrics_relation relation)
{
    session_knot_observation *knot = &r->observation.knot;
    knot->throws[number] = (session_throw_observation){wraps, handedness, relation};
    knot->throw_count = wraps > 0 ? number + 1 : number;
}

void rig_hold_thread(rig *r, uint32_t tool, double from_end)
{
    session_tool_observation *seen = &r->observation.tools[tool];
    seen->held_arc = r->observation.thread_length - from_end;
    seen->has_tail = from_end <= r->scene.config.tail_reach;
}

void rig_let_go(rig *r, uint32_t tool)
{
    r->observation.tools[tool].held_arc = -1.0;
    r->observation.tools[tool].has_tail = false;
}

void rig_wind(rig *r, uint32_t tool, double turns, int32_t direction)
{
    r->s->coach.turns[tool] = turns;
    r->s->coach.direction[tool] = direction;
    r->observation.knot.next_throw = fabs(turns) >= 0.75 ? VBSS_KNOT_VERDICT_WRAPPING : 0;
}

void rig_pull(rig *r, double force, double gap)
{
    r->observation.tension[0] = r->observation.tension[1] = force;
    r->observation.gap = r->observation.max_gap = r->observation.signed_gap = gap;
}

/* ---- from the begin to there */

void rig_to_approach(rig *r)
{
    rig_take(r, RIG_RIGHT);
    rig_run(r, 0.1);
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_TAKEN, 0, 0)->tool, VBSS_METRICS_TOOL_RIGHT);
    rig_expect_phase(r, VBSS_SESSION_PHASE_APPROACH, 0);
    rig_expect_quiet(r);
}

void rig_to_tail(rig *r)
{
    rig_to_approach(r);
    rig_pierce(r, RIG_ENTRY, 1, 0.5e-3);
    rig_run(r, 0.1);
    rig_expect(r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_ENTRY, 0);
    rig_expect_phase(r, VBSS_SESSION_PHASE_IN_DRAIN, 0);
    rig_pierce(r, RIG_EXIT, 0, -1e-3);
    rig_run(r, 0.1);
    rig_expect(r, VBSS_SESSION_EVENT_PUNCTURE, SESSION_EXIT, 0);
    rig_expect_phase(r, VBSS_SESSION_PHASE_PULL_THROUGH, 0);
    rig_thread_through(r, RIG_ENTRY, 0.02);
    rig_run(r, 0.1);
    rig_expect(r, VBSS_SESSION_EVENT_THREADED, SESSION_ENTRY, 0);
    rig_thread_through(r, RIG_EXIT, 0.01);
    rig_run(r, 0.1);
    rig_expect(r, VBSS_SESSION_EVENT_THREADED, SESSION_EXIT, 0);
    rig_thread_through(r, RIG_EXIT, LENGTH - TAIL - 12e-3);
    rig_thread_through(r, RIG_ENTRY, LENGTH - TAIL);
    rig_run(r, 0.1);
    expect_near(TAIL, rig_expect(r, VBSS_SESSION_EVENT_TAIL, 0, 0)->amount, 1e-12);
    rig_expect_phase(r, VBSS_SESSION_PHASE_THROW_1, 0);
    rig_expect_quiet(r);
}

static void hand_over(rig *r, uint32_t tool)
{
    if (!r->observation.tools[1 - tool].has_needle) {
        return;
    }
    rig_take(r, tool);
    rig_run(r, 0.1);
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_TAKEN, 0, 0)->tool, tool);
    rig_drop(r, 1 - tool);
    rig_run(r, 0.1);
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_TAKEN, 0, 1)->tool, 1 - tool);
}

void rig_expect_stage(rig *r, uint32_t number, vbss_session_stage stage)
{
    assert_int_equal(rig_expect(r, VBSS_SESSION_EVENT_STAGE, number, 0)->stage, stage);
}

void rig_tie(rig *r, uint32_t number)
{
    r->observation.knot.next_throw = VBSS_KNOT_VERDICT_WRAPPING;
    rig_run(r, 0.1);
    rig_expect_stage(r, number, VBSS_SESSION_STAGE_WRAP);
    r->observation.knot.next_throw = VBSS_KNOT_VERDICT_PASSED;
    rig_run(r, 0.1);
    rig_expect_stage(r, number, VBSS_SESSION_STAGE_PASSED);
    rig_set_throw(r, number, number == 0 ? 2 : 1, number % 2 == 0 ? 1 : -1,
                  number == 0 ? VBSS_METRICS_RELATION_FIRST : VBSS_METRICS_RELATION_SQUARE);
    rig_run(r, 0.12);
    rig_expect(r, VBSS_SESSION_EVENT_THROW, number, 0);
    r->observation.knot.next_throw = VBSS_KNOT_VERDICT_NONE;
    rig_run(r, 0.1);
    rig_expect_stage(r, number, VBSS_SESSION_STAGE_SEATING);
}

void rig_to_throw(rig *r, uint32_t number, uint32_t tool)
{
    bool over = r->observation.tools[1 - tool].has_needle;
    uint32_t phase = VBSS_SESSION_PHASE_THROW_1 + 2 * number;
    hand_over(r, tool);
    if (over && number > 0) {
        rig_expect(r, VBSS_SESSION_EVENT_TRANSFER, number - 1, 0);
        rig_expect_phase(r, phase, 0);
    }
    rig_pull(r, 0.0, 3e-4);
    rig_tie(r, number);
    rig_pull(r, 1.0, 3e-4);
    rig_run(r, 0.2);
    rig_expect(r, VBSS_SESSION_EVENT_SEATED, number, 0);
    rig_expect_phase(r, phase + 1, 0);
    rig_expect_stage(r, number, VBSS_SESSION_STAGE_SEATED);
    rig_expect_quiet(r);
}

void rig_to_cut(rig *r)
{
    rig_to_tail(r);
    rig_to_throw(r, 0, RIG_RIGHT);
    rig_to_throw(r, 1, RIG_LEFT);
    rig_to_throw(r, 2, RIG_RIGHT);
}
