#include "scenes/scene_scenes.h"

#include <stdbool.h>
#include <stddef.h>

#include "scenes/knots.h"

/* Returns a failure to the caller at once. */
#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

/* ---- bodies in a few words */

static vbss_result add_capsule(vbss_scene *scene, vbss_rigid_kind kind, vec3 middle, vec3 half,
                               double radius, double weight)
{
    vbss_rigid_config config;
    vbss_capsule capsule;
    uint32_t body;
    TRY(vbss_rigid_config_init(&config, sizeof config));
    vec3_store(capsule.begin, vec3_neg(half));
    vec3_store(capsule.end, half);
    capsule.radius = radius;
    config.kind = kind;
    config.capsules = &capsule;
    config.capsule_count = 1;
    config.mass = kind == VBSS_RIGID_FREE ? 2e-3 : 0.02;
    config.friction = 0.2;
    config.gravity[1] = weight;
    vec3_store(config.position, middle);
    return vbss_scene_add_rigid(scene, &config, &body);
}

static vbss_result move(vbss_scene *scene, uint32_t body, vec3 position)
{
    double p[3];
    vec3_store(p, position);
    return vbss_scene_move_rigid(scene, body, p, NULL);
}

static vbss_result add_line(vbss_context *context, vbss_scene *scene, vec3 begin, vec3 way,
                            uint32_t segments)
{
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t body;
    TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = segments;
    config.length = vec3_norm(way);
    vec3_store(config.start, begin);
    vec3_store(config.direction, way);
    TRY(vbss_thread_create(context, &config, &thread));
    return vbss_scene_add_thread(scene, thread, &body);
}

/* ---- the knot: body 1 is the thread, 2 and 3 are the hands at its ends */

enum { KNOT_HANDS = 2 };

/* Fast at first; held once the knot is tight. */
static double pulled(uint64_t step)
{
    double fast = step < 10 ? (double)step : 10.0, all = step < 290 ? (double)step : 290.0;
    return 1e-4 * fast + 2.5e-5 * (all - fast);
}

static vbss_result create_knot(vbss_context *context, vbss_scene *scene, bool adapts)
{
    static const vec3 hand = {2e-4, 0.0, 0.0};
    vec3 x[KNOT_NODES];
    double rest[KNOT_NODES];
    knot_shape shape;
    knot_line line;
    vbss_thread_config config;
    vbss_thread *thread;
    uint32_t body, pin;
    knot_shape_init(&shape, KNOT_OVERHAND);
    shape.length = 0.04;
    shape.size = 0.75e-3;
    if (adapts) {
        shape.length = 0.06;
        shape.size = 1.5e-3;
        shape.finest = shape.coarsest = 0.6e-3;
    }
    TRY(knot_make(&shape, KNOT_NODES, x, rest, &line));
    TRY(vbss_thread_config_init(&config, sizeof config));
    config.segment_count = line.node_count - 1;
    config.rest_lengths = rest;
    config.positions = &x[0].x;
    if (adapts) {
        config.mesh = VBSS_MESH_ADAPTIVE;
        config.node_capacity = 240;
        config.cut_capacity = 1;
    }
    TRY(vbss_thread_create(context, &config, &thread));
    TRY(vbss_scene_add_thread(scene, thread, &body));
    for (uint32_t k = 0; k < KNOT_HANDS; k++) {
        uint32_t node = k == 0 ? 0 : line.node_count - 1;
        TRY(add_capsule(scene, VBSS_RIGID_DRIVEN, x[node], hand, 2e-4, 0.0));
        TRY(vbss_scene_pin_thread(scene, body, node, body + 1 + k, NULL, &pin));
    }
    return VBSS_OK;
}

static vbss_result drive_knot(vbss_scene *scene, uint64_t step)
{
    double further = pulled(step + 1) - pulled(step);
    for (uint32_t k = 0; k < KNOT_HANDS; k++) {
        vbss_rigid_state state;
        TRY(vbss_scene_get_rigid(scene, 2 + k, &state, sizeof state));
        vec3 to = vec3_load(state.target_position);
        to.x += k == 0 ? -further : further;
        TRY(move(scene, 2 + k, to));
    }
    return VBSS_OK;
}

#define CUT_AT_STEP 220
#define CUT_AT_ARC 4.1e-3

static vbss_result drive_mesh(vbss_scene *scene, uint64_t step)
{
    uint32_t piece;
    if (step == CUT_AT_STEP) {
        TRY(vbss_scene_cut_thread(scene, 1, CUT_AT_ARC, &piece));
    }
    return drive_knot(scene, step);
}

/* ---- the tools: a thread, two tools, a needle, its thread, a stick; and a thread that swings out of reach */

enum { HEAP = 1, TOOL, OTHER_TOOL, NEEDLE, NEEDLE_THREAD, STICK, SWING };

static vbss_result create_tools(vbss_context *context, vbss_scene *scene)
{
    const vec3 tool = {0.0, 0.0, 6e-3}, needle = {4e-3, 0.0, 0.0};
    uint32_t pin;
    TRY(add_line(context, scene, vec3_make(-0.01, 4e-4, 0.0), vec3_make(0.02, 1e-3, 2e-3), 40));
    TRY(add_capsule(scene, VBSS_RIGID_COUPLED, vec3_make(0.0, 2.9e-3, 0.0), tool, 1.5e-3, 0.0));
    TRY(add_capsule(scene, VBSS_RIGID_COUPLED, vec3_make(1e-3, 6e-3, 0.0),
                    vec3_make(6e-3, 0.0, 0.0), 1.5e-3, 0.0));
    TRY(add_capsule(scene, VBSS_RIGID_FREE, vec3_make(0.012, 1.2e-3, 8e-3), needle, 5e-4, -9.81));
    TRY(add_line(context, scene, vec3_make(0.016, 1.2e-3, 8e-3), vec3_make(0.01, 0.0, 1e-3), 16));
    TRY(add_capsule(scene, VBSS_RIGID_DRIVEN, vec3_make(-0.014, 1.6e-3, 0.0), tool, 1e-3, 0.0));
    TRY(vbss_scene_pin_thread(scene, NEEDLE_THREAD, 0, NEEDLE, NULL, &pin));
    TRY(add_line(context, scene, vec3_make(0.0, 0.1, 0.0), vec3_make(0.03, 0.0, 0.0), 12));
    return vbss_scene_pin_thread(scene, SWING, 0, 0, NULL, &pin);
}

static vbss_result drive_tools(vbss_scene *scene, uint64_t step)
{
    double t = 1e-3 * (double)(step + 1), down = 0.06 * t < 1.3e-3 ? 0.06 * t : 1.3e-3;
    TRY(move(scene, TOOL, vec3_make(0.01 * t, 2.9e-3 - down, 0.0)));
    TRY(move(scene, OTHER_TOOL, vec3_make(1e-3, 6e-3 - 1.1 * down, 0.005 * t)));
    return move(scene, STICK, vec3_make(-0.014 + 0.02 * t, 1.6e-3, 0.0));
}

/* ---- any */

vbss_result scene_scene_create(vbss_context *context, scene_scene_kind kind, vbss_scene **scene)
{
    vbss_scene_config config;
    TRY(vbss_scene_config_init(&config, sizeof config));
    config.node_capacity = 256;
    config.contact_capacity = 512;
    if (kind == SCENE_SCENE_TOOLS) {
        config.floor = 1;
        config.floor_normal[0] = 0.02;
    }
    TRY(vbss_scene_create(context, &config, scene));
    return kind == SCENE_SCENE_TOOLS ? create_tools(context, *scene)
                                     : create_knot(context, *scene, kind == SCENE_SCENE_MESH);
}

vbss_result scene_scene_drive(vbss_scene *scene, scene_scene_kind kind)
{
    vbss_scene_statistics statistics;
    TRY(vbss_scene_get_statistics(scene, &statistics, sizeof statistics));
    return kind == SCENE_SCENE_KNOT    ? drive_knot(scene, statistics.steps)
           : kind == SCENE_SCENE_TOOLS ? drive_tools(scene, statistics.steps)
                                       : drive_mesh(scene, statistics.steps);
}

vbss_result scene_scene_step(vbss_scene *scene, scene_scene_kind kind)
{
    TRY(scene_scene_drive(scene, kind));
    return vbss_scene_step(scene, 1e-3);
}
