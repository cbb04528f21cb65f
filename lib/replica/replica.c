/* Public object of replicas: configuration, creation, destruction. */
#include "replica/replica.h"

#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/memory.h"
#include "base/stream.h"

_Static_assert(sizeof(vbss_replica_config) == 8, "published size");

static const vbss_replica_config defaults = {.struct_size = sizeof(vbss_replica_config)};
static const uint32_t config_sizes[] = {8, 0};
static const vbss_layout config_layout = {"vbss_replica_config", &defaults, config_sizes};

vbss_result vbss_replica_config_init(vbss_replica_config *config, uint32_t struct_size)
{
    return vbss_config_init(&config_layout, config, struct_size);
}

/* ---- memory */

enum { ARRAYS_PER_STATE = 23, ARRAY_COUNT = 3 * ARRAYS_PER_STATE };

static uint32_t list_state(const replica_capacities *c, replica_state *s, vbss_array *arrays)
{
    const size_t nodes = (size_t)c->thread_nodes + c->drain_nodes;
    const size_t triangles = (size_t)c->drain_nodes * REPLICA_TRIANGLES_PER_NODE;
    const size_t edges = (size_t)c->drain_nodes * REPLICA_EDGES_PER_NODE;
    const vbss_array list[ARRAYS_PER_STATE] = {
        {&s->bodies, c->bodies, sizeof *s->bodies},
        {&s->body_rows, c->bodies, sizeof *s->body_rows},
        {&s->poses, c->bodies, sizeof *s->poses},
        {&s->sizes, c->bodies, sizeof *s->sizes},
        {&s->nodes, nodes, sizeof *s->nodes},
        {&s->tensions, nodes, sizeof *s->tensions},
        {&s->rest_lengths, nodes, sizeof *s->rest_lengths},
        {&s->mesh_identities, c->drains, sizeof *s->mesh_identities},
        {&s->rest_positions, c->drain_nodes, sizeof *s->rest_positions},
        {&s->material_coordinates, c->drain_nodes, sizeof *s->material_coordinates},
        {&s->first_edge, c->drain_nodes, sizeof *s->first_edge},
        {&s->triangles, triangles, sizeof *s->triangles},
        {&s->edges, edges, sizeof *s->edges},
        {&s->next_edge, edges, sizeof *s->next_edge},
        {&s->capsules, c->capsules, sizeof *s->capsules},
        {&s->holes, c->holes, sizeof *s->holes},
        {&s->hole_bodies, c->holes, sizeof *s->hole_bodies},
        {&s->hole_rows, c->holes, sizeof *s->hole_rows},
        {&s->contact_features, c->contacts, sizeof *s->contact_features},
        {&s->contact_points, c->contacts, sizeof *s->contact_points},
        {&s->contact_normals, c->contacts, sizeof *s->contact_normals},
        {&s->contact_forces, c->contacts, sizeof *s->contact_forces},
        {&s->contact_gaps, c->contacts, sizeof *s->contact_gaps},
    };
    for (uint32_t i = 0; i < ARRAYS_PER_STATE; i++) {
        arrays[i] = list[i];
    }
    return ARRAYS_PER_STATE;
}

static uint32_t list_arrays(replica_object *r, vbss_array arrays[ARRAY_COUNT])
{
    uint32_t count = 0;
    for (int i = 0; i < 3; i++) {
        count += list_state(&r->capacities, &r->states[i], &arrays[count]);
    }
    return count;
}

static void free_replica(vbss_context *context, void *object)
{
    replica_object *r = object;
    vbss_array arrays[ARRAY_COUNT];
    vbss_release_arrays(context, arrays, list_arrays(r, arrays));
    vbss_release(context, r, 1, sizeof *r);
}

/* A replica is no part of the state, so there is nothing to save. */
static void visit_nothing(vbss_stream *stream, void *object)
{
    (void)stream;
    (void)object;
}

const vbss_kind vbss_replica_kind_of_slot = {
    "replica", VBSS_CODE('R', 'E', 'P', 'L'), 1, free_replica, visit_nothing, NULL};

static vbss_result allocate_replica(vbss_context *context, const replica_capacities *capacities,
                                    replica_object **replica)
{
    vbss_array arrays[ARRAY_COUNT];
    replica_object *r = vbss_allocate(context, 1, sizeof *r, "replica");
    if (r == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    r->context = context;
    r->capacities = *capacities;
    vbss_triple_buffer_init(&r->buffer);
    atomic_init(&r->is_reading, 0);
    vbss_result result = vbss_allocate_arrays(context, arrays, list_arrays(r, arrays), "replica");
    if (result != VBSS_OK) {
        free_replica(context, r);
        return result;
    }
    *replica = r;
    return VBSS_OK;
}

/* ---- creation and destruction */

static uint32_t count_drain_nodes(const vbss_scene *scene, uint32_t entry_count)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < entry_count; i++) {
        const scene_body_info body = vbss_scene_inspect_entry(scene, i);
        count += body.drain != NULL ? vbss_scene_inspect_drain(body.drain).node_count : 0;
    }
    return count;
}

static vbss_result read_config(vbss_context *context, const vbss_replica_config *config,
                               vbss_replica_config *own)
{
    if (config == NULL) {
        *own = defaults;
        return VBSS_OK;
    }
    VBSS_TRY(vbss_config_read(context, &config_layout, config, own));
    return vbss_check_range(context, own->drain_node_capacity, 0.0, 1048576.0,
                            "drain_node_capacity");
}

vbss_result vbss_replica_create(vbss_scene *scene, const vbss_replica_config *config,
                                vbss_replica **replica)
{
    VBSS_ENTER_WITH_RESULT(scene, replica);
    scene_info info;
    VBSS_TRY(vbss_scene_inspect_for_edit(scene, &info));
    VBSS_TRY(vbss_check_pointer(info.context, replica, "replica"));
    vbss_replica_config own;
    VBSS_TRY(read_config(info.context, config, &own));
    const vbss_scene_config *c = info.config;
    const replica_capacities capacities = {
        .bodies = c->thread_capacity + c->rigid_capacity + c->drain_capacity,
        .thread_nodes = c->node_capacity,
        .drains = c->drain_capacity,
        .drain_nodes = own.drain_node_capacity != 0 ? own.drain_node_capacity
                                                    : count_drain_nodes(scene, info.entry_count),
        .capsules = c->capsule_capacity,
        .holes = c->hole_capacity,
        .contacts = c->contact_capacity};
    replica_object *r;
    vbss_slot *slot;
    VBSS_TRY(allocate_replica(info.context, &capacities, &r));
    vbss_result result = vbss_slot_create(info.context, &vbss_replica_kind_of_slot, r, &slot);
    if (result != VBSS_OK) {
        free_replica(info.context, r);
        return result;
    }
    *replica = (vbss_replica *)slot;
    return VBSS_OK;
}

vbss_result vbss_replica_destroy(vbss_replica *replica)
{
    VBSS_ENTER(replica);
    if (replica != NULL) {
        vbss_slot *slot;
        VBSS_TRY(vbss_slot_edit(replica, &vbss_replica_kind_of_slot, &slot));
        replica_object *r = slot->object;
        if (atomic_exchange_explicit(&r->is_reading, 1, memory_order_acquire) != 0) {
            return vbss_fail(r->context, VBSS_ERROR_BUSY, "the reader is in a call on the replica");
        }
    }
    return vbss_slot_destroy(replica, &vbss_replica_kind_of_slot);
}

/* ---- publishing */

vbss_result vbss_replica_publish(vbss_replica *replica, vbss_scene *scene)
{
    VBSS_ENTER(replica);
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(replica, &vbss_replica_kind_of_slot, &slot));
    replica_object *r = slot->object;
    VBSS_TRY(vbss_slot_check_other(r->context, scene, "scene"));
    replica_state *state = &r->states[r->buffer.writer];
    VBSS_TRY(vbss_replica_copy_scene(r, state, scene));
    state->number = ++r->published;
    vbss_triple_buffer_publish(&r->buffer);
    return VBSS_OK;
}
