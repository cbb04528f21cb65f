/* Functions for the reader of a replica. They run while another thread may be inside the context of
 * the replica, so they touch nothing of that context: no error text, no log, no memory. */
#include "replica/replica.h"

#include "base/api_call.h"
#include "base/config.h"

_Static_assert(sizeof(vbss_replica_state) == 88, "published size");
_Static_assert(sizeof(replica_body_row) == 32, "numbers side by side");
_Static_assert(sizeof(replica_hole_row) == 64, "numbers side by side");
_Static_assert(sizeof(scene_capsule_info) == 56, "numbers side by side");

static const uint32_t state_sizes[] = {88, 0};
static const vbss_layout state_layout = {"vbss_replica_state", NULL, state_sizes};

/* ---- entering and leaving */

static vbss_result begin(const void *handle, replica_object **replica)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_open_shared(handle, &vbss_replica_kind_of_slot, &slot));
    replica_object *r = slot->object;
    if (atomic_exchange_explicit(&r->is_reading, 1, memory_order_acquire) != 0) {
        return VBSS_ERROR_BUSY;
    }
    *replica = r;
    return VBSS_OK;
}

static void end(replica_object *r)
{
    atomic_store_explicit(&r->is_reading, 0, memory_order_release);
}

vbss_result vbss_replica_begin_reading(const void *replica, const replica_state **state)
{
    replica_object *r;
    VBSS_TRY(begin(replica, &r));
    *state = &r->states[r->buffer.reader];
    return VBSS_OK;
}

void vbss_replica_end_reading(const void *replica)
{
    end(((const vbss_slot *)replica)->object);
}

/* ---- taking */

static vbss_replica_state take(replica_object *r)
{
    const uint64_t last = r->states[r->buffer.reader].number;
    const bool is_new = vbss_triple_buffer_fetch(&r->buffer);
    const replica_state *s = &r->states[r->buffer.reader];
    if (is_new) {
        r->missed += s->number - last - 1;
    }
    vbss_replica_state own = {.struct_size = sizeof own,
                              .is_new = is_new,
                              .number = s->number,
                              .missed = r->missed,
                              .steps = s->steps,
                              .time = s->time,
                              .bytes = s->bytes,
                              .floor = s->has_floor,
                              .floor_height = s->floor_height};
    vec3_store(own.floor_normal, s->floor_normal);
    return own;
}

vbss_result vbss_replica_take(vbss_replica *replica, vbss_replica_state *state,
                              uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    replica_object *r;
    vbss_replica_state none = {.struct_size = sizeof none};
    if (state != NULL) { /* a wrong size takes nothing */
        VBSS_TRY(vbss_struct_write(NULL, &state_layout, &none, state, struct_size));
    }
    VBSS_TRY(begin(replica, &r));
    const vbss_replica_state own = take(r);
    end(r);
    return state != NULL ? vbss_struct_write(NULL, &state_layout, &own, state, struct_size)
                         : VBSS_OK;
}

/* ---- views */

typedef struct array_shape {
    const void *data;
    uint32_t count;
    vbss_view_type type;
    uint32_t components;
} array_shape;

static bool find_array(const replica_state *s, vbss_replica_field field, array_shape *shape)
{
    const array_shape arrays[] = {
        [VBSS_REPLICA_VIEW_BODIES] = {s->body_rows, s->body_count, VBSS_VIEW_TYPE_U32, 8},
        [VBSS_REPLICA_VIEW_POSES] = {s->poses, s->body_count, VBSS_VIEW_TYPE_F64, 7},
        [VBSS_REPLICA_VIEW_SIZES] = {s->sizes, s->body_count, VBSS_VIEW_TYPE_F64, 2},
        [VBSS_REPLICA_VIEW_NODES] = {s->nodes, s->node_count, VBSS_VIEW_TYPE_F64, 3},
        [VBSS_REPLICA_VIEW_TENSIONS] = {s->tensions, s->node_count, VBSS_VIEW_TYPE_F64, 1},
        [VBSS_REPLICA_VIEW_TRIANGLES] = {s->triangles, s->triangle_count, VBSS_VIEW_TYPE_U32, 3},
        [VBSS_REPLICA_VIEW_CAPSULES] = {s->capsules, s->capsule_count, VBSS_VIEW_TYPE_F64, 7},
        [VBSS_REPLICA_VIEW_HOLES] = {s->hole_bodies, s->hole_count, VBSS_VIEW_TYPE_U32, 4},
        [VBSS_REPLICA_VIEW_HOLE_PLACES] = {s->hole_rows, s->hole_count, VBSS_VIEW_TYPE_F64, 8},
        [VBSS_REPLICA_VIEW_CONTACTS] = {s->contact_features, s->contact_count, VBSS_VIEW_TYPE_U32,
                                        5},
        [VBSS_REPLICA_VIEW_CONTACT_POINTS] = {s->contact_points, s->contact_count,
                                              VBSS_VIEW_TYPE_F64, 3},
        [VBSS_REPLICA_VIEW_CONTACT_NORMALS] = {s->contact_normals, s->contact_count,
                                               VBSS_VIEW_TYPE_F64, 3},
        [VBSS_REPLICA_VIEW_CONTACT_FORCES] = {s->contact_forces, s->contact_count,
                                              VBSS_VIEW_TYPE_F64, 3},
        [VBSS_REPLICA_VIEW_CONTACT_GAPS] = {s->contact_gaps, s->contact_count, VBSS_VIEW_TYPE_F64,
                                            1},
    };
    const bool known = field >= 0 && (size_t)field < sizeof arrays / sizeof arrays[0];
    *shape = arrays[known ? field : 0];
    return known;
}

vbss_result vbss_replica_get_view(vbss_replica *replica, vbss_replica_field field, vbss_view *view,
                                  uint32_t struct_size)
{
    VBSS_ENTER(NULL);
    replica_object *r;
    array_shape shape;
    VBSS_TRY(begin(replica, &r));
    const replica_state *s = &r->states[r->buffer.reader];
    const bool known = find_array(s, field, &shape);
    const uint64_t number = s->number;
    end(r);
    if (!known) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    const uint32_t size =
        (uint32_t)(shape.type == VBSS_VIEW_TYPE_F64 ? sizeof(double) : sizeof(uint32_t));
    const vbss_view own = {.struct_size = sizeof own,
                           .type = shape.type,
                           .count = shape.count,
                           .components = shape.components,
                           .stride_bytes = shape.components * size,
                           .generation = number,
                           .data = shape.data};
    return vbss_struct_write(NULL, &vbss_view_layout, &own, view, struct_size);
}
