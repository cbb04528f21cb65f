#include "scenes/contact_build.h"

#include "base/elementary.h"
#include "base/error.h"

enum { MOST_NODES = 2048 };
#define PI 3.14159265358979324

/* A thread as it is being laid out. */
typedef struct layout {
    uint32_t count; /* nodes */
    vec3 x[MOST_NODES];
    double rest[MOST_NODES]; /* from each node to the next */
} layout;

/* ---- what all have */

static vbss_result add_thread(vbss_context *context, contact_scene *scene, const layout *from)
{
    vbss_thread_config config = scene->options.thread;
    uint32_t k = scene->thread_count;
    config.segment_count = from->count - 1;
    config.rest_lengths = from->rest;
    config.positions = &from->x[0].x;
    VBSS_TRY(vbss_thread_create(context, &config, &scene->threads[k]));
    scene->nodes[k] = from->count;
    scene->thread_count++;
    return vbss_scene_add_thread(scene->scene, scene->threads[k], &scene->thread_bodies[k]);
}

static double length_of(const layout *from)
{
    double length = 0.0;
    for (uint32_t i = 0; i + 1 < from->count; i++) {
        length += from->rest[i];
    }
    return length;
}

/* Both ends of the thread made last. */
static vbss_result take_ends(contact_scene *scene, const layout *from, vec3 first, vec3 last)
{
    uint32_t k = scene->thread_count - 1;
    double give = scene->options.thread.axial_stiffness / length_of(from);
    bool waits = contact_hand_scene_waits(&scene->options.scene);
    vbss_result result = contact_hand_take(&scene->hands[scene->hand_count++], scene->threads[k], 0,
                                           first, &scene->options.pull, give, waits);
    return result != VBSS_OK
               ? result
               : contact_hand_take(&scene->hands[scene->hand_count++], scene->threads[k],
                                   from->count - 1, last, &scene->options.pull, give, waits);
}

static vbss_capsule rod(vec3 begin, vec3 end, double radius)
{
    vbss_capsule c = {.radius = radius};
    vec3_store(c.begin, begin);
    vec3_store(c.end, end);
    return c;
}

/* In a frame like the world's. */
static vbss_result add_tool(contact_scene *scene, vbss_rigid_kind kind, vec3 at,
                            const vbss_capsule *capsules, uint32_t count)
{
    vbss_rigid_config config;
    VBSS_TRY(vbss_rigid_config_init(&config, sizeof config));
    config.kind = kind;
    config.capsules = capsules;
    config.capsule_count = count;
    config.friction = scene->options.tool_friction;
    vec3_store(config.position, at);
    bool thrown = scene->options.kind == CONTACT_SCENE_STRUCK;
    config.velocity[2] = thrown && kind == VBSS_RIGID_FREE ? scene->options.tool_speed : 0.0;
    config.gravity[1] = !thrown && kind == VBSS_RIGID_FREE ? -9.81 : 0.0;
    uint32_t k = scene->tool_count++;
    scene->tool_homes[k] = at;
    return vbss_scene_add_rigid(scene->scene, &config, &scene->tools[k]);
}

/* ---- knots */

static vbss_result lay_knot(contact_scene *scene, layout *to)
{
    knot_shape shape = scene->options.knot;
    shape.thread_radius = scene->options.thread.radius;
    bool arcs = scene->options.thread.bending == VBSS_BENDING_SPLINE;
    shape.rest = arcs ? KNOT_REST_ARCS : KNOT_REST_CHORDS;
    VBSS_TRY(knot_make(&shape, MOST_NODES, to->x, to->rest, &scene->line));
    to->count = scene->line.node_count;
    return VBSS_OK;
}

static vec3 along_x(double sign)
{
    return vec3_make(sign, 0.0, 0.0);
}

vbss_result contact_build_knot(vbss_context *context, contact_scene *scene)
{
    layout l;
    const contact_scene_options *o = &scene->options;
    VBSS_TRY(lay_knot(scene, &l));
    VBSS_TRY(add_thread(context, scene, &l));
    VBSS_TRY(take_ends(scene, &l, along_x(-1.0), along_x(1.0)));
    if (o->knot.cylinder) {
        vbss_capsule c =
            rod(scene->line.cylinder_begin, scene->line.cylinder_end, scene->line.cylinder_radius);
        return add_tool(scene, VBSS_RIGID_DRIVEN, vec3_zero(), &c, 1);
    }
    if (o->kind == CONTACT_SCENE_STRUCK) {
        vec3 end = vec3_make(0.0, 0.02, 0.0);
        vbss_capsule c = rod(vec3_neg(end), end, o->tool_radius);
        /* One that flies is there in time in steps of a millisecond. */
        double thrown = o->tool == VBSS_RIGID_FREE ? 1e-3 * o->begin * o->tool_speed : 0.0;
        return add_tool(scene, o->tool, vec3_make(0.0, 0.0, -CONTACT_STRIKE_AWAY - thrown), &c, 1);
    }
    return VBSS_OK;
}

/* The rods are where a cylinder was that the knot is tied round. */
vbss_result contact_build_pulled_open(vbss_context *context, contact_scene *scene)
{
    layout l;
    VBSS_TRY(lay_knot(scene, &l));
    VBSS_TRY(add_thread(context, scene, &l));
    double apart = scene->line.cylinder_radius - scene->options.tool_radius;
    vbss_capsule c =
        rod(scene->line.cylinder_begin, scene->line.cylinder_end, scene->options.tool_radius);
    VBSS_TRY(add_tool(scene, VBSS_RIGID_DRIVEN, along_x(-apart), &c, 1));
    return add_tool(scene, VBSS_RIGID_DRIVEN, along_x(apart), &c, 1);
}

vbss_result contact_build_many_knots(vbss_context *context, contact_scene *scene)
{
    layout one, all = {.count = 0};
    vec3 begin = vec3_zero();
    VBSS_TRY(lay_knot(scene, &one));
    for (uint32_t k = 0; k < scene->options.knots; k++) {
        if (all.count + one.count > MOST_NODES) {
            return VBSS_ERROR_CAPACITY;
        }
        vec3 shift = vec3_sub(begin, one.x[0]);
        all.count -= k > 0; /* the last node is the first of the next */
        for (uint32_t i = 0; i < one.count; i++) {
            all.x[all.count] = vec3_add(one.x[i], shift);
            all.rest[all.count++] = one.rest[i];
        }
        begin = all.x[all.count - 1];
    }
    VBSS_TRY(add_thread(context, scene, &all));
    return take_ends(scene, &all, along_x(-1.0), along_x(1.0));
}

/* ---- curves by formula, in steps of one length */

typedef vec3 (*curve)(double s, const contact_scene_options *options);

/* The chord is the rest length: nearly that of the arc. */
static void lay_curve(const contact_scene_options *o, curve at, double length, layout *to)
{
    double segments = floor(length / o->knot.finest + 0.5), l = length / segments;
    to->count = (uint32_t)segments + 1;
    for (uint32_t i = 0; i < to->count; i++) {
        to->x[i] = at(l * i, o);
        to->rest[i] = l;
    }
    for (uint32_t i = 0; i + 1 < to->count; i++) {
        to->rest[i] = vec3_distance(to->x[i], to->x[i + 1]);
    }
}

#define BIGHT_RADIUS 3e-3
#define BIGHT_LEG 0.025

/* A bight open to -x, in the plane of x and y, whose end is 1.5 mm beyond the origin. */
static vec3 bight(double s, const contact_scene_options *options)
{
    (void)options;
    double bend = PI * BIGHT_RADIUS, middle = 1.5e-3 - BIGHT_RADIUS;
    if (s < BIGHT_LEG) {
        return vec3_make(middle - BIGHT_LEG + s, -BIGHT_RADIUS, 0.0);
    }
    if (s > BIGHT_LEG + bend) {
        return vec3_make(middle - (s - BIGHT_LEG - bend), BIGHT_RADIUS, 0.0);
    }
    double angle = (s - BIGHT_LEG) / BIGHT_RADIUS;
    return vec3_make(middle + BIGHT_RADIUS * vbss_sin(angle), -BIGHT_RADIUS * vbss_cos(angle), 0.0);
}

static vec3 other_bight(double s, const contact_scene_options *options)
{
    vec3 x = bight(s, options);
    return vec3_make(-x.x, 0.0, x.y);
}

vbss_result contact_build_interlocked(vbss_context *context, contact_scene *scene)
{
    static const curve curves[2] = {bight, other_bight};
    layout l;
    for (int k = 0; k < 2; k++) {
        vec3 way = along_x(k == 0 ? -1.0 : 1.0);
        lay_curve(&scene->options, curves[k], 2.0 * BIGHT_LEG + PI * BIGHT_RADIUS, &l);
        VBSS_TRY(add_thread(context, scene, &l));
        VBSS_TRY(take_ends(scene, &l, way, way));
    }
    return VBSS_OK;
}

/* ---- turns round a tool: a shaft along z whose end is a jaw */

#define SHAFT_RADIUS 2.5e-3
#define SHAFT_LENGTH 0.08
#define JAW_LENGTH 0.013
#define TURNS_AT 0.01 /* behind the jaw, where they begin */
#define TAIL 0.03

static double turns_radius(const contact_scene_options *o)
{
    return SHAFT_RADIUS + o->thread.radius + 0.15e-3;
}

/* Comes along x above the shaft, turns, each turn four radii nearer to the jaw, and leaves. */
static vec3 turns(double s, const contact_scene_options *o)
{
    double r = turns_radius(o), rise = 4.0 * o->thread.radius / (2.0 * PI),
           all = 2.0 * PI * o->turns;
    double angle = vbss_min(vbss_max((s - TAIL) / r, 0.0), all);
    double beyond = s - TAIL - r * angle;
    vec3 on = vec3_make(r * vbss_sin(angle), r * vbss_cos(angle), rise * angle - TURNS_AT);
    vec3 ahead = vec3_make(vbss_cos(angle), -vbss_sin(angle), 0.0);
    return vec3_add_scaled(on, beyond, ahead);
}

vbss_result contact_build_sliding_off(vbss_context *context, contact_scene *scene)
{
    layout l;
    const contact_scene_options *o = &scene->options;
    double length = 2.0 * TAIL + 2.0 * PI * o->turns * turns_radius(o);
    lay_curve(o, turns, length, &l);
    VBSS_TRY(add_thread(context, scene, &l));
    vec3 last = vec3_sub(l.x[l.count - 1], l.x[l.count - 2]);
    VBSS_TRY(take_ends(scene, &l, along_x(-1.0), vec3_unit_or(last, along_x(1.0))));
    vbss_capsule tool[2] = {rod(vec3_make(0.0, 0.0, -SHAFT_LENGTH), vec3_zero(), SHAFT_RADIUS),
                            rod(vec3_zero(), vec3_make(0.0, 0.0, JAW_LENGTH), 0.9e-3)};
    return add_tool(scene, VBSS_RIGID_DRIVEN, vec3_zero(), tool, 2);
}

/* ---- a thread that falls */

#define FALL 0.02
#define TOOLS_ABOVE 0.008

static vec3 dropped(double s, const contact_scene_options *o)
{
    double x = s - 0.5 * o->knot.length;
    return vec3_add(o->aside, vec3_make(x, FALL, o->wave * vbss_sin(200.0 * x)));
}

/* A tool across the thread, one along it below that. */
vbss_result contact_build_dropped(vbss_context *context, contact_scene *scene)
{
    layout l;
    const contact_scene_options *o = &scene->options;
    lay_curve(o, dropped, o->knot.length, &l);
    VBSS_TRY(add_thread(context, scene, &l));
    vec3 across = vec3_make(0.0, 0.0, 0.05), along = vec3_make(0.05, 0.0, 0.0);
    vbss_capsule first = rod(vec3_neg(across), across, o->tool_radius);
    vbss_capsule second = rod(vec3_neg(along), along, 0.5 * o->tool_radius);
    VBSS_TRY(add_tool(scene, VBSS_RIGID_DRIVEN, vec3_make(0.0, TOOLS_ABOVE, 0.0), &first, 1));
    return add_tool(scene, VBSS_RIGID_DRIVEN, vec3_make(0.0, 0.5 * TOOLS_ABOVE - 1e-3, 0.0),
                    &second, 1);
}

/* ---- two straight threads */

static vec3 straight(double s, const contact_scene_options *o)
{
    return vec3_make(s - 0.5 * o->knot.length, 0.0, 0.0);
}

static vec3 beside(double s, const contact_scene_options *o)
{
    return vec3_add(straight(s, o), o->aside);
}

vbss_result contact_build_beside(vbss_context *context, contact_scene *scene)
{
    layout l;
    const contact_scene_options *o = &scene->options;
    lay_curve(o, straight, o->knot.length, &l);
    VBSS_TRY(add_thread(context, scene, &l));
    VBSS_TRY(take_ends(scene, &l, along_x(-1.0), along_x(1.0)));
    lay_curve(o, beside, o->knot.length, &l);
    return add_thread(context, scene, &l);
}

/* ---- tools alone */

static vec3 up(double height)
{
    return vec3_make(0.0, height, 0.0);
}

/* A driven rod above a coupled one above a free one above the floor, each across the one below, and a free
 * ball and a free rod that fall beside and onto them. */
vbss_result contact_build_tools(contact_scene *scene)
{
    vec3 x = vec3_make(0.02, 0.0, 0.0), z = vec3_make(0.0, 0.0, 0.02),
         aslant = vec3_make(0.01, 0.005, 0.002), ball_at = vec3_make(0.012, 0.03, 0.001);
    vbss_capsule along_x_axis = rod(vec3_neg(x), x, 2e-3), along_z_axis = rod(vec3_neg(z), z, 2e-3),
                 slanting = rod(vec3_neg(aslant), aslant, 1.5e-3),
                 ball = rod(vec3_zero(), vec3_zero(), 3e-3);
    VBSS_TRY(add_tool(scene, VBSS_RIGID_DRIVEN, up(0.02), &along_x_axis, 1));
    VBSS_TRY(add_tool(scene, VBSS_RIGID_COUPLED, up(0.013), &along_z_axis, 1));
    VBSS_TRY(add_tool(scene, VBSS_RIGID_FREE, up(0.006), &along_x_axis, 1));
    VBSS_TRY(add_tool(scene, VBSS_RIGID_FREE, ball_at, &ball, 1));
    return add_tool(scene, VBSS_RIGID_FREE, vec3_make(-0.01, 0.04, 0.003), &slanting, 1);
}
