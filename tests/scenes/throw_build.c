#include "scenes/throw_build.h"

#include "base/elementary.h"
#include "base/error.h"
#include "base/rotation.h"

#define PI 3.14159265358979324
enum { MOST_NODES = 512 };

/* m: x right, y away, z up, the top of the drain at 0 */
#define DRAIN_RADIUS 6.5e-3
#define DRAIN_HALF 30e-3
#define DRAIN_FRICTION 0.3
#define MARK_ARC 4.5e-3 /* of the drain's surface beside its top, where the thread comes out */
#define JUST_CLEAR 0.03e-3
#define INSIDE 1e-3
#define LIMB 117e-3
#define FLOOR (-13e-3)
static const vec3 trocar = {-0.110, -0.050, 0.080};

#define SHAFT_RADIUS 2.5e-3
#define SHAFT_LENGTH 0.12
#define JAW_RADIUS 0.7e-3
#define JAW_LENGTH 13e-3
#define FROM_TAIL_END 7u /* nodes: where W takes the tail */

vbss_result throw_scene_init(throw_scene_options *o, bool twice)
{
    *o = (throw_scene_options){.segment = 0.5e-3,
                               .turns = twice ? 2.3 : 1.3,
                               .tip = twice ? vec3_make(36e-3, 2e-3, 22e-3)
                                            : vec3_make(29e-3, 2e-3, 14e-3),
                               .held_at = twice ? 100e-3 : 85e-3,
                               .first = 27e-3,
                               .advance = 4e-3,
                               .speed = 0.145,
                               .pull = 0.05,
                               .tremor = 0.3e-3};
    VBSS_TRY(vbss_scene_config_init(&o->scene, sizeof o->scene));
    VBSS_TRY(vbss_thread_config_init(&o->thread, sizeof o->thread));
    o->scene.node_capacity = MOST_NODES;
    o->scene.contact_capacity = 2048;
    o->scene.candidate_capacity = 32768;
    o->scene.capsule_capacity = 8;
    o->scene.floor = 1;
    o->scene.floor_normal[1] = 0.0;
    o->scene.floor_normal[2] = 1.0;
    o->scene.floor_height = FLOOR;
    o->thread.axial_stiffness = 427.0;
    o->thread.bending_stiffness = 1e-8;
    o->thread.radius = 0.125e-3;
    o->thread.gravity[1] = 0.0;
    o->thread.gravity[2] = -9.81;
    return VBSS_OK;
}

/* ---- the thread */

typedef struct layout {
    uint32_t count;
    vec3 x[MOST_NODES];
    double rest[MOST_NODES];
} layout;

static void lay_node(layout *l, vec3 x)
{
    if (l->count > 0) {
        l->rest[l->count - 1] = vec3_distance(l->x[l->count - 1], x);
    }
    l->x[l->count++] = x;
}

static vec3 out_of_drain(double side)
{
    double angle = side * MARK_ARC / DRAIN_RADIUS;
    return vec3_make(vbss_sin(angle), 0.0, vbss_cos(angle));
}

static vec3 on_drain(double side, double radius)
{
    return vec3_add_scaled(vec3_make(0.0, 0.0, -DRAIN_RADIUS), radius, out_of_drain(side));
}

/* Tail, through the drain, and the limb, which bends to its way over so much of it. */
#define BEND 15e-3
static void lay_thread(throw_scene *scene, vec3 limb_way, layout *l)
{
    const throw_scene_options *o = &scene->options;
    const double surface = DRAIN_RADIUS + o->thread.radius + JUST_CLEAR;
    uint32_t tail = (uint32_t)(THROW_TAIL / o->segment + 0.5),
             limb = (uint32_t)(LIMB / o->segment + 0.5);
    l->count = 0;
    for (uint32_t i = 0; i <= tail; i++) {
        lay_node(l, on_drain(1.0, surface + (tail - i) * o->segment));
    }
    scene->right_mark = tail;
    lay_node(l, on_drain(1.0, surface - INSIDE));
    lay_node(l, on_drain(-1.0, surface - INSIDE));
    lay_node(l, on_drain(-1.0, surface));
    scene->left_mark = l->count - 1;
    for (uint32_t i = 1; i <= limb; i++) {
        double along = vbss_min((i - 0.5) * o->segment / BEND, 1.0);
        vec3 way = vec3_unit_or(vec3_lerp(out_of_drain(-1.0), limb_way, along), limb_way);
        lay_node(l, vec3_add_scaled(l->x[l->count - 1], o->segment, way));
    }
    scene->held_node = scene->left_mark + (uint32_t)(o->held_at / o->segment + 0.5);
    scene->tail_node = FROM_TAIL_END;
    scene->nodes = l->count;
}

static vbss_result hold(throw_scene *scene, const layout *l, uint32_t node)
{
    vbss_thread_attachment a;
    uint32_t id;
    VBSS_TRY(vbss_thread_attachment_init(&a, sizeof a));
    a.node = node;
    vec3_store(a.position, l->x[node]);
    return vbss_thread_attach(scene->thread, &a, &id);
}

static vbss_result add_thread(vbss_context *context, throw_scene *scene, const layout *l)
{
    vbss_thread_config config = scene->options.thread;
    config.segment_count = l->count - 1;
    config.rest_lengths = l->rest;
    config.positions = &l->x[0].x;
    VBSS_TRY(vbss_thread_create(context, &config, &scene->thread));
    VBSS_TRY(vbss_scene_add_thread(scene->scene, scene->thread, &scene->thread_body));
    for (uint32_t i = scene->right_mark; i <= scene->left_mark; i++) {
        VBSS_TRY(hold(scene, l, i));
    }
    return VBSS_OK;
}

/* ---- tools */

/* W's axis, from tip to handle, when its grasp is there. */
vec3 throw_axis_of_w(vec3 grasp)
{
    return vec3_unit_or(vec3_sub(trocar, grasp), vec3_make(0.0, 0.0, 1.0));
}

static vec3 across_w(vec3 u)
{
    return vec3_unit_or(vec3_add_scaled(vec3_make(1.0, 0.0, 0.0), -u.x, u),
                        vec3_make(0.0, 1.0, 0.0));
}

vec3 throw_from_w(const throw_scene *scene, double phi)
{
    vec3 u = throw_axis_of_w(scene->w.at), e1 = across_w(u), e2 = vec3_cross(u, e1);
    return vec3_add(vec3_scale(e1, vbss_cos(phi)), vec3_scale(e2, vbss_sin(phi)));
}

quat throw_stand_of_w(const throw_scene *scene)
{
    return quat_between(vec3_make(0.0, 0.0, 1.0), throw_axis_of_w(scene->w.at));
}

/* Its handle is away from W and goes round with it. */
quat throw_stand_of_c(const throw_scene *scene)
{
    double since = scene->phi + 0.5 * PI, whole = 2.0 * PI * floor(since / (2.0 * PI));
    vec3 u = throw_axis_of_w(scene->w.at);
    quat first = quat_between(vec3_make(0.0, 0.0, 1.0), throw_from_w(scene, -0.5 * PI));
    return quat_mul(vbss_quat_from_rotation_vector(vec3_scale(u, since - whole)), first);
}

static vbss_capsule rod(vec3 begin, vec3 end, double radius)
{
    vbss_capsule c = {.radius = radius};
    vec3_store(c.begin, begin);
    vec3_store(c.end, end);
    return c;
}

vec3 throw_frame_of(vec3 grasp, quat stand)
{
    return vec3_sub(grasp, quat_rotate(stand, vec3_make(0.0, 0.0, THROW_GRASP)));
}

static vbss_result add_tool(throw_scene *scene, throw_tool *tool, quat stand, uint32_t capsules)
{
    vbss_rigid_config config;
    vec3 end = vec3_make(0.0, 0.0, JAW_LENGTH), side = vec3_make(JAW_RADIUS, 0.0, 0.0);
    vbss_capsule parts[3] = {
        rod(side, vec3_add(side, end), JAW_RADIUS),
        rod(vec3_neg(side), vec3_sub(end, side), JAW_RADIUS),
        rod(end, vec3_make(0.0, 0.0, SHAFT_LENGTH), SHAFT_RADIUS),
    };
    VBSS_TRY(vbss_rigid_config_init(&config, sizeof config));
    config.kind = VBSS_RIGID_COUPLED;
    config.capsules = parts;
    config.capsule_count = capsules;
    vec3_store(config.position, throw_frame_of(tool->at, stand));
    config.orientation[0] = stand.w;
    config.orientation[1] = stand.x;
    config.orientation[2] = stand.y;
    config.orientation[3] = stand.z;
    return vbss_scene_add_rigid(scene->scene, &config, &tool->body);
}

static vbss_result add_drain(throw_scene *scene)
{
    vbss_rigid_config config;
    vec3 at = vec3_make(0.0, 0.0, -DRAIN_RADIUS), half = vec3_make(0.0, DRAIN_HALF, 0.0);
    vbss_capsule c = rod(vec3_sub(at, half), vec3_add(at, half), DRAIN_RADIUS);
    uint32_t body;
    VBSS_TRY(vbss_rigid_config_init(&config, sizeof config));
    config.capsules = &c;
    config.capsule_count = 1;
    config.friction = DRAIN_FRICTION;
    return vbss_scene_add_rigid(scene->scene, &config, &body);
}

vbss_result throw_take(throw_scene *scene, const throw_tool *tool, uint32_t node)
{
    uint32_t pin;
    for (uint32_t i = node - THROW_WELDED; i <= node + THROW_WELDED; i++) {
        VBSS_TRY(
            vbss_scene_pin_thread(scene->scene, scene->thread_body, i, tool->body, NULL, &pin));
    }
    return VBSS_OK;
}

vbss_result throw_build(vbss_context *context, throw_scene *scene)
{
    layout l;
    const throw_scene_options *options = &scene->options;
    scene->w.at = vec3_add_scaled(options->tip, THROW_GRASP, throw_axis_of_w(options->tip));
    scene->mark = on_drain(1.0, DRAIN_RADIUS);
    VBSS_TRY(vbss_scene_create(context, &options->scene, &scene->scene));
    /* To the near side, under W, across C's jaws. */
    vec3 way = vec3_unit_or(vec3_make(-0.05, -0.6, 0.75), vec3_zero());
    lay_thread(scene, way, &l);
    VBSS_TRY(add_thread(context, scene, &l));
    scene->c.at = l.x[scene->held_node];
    VBSS_TRY(add_tool(scene, &scene->w, throw_stand_of_w(scene), 3));
    VBSS_TRY(add_tool(scene, &scene->c, throw_stand_of_c(scene), 2));
    VBSS_TRY(add_drain(scene));
    return throw_take(scene, &scene->c, scene->held_node);
}
