/* Drains in a scene: how they come and go, and their part of each stage of a step. */
#include "base/check.h"
#include "base/error.h"
#include "scene/substep.h"
#include "scene/events.h"
#include "scene/scene.h"

#include <string.h>

/* Beyond this along the surface, in walls, a drain touches itself: nearer it is only bent. */
#define MIN_SELF_CONTACT_ARC_RATIO 3.0

/* ---- room in the system */

/* Each node may be a separator; beside its neighbours along the thread it is coupled by contacts, and
 * elimination fills in more. */
#define PAIRS_PER_SEPARATOR 24u
/* The same of a drain, where it is no more than all of its nodes. */
#define PAIRS_PER_DRAIN_NODE 128u
/* Separators are eliminated later than the order of the drain has them, which fills in more: so many times what it does
 * without. */
#define FILL_IN_ENTRY_RATIO 4u
#define FILL_IN_PRODUCT_RATIO 8u

static void add_capacity(vbss_system_capacity *capacity, const drain_object *d)
{
    uint32_t n = d->mesh.node_count, all = n * (n - 1) / 2, max_pairs = PAIRS_PER_DRAIN_NODE * n;
    capacity->blocks += n;
    capacity->couplings += d->order.pair_count;
    capacity->entries += FILL_IN_ENTRY_RATIO * d->order.factor_entries;
    capacity->products += FILL_IN_PRODUCT_RATIO * d->order.factor_products;
    capacity->separators += n;
    capacity->pairs += all < max_pairs ? all : max_pairs;
}

vbss_result vbss_scene_create_system(scene_object *s, const drain_object *added)
{
    uint32_t blocks = s->node_capacity + 2 * s->config.rigid_capacity;
    vbss_system_capacity capacity = vbss_system_capacity_of_chains(blocks, THREAD_BANDWIDTH, blocks,
                                                                   PAIRS_PER_SEPARATOR * blocks);
    vbss_system *new_system;
    for (uint32_t i = 0; i < s->body_count; i++) {
        if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            add_capacity(&capacity, s->bodies[i].drain.drain);
        }
    }
    if (added != NULL) {
        add_capacity(&capacity, added);
    }
    VBSS_TRY(vbss_system_create_with_capacity(s->context, &capacity, &new_system));
    vbss_system_destroy(s->context, s->system);
    s->system = new_system;
    s->pattern_hash = 0;
    return VBSS_OK;
}

/* ---- joining and leaving */

enum { ARRAY_COUNT = 6 };
/* Of a surface: most sides of triangles a node. */
#define EDGES_PER_NODE 3u

static void list_arrays(scene_drain *b, uint32_t nodes, vbss_array arrays[ARRAY_COUNT])
{
    const vbss_array all[ARRAY_COUNT] = {
        {&b->is_separator, nodes, sizeof *b->is_separator},
        {&b->expected_displacements, nodes, sizeof *b->expected_displacements},
        {&b->vertices, 2 * (size_t)nodes, sizeof *b->vertices},
        {&b->lip_of_side, EDGES_PER_NODE * (size_t)nodes, sizeof *b->lip_of_side},
        {&b->lip_of_node, nodes, sizeof *b->lip_of_node},
        {&b->near_features, EDGES_PER_NODE * (size_t)nodes, sizeof *b->near_features}};
    memcpy(arrays, all, sizeof all);
}

static vbss_result check_drain(const scene_object *s, const vbss_slot *slot, const uint32_t *number)
{
    const drain_object *d = slot->object;
    VBSS_TRY(vbss_check_pointer(s->context, number, "body"));
    if (slot->context != s->context) {
        return vbss_fail(s->context, VBSS_ERROR_INVALID_HANDLE,
                         "drain %llu belongs to another context",
                         (unsigned long long)slot->ordinal);
    }
    if (d->config.method != s->config.method) {
        return vbss_fail(s->context, VBSS_ERROR_OUT_OF_RANGE,
                         "the drain's method is not the scene's");
    }
    return VBSS_OK;
}

static vbss_result add_shape(scene_object *s, const drain_object *d, uint32_t *shape)
{
    const drain_mesh *m = &d->mesh;
    double wall = d->config.thickness;
    VBSS_TRY(vbss_collision_add_mesh(scene_collision(s), m->node_count, m->triangles[0],
                                     m->triangle_count, 0.5 * wall, shape));
    if (s->config.method == VBSS_METHOD_PAPER) {
        /* Edges alone, against those of others: docs/paper-scene.md. */
        s->collision->shapes[*shape]->is_rigid = true;
        s->collision->shapes[*shape]->edges_only = true;
        return VBSS_OK;
    }
    vbss_result result = vbss_collision_exclude_near(s->collision, *shape, m->rest,
                                                     MIN_SELF_CONTACT_ARC_RATIO * wall);
    if (result != VBSS_OK) {
        (void)vbss_collision_remove(scene_collision(s), *shape);
    }
    return result;
}

static uint32_t find_edge(const collision_shape *shape, uint32_t p, uint32_t q)
{
    uint32_t i = 0;
    while ((shape->edges[i][0] != p || shape->edges[i][1] != q) &&
           (shape->edges[i][0] != q || shape->edges[i][1] != p)) {
        i++;
    }
    return i;
}

static void find_lips(scene_drain *b, const collision_shape *shape)
{
    const drain_mesh *m = &b->drain->mesh;
    for (uint32_t i = 0; i < shape->edge_count; i++) {
        b->lip_of_side[i] = SCENE_NO_FACE;
    }
    for (uint32_t i = 0; i < m->node_count; i++) {
        b->lip_of_node[i] = SCENE_NO_FACE;
    }
    for (uint32_t t = 0; t < m->triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            uint32_t p = m->triangles[t][(k + 1) % 3], q = m->triangles[t][(k + 2) % 3];
            if (m->opposite_node[t][k] == DRAIN_NONE) {
                b->lip_of_side[find_edge(shape, p, q)] = t;
                b->lip_of_node[p] = b->lip_of_node[q] = t;
            }
        }
    }
}

static vbss_result create_drain_data(scene_object *s, scene_drain *b, uint32_t *shape)
{
    vbss_array arrays[ARRAY_COUNT];
    list_arrays(b, b->drain->mesh.node_count, arrays);
    VBSS_TRY(vbss_allocate_arrays(s->context, arrays, ARRAY_COUNT, "drain in a scene"));
    VBSS_TRY(add_shape(s, b->drain, shape));
    find_lips(b, s->collision->shapes[*shape]);
    vbss_result result =
        s->config.method == VBSS_METHOD_OURS ? vbss_scene_create_system(s, b->drain) : VBSS_OK;
    if (result != VBSS_OK) {
        (void)vbss_collision_remove(scene_collision(s), *shape);
    }
    return result;
}

vbss_result vbss_scene_add_drain(vbss_scene *scene, vbss_drain *drain, uint32_t *body)
{
    scene_object *s;
    vbss_slot *slot;
    uint32_t shape = 0;
    VBSS_TRY(vbss_scene_open_for_edit(scene, &s));
    VBSS_TRY(vbss_slot_edit_unowned(drain, &vbss_drain_kind, &slot));
    VBSS_TRY(check_drain(s, slot, body));
    scene_body *b = vbss_scene_find_free_body(s, SCENE_BODY_DRAIN);
    if (b == NULL) {
        return VBSS_ERROR_CAPACITY;
    }
    scene_drain own = {.slot = slot, .drain = slot->object};
    vbss_result result = create_drain_data(s, &own, &shape);
    if (result != VBSS_OK) {
        vbss_array arrays[ARRAY_COUNT];
        list_arrays(&own, own.drain->mesh.node_count, arrays);
        vbss_release_arrays(s->context, arrays, ARRAY_COUNT);
        return result;
    }
    *b = (scene_body){.drain = own};
    slot->owner = s;
    vbss_scene_register_body(s, b, SCENE_BODY_DRAIN, shape, body);
    return VBSS_OK;
}

void vbss_scene_disown_drain(scene_object *s, scene_body *b)
{
    vbss_array arrays[ARRAY_COUNT];
    scene_drain *own = &b->drain;
    uint32_t nodes = s->collision->shapes[b->shape]->node_count;
    own->slot->owner = NULL;
    if (own->slot->object == own->drain) { /* it may have ended with the context */
        own->drain->is_sparsity_valid = false;
        memset(own->drain->contact_forces, 0, nodes * sizeof *own->drain->contact_forces);
    }
    list_arrays(own, nodes, arrays);
    vbss_release_arrays(s->context, arrays, ARRAY_COUNT);
}

/* ---- in a step */

void vbss_scene_checkpoint_drain(scene_drain *b)
{
    drain_object *d = b->drain;
    size_t bytes = d->mesh.node_count * sizeof *d->x;
    memcpy(d->saved_x, d->x, bytes);
    memcpy(d->saved_v, d->v, bytes);
    memcpy(d->v_substep_start, d->v, bytes); /* if it waits all of the step */
    b->checkpoint_statistics = d->statistics;
}

void vbss_scene_rollback_drain(scene_drain *b)
{
    drain_object *d = b->drain;
    size_t bytes = d->mesh.node_count * sizeof *d->x;
    memcpy(d->x, d->saved_x, bytes);
    memcpy(d->v, d->saved_v, bytes);
    d->statistics = b->checkpoint_statistics;
}

void vbss_scene_set_drain_displacements(scene_drain *b, const scene_substep *substep)
{
    const drain_object *d = b->drain;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        b->expected_displacements[i] = substep->uses_trial_motion ? vec3_sub(d->trial[i], d->x[i])
                                                                  : vec3_scale(d->v[i], substep->h);
    }
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        const drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            vec3 target = vbss_drain_attachment_position(a, substep->end_fraction);
            b->expected_displacements[a->node] = vec3_sub(target, d->x[a->node]);
        }
    }
    double max_squared = 0.0;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        max_squared = vbss_max_or_nan(vec3_norm_squared(b->expected_displacements[i]), max_squared);
    }
    b->max_displacement = sqrt(max_squared);
}

void vbss_scene_truncate_drain(scene_drain *b, double fraction)
{
    drain_object *d = b->drain;
    for (uint32_t i = 0; i < d->mesh.node_count; i++) {
        /* At 0 it may be no state at all, not even finite. */
        vec3 displacement = fraction > 0.0 ? vec3_sub(d->trial[i], d->x[i]) : vec3_zero();
        d->trial[i] = vec3_add_scaled(d->x[i], fraction, displacement);
    }
}

/* What contacts do to the drains, by node. */
static void accumulate_contact_forces(scene_object *s, scene_drain *b)
{
    drain_object *d = b->drain;
    uint32_t n = d->mesh.node_count;
    memset(d->contact_forces, 0, n * sizeof *d->contact_forces);
    for (uint32_t i = 0; i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        vec3 force;
        bool has_force = vbss_scene_find_contact_force(s->contacts, i, &force);
        for (uint32_t k = 0; has_force && k < constraint->jacobian_block_count; k++) {
            const contact_jacobian_block *t = &constraint->jacobian[k];
            if (t->block >= b->first_block && t->block - b->first_block < n) {
                uint32_t node = d->order.node[t->block - b->first_block];
                d->contact_forces[node] =
                    vec3_add_scaled(d->contact_forces[node], t->weight, force);
            }
        }
    }
}

/* What was held back goes on from where it is. */
static void restart_pins_here(drain_object *d)
{
    for (uint32_t k = 0; k < d->config.attachment_capacity; k++) {
        drain_attachment *a = &d->attachments[k];
        if (a->id != 0 && a->kind == VBSS_DRAIN_ATTACHMENT_PIN) {
            a->position = d->x[a->node];
        }
    }
}

void vbss_scene_finish_drains(scene_object *s, double h)
{
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_drain *b = &s->bodies[i].drain;
        if (s->bodies[i].kind == SCENE_BODY_DRAIN) {
            accumulate_contact_forces(s, b);
            if (s->is_behind_targets) { /* not those of an attempt that was thrown away */
                vbss_drain_compute_internal_forces(b->drain, b->drain->x);
            }
            vbss_drain_finish_substeps(b->drain, b->substep.h);
            if (s->is_behind_targets) {
                restart_pins_here(b->drain);
            }
            vbss_drain_finish_step(b->drain, h);
        }
    }
}

void vbss_scene_paper_arrive_drain(scene_drain *b, double h)
{
    vbss_drain_paper_arrive(b->drain, b->substep.h);
    vbss_drain_finish_step(b->drain, h);
}
