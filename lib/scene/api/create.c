/* Creates scenes: default configuration, checks of the configuration, and memory. */
#include "base/api_call.h"
#include "base/baseline_config.h"
#include "base/check.h"
#include "base/error.h"
#include "base/stream.h"
#include "scene/api/api.h"
#include "scene/snapshot/describe.h"
#include "scene/snapshot/snapshot.h"
#include "scene/topology/topology.h"
#include "scene/world/method.h"
#include "scene/world/world.h"

#include <string.h>

_Static_assert(sizeof(vbss_scene_config) == VBSS_SIZE_WITH_POINTERS(vbss_scene_config, 136u, 2u),
               "published size");
_Static_assert(sizeof(vbss_scene_statistics) == 264, "published size");

static const vbss_scene_config defaults = {
    .struct_size = sizeof(vbss_scene_config),
    .method = VBSS_METHOD_IMPLICIT,
    .mode = VBSS_SCENE_MODE_REAL_TIME,
    .thread_capacity = 4,
    .node_capacity = 1024,
    .rigid_capacity = 4,
    .capsule_capacity = 16,
    .pin_capacity = 8,
    .contact_capacity = 1024,
    .candidate_capacity = 16384,
    .event_capacity = 256,
    .grasp_capacity = 8,
    .floor_normal = {0.0, 1.0, 0.0},
    .floor_friction = 0.3,
    .thread_friction = 0.3,
    .contact_stiffness = 2e5,
    .drain_capacity = 1,
    .hole_capacity = 16,
    .speed_limit = SCENE_DEFAULT_SPEED_LIMIT,
};
static const uint32_t config_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_scene_config, 136u, 2u), 0};
static const vbss_layout config_layout = {"vbss_scene_config", &defaults, config_sizes};

vbss_result vbss_scene_config_init(vbss_scene_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

typedef struct range {
    const char *name;
    double value, low, high;
} range;

static vbss_result check_config(vbss_context *context, const vbss_scene_config *c)
{
    const range ranges[] = {
        {"method", c->method, VBSS_METHOD_IMPLICIT, VBSS_METHOD_VBLAST},
        {"mode", c->mode, VBSS_SCENE_MODE_REAL_TIME, VBSS_SCENE_MODE_OFFLINE},
        {"thread_capacity", c->thread_capacity, 0.0, SCENE_MAX_THREADS},
        {"node_capacity", c->node_capacity, 0.0, 8192.0},
        {"rigid_capacity", c->rigid_capacity, 0.0, 256.0},
        {"capsule_capacity", c->capsule_capacity, 0.0, 4096.0},
        {"pin_capacity", c->pin_capacity, 0.0, 256.0},
        {"contact_capacity", c->contact_capacity, 0.0, 65536.0},
        {"candidate_capacity", c->candidate_capacity, 0.0, 1e7},
        {"event_capacity", c->event_capacity, 0.0, 65536.0},
        {"floor", c->floor, 0.0, 1.0},
        {"floor_height", c->floor_height, -1e3, 1e3},
        {"floor_friction", c->floor_friction, 0.0, 10.0},
        {"thread_friction", c->thread_friction, 0.0, 10.0},
        {"contact_stiffness", c->contact_stiffness, 1e3, 1e9},
        {"drain_capacity", c->drain_capacity, 0.0, 16.0},
        {"grasp_capacity", c->grasp_capacity, 0.0, 256.0},
        {"hole_capacity", c->hole_capacity, 0.0, 256.0},
        {"speed_limit", c->speed_limit, 0.0, 1e6},
        {"overlap", c->overlap, VBSS_SCENE_OVERLAP_WARN, VBSS_SCENE_OVERLAP_ALLOW},
        {"matrix_capacity", c->matrix_capacity, 0.0, 1e7},
        {"reserved", c->reserved, 0.0, 0.0},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        const range *r = &ranges[i];
        VBSS_TRY(vbss_check_range(context, r->value, r->low, r->high, r->name));
    }
    VBSS_TRY(vbss_check_finite(context, c->floor_normal, 3, "floor_normal"));
    return vbss_check_range(context, vec3_norm(vec3_load(c->floor_normal)), 1e-100, 1e100,
                            "length of floor_normal");
}

/* ---- memory */

enum { ARRAY_COUNT = 31 };

static size_t list_arrays(scene_object *s, vbss_array arrays[ARRAY_COUNT])
{
    size_t nodes = s->node_capacity, capsules = s->config.capsule_capacity;
    size_t vertices = nodes > 2 * capsules ? nodes : 2 * capsules;
    size_t contacts = s->config.contact_capacity;
    /* One more for a pair that turns out to be apart (add_contact.c). */
    size_t constraints = s->config.method == VBSS_METHOD_IMPLICIT ? contacts + 1 : 0;
    const vbss_array all[] = {
        {&s->bodies, s->body_capacity, sizeof *s->bodies},
        {&s->capsules, capsules, sizeof *s->capsules},
        {&s->pins, s->config.pin_capacity, sizeof *s->pins},
        {&s->thread_grasps, s->config.grasp_capacity, sizeof *s->thread_grasps},
        {&s->checkpoint.thread_grasps, s->config.grasp_capacity,
         sizeof *s->checkpoint.thread_grasps},
        {&s->holes, s->config.hole_capacity, sizeof *s->holes},
        {&s->checkpoint.holes, s->config.hole_capacity, sizeof *s->checkpoint.holes},
        {&s->step.previous_holes, s->config.hole_capacity, sizeof *s->step.previous_holes},
        {&s->step.is_separator, nodes, sizeof *s->step.is_separator},
        {&s->step.expected_displacements, nodes + 2 * capsules,
         sizeof *s->step.expected_displacements},
        {&s->step.contact_geometries, constraints, sizeof *s->step.contact_geometries},
        {&s->scratch.vertices, 2 * vertices, sizeof *s->scratch.vertices},
        {&s->step.welds, s->config.pin_capacity, sizeof *s->step.welds},
        {&s->scratch.ccd_batch, 1, sizeof *s->scratch.ccd_batch},
        {&s->scratch.mass_capsules, capsules, sizeof *s->scratch.mass_capsules},
        {&s->report.touching_pairs, contacts, sizeof *s->report.touching_pairs},
        {&s->report.previous_touching_pairs, contacts, sizeof *s->report.previous_touching_pairs},
        {&s->report.logged_events, s->config.event_capacity, sizeof *s->report.logged_events},
        {&s->events.ring, s->config.event_capacity, sizeof *s->events.ring},
        {&s->events.pending, s->config.event_capacity, sizeof *s->events.pending},
        {&s->report.contact_features, contacts, sizeof *s->report.contact_features},
        {&s->report.contact_points, contacts, sizeof *s->report.contact_points},
        {&s->report.contact_normals, contacts, sizeof *s->report.contact_normals},
        {&s->report.contact_forces, contacts, sizeof *s->report.contact_forces},
        {&s->report.contact_gaps, contacts, sizeof *s->report.contact_gaps},
        {&s->body_of_shape, SCENE_MAX_SHAPES, sizeof *s->body_of_shape},
        {&s->body_of_number, SCENE_MAX_SHAPES, sizeof *s->body_of_number},
        {&s->scratch.near_features, vertices, sizeof *s->scratch.near_features},
        {&s->scratch.keeps_entry, contacts, sizeof *s->scratch.keeps_entry},
        {&s->scratch.is_duplicate, constraints, sizeof *s->scratch.is_duplicate},
        {&s->scratch.sides_beyond_cut, constraints, sizeof *s->scratch.sides_beyond_cut},
    };
    _Static_assert(sizeof all <= ARRAY_COUNT * sizeof(vbss_array), "the table is long enough");
    memcpy(arrays, all, sizeof all);
    return sizeof all / sizeof all[0];
}

static void free_object(vbss_context *context, void *object)
{
    scene_object *s = object;
    vbss_array arrays[ARRAY_COUNT];
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_THREAD) {
            vbss_scene_disown_thread(&s->bodies[i]);
        } else if (s->bodies[i].kind == SCENE_BODY_RIGID && s->bodies[i].rigid.grasper != NULL) {
            vbss_scene_disown_grasper(&s->bodies[i]);
        } else if (s->bodies[i].kind == SCENE_BODY_RIGID && s->bodies[i].rigid.needle != NULL) {
            vbss_scene_disown_needle(&s->bodies[i]);
        } else if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            vbss_scene_disown_drain(s, &s->bodies[i]);
        } else if (scene_is_mesh(&s->bodies[i])) {
            vbss_scene_release_static_mesh(s, &s->bodies[i]);
        } else if (s->bodies[i].is_reserved) {
            vbss_scene_return_spare(&s->bodies[i]);
        }
    }
    for (uint32_t i = 0; i < s->body_count; i++) {
        vbss_slot *slot = vbss_scene_slot_of_body(&s->bodies[i]);
        if (slot != NULL) {
            vbss_slot_destroy_owned(slot);
        }
    }
    if (s->collision != NULL) {
        vbss_collision_free(context, s->collision);
    }
    s->method->destroy_state(s);
    vbss_release(context, s->step.springs, s->step.spring_capacity, sizeof *s->step.springs);
    vbss_release_arrays(context, arrays, list_arrays(s, arrays));
    vbss_release(context, s, 1, sizeof *s);
}

const vbss_kind vbss_scene_kind = {"scene",     VBSS_CODE('S', 'C', 'E', 'N'), 6,
                                   free_object, vbss_scene_serialise,          vbss_scene_describe};

static vbss_result make_collision(scene_object *s)
{
    const vbss_baseline_config baseline = vbss_baseline_config_default();
    vbss_collision_config c;
    VBSS_TRY(vbss_collision_config_init(&c, sizeof c));
    c.baseline = &baseline;
    c.shape_capacity = SCENE_MAX_SHAPES;
    c.pair_capacity = s->config.candidate_capacity;
    c.impact_capacity = 0; /* unused: the CCD and the baseline method run their own tests */
    s->method->configure_collision(s, &c);
    VBSS_TRY(vbss_collision_allocate(s->context, &c, s->body_capacity,
                                     s->method->has_separation_cache, &s->collision));
    s->collision_slot = vbss_slot_inside(s->context, &vbss_collision_kind, s->collision);
    return VBSS_OK;
}

static vbss_result create_members(scene_object *s)
{
    vbss_array arrays[ARRAY_COUNT];
    VBSS_TRY(vbss_allocate_arrays(s->context, arrays, list_arrays(s, arrays), "scene"));
    VBSS_TRY(make_collision(s));
    return s->method->create_state(s);
}

/* ---- creation */

/* Creates a scene without a handle, from a configuration or NULL. */
static vbss_result create_object(vbss_context *context, const vbss_scene_config *config,
                                 scene_object **scene)
{
    vbss_scene_config own = defaults;
    if (config != NULL) {
        VBSS_TRY(vbss_config_read(context, &config_layout, config, &own));
    }
    vbss_baseline_config baseline;
    VBSS_TRY(vbss_baseline_read_config(context, &own.baseline, &baseline));
    vbss_solver_options solver;
    VBSS_TRY(vbss_solver_options_read(context, own.solver, &solver));
    VBSS_TRY(check_config(context, &own));
    scene_object *s = vbss_allocate(context, 1, sizeof *s, "scene");
    if (s == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    s->method = own.method == VBSS_METHOD_VBLAST ? &vbss_baseline_scene : &vbss_scene_implicit;
    s->context = context;
    s->config = own;
    s->baseline_config = baseline;
    s->config.baseline = &s->baseline_config;
    s->solver = solver;
    s->config.solver = &s->solver;
    s->settings = vbss_scene_created_settings(s);
    s->cursor.group_count = 1;
    s->floor_normal = vec3_unit_or(vec3_load(own.floor_normal), vec3_make(0.0, 1.0, 0.0));
    s->node_capacity = own.node_capacity;
    s->body_capacity = own.thread_capacity + own.rigid_capacity + own.drain_capacity;
    const vbss_result result = create_members(s);
    if (result != VBSS_OK) {
        free_object(context, s);
        return result;
    }
    *scene = s;
    return VBSS_OK;
}

vbss_result vbss_scene_create(vbss_context *context, const vbss_scene_config *config,
                              vbss_scene **scene)
{
    VBSS_ENTER_WITH_RESULT(context, scene);
    if (scene == NULL) {
        VBSS_TRY(vbss_context_open(context));
        return vbss_check_pointer(context, scene, "scene");
    }
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    scene_object *s;
    vbss_slot *slot;
    VBSS_TRY(create_object(context, config, &s));
    const vbss_result result = vbss_slot_create(context, &vbss_scene_kind, s, &slot);
    if (result != VBSS_OK) {
        free_object(context, s);
        return result;
    }
    slot->hook = &s->hook;
    *scene = (vbss_scene *)slot;
    return VBSS_OK;
}

vbss_result vbss_scene_config_get_memory(vbss_context *context, const vbss_scene_config *config,
                                         uint64_t *bytes)
{
    VBSS_ENTER(context);
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, bytes, "bytes"));
    const uint64_t before = vbss_bytes_allocated(context);
    scene_object *s;
    VBSS_TRY(create_object(context, config, &s));
    *bytes = vbss_bytes_allocated(context) - before;
    free_object(context, s);
    return VBSS_OK;
}
