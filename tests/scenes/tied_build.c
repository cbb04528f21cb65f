#include "scenes/tied_build.h"

#include "base/error.h"

/* knot_make's loop passes the cylinder at so many sums of both radii; here it passes it by so much, m. */
#define LOOP_SHARE 1.4
#define LOOP_CLEARANCE 0.1e-3
/* knot_make's turns, in sizes; a peg fills so much of one and reaches so far to either side, m. */
#define TURN_RADIUS 1.2
#define PEG_SHARE 0.75
#define PEG_CLEARANCE 0.05e-3
#define PEG_REACH 3e-3

/* ---- the line */

/* On its way from an end to the loop the line is furthest from the middle plane where it turns above a throw.
 * Fills the nodes from the top down; returns how many. */
static uint32_t find_turns(const tied_knot *knot, int k, const vec3 *x, uint32_t *turns)
{
    uint32_t count = 0, middle = (knot->line.knot_first + knot->line.knot_last) / 2;
    uint32_t i = k == 0 ? knot->line.knot_first + 1 : knot->line.knot_last - 1;
    for (; i != middle && count < TIED_KNOT_THROWS - 1; i = next_node(k, i, true)) {
        double before = fabs(x[next_node(k, i, false)].x), after = fabs(x[next_node(k, i, true)].x);
        if (x[i].z > 0.0 && fabs(x[i].x) > before && fabs(x[i].x) >= after) {
            turns[count++] = i;
        }
    }
    return count;
}

static void choose_nodes(tied_knot *knot, const vec3 *x)
{
    knot_kind kind = knot->options.knot.kind;
    bool hitches = kind == KNOT_HALF_HITCHES || kind == KNOT_REVERSED_HALF_HITCHES;
    for (int k = 0; k < 2; k++) {
        uint32_t turns[TIED_KNOT_THROWS] = {0};
        uint32_t count = hitches ? 0 : find_turns(knot, k, x, turns);
        for (uint32_t i = 0; i < count; i++) {
            knot->nodes[i][k] = turns[count - 1 - i];
        }
        knot->nodes[count][k] = end_node(knot, k);
        knot->throws = count + 1;
    }
}

/* Where the arc through a node and its neighbours is furthest out. */
static vec3 crest(const vec3 *x)
{
    double bend = x[-1].x - 2.0 * x[0].x + x[1].x;
    double t = 0.5 * (x[-1].x - x[1].x) / bend;
    vec3 middle = vec3_add_scaled(x[0], 0.5 * t, vec3_sub(x[1], x[-1]));
    middle.x = x[0].x - 0.5 * bend * t * t;
    return middle;
}

static void choose_pegs(tied_knot *knot, const vec3 *x)
{
    double thread = knot->options.thread.radius;
    knot->peg_radius = PEG_SHARE * (TURN_RADIUS * knot->options.knot.size - thread);
    for (int k = 0; k < TIED_KNOT_PEGS; k++) {
        vec3 at = crest(&x[knot->nodes[1][k]]);
        double in = thread + knot->peg_radius + PEG_CLEARANCE;
        at.x += at.x > 0.0 ? -in : in;
        knot->peg_homes[k] = at;
    }
}

static vbss_result make_thread(vbss_context *context, tied_knot *knot)
{
    vec3 x[KNOT_NODES];
    double rest[KNOT_NODES];
    vbss_thread_config config = knot->options.thread;
    knot_shape shape = knot->options.knot;
    shape.thread_radius = config.radius;
    shape.cylinder_radius =
        (shape.cylinder_radius + config.radius + LOOP_CLEARANCE) / LOOP_SHARE - config.radius;
    shape.rest = config.bending == VBSS_BENDING_SPLINE ? KNOT_REST_ARCS : KNOT_REST_CHORDS;
    VBSS_TRY(knot_make(&shape, KNOT_NODES, x, rest, &knot->line));
    knot->node_count = knot->line.node_count;
    for (uint32_t i = 0; i + 1 < knot->node_count; i++) {
        knot->length += rest[i];
    }
    choose_nodes(knot, x);
    if (knot->throws > 2) {
        choose_pegs(knot, x);
    }
    config.segment_count = knot->node_count - 1;
    config.rest_lengths = rest;
    config.positions = &x[0].x;
    return vbss_thread_create(context, &config, &knot->thread);
}

/* ---- what it is tied round and held open by */

static vbss_result add_rod(tied_knot *knot, vec3 at, vec3 begin, vec3 end, double radius,
                           double friction, uint32_t *body)
{
    vbss_rigid_config config;
    vbss_capsule c = {.radius = radius};
    vec3_store(c.begin, begin);
    vec3_store(c.end, end);
    VBSS_TRY(vbss_rigid_config_init(&config, sizeof config));
    config.capsules = &c;
    config.capsule_count = 1;
    config.friction = friction;
    vec3_store(config.position, at);
    return vbss_scene_add_rigid(knot->scene, &config, body);
}

static vbss_result add_rods(tied_knot *knot)
{
    const tied_knot_options *o = &knot->options;
    vec3 reach = vec3_make(0.0, PEG_REACH, 0.0);
    if (o->knot.cylinder) {
        VBSS_TRY(add_rod(knot, vec3_zero(), knot->line.cylinder_begin, knot->line.cylinder_end,
                         o->knot.cylinder_radius, o->cylinder_friction, &knot->cylinder_body));
    }
    for (int k = 0; k < TIED_KNOT_PEGS && knot->peg_radius > 0.0; k++) {
        VBSS_TRY(add_rod(knot, knot->peg_homes[k], vec3_neg(reach), reach, knot->peg_radius,
                         o->peg_friction, &knot->peg_bodies[k]));
    }
    return VBSS_OK;
}

vbss_result tied_build(vbss_context *context, tied_knot *knot)
{
    VBSS_TRY(make_thread(context, knot));
    VBSS_TRY(vbss_scene_create(context, &knot->options.scene, &knot->scene));
    VBSS_TRY(vbss_scene_add_thread(knot->scene, knot->thread, &knot->thread_body));
    return add_rods(knot);
}
