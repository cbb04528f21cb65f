#include "scenes/contact_scenes.h"

#include <string.h>

#include "base/error.h"
#include "scenes/contact_build.h"

const char *const contact_scene_names[CONTACT_SCENE_KINDS] = {
    "pulled",      "tugged",      "struck",  "pulled open", "many knots",
    "interlocked", "sliding off", "dropped", "beside",      "tools"};

/* ---- options */

vbss_result contact_scene_init(contact_scene_options *options, contact_scene_kind kind)
{
    *options = (contact_scene_options){.kind = kind,
                                       .knots = 10,
                                       .pull = {0.1, 1.0, 0.0},
                                       .begin = 300,
                                       .tool = VBSS_RIGID_DRIVEN,
                                       .tool_speed = 0.05,
                                       .tool_radius = 2e-3,
                                       .tool_friction = 0.15,
                                       .turns = 2.5};
    VBSS_TRY(vbss_scene_config_init(&options->scene, sizeof options->scene));
    VBSS_TRY(vbss_thread_config_init(&options->thread, sizeof options->thread));
    options->thread.axial_stiffness = 4000.0;
    knot_shape_init(&options->knot, KNOT_OVERHAND);
    options->knot.length = 0.08;
    if (kind == CONTACT_SCENE_STRUCK) {
        options->pull.stiffness = 2000.0;
        options->tool_speed = 1.0;
    } else if (kind == CONTACT_SCENE_PULLED_OPEN) {
        options->knot.kind = KNOT_SQUARE;
        options->knot.cylinder = true;
        options->tool_radius = 1e-3;
        options->tool_speed = 5e-3;
    } else if (kind == CONTACT_SCENE_MANY_KNOTS) {
        options->knot.length = 0.04;
        options->knot.coarsest = 1e-3;
    } else if (kind == CONTACT_SCENE_SLIDING_OFF) {
        options->pull = (contact_pull){0.1, 0.05, 200.0};
    } else if (kind == CONTACT_SCENE_DROPPED) {
        options->knot.finest = 0.6e-3;
        options->knot.length = 0.12;
        options->wave = 1e-3;
    } else if (kind == CONTACT_SCENE_BESIDE) {
        options->knot.finest = 0.6e-3;
        options->knot.length = 0.05;
        options->aside = vec3_make(0.0, 1e-3, 0.0);
    }
    bool falls = kind == CONTACT_SCENE_DROPPED || kind == CONTACT_SCENE_BESIDE;
    options->thread.gravity[1] = falls ? -9.81 : 0.0;
    return VBSS_OK;
}

/* ---- making */

static vbss_result make_scene(vbss_context *context, contact_scene *scene)
{
    vbss_scene_config config = scene->options.scene;
    contact_scene_kind kind = scene->options.kind;
    bool large = kind == CONTACT_SCENE_MANY_KNOTS;
    config.node_capacity = large ? 2048 : 1024;
    config.contact_capacity = large ? 4096 : 2048;
    config.candidate_capacity = large ? 65536 : 32768;
    config.rigid_capacity = CONTACT_SCENE_TOOLS_MOST;
    config.floor = kind == CONTACT_SCENE_DROPPED || kind == CONTACT_SCENE_TOOLS;
    return vbss_scene_create(context, &config, &scene->scene);
}

vbss_result contact_scene_create(vbss_context *context, const contact_scene_options *options,
                                 contact_scene *scene)
{
    *scene = (contact_scene){.options = *options};
    VBSS_TRY(make_scene(context, scene));
    switch (options->kind) {
    case CONTACT_SCENE_PULLED_OPEN:
        return contact_build_pulled_open(context, scene);
    case CONTACT_SCENE_MANY_KNOTS:
        return contact_build_many_knots(context, scene);
    case CONTACT_SCENE_INTERLOCKED:
        return contact_build_interlocked(context, scene);
    case CONTACT_SCENE_SLIDING_OFF:
        return contact_build_sliding_off(context, scene);
    case CONTACT_SCENE_DROPPED:
        return contact_build_dropped(context, scene);
    case CONTACT_SCENE_BESIDE:
        return contact_build_beside(context, scene);
    case CONTACT_SCENE_TOOLS:
        return contact_build_tools(scene);
    default:
        return contact_build_knot(context, scene);
    }
}

vbss_result contact_scene_destroy(contact_scene *scene)
{
    VBSS_TRY(vbss_scene_destroy(scene->scene));
    for (uint32_t i = 0; i < scene->thread_count; i++) {
        VBSS_TRY(vbss_thread_destroy(scene->threads[i]));
    }
    return VBSS_OK;
}

/* ---- moving */

#define TOOLS_DEPTH 0.013

static vbss_result move_tool(const contact_scene *scene, uint32_t tool, vec3 way)
{
    double target[3];
    vec3_store(target, vec3_add(scene->tool_homes[tool], way));
    return vbss_scene_move_rigid(scene->scene, scene->tools[tool], target, NULL);
}

/* Up by twice its distance, and back. */
static vbss_result strike(const contact_scene *scene, double since)
{
    double far = 2.0 * CONTACT_STRIKE_AWAY, way = scene->options.tool_speed * since;
    return move_tool(scene, 0,
                     vec3_make(0.0, 0.0, way < far ? way : vbss_max(2.0 * far - way, 0.0)));
}

static vbss_result open(const contact_scene *scene, double since)
{
    double way = scene->options.tool_speed * since;
    VBSS_TRY(move_tool(scene, 0, vec3_make(-way, 0.0, 0.0)));
    return move_tool(scene, 1, vec3_make(way, 0.0, 0.0));
}

static vbss_result draw_out(const contact_scene *scene, double since)
{
    double way = vbss_min(scene->options.tool_speed * since, CONTACT_DRAWN_OUT);
    return move_tool(scene, 0, vec3_make(0.0, 0.0, -way));
}

/* The driven one down, further than there is room above the floor, and back up; the coupled one half as far. */
static vbss_result push_tools(const contact_scene *scene, double since)
{
    double way = 0.2 * since;
    way = way < TOOLS_DEPTH ? way : vbss_max(2.0 * TOOLS_DEPTH - way, 0.0);
    VBSS_TRY(move_tool(scene, 0, vec3_make(0.0, -way, 0.0)));
    return move_tool(scene, 1, vec3_make(0.0, -0.5 * way, 0.0));
}

static vbss_result move_tools(const contact_scene *scene, double h)
{
    const contact_scene_options *o = &scene->options;
    bool later = o->kind == CONTACT_SCENE_STRUCK || o->kind == CONTACT_SCENE_SLIDING_OFF;
    uint64_t from = later ? o->begin : 0;
    double since = scene->steps < from ? 0.0 : (double)(scene->steps + 1 - from) * h;
    switch (o->kind) {
    case CONTACT_SCENE_STRUCK:
        return o->tool == VBSS_RIGID_FREE ? VBSS_OK : strike(scene, since);
    case CONTACT_SCENE_PULLED_OPEN:
        return open(scene, since);
    case CONTACT_SCENE_SLIDING_OFF:
        return draw_out(scene, since);
    case CONTACT_SCENE_TOOLS:
        return push_tools(scene, since);
    default:
        return VBSS_OK;
    }
}

static vbss_result move_hands(contact_scene *scene, double h)
{
    const contact_scene_options *o = &scene->options;
    bool tugs = o->kind == CONTACT_SCENE_TUGGED && scene->steps >= o->begin;
    /* All pull alike, or the whole would be carried off. */
    double force = contact_whim_of(&o->pull, o->seed, 0, scene->steps).pull.force;
    for (uint32_t i = 0; i < scene->hand_count; i++) {
        if (tugs) {
            contact_whim whim = contact_whim_of(&o->pull, o->seed, i, scene->steps);
            whim.pull.force = force;
            VBSS_TRY(contact_hand_tug(&scene->hands[i], &whim, h, o->loose));
        } else {
            VBSS_TRY(contact_hand_move(&scene->hands[i], h, vec3_zero()));
        }
    }
    return VBSS_OK;
}

vbss_result contact_scene_step(contact_scene *scene, double h)
{
    VBSS_TRY(move_hands(scene, h));
    VBSS_TRY(move_tools(scene, h));
    scene->steps++;
    return vbss_scene_step(scene->scene, h);
}

/* ---- looking */

vbss_result contact_scene_hash(const contact_scene *scene, uint64_t *hash)
{
    return vbss_scene_get_hash(scene->scene, hash);
}

double contact_scene_pull_felt(const contact_scene *scene)
{
    double least = scene->hand_count > 0 ? scene->hands[0].felt : 0.0;
    for (uint32_t i = 1; i < scene->hand_count; i++) {
        least = vbss_min(scene->hands[i].felt, least);
    }
    return least;
}
