/* The baseline method of scenes: its state, and its function table. */
#include "base/memory.h"
#include "baseline/scene.h"
#include "scene/tools/tools.h"
#include "scene/world/method.h"

/* ---- life */

enum { ARRAY_COUNT = 3 };

static void list_arrays(const scene_object *s, vbss_array arrays[ARRAY_COUNT])
{
    baseline_scene *own = s->baseline;
    arrays[0] = (vbss_array){&own->bodies, s->body_capacity, sizeof *own->bodies};
    arrays[1] = (vbss_array){&own->grasp_pins, s->config.grasp_capacity, sizeof *own->grasp_pins};
    arrays[2] = (vbss_array){&own->contacts, s->config.contact_capacity, sizeof *own->contacts};
}

static vbss_result create_state(scene_object *s)
{
    vbss_array arrays[ARRAY_COUNT];
    s->baseline = vbss_allocate(s->context, 1, sizeof *s->baseline, "scene");
    if (s->baseline == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    list_arrays(s, arrays);
    return vbss_allocate_arrays(s->context, arrays, ARRAY_COUNT, "scene");
}

static void destroy_state(scene_object *s)
{
    vbss_array arrays[ARRAY_COUNT];
    if (s->baseline != NULL) {
        list_arrays(s, arrays);
        vbss_release_arrays(s->context, arrays, ARRAY_COUNT);
        vbss_release(s->context, s->baseline, 1, sizeof *s->baseline);
    }
}

static void configure_collision(const scene_object *s, vbss_collision_config *config)
{
    config->method = VBSS_COLLISION_METHOD_VBLAST;
    config->thickness = s->config.baseline->scene_thickness;
    config->margin = 0.0;
}

/* Only the edges of a drain collide, and only with other bodies: docs/explanation/paper-scene.md. */
static vbss_result prepare_drain(scene_object *s, const drain_object *added, uint32_t shape)
{
    (void)added;
    s->collision->shapes[shape]->is_rigid = true;
    s->collision->shapes[shape]->edges_only = true;
    return VBSS_OK;
}

static void add_body(scene_object *s, const scene_body *b)
{
    *baseline_body_of(s, b) = (baseline_body){0};
}

static void remove_body(scene_object *s, uint32_t number)
{
    vbss_baseline_forget_toggles(s, number);
    vbss_baseline_forget_leader(s, number);
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        s->baseline->grasp_pins[i] = s->thread_grasps[i].id != 0 ? s->baseline->grasp_pins[i] : 0;
    }
}

/* ---- tools */

/* Needle drivers close fully, whatever is between their jaws. */
static void move_jaws(scene_object *s, scene_body *tool, double h)
{
    grasper_object *g = tool->rigid.grasper;
    double before = g->jaw_angle;
    if (g->kind == VBSS_GRASPER_KIND_NEEDLE_DRIVER) {
        g->jaw_angle = vbss_grasper_next_angle(g, h, 0.0);
    } else {
        vbss_scene_move_jaws(s, tool, h);
    }
    baseline_body_of(s, tool)->has_closed_jaws = before > 0.0 && g->jaw_angle == 0.0;
}

static bool holds_thread(const scene_object *s, const scene_thread_grasp *g)
{
    return s->baseline->grasp_pins[g - s->thread_grasps] != 0;
}

static bool holds_needle(const scene_object *s, const scene_body *tool)
{
    const scene_body *needle = vbss_scene_body(s, tool->rigid.needle_grasp.needle);
    return baseline_body_of(s, needle)->leader == tool->number;
}

static vec3 grasp_position(const thread_object *t, const scene_thread_grasp *g)
{
    return t->now.x[g->segment];
}

/* ---- snapshots; scenes of older versions had no needles */

static void serialise_needle(vbss_stream *stream, scene_object *s, const scene_body *needle)
{
    baseline_body *own = baseline_body_of(s, needle);
    vbss_stream_u32(stream, 142, &own->leader, 1);
    for (int k = 0; k < BASELINE_TOGGLES; k++) {
        baseline_toggle *toggle = &own->toggles[k];
        uint32_t words[] = {toggle->drain, toggle->triangle, toggle->outward};
        vbss_stream_u32(stream, 143, words, sizeof words / sizeof words[0]);
        if (words[2] > 1) {
            vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such flag");
        }
        *toggle = (baseline_toggle){words[0], words[1], words[2] != 0};
    }
}

/* A needle may only follow a tool that has closed on it, and its toggles must name existing
 * triangles. */
static bool is_valid_body(const scene_object *s, const scene_body *b)
{
    const baseline_body *own = baseline_body_of(s, b);
    const scene_body *tool = vbss_scene_body(s, own->leader);
    bool is_valid = own->leader == 0 || (tool != NULL && tool->kind == SCENE_BODY_RIGID &&
                                         tool->rigid.needle_grasp.needle == b->number);
    for (int k = 0; k < BASELINE_TOGGLES; k++) {
        const baseline_toggle *toggle = &own->toggles[k];
        const scene_body *d = vbss_scene_body(s, toggle->drain);
        bool none = toggle->drain == 0 && toggle->triangle == 0 && !toggle->outward;
        is_valid = is_valid && (none || (d != NULL && d->kind == SCENE_BODY_DRAIN &&
                                         toggle->triangle < d->drain.drain->mesh.triangle_count));
    }
    return is_valid;
}

static uint32_t *grasp_pin(const scene_object *s, uint32_t index)
{
    return &s->baseline->grasp_pins[index];
}

static vbss_baseline_statistics *baseline_statistics(const scene_object *s)
{
    return &s->baseline->statistics;
}

const scene_method vbss_baseline_scene = {
    .create_state = create_state,
    .destroy_state = destroy_state,
    .configure_collision = configure_collision,
    .prepare_drain = prepare_drain,
    .add_body = add_body,
    .remove_body = remove_body,
    .step_scene = vbss_baseline_scene_step,
    .move_jaws = move_jaws,
    .publish_contacts = vbss_baseline_publish_contacts,
    .list_touching_pairs = vbss_baseline_list_touching_pairs,
    .holds_thread = holds_thread,
    .holds_needle = holds_needle,
    .grasp_position = grasp_position,
    .serialise_needle = serialise_needle,
    .is_valid_body = is_valid_body,
    .grasp_pin = grasp_pin,
    .baseline_statistics = baseline_statistics,
    .has_separation_cache = false,
    .drives_tools = true,
    .welds_pins = false,
    .grasps_when_closed = true,
    .accepts_holes = false,
};
