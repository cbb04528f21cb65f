#include "trainer/stage.h"

#include <stdio.h>

#include <math.h>
#include <string.h>

#include "exercise/practice.h"
#include "surgeon/surgeon.h"
#include "surgeon/task.h"

#define GRAVITY (-9.81)
#define FINE 0.25e-3 /* radius of jaws that take what lies flat on a floor */
#define NECK 5e-3    /* of the left tool, to wind a thread about */
#define ABOVE 0.03
#define WIDE 0.6     /* of the handle */
#define PRESS 0.3e-3 /* of jaws into the floor */
#define GO 1.0       /* s, until the hands are over their places, */
#define DOWN 1.5     /* and down */
#define CLOSED 0.25  /* s of each closing */
#define EVERY 1.25   /* from one to the next: a quarter of the time is what a solenoid bears */
#define FIRST 1.75   /* closing */
#define SEGMENTS 300 /* of the thread */
/* Budget of a call where the core is not measured, us, less than the default: so that a slot is kept by a core of
 * 2.6 GHz (docs/notebook/trainer.md). */
#define FIXED_CALL 360.0

/* ---- tools */

static vbss_result add_tool(stage *s, int side, vec start)
{
    vbss_grasper_config c;
    double at[3];
    v_store(at, start);
    s->start[side] = start;
    TRY(vbss_grasper_config_init(&c, sizeof c));
    c.driver_radius = side == RIGHT ? FINE : c.driver_radius;
    c.driver_neck = side == LEFT ? NECK : c.driver_neck;
    TRY(vbss_grasper_create(s->context, &c, &s->tools[side]));
    TRY(vbss_grasper_set_target(s->tools[side], at, NULL));
    TRY(vbss_grasper_set_opening(s->tools[side], WIDE));
    return vbss_scene_add_grasper(s->scene, s->tools[side], &s->bodies[side]);
}

/* ---- a needle on a table */

static vbss_result create_table(stage *s)
{
    vbss_scene_config c;
    vbss_needle_config n;
    vbss_needle *needle;
    uint32_t body;
    TRY(vbss_context_create(NULL, &s->context));
    TRY(vbss_scene_config_init(&c, sizeof c));
    c.floor = 1;
    c.floor_normal[1] = 0.0;
    c.floor_normal[2] = 1.0;
    c.solver = &s->solver;
    TRY(vbss_scene_create(s->context, &c, &s->scene));
    TRY(vbss_needle_config_init(&n, sizeof n));
    n.gravity[2] = GRAVITY;
    n.drag = 5.0; /* felt: what is let go stays */
    n.position[2] = n.wire_radius;
    n.orientation[0] = n.orientation[3] = sqrt(0.5);
    TRY(vbss_needle_create(s->context, &n, &needle));
    TRY(vbss_scene_add_needle(s->scene, needle, &body));
    /* where the arc runs away from who trains, so that upright jaws close on it */
    vbss_needle_state state;
    TRY(vbss_needle_get_state(needle, &state, sizeof state));
    double angle = -0.5 * n.arc;
    pose at = pose_load(state.position, state.orientation);
    s->needle = pose_point(&at, v3(n.radius * vbss_cos(angle), n.radius * vbss_sin(angle), 0.0));
    s->middle = v3(0.0, 0.0, 0.03);
    TRY(add_tool(s, RIGHT, v3(0.03, 0.0, ABOVE)));
    return add_tool(s, LEFT, v3(-0.03, 0.0, ABOVE));
}

static double smooth(double from, double to, double time)
{
    double x = smaller(larger((time - from) / (to - from), 0.0), 1.0);
    return x * x * (3.0 - 2.0 * x);
}

static bool is_closed(double time)
{
    return time >= FIRST && fmod(time - FIRST, EVERY) < CLOSED;
}

/* The right hand closes on the needle again and again, the left one presses on the table. */
static motion script_table(const stage *s, int side, double time)
{
    vec over = side == RIGHT ? s->needle : v3(-0.03, 0.02, 0.0);
    double radius = side == RIGHT ? FINE : 0.5e-3;
    double low = s->floor + radius - (side == RIGHT ? PRESS : 2.0 * PRESS);
    over.z = ABOVE;
    vec at = v_mix(s->start[side], over, smooth(0.0, GO, time));
    at.z += (low - at.z) * smooth(GO, DOWN, time);
    return (motion){at, side == RIGHT && is_closed(time) ? 0.0 : WIDE};
}

/* ---- the stitch */

static vbss_result add_session(stage *s)
{
    vbss_session_config c;
    TRY(vbss_session_config_init(&c, sizeof c));
    c.thread = s->site.rig.thread_body;
    c.needle = s->site.needle_body;
    c.drain = s->site.drain_body;
    c.tools[0] = s->bodies[LEFT];
    c.tools[1] = s->bodies[RIGHT];
    return vbss_session_create(s->scene, &c, &s->session);
}

static vbss_result create_stitch(stage *s)
{
    const site_plan plan = {.segments = SEGMENTS, .solver = &s->solver};
    vbss_result result = site_create(&s->site, v3(0.035, -0.005, 0.0), 3.141592653589793, &plan);
    s->context = s->site.rig.context;
    s->scene = s->site.rig.scene;
    TRY(result);
    s->floor = s->site.floor;
    s->middle = v3(0.0, 0.0, 0.02);
    TRY(add_tool(s, RIGHT, v3(0.05, -0.05, ABOVE)));
    TRY(add_tool(s, LEFT, v3(-0.04, -0.01, ABOVE)));
    return add_session(s);
}

/* The left hand leans on the drain's top beside the slit, the right one goes round above the needle. */
static motion script_stitch(const stage *s, int side, double time)
{
    double turn = 2.0 * larger(time - GO, 0.0), outer = s->site.tube + 0.5 * s->site.wall;
    if (side == RIGHT) {
        vec at = v3(0.035 + 5e-3 * (vbss_cos(turn) - 1.0), -0.005 + 5e-3 * vbss_sin(turn), 0.01);
        return (motion){v_mix(s->start[side], at, smooth(0.0, GO, time)),
                        is_closed(time) ? 0.0 : WIDE};
    }
    double aside = -4e-3, top = sqrt(outer * outer - aside * aside) - outer;
    vec at = v3(aside, 8e-3, ABOVE);
    at = v_mix(s->start[side], at, smooth(0.0, GO, time));
    at.z += (top - 1e-3 * (1.0 - vbss_cos(turn)) - at.z) * smooth(GO, DOWN, time);
    return (motion){at, 0.0};
}

/* ---- what the scripted surgeon finds */

static void take_tool(stage *s, int side, const hand *h)
{
    s->tools[side] = h->grasper;
    s->bodies[side] = h->body;
    s->start[side] = h->shown;
}

static vbss_result create_surgeon(stage *s)
{
    const surgeon_options usual = {.seed = s->seed};
    stitch_plan plan;
    task of_surgeon;
    surgeon_plan(&usual, &plan);
    plan.site.solver = &s->solver;
    vbss_result result = stitch_create(&s->stitch, s->seed, &plan);
    s->site = s->stitch.site;
    s->context = s->site.rig.context;
    s->scene = s->site.rig.scene;
    TRY(result);
    s->floor = s->site.floor;
    s->middle = v3(0.0, 0.0, 0.02);
    take_tool(s, LEFT, &s->stitch.left);
    take_tool(s, RIGHT, &s->stitch.right);
    TRY(task_create(&of_surgeon, &s->stitch, NULL, NULL));
    s->session = of_surgeon.session;
    return VBSS_OK;
}

/* ---- an exercise, in the same scene */

static void take_tool_as_it_is(stage *s, int side, const hand *h)
{
    vbss_grasper_state now;
    take_tool(s, side, h);
    if (vbss_grasper_get_state(h->grasper, &now, sizeof now) == VBSS_OK) {
        s->start[side] = v_load(now.target_position);
    }
}

static const stage_row exercise_row = {
    "exercise", "one skill of the task", create_surgeon, script_stitch, 0.0, 0.0};

/* States are of a scene with the usual budgets, which change when it is restored. */
static vbss_result begin_exercise(stage *s, const start_states *states)
{
    const surgeon_options usual = {.seed = 0};
    const vbss_solver_options *o = &s->solver;
    stitch_plan plan;
    task of_exercise;
    surgeon_plan(&usual, &plan);
    vbss_result result = stitch_create(&s->stitch, 0, &plan);
    s->site = s->stitch.site;
    s->context = s->site.rig.context;
    s->scene = s->site.rig.scene;
    TRY(result);
    s->floor = s->site.floor;
    s->middle = v3(0.0, 0.0, 0.02);
    TRY(practice_begin(&of_exercise, &s->stitch, s->exercise, states));
    s->session = of_exercise.session;
    take_tool_as_it_is(s, LEFT, &s->stitch.left);
    take_tool_as_it_is(s, RIGHT, &s->stitch.right);
    return vbss_scene_set_budgets(s->scene, o->step_budget_us, o->call_budget_us,
                                  o->operations_per_us);
}

static void begin_stage(stage *s, const stage_row *row, const vbss_solver_options *solver)
{
    memset(s, 0, sizeof *s);
    s->solver = solver != NULL ? *solver : vbss_solver_options_default();
    s->solver.call_budget_us = solver != NULL ? s->solver.call_budget_us : FIXED_CALL;
    s->row = row;
}

vbss_result stage_create_exercise(stage *s, vbss_session_exercise exercise,
                                  const start_states *states, const vbss_solver_options *solver)
{
    begin_stage(s, &exercise_row, solver);
    s->exercise = exercise;
    return begin_exercise(s, states);
}

bool stage_has_outcome(const stage *s, vbss_session_exercise_state *state)
{
    return s->exercise != VBSS_SESSION_EXERCISE_NONE &&
           vbss_session_get_exercise(s->session, state, sizeof *state) == VBSS_OK &&
           state->outcome != VBSS_SESSION_OUTCOME_NONE;
}

/* ---- the table */

static const stage_row rows[] = {
    {"stitch", "the task: a drain, a needle on the floor, its thread", create_stitch, script_stitch,
     0.0, 0.0},
    {"surgeon", "the same with the scripted surgeon's tools, for his logs", create_surgeon,
     script_stitch, 0.0, 0.0},
    {"table", "light: a needle on a table, to try arms, handles and solenoids", create_table,
     script_table, FIRST, EVERY},
};

const stage_row *stage_at(size_t number)
{
    return number < sizeof rows / sizeof *rows ? &rows[number] : NULL;
}

const stage_row *stage_find(const char *name)
{
    for (size_t i = 0; stage_at(i) != NULL; i++) {
        if (strcmp(rows[i].name, name) == 0) {
            return &rows[i];
        }
    }
    return NULL;
}

vbss_result stage_create(stage *s, const stage_row *row, unsigned long seed,
                         const vbss_solver_options *solver)
{
    begin_stage(s, row, solver);
    s->seed = seed;
    return row->create(s);
}

vbss_result stage_step(stage *s, double h)
{
    return s->session != NULL ? vbss_session_step(s->session, 0.0, h)
                              : vbss_scene_step(s->scene, h);
}

const char *stage_phase(const stage *s)
{
    static const char *const names[] = {
        "idle",    "loading",  "approach", "in the drain", "pull through", "throw 1", "transfer",
        "throw 2", "transfer", "throw 3",  "cut",          "done",         "failed"};
    vbss_session_status status;
    if (s->session == NULL ||
        vbss_session_get_status(s->session, &status, sizeof status) != VBSS_OK) {
        return "";
    }
    return names[status.phase];
}

static void report_lost_time(const stage *s)
{
    vbss_scene_statistics c;
    if (vbss_scene_get_statistics(s->scene, &c, sizeof c) == VBSS_OK && c.time > 0.0) {
        printf("left out by the limits of work: %.3f s of %.3f s (%.1f %%); %u steps finished "
               "beyond the limit of a call\n",
               c.time_paused, c.time, 100.0 * c.time_paused / c.time, (unsigned)c.overdue);
    }
}

static void report_exercise(const stage *s)
{
    vbss_session_exercise_state e;
    vbss_session_measure m;
    char words[PRACTICE_LINE];
    bool has_ended = stage_has_outcome(s, &e);
    if (s->exercise == VBSS_SESSION_EXERCISE_NONE) {
        return;
    }
    printf("exercise %s: %s after %.1f s%s\n", e.name,
           !has_ended                                 ? "not ended"
           : e.outcome == VBSS_SESSION_OUTCOME_PASSED ? "PASSED"
                                                      : "not passed",
           e.time, e.aids_used != 0 ? ", with aids" : "");
    for (uint32_t i = 0; i < e.measure_count; i++) {
        if (vbss_session_get_measure(s->session, i, &m, sizeof m) == VBSS_OK) {
            practice_words(&m, words);
            printf("  %s %s\n", m.is_met != 0 ? "good" : "    ", words);
        }
    }
}

void stage_report(const stage *s)
{
    report_lost_time(s);
    report_exercise(s);
    vbss_session_status now;
    vbss_session_event e;
    char words[TASK_WORDS];
    if (s->session == NULL || vbss_session_get_status(s->session, &now, sizeof now) != VBSS_OK) {
        return;
    }
    for (uint64_t i = now.first_event; i < now.event_count; i++) {
        if (vbss_session_get_event(s->session, i, &e, sizeof e) == VBSS_OK &&
            e.kind != VBSS_SESSION_EVENT_STAGE) { /* which come and go while hands wind */
            task_words(&e, words);
            printf("%.3f s  %s\n", e.time, words);
        }
    }
    printf("task: %s%s%s, throws %u, seated %u, transfers %u, tails cut %u, slit %.2f mm\n",
           task_phase_name(now.phase), now.failure != VBSS_SESSION_FAILURE_NONE ? ": " : "",
           now.failure != VBSS_SESSION_FAILURE_NONE ? task_failure_name(now.failure) : "",
           (unsigned)now.throws, (unsigned)now.seated, (unsigned)now.transfers,
           (unsigned)((now.cut & 1u) + (now.cut >> 1u)), 1e3 * now.gap);
}

uint64_t stage_closings(const stage_row *row, double time)
{
    return row->closings_every > 0.0 && time > row->closings_begin
               ? 1 + (uint64_t)((time - row->closings_begin) / row->closings_every)
               : 0;
}

void stage_destroy(stage *s)
{
    if (s->context != NULL) {
        (void)vbss_context_destroy(s->context);
        s->context = NULL;
    }
}
