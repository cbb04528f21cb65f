/* The implicit method of scenes: its state, and the table of what it does. */
#include "base/error.h"
#include "scene/solve/solve.h"
#include "scene/step/step.h"
#include "scene/tools/tools.h"
#include "scene/tuning.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

static vbss_result create_state(scene_object *s)
{
    VBSS_TRY(vbss_contact_create(s->context, s->config.contact_capacity, &s->contacts));
    return vbss_scene_create_system(s, NULL, 0);
}

static void destroy_state(scene_object *s)
{
    vbss_contact_destroy(s->context, s->contacts);
    vbss_system_destroy(s->context, s->system);
}

static void configure_collision(const scene_object *s, vbss_collision_config *config)
{
    config->margin = s->solver.contact_margin;
}

static vbss_result prepare_drain(scene_object *s, const drain_object *added, uint32_t shape)
{
    VBSS_TRY(vbss_collision_exclude_near(s->collision, shape, added->mesh.rest,
                                         SCENE_DRAIN_SELF_ARC_RATIO * added->config.thickness));
    return vbss_scene_create_system(s, added, 0);
}

static void add_body(scene_object *s, const scene_body *b)
{
    (void)s;
    (void)b;
}

static void remove_body(scene_object *s, uint32_t number)
{
    (void)s;
    (void)number;
}

static bool holds_thread(const scene_object *s, const scene_thread_grasp *g)
{
    (void)s;
    (void)g;
    return true;
}

static bool holds_needle(const scene_object *s, const scene_body *tool)
{
    (void)s;
    (void)tool;
    return true;
}

static vec3 grasp_position(const thread_object *t, const scene_thread_grasp *g)
{
    return vbss_scene_grip_point(g, t, t->now.x, GRASPER_THREAD_POINTS / 2);
}

static void serialise_needle(vbss_stream *stream, scene_object *s, const scene_body *needle)
{
    (void)stream;
    (void)s;
    (void)needle;
}

static bool is_valid_body(const scene_object *s, const scene_body *b)
{
    (void)s;
    (void)b;
    return true;
}

static vbss_baseline_statistics *baseline_statistics(const scene_object *s)
{
    (void)s;
    return NULL;
}

static uint32_t *grasp_pin(const scene_object *s, uint32_t index)
{
    (void)s;
    (void)index;
    return NULL;
}

const scene_method vbss_scene_implicit = {
    .create_state = create_state,
    .destroy_state = destroy_state,
    .configure_collision = configure_collision,
    .prepare_drain = prepare_drain,
    .add_body = add_body,
    .remove_body = remove_body,
    .step_scene = vbss_scene_implicit_step,
    .move_jaws = vbss_scene_move_jaws,
    .publish_contacts = vbss_scene_publish_constraints,
    .list_touching_pairs = vbss_scene_list_touching_pairs,
    .holds_thread = holds_thread,
    .holds_needle = holds_needle,
    .grasp_position = grasp_position,
    .serialise_needle = serialise_needle,
    .is_valid_body = is_valid_body,
    .grasp_pin = grasp_pin,
    .baseline_statistics = baseline_statistics,
    .has_separation_cache = true,
    .drives_tools = false,
    .welds_pins = true,
    .grasps_when_closed = false,
    .accepts_holes = true,
};
