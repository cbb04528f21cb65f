#include "ghost/ghost.h"

#include <math.h>
#include <string.h>

#include "throw/rig.h"

#define LEAD 0.015   /* m: so far ahead of the trainee's tool a ghost's goes */
#define MOVING 0.002 /* m in AHEAD: a tool that goes less does not lead */
#define AHEAD 0.5    /* s */
#define PATIENCE \
    2.0 /* s of waiting: then it goes where its path is nearest to the trainee's tool */

#define LONGEST 0.1 /* s, of a step of their scene: after a longer pause the jaws are late */

/* ---- made */

static vbss_result add_tool(ghost *g, vbss_context *context, int side,
                            const vbss_grasper_config *shape)
{
    vbss_grasper_config c = *shape;
    uint32_t body;
    c.method = VBSS_METHOD_VBLAST;
    c.has_trocar = 0; /* the poses of the track have it in them */
    c.kind = VBSS_GRASPER_KIND_NEEDLE_DRIVER;
    TRY(vbss_grasper_create(context, &c, &g->graspers[side]));
    return vbss_scene_add_grasper(g->scene, g->graspers[side], &body);
}

vbss_result ghost_create(ghost *g, const ghost_track *track, vbss_context *context,
                         const vbss_grasper_config shapes[GHOST_SIDES], vbss_visual *visual)
{
    vbss_scene_config c;
    memset(g, 0, sizeof *g);
    g->track = track;
    g->visual = visual;
    g->phase = -1;
    TRY(vbss_scene_config_init(&c, sizeof c));
    c.method = VBSS_METHOD_VBLAST;
    c.thread_capacity = c.drain_capacity = c.pin_capacity = 0;
    c.rigid_capacity = GHOST_SIDES;
    TRY(vbss_scene_create(context, &c, &g->scene));
    TRY(add_tool(g, context, 0, &shapes[0]));
    return add_tool(g, context, 1, &shapes[1]);
}

/* ---- from the track's scene to the trainee's: a shift, and a turn about the vertical */

/* Direction from above, rad: of the needle's x axis, or from mark to mark. */
static double heading(const ghost_scene *s, bool by_needle)
{
    const double *q = s->needle + 3;
    return by_needle ? atan2(2.0 * (q[1] * q[2] + q[0] * q[3]),
                             q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3])
                     : atan2(s->marks[1][1] - s->marks[0][1], s->marks[1][0] - s->marks[0][0]);
}

static void centre(const ghost_scene *s, bool by_needle, double at[3])
{
    for (int i = 0; i < 3; i++) {
        at[i] = by_needle ? s->needle[i] : 0.5 * (s->marks[0][i] + s->marks[1][i]);
    }
}

/* Who takes the needle goes where it lies; everything else is done at the marks. */
static void align(ghost *g, const ghost_seen *seen)
{
    const ghost_scene *then = &g->track->phases[g->phase].scene;
    const bool by_needle = g->phase <= VBSS_SESSION_PHASE_LOADING;
    const double turn = heading(&seen->scene, by_needle) - heading(then, by_needle);
    g->cosine = cos(turn);
    g->sine = sin(turn);
    centre(then, by_needle, g->from);
    centre(&seen->scene, by_needle, g->to);
}

static void place_in_scene(const ghost *g, ghost_pose *p)
{
    const double x = p->position[0] - g->from[0], y = p->position[1] - g->from[1];
    /* half the turn, about z */
    const double w = sqrt(fmax(0.5 * (1.0 + g->cosine), 0.0));
    const double z = copysign(sqrt(fmax(0.5 * (1.0 - g->cosine), 0.0)), g->sine);
    const double q[4] = {p->orientation[0], p->orientation[1], p->orientation[2],
                         p->orientation[3]};
    p->position[0] = g->to[0] + g->cosine * x - g->sine * y;
    p->position[1] = g->to[1] + g->sine * x + g->cosine * y;
    p->position[2] += g->to[2] - g->from[2];
    p->orientation[0] = w * q[0] - z * q[3];
    p->orientation[1] = w * q[1] - z * q[2];
    p->orientation[2] = w * q[2] + z * q[1];
    p->orientation[3] = w * q[3] + z * q[0];
}

/* ---- along the track */

static const ghost_phase *phase_of(const ghost *g)
{
    return g->phase >= 0 && g->phase < GHOST_PHASES ? &g->track->phases[g->phase] : NULL;
}

/* A tool, that long after the beginning of the phase. */
static void pose_at(const ghost *g, int side, double time, ghost_pose *p)
{
    const ghost_phase *phase = phase_of(g);
    const double place = fmin(fmax(time / GHOST_INTERVAL, 0.0), (double)(phase->count - 1));
    const uint32_t row = (uint32_t)place, next = row + 1 < phase->count ? row + 1 : row;
    const double share = place - row;
    const ghost_pose *a = &g->track->rows[phase->first + row][side];
    const ghost_pose *b = &g->track->rows[phase->first + next][side];
    double dot = 0.0;
    for (int i = 0; i < 4; i++) {
        dot += a->orientation[i] * b->orientation[i];
    }
    *p = *a;
    for (int i = 0; i < 3; i++) {
        p->position[i] += share * (b->position[i] - a->position[i]);
    }
    for (int i = 0; i < 4; i++) {
        p->orientation[i] += share * (copysign(1.0, dot) * b->orientation[i] - a->orientation[i]);
    }
    p->opening += share * (b->opening - a->opening);
    place_in_scene(g, p);
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* The sides, as bits, whose tool goes on from here and has the trainee's too far behind it. */
static unsigned sides_behind(const ghost *g, const ghost_seen *seen)
{
    unsigned sides = 0;
    for (int side = 0; side < GHOST_SIDES; side++) {
        ghost_pose now, soon;
        pose_at(g, side, g->time, &now);
        pose_at(g, side, g->time + AHEAD, &soon);
        if (distance(now.position, soon.position) > MOVING &&
            distance(now.position, seen->tips[side]) > LEAD) {
            sides |= 1U << side;
        }
    }
    return sides;
}

/* The time of the phase at which the tools of those sides are nearest to the trainee's: any before, or a little later, so that no
 * turn about the other jaws is left out. */
static double nearest_time(const ghost *g, const ghost_seen *seen, unsigned sides)
{
    const double last = fmin(g->time + PATIENCE, GHOST_INTERVAL * (phase_of(g)->count - 1));
    double nearest = HUGE_VAL, time = g->time;
    for (uint32_t row = 0; GHOST_INTERVAL * row <= last; row++) {
        double apart = 0.0;
        for (int side = 0; side < GHOST_SIDES; side++) {
            ghost_pose tool;
            pose_at(g, side, GHOST_INTERVAL * row, &tool);
            apart += (sides >> side & 1U) != 0 ? distance(tool.position, seen->tips[side]) : 0.0;
        }
        if (apart < nearest) {
            nearest = apart;
            time = GHOST_INTERVAL * row;
        }
    }
    return time;
}

/* At most a row. */
static void advance(ghost *g, const ghost_seen *seen, double seconds)
{
    const unsigned sides = sides_behind(g, seen);
    if (sides == 0) {
        g->time = fmin(g->time + seconds, GHOST_INTERVAL * (phase_of(g)->count - 1));
        g->waited = 0.0;
        return;
    }
    g->waited += seconds;
    if (g->waited > PATIENCE) {
        g->time = nearest_time(g, seen, sides);
        g->waited = 0.0;
    }
}

void ghost_again(ghost *g)
{
    g->time = g->waited = 0.0;
}

/* ---- shown */

vbss_result ghost_hide(ghost *g)
{
    const uint32_t source = g->source;
    g->source = 0;
    return source != 0 ? vbss_visual_remove(g->visual, source) : VBSS_OK;
}

static vbss_result put_tool(const ghost *g, int side)
{
    const ghost_pose *p = &g->poses[side];
    vbss_grasper_state now;
    TRY(vbss_grasper_get_state(g->graspers[side], &now, sizeof now));
    if (now.kind != p->kind) {
        TRY(vbss_grasper_exchange(g->graspers[side], p->kind));
    }
    TRY(vbss_grasper_set_target(g->graspers[side], p->position, p->orientation));
    return vbss_grasper_set_opening(g->graspers[side], p->opening);
}

static vbss_result show(ghost *g, double seconds)
{
    pose_at(g, 0, g->time, &g->poses[0]);
    pose_at(g, 1, g->time, &g->poses[1]);
    TRY(put_tool(g, 0));
    TRY(put_tool(g, 1));
    TRY(vbss_scene_step(g->scene, fmin(seconds, LONGEST)));
    return g->source == 0 ? vbss_visual_add_scene(g->visual, g->scene, &g->source) : VBSS_OK;
}

vbss_result ghost_step(ghost *g, const ghost_seen *seen, double seconds)
{
    const bool is_new = seen->phase != g->phase;
    g->phase = seen->phase;
    if (phase_of(g) == NULL || phase_of(g)->count == 0) {
        return ghost_hide(g);
    }
    if (is_new) {
        ghost_again(g);
        align(g, seen);
    } else if (g->source != 0) {
        const int parts = (int)ceil(seconds / GHOST_INTERVAL);
        for (int i = 0; i < parts; i++) {
            advance(g, seen, seconds / parts);
        }
    }
    return show(g, seconds);
}
