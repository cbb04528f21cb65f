#include "scenes/wrap_scripts.h"

#include "scenes/wrap_path.h"

typedef enum story {
    WRAP_TABLE, /* w = -3, -2.5, ... 3, towards the tip and towards the handle */
    SECOND,     /* on 2: 1 of the other hand */
    THIRD,      /* on 2=1 */
    BOTH_PULLED,
    ONE_PULLED,
    SAME_HAND, /* on 2: 1 of the same hand: 2x1 */
    TO_HANDLE,
    BIGHT,
    DROPPED,
    BACKS_OUT,
    COUNTER_WRAP,
    BEYOND_TIP,
    ON_FLOOR,
    UNWRAPPED, /* N goes back */
    WITHDRAWN  /* formed, then the needle is drawn back through the throw and the drain */
} story;

/* Variants beyond these repeat: bit 0: handedness; bit 1: a turn more. */
const wrap_script wrap_scripts[WRAP_SCRIPTS] = {
    [WRAP_TABLE] = {"wrap table", 26, false},
    [SECOND] = {"second throw", 2, true},
    [THIRD] = {"third throw", 2, true},
    [BOTH_PULLED] = {"both limbs pulled", 4, true},
    [ONE_PULLED] = {"one limb pulled", 4, false},
    [SAME_HAND] = {"same hand again", 2, false},
    [TO_HANDLE] = {"wraps towards the handle", 4, false},
    [BIGHT] = {"bight of the tail", 4, false},
    [DROPPED] = {"tail dropped", 4, false},
    [BACKS_OUT] = {"tail backs out", 4, false},
    [COUNTER_WRAP] = {"counter-wrap", 2, false},
    [BEYOND_TIP] = {"loop beyond the tip", 4, false},
    [ON_FLOOR] = {"loop on the floor", 4, false},
    [UNWRAPPED] = {"needle goes back", 4, false},
    [WITHDRAWN] = {"needle withdrawn", 4, false},
};

/* How far t has gone from one moment to another, 0 to 1, smoothly. */
static double part(double t, double from, double to)
{
    double s = vbss_min(vbss_max((t - from) / (to - from), 0.0), 1.0);
    return s * s * (3.0 - 2.0 * s);
}

static double mix(double a, double b, double share)
{
    return a + share * (b - a);
}

/* ---- acts */

/* Moments. */
#define WOUND 0.35
#define GRASPED 0.45
#define DRAWN 0.75
#define PULLED 0.9

#define CLEAR 24e-3      /* along the axis: the jaws in the end */
#define JAW_OF_W (-7e-3) /* W's tip while it is wound about */
#define LOOSE 2.5e-3     /* radius of loops */
#define TIGHT 0.8e-3

typedef struct scene {
    wrap_state state;
    double tip;     /* of W along the axis */
    bool holds;     /* the tail */
    bool no_tissue; /* the thread has left it */
    double full;    /* turns in the end */
} scene;

static void add_below(knot_pile *pile, int wraps, int sign)
{
    pile->wraps[pile->throws] = wraps;
    pile->signs[pile->throws++] = sign;
}

static void choose_story(story which, uint32_t variant, scene *s)
{
    wrap_state *state = &s->state;
    double hand = variant % 2 == 0 ? 1.0 : -1.0;
    int below = hand > 0.0 ? 1 : -1; /* positive turns tie left-handed: the other hand */
    s->full = hand * (variant / 2 % 2 == 0 ? 1.5 : 2.5);
    if (which == WRAP_TABLE) {
        s->full = 0.5 * (variant % 13) - 3.0;
        state->to_handle = variant / 13 % 2 == 1;
    } else if (which == SECOND || which == SAME_HAND) {
        s->full = hand * 1.5;
        add_below(&state->below, 2, which == SECOND ? below : -below);
    } else if (which == THIRD) {
        s->full = hand * 1.5;
        add_below(&state->below, 2, -below);
        add_below(&state->below, 1, below);
    } else if (which == TO_HANDLE) {
        state->to_handle = true;
    } else if (which == COUNTER_WRAP) {
        s->full = 0.0;
        state->there_and_back = hand;
    }
}

/* Which thread it would be without a story's fault. */
static void usual(double t, scene *s)
{
    wrap_state *state = &s->state;
    state->turns = s->full * part(t, 0.0, WOUND);
    state->there_and_back *= part(t, 0.0, WOUND);
    state->lift = part(t, WOUND, GRASPED);
    double drawn = part(t, GRASPED, DRAWN);
    state->jaws = mix(WRAP_RISE - 1e-3, CLEAR, drawn);
    state->hanging = 4e-3;
    state->swing = part(t, DRAWN + 0.02, PULLED - 0.06);
    state->pulled = part(t, DRAWN, PULLED);
    state->radius = mix(LOOSE, TIGHT, part(t, DRAWN + 0.02, PULLED));
    state->limb_left = 1.0;
    s->holds = t >= GRASPED && t < DRAWN + 0.02;
    double reaching = mix(JAW_OF_W, WRAP_RISE - 1e-3, part(t, WOUND, GRASPED));
    s->tip = t < GRASPED ? reaching : state->jaws + 20e-3 * part(t, DRAWN + 0.02, PULLED);
}

static void slip_back(double t, double from, double to, double there, scene *s)
{
    s->state.jaws = mix(there, WRAP_RISE, part(t, from, to));
    s->state.swing = 0.0;
}

static void spoil(story which, double t, scene *s)
{
    wrap_state *state = &s->state;
    if (which == BIGHT) {
        state->hanging = 45e-3;
        state->swing = 0.0;
        state->radius = LOOSE;
    } else if (which == DROPPED && t >= 0.5) {
        s->holds = t < 0.6;
        slip_back(t, 0.75, 0.95, mix(WRAP_RISE - 1e-3, 1e-3, part(t, GRASPED, 0.6)), s);
        s->tip = mix(WRAP_RISE - 1e-3, CLEAR, part(t, GRASPED, 0.75));
        s->tip = t < 0.6 ? state->jaws : vbss_max(s->tip, state->jaws);
        state->pulled = 0.0;
        state->radius = LOOSE;
    } else if (which == BACKS_OUT && t >= DRAWN) {
        slip_back(t, 0.8, 1.0, CLEAR, s);
        state->pulled = 0.0;
        state->radius = LOOSE;
    } else if (which == BEYOND_TIP || which == ON_FLOOR) {
        s->holds = false;
        s->tip = which == BEYOND_TIP ? WRAP_LOOPS + 6e-3 : 45e-3;
        state->lift = state->pulled = state->swing = 0.0;
        state->radius = LOOSE;
    } else if (which == UNWRAPPED) {
        state->turns = s->full * (part(t, 0.0, WOUND) - part(t, 0.5, 0.9));
        state->lift = state->pulled = state->swing = 0.0;
        state->radius = LOOSE;
        s->holds = false;
        s->tip = JAW_OF_W;
    } else if (which == WITHDRAWN && t > PULLED) {
        state->limb_left = 1.0 - part(t, PULLED, 0.98);
        s->no_tissue = state->limb_left == 0.0;
    } else if (which == BOTH_PULLED) {
        state->flat = 0.5 * part(t, PULLED, 0.98);
    }
}

static scene stage_scene(story which, uint32_t variant, double t)
{
    scene s = {.full = 0.0};
    choose_story(which, variant, &s);
    usual(t, &s);
    spoil(which, t, &s);
    return s;
}

/* ---- what is true then */

/* Wraps that so many turns tie. */
static int wraps_of(const scene *s)
{
    double turns = fabs(s->state.turns);
    int k = 0;
    while (turns > k + 1.0 + 1e-6) {
        k++;
    }
    return s->state.to_handle ? 0 : k;
}

/* Turns beside W, from its tip on. */
static double turns_beside(const scene *s)
{
    double beside = (WRAP_LOOPS - s->tip) / (2.0 * WRAP_LOOPS);
    return s->state.turns * vbss_min(vbss_max(beside, 0.0), 1.0);
}

static void tell(story which, double t, const scene *s, script_frame *frame)
{
    const wrap_state *state = &s->state;
    bool lifted = state->lift >= 1.0, bight = which == BIGHT;
    double end = state->jaws - (state->hanging < 10e-3 ? state->hanging : 100e-3);
    bool in_loops = lifted && state->jaws > -WRAP_LOOPS - 3e-3 && end < WRAP_LOOPS + 1e-3;
    bool clear = lifted && end >= WRAP_LOOPS + 1e-3;
    int wraps = wraps_of(s);
    frame->turns = turns_beside(s);
    frame->sense = frame->turns == 0.0 ? 0 : state->to_handle ? -1 : 1;
    frame->throws = state->below.throws;
    for (uint32_t i = 0; i < frame->throws; i++) {
        frame->throw_wraps[i] = state->below.wraps[i];
        frame->throw_signs[i] = state->below.signs[i];
    }
    frame->stage = fabs(frame->turns) > 0.5 ? SCRIPT_WRAPPING : SCRIPT_NOTHING;
    if (bight && lifted) {
        wraps = 0; /* it comes out again */
        frame->stage = s->holds ? frame->stage : SCRIPT_NOTHING;
    } else if (in_loops && !s->holds) {
        frame->stage = SCRIPT_OPEN;
    } else if (s->holds && lifted && wraps > 0) {
        frame->stage = SCRIPT_PASSED;
    }
    if (clear && !bight && wraps > 0) {
        frame->stage = SCRIPT_FORMED;
    }
    if (which == WITHDRAWN && t > PULLED) {
        frame->stage = s->no_tissue ? SCRIPT_NOTHING : SCRIPT_OPEN;
    }
    if (frame->stage == SCRIPT_PASSED || frame->stage == SCRIPT_FORMED) {
        frame->wraps = wraps;
        frame->sign = state->turns > 0.0 ? -1 : 1;
    }
    if (frame->stage == SCRIPT_FORMED) {
        frame->throw_wraps[frame->throws] = frame->wraps;
        frame->throw_signs[frame->throws++] = frame->sign;
        frame->slip = state->flat > 0.4 ? 0 : -1;
    }
}

/* ---- the tools */

static void put_tools(const scene *s, double jaws, script_frame *frame)
{
    double z = wrap_axis_height(&s->state);
    const thread_line *line = &frame->line;
    vec3 end = line->x[line->count - 1];
    vec3 out = vec3_unit_or(vec3_sub(end, line->x[line->count - 2]), vec3_zero());
    frame->tools[SCRIPT_N] =
        (script_tool){.points = 2,
                      .axis = {vec3_add_scaled(end, 0.1, out), end},
                      .radius = {1e-3},
                      .held = s->no_tissue ? SCRIPT_HELD_NOTHING : SCRIPT_HELD_NEEDLE};
    frame->tools[SCRIPT_W] =
        (script_tool){.points = 3,
                      .axis = {vec3_make(s->tip + 0.15, 0.0, z), vec3_make(s->tip + 10e-3, 0.0, z),
                               vec3_make(s->tip, 0.0, z)},
                      .radius = {1.5e-3, 1e-3},
                      .held = s->holds ? SCRIPT_HELD_THREAD : SCRIPT_HELD_NOTHING,
                      .held_place = s->holds ? jaws : 0.0};
}

bool wrap_script_frame(uint32_t script, uint32_t variant, double t, uint32_t segments,
                       script_frame *frame)
{
    if (script >= WRAP_SCRIPTS || !(t >= 0.0 && t <= 1.0)) {
        return false;
    }
    scene s = stage_scene((story)script, variant, t);
    double jaws = 0.0;
    *frame = (script_frame){.stage = SCRIPT_NOTHING};
    if (!wrap_path(&s.state, segments, &frame->line, &jaws)) {
        return false;
    }
    if (s.no_tissue) {
        thread_line_leave_tissue(&frame->line);
    }
    put_tools(&s, jaws, frame);
    tell((story)script, t, &s, frame);
    return true;
}
