/* Creates a scene and its bodies from a snapshot alone. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/snapshot.h"
#include "base/stream.h"
#include "drain/surface.h"
#include "scene/api/api.h"
#include "scene/api/inspect.h"
#include "scene/api/place.h"
#include "scene/snapshot/describe.h"
#include "scene/snapshot/snapshot.h"
#include "scene/solve/solve.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

typedef struct scene_loader {
    scene_object *s;
    vbss_stream stream;
    scene_table_description table;
    /* Thread whose pieces come next, and its slot; NULL: no pieces may come. */
    thread_object *family;
    vbss_slot *gone; /* the same slot, if the thread itself is in no scene */
} scene_loader;

static vbss_result refuse(const scene_loader *l, const char *problem)
{
    (void)vbss_fail(l->s->context, VBSS_ERROR_CORRUPT, "scene load: %s (description, byte %llu)",
                    problem, (unsigned long long)l->stream.position);
    return VBSS_ERROR_CORRUPT;
}

static vbss_result check_stream(const scene_loader *l)
{
    if (l->stream.result == VBSS_ERROR_DATA_VERSION) {
        (void)vbss_fail(l->s->context, VBSS_ERROR_DATA_VERSION,
                        "scene load: a newer library wrote the description");
        return VBSS_ERROR_DATA_VERSION;
    }
    return l->stream.result == VBSS_OK ? VBSS_OK : refuse(l, l->stream.problem);
}

/* A body that the library itself refuses to create was described wrongly. */
static vbss_result check_created(const scene_loader *l, vbss_result result)
{
    return result == VBSS_OK || result == VBSS_ERROR_OUT_OF_MEMORY
               ? result
               : refuse(l, "no body has such a configuration");
}

/* ---- where a body belongs */

static vbss_result check_place(const scene_loader *l, const scene_body_description *d)
{
    const scene_object *s = l->s;
    if (d->type == SCENE_DESCRIBED_GONE_THREAD) {
        return VBSS_OK;
    }
    if (d->entry >= l->table.entry_count || s->bodies[d->entry].kind != SCENE_BODY_NONE ||
        s->bodies[d->entry].is_reserved) {
        return refuse(l, "no such entry of the table of bodies");
    }
    if (d->shape < s->collision->shape_count || d->shape >= l->table.shape_count) {
        return refuse(l, "no such shape");
    }
    if (d->type != SCENE_DESCRIBED_PIECE &&
        (d->number <= s->last_body_number || d->number > SCENE_MAX_SHAPES)) {
        return refuse(l, "no such number of a body");
    }
    return VBSS_OK;
}

/* Claims the described entry, number and shape for the body that is placed next. */
static vbss_result claim_place(scene_loader *l, const scene_body_description *d,
                               scene_body_kind kind, scene_body **b)
{
    scene_object *s = l->s;
    if (vbss_scene_find_free_body(s, kind, b) != VBSS_OK) {
        return refuse(l, "more bodies than the scene has room for");
    }
    s->last_body_number = d->number - 1;
    vbss_collision_skip_shapes(s->collision, d->shape);
    *b = &s->bodies[d->entry];
    return VBSS_OK;
}

/* ---- threads and their pieces */

static void forget_family(scene_loader *l)
{
    if (l->gone != NULL) {
        (void)vbss_slot_destroy(l->gone, &vbss_thread_kind);
    }
    l->gone = NULL;
    l->family = NULL;
}

/* Rest lengths of a new thread. The state replaces those of a thread that has no rest lengths in the
 * description, so that any valid length serves. Unit: m. Origin: chosen. Test: scene.load. */
#define PLACEHOLDER_LENGTH 1e-3

static vbss_result create_thread(scene_loader *l, scene_body_description *d, vbss_slot **slot)
{
    vbss_thread *thread = NULL;
    vbss_context *context = l->s->context;
    vbss_thread_config *c = &d->thread;
    const uint32_t count = c->segment_count;
    if (count >= l->s->node_capacity || c->node_capacity > l->s->node_capacity) {
        return refuse(l, "more nodes than the scene has room for");
    }
    double *rest = vbss_allocate(context, count, sizeof *rest, "rest lengths");
    if (rest == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    for (uint32_t i = 0; i < count; i++) {
        rest[i] = PLACEHOLDER_LENGTH;
    }
    vbss_scene_visit_described_rest(&l->stream, rest, d->rest_count);
    c->rest_lengths = rest;
    vbss_result result = check_stream(l);
    if (result == VBSS_OK) {
        result = check_created(l, vbss_thread_create(context, c, &thread));
    }
    c->rest_lengths = NULL;
    vbss_release(context, rest, count, sizeof *rest);
    *slot = (vbss_slot *)thread;
    return result;
}

static vbss_result place_thread(scene_loader *l, const scene_body_description *d, vbss_slot *slot)
{
    scene_body *b;
    uint32_t shape = 0, number;
    const thread_object *t = slot->object;
    if (t->config.method != l->s->config.method) {
        return refuse(l, "a thread of another method");
    }
    VBSS_TRY(claim_place(l, d, SCENE_BODY_THREAD, &b));
    VBSS_TRY(vbss_scene_reserve_rolls(l->s, t));
    VBSS_TRY(vbss_scene_create_thread_shape(l->s, t, &shape));
    vbss_scene_place_thread(l->s, slot, b, shape, &number);
    return VBSS_OK;
}

static vbss_result load_thread(scene_loader *l, scene_body_description *d)
{
    vbss_slot *slot = NULL;
    VBSS_TRY(create_thread(l, d, &slot));
    l->family = slot->object;
    l->gone = slot;
    if (d->type == SCENE_DESCRIBED_THREAD) {
        VBSS_TRY(place_thread(l, d, slot)); /* on failure it is gone, and is destroyed */
        slot->is_owned_for_good = true;
        l->gone = NULL;
    }
    return VBSS_OK;
}

static vbss_result load_piece(scene_loader *l, const scene_body_description *d)
{
    scene_object *s = l->s;
    vbss_slot *slot = NULL;
    uint32_t shape = 0;
    scene_body *free_body;
    if (vbss_scene_find_free_body(s, SCENE_BODY_THREAD, &free_body) != VBSS_OK) {
        return refuse(l, "more threads than the scene has room for");
    }
    thread_object *piece = l->family != NULL ? vbss_thread_acquire_piece(l->family, &slot) : NULL;
    if (piece == NULL) {
        return refuse(l, "a piece without a thread");
    }
    vbss_collision_skip_shapes(s->collision, d->shape);
    vbss_result result = vbss_collision_add_disabled_chain(s->collision, piece->node_capacity,
                                                           piece->config.radius, &shape);
    if (result != VBSS_OK) {
        vbss_thread_return_piece(piece, slot);
        return result;
    }
    slot->is_owned_for_good = true;
    s->bodies[d->entry] = (scene_body){
        .is_reserved = true, .shape = shape, .thread = {.slot = slot, .thread = piece}};
    s->body_of_shape[shape] = d->entry;
    return VBSS_OK;
}

/* ---- bodies of other kinds */

/* Reads the arrays of the surface, and creates a drain with it. */
static vbss_result create_sheet(scene_loader *l, const scene_body_description *d,
                                vbss_drain **drain)
{
    const scene_surface_counts *n = &d->surface;
    vbss_drain_surface surface;
    vbss_drain_config config = d->drain;
    scene_surface_arrays arrays = {0};
    const bool has_counts = (n->thicknesses == 0 || n->thicknesses == n->triangles) &&
                            (n->moduli == 0 || n->moduli == n->triangles) &&
                            n->nodes <= DRAIN_MAX_SURFACE_NODES && n->anchors <= n->nodes &&
                            n->triangles <= 2 * DRAIN_MAX_SURFACE_NODES;
    if (!has_counts) {
        return refuse(l, "no surface has such counts");
    }
    const vbss_array table[] = {{&arrays.positions, 3 * (size_t)n->nodes, sizeof(double)},
                                {&arrays.triangles, 3 * (size_t)n->triangles, sizeof(uint32_t)},
                                {&arrays.anchors, n->anchors, sizeof(uint32_t)},
                                {&arrays.thickness, n->thicknesses, sizeof(double)},
                                {&arrays.young_modulus, n->moduli, sizeof(double)}};
    const size_t count = sizeof table / sizeof table[0];
    vbss_result result = vbss_allocate_arrays(l->s->context, table, count, "surface of a drain");
    if (result == VBSS_OK) {
        vbss_scene_visit_described_surface(&l->stream, n, &arrays);
        result = check_stream(l);
    }
    if (result == VBSS_OK) {
        (void)vbss_drain_surface_init(&surface, sizeof surface);
        surface.node_count = n->nodes;
        surface.triangle_count = n->triangles;
        surface.anchor_count = n->anchors;
        surface.positions = arrays.positions;
        surface.triangles = arrays.triangles;
        surface.anchors = arrays.anchors;
        surface.thickness = n->thicknesses > 0 ? arrays.thickness : NULL;
        surface.young_modulus = n->moduli > 0 ? arrays.young_modulus : NULL;
        config.surface = &surface;
        result = check_created(l, vbss_drain_create(l->s->context, &config, drain));
    }
    vbss_release_arrays(l->s->context, table, count);
    return result;
}

static vbss_result create_drain(scene_loader *l, const scene_body_description *d,
                                vbss_drain **drain)
{
    return d->type == SCENE_DESCRIBED_SURFACE
               ? create_sheet(l, d, drain)
               : check_created(l, vbss_drain_create(l->s->context, &d->drain, drain));
}

static vbss_result load_drain(scene_loader *l, const scene_body_description *d)
{
    vbss_drain *drain = NULL;
    scene_body *b;
    uint32_t number;
    VBSS_TRY(claim_place(l, d, SCENE_BODY_DRAIN, &b));
    if (d->drain.method != l->s->config.method) {
        return refuse(l, "a drain of another method");
    }
    VBSS_TRY(create_drain(l, d, &drain));
    vbss_slot *slot = (vbss_slot *)drain;
    vbss_result result = vbss_scene_place_drain(l->s, slot, b, &number);
    slot->is_owned_for_good = result == VBSS_OK;
    if (result != VBSS_OK) {
        (void)vbss_drain_destroy(drain);
    }
    return result;
}

static vbss_result check_capsules(const scene_loader *l, uint32_t count)
{
    return count > 0 && count <= l->s->config.capsule_capacity - l->s->capsule_count
               ? VBSS_OK
               : refuse(l, "more capsules than the scene has room for");
}

static vbss_result load_needle(scene_loader *l, const scene_body_description *d)
{
    vbss_needle *needle = NULL;
    scene_body *b;
    uint32_t number;
    VBSS_TRY(claim_place(l, d, SCENE_BODY_RIGID, &b));
    VBSS_TRY(check_capsules(l, d->needle.segment_count));
    if (d->needle.method != l->s->config.method) {
        return refuse(l, "a needle of another method");
    }
    VBSS_TRY(check_created(l, vbss_needle_create(l->s->context, &d->needle, &needle)));
    vbss_slot *slot = (vbss_slot *)needle;
    vbss_result result = vbss_scene_place_needle(l->s, slot, b, &number);
    slot->is_owned_for_good = result == VBSS_OK;
    if (result != VBSS_OK) {
        (void)vbss_needle_destroy(needle);
    }
    return result;
}

static vbss_result load_grasper(scene_loader *l, const scene_body_description *d)
{
    vbss_grasper *grasper = NULL;
    scene_body *b;
    uint32_t number;
    VBSS_TRY(claim_place(l, d, SCENE_BODY_RIGID, &b));
    VBSS_TRY(check_capsules(l, GRASPER_CAPSULES));
    if (d->grasper.method != l->s->config.method) {
        return refuse(l, "a grasper of another method");
    }
    VBSS_TRY(check_created(l, vbss_grasper_create(l->s->context, &d->grasper, &grasper)));
    vbss_slot *slot = (vbss_slot *)grasper;
    const pose origin = pose_make(vec3_zero(), quat_identity()); /* the state has the pose */
    vbss_result result = vbss_scene_place_grasper(l->s, slot, origin, b, &number);
    slot->is_owned_for_good = result == VBSS_OK;
    if (result != VBSS_OK) {
        (void)vbss_grasper_destroy(grasper);
    }
    return result;
}

/* Largest coordinate of a capsule in the principal frame of its body.
 * Unit: m. Origin: chosen, twice what hosts can set. Test: scene.load_damage. */
#define MAX_CAPSULE_COORDINATE 4e3

static bool are_capsules_valid(const scene_capsule *capsules, uint32_t count)
{
    bool valid = true;
    for (uint32_t i = 0; i < count; i++) {
        const scene_capsule *c = &capsules[i];
        valid = valid && c->radius >= 1e-6 && c->radius <= 1.0 &&
                vbss_max_abs(&c->local[0].x, 3) <= MAX_CAPSULE_COORDINATE &&
                vbss_max_abs(&c->local[1].x, 3) <= MAX_CAPSULE_COORDINATE;
    }
    return valid;
}

/* A rigid body at the origin, without its shape; the state has its pose. */
static vbss_result init_rigid(const scene_loader *l, const scene_rigid_description *c,
                              scene_rigid *rigid)
{
    *rigid = (scene_rigid){.kind = c->kind,
                           .capsule_count = c->capsule_count,
                           .friction = c->friction,
                           .created_friction = c->friction,
                           .frame = c->frame};
    rigid->body.mass = c->mass;
    rigid->body.inertia = c->inertia;
    rigid->body.now.pose = rigid->body.target_start = rigid->body.target_end = rigid->trial =
        c->frame;
    return c->kind >= VBSS_SCENE_RIGID_DRIVEN && c->kind <= VBSS_SCENE_RIGID_FREE &&
                   vbss_rigid_is_valid(&rigid->body) && c->friction >= 0.0 && c->friction <= 10.0
               ? VBSS_OK
               : refuse(l, "no such rigid body");
}

static vbss_result load_rigid(scene_loader *l, const scene_body_description *d)
{
    const scene_rigid_description *c = &d->rigid;
    scene_object *s = l->s;
    scene_capsule *capsules = s->capsules + s->capsule_count;
    scene_body *b;
    uint32_t number;
    VBSS_TRY(check_capsules(l, c->capsule_count));
    for (uint32_t i = 0; i < c->capsule_count; i++) {
        vbss_scene_visit_described_capsule(&l->stream, &capsules[i]);
        capsules[i].local_end[0] = capsules[i].local[0];
        capsules[i].local_end[1] = capsules[i].local[1];
    }
    VBSS_TRY(check_stream(l));
    scene_rigid rigid;
    VBSS_TRY(init_rigid(l, c, &rigid));
    if (!are_capsules_valid(capsules, c->capsule_count)) {
        return refuse(l, "no such rigid body");
    }
    VBSS_TRY(claim_place(l, d, SCENE_BODY_RIGID, &b));
    return vbss_scene_place_rigid(s, &rigid, b, &number);
}

/* Vertices and triangles of a mesh, read from its record. */
typedef struct mesh_arrays {
    double *vertices;
    uint32_t *triangles;
    vbss_array table[2];
} mesh_arrays;

/* Reads them. On success the caller releases the table. */
static vbss_result read_mesh_arrays(scene_loader *l, const scene_static_mesh_description *m,
                                    mesh_arrays *x)
{
    if (m->vertex_count > SCENE_MAX_MESH_VERTICES || m->triangle_count > SCENE_MAX_MESH_TRIANGLES) {
        return refuse(l, "no mesh has such counts");
    }
    x->vertices = NULL;
    x->triangles = NULL;
    x->table[0] = (vbss_array){&x->vertices, 3 * (size_t)m->vertex_count, sizeof *x->vertices};
    x->table[1] = (vbss_array){&x->triangles, 3 * (size_t)m->triangle_count, sizeof *x->triangles};
    VBSS_TRY(vbss_allocate_arrays(l->s->context, x->table, 2, "mesh"));
    vbss_scene_visit_described_static_mesh(&l->stream, m, x->vertices, x->triangles);
    const vbss_result result = check_stream(l);
    if (result != VBSS_OK) {
        vbss_release_arrays(l->s->context, x->table, 2);
    }
    return result;
}

static vbss_scene_static_mesh_config config_of_mesh(const scene_static_mesh_description *m,
                                                    const mesh_arrays *x)
{
    vbss_scene_static_mesh_config config = vbss_scene_static_mesh_config_default();
    config.vertex_count = m->vertex_count;
    config.triangle_count = m->triangle_count;
    config.one_sided = m->one_sided;
    config.vertices = x->vertices;
    config.triangles = x->triangles;
    config.friction = m->friction;
    config.thickness = m->thickness;
    return config;
}

static vbss_result load_rigid_mesh(scene_loader *l, const scene_body_description *d)
{
    const scene_static_mesh_description *m = &d->rigid_mesh.mesh;
    mesh_arrays x;
    uint32_t number;
    scene_body *b;
    scene_rigid rigid;
    VBSS_TRY(init_rigid(l, &d->rigid_mesh.rigid, &rigid));
    if (rigid.capsule_count != 0) {
        return refuse(l, "a mesh with capsules");
    }
    VBSS_TRY(claim_place(l, d, SCENE_BODY_RIGID, &b));
    VBSS_TRY(read_mesh_arrays(l, m, &x));
    const vbss_scene_static_mesh_config config = config_of_mesh(m, &x);
    vbss_result result = check_created(l, vbss_scene_check_rigid_mesh(l->s->context, &config));
    if (result == VBSS_OK) {
        result = vbss_scene_place_rigid_mesh(l->s, &rigid, &config, true, b, &number);
    }
    vbss_release_arrays(l->s->context, x.table, 2);
    return result;
}

static vbss_result load_static_mesh(scene_loader *l, const scene_body_description *d)
{
    const scene_static_mesh_description *m = &d->static_mesh;
    mesh_arrays x;
    uint32_t number;
    scene_body *b;
    VBSS_TRY(claim_place(l, d, SCENE_BODY_RIGID, &b));
    VBSS_TRY(read_mesh_arrays(l, m, &x));
    const vbss_scene_static_mesh_config config = config_of_mesh(m, &x);
    vbss_result result = check_created(l, vbss_scene_check_static_mesh(l->s->context, &config));
    if (result == VBSS_OK) {
        result = vbss_scene_place_static_mesh(l->s, &config, b, &number);
    }
    vbss_release_arrays(l->s->context, x.table, 2);
    return result;
}

static void set_hole_parameters(vbss_scene_surface_config *config, const vbss_drain_config *law)
{
    config->puncture_force = law->puncture_force;
    config->hole_force = law->hole_force;
    config->hole_friction = law->hole_friction;
    config->hole_stiffness = law->hole_stiffness;
    config->hole_damping = law->hole_damping;
    config->tip_length = law->tip_length;
    config->thread_force = law->thread_force;
    config->tear_energy = law->tear_energy;
}

static vbss_result load_host_surface(scene_loader *l, const scene_body_description *d)
{
    const scene_static_mesh_description *m = &d->host_surface.mesh;
    mesh_arrays x;
    uint32_t number;
    scene_body *b;
    VBSS_TRY(claim_place(l, d, SCENE_BODY_RIGID, &b));
    VBSS_TRY(read_mesh_arrays(l, m, &x));
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = m->vertex_count;
    config.triangle_count = m->triangle_count;
    config.one_sided = m->one_sided;
    config.vertices = x.vertices;
    config.triangles = x.triangles;
    config.friction = m->friction;
    config.thickness = m->thickness;
    config.jump_limit = d->host_surface.jump_limit;
    config.compliance_size = d->host_surface.compliance_size;
    if (d->type != SCENE_DESCRIBED_HOST_SURFACE) {
        set_hole_parameters(&config, &d->host_surface.law);
    }
    vbss_result result = check_created(l, vbss_scene_check_host_surface(l->s->context, &config));
    if (result == VBSS_OK) {
        result = vbss_scene_place_host_surface(l->s, &config, b, &number);
    }
    vbss_release_arrays(l->s->context, x.table, 2);
    return result;
}

static vbss_result load_plane(scene_loader *l, const scene_body_description *d)
{
    const scene_plane_description *p = &d->plane;
    scene_body *b;
    uint32_t number;
    if (!vbss_scene_is_plane_valid(p)) {
        return refuse(l, "no such plane");
    }
    VBSS_TRY(claim_place(l, d, SCENE_BODY_RIGID, &b));
    return vbss_scene_place_plane(l->s, p, b, &number);
}

/* ---- all bodies */

/* The configurations start with the defaults, which also sets their sizes. */
static vbss_result init_config(const scene_loader *l, scene_body_description *d)
{
    vbss_stream head = l->stream;
    uint32_t type = 0;
    vbss_stream_u32(&head, 1, &type, 1);
    switch (type) {
    case SCENE_DESCRIBED_THREAD:
    case SCENE_DESCRIBED_GONE_THREAD:
        return vbss_thread_config_init(&d->thread, sizeof d->thread);
    case SCENE_DESCRIBED_DRAIN:
    case SCENE_DESCRIBED_SURFACE:
        return vbss_drain_config_init(&d->drain, sizeof d->drain);
    case SCENE_DESCRIBED_NEEDLE:
        return vbss_needle_config_init(&d->needle, sizeof d->needle);
    case SCENE_DESCRIBED_GRASPER:
        return vbss_grasper_config_init(&d->grasper, sizeof d->grasper);
    default:
        return VBSS_OK;
    }
}

static vbss_result load_body(scene_loader *l)
{
    scene_body_description d = {.type = 0, .baseline = vbss_baseline_config_default()};
    VBSS_TRY(init_config(l, &d));
    vbss_scene_visit_body_description(&l->stream, &d);
    VBSS_TRY(check_stream(l));
    VBSS_TRY(check_place(l, &d));
    if (d.type != SCENE_DESCRIBED_PIECE) {
        forget_family(l);
    }
    switch (d.type) {
    case SCENE_DESCRIBED_THREAD:
    case SCENE_DESCRIBED_GONE_THREAD:
        return load_thread(l, &d);
    case SCENE_DESCRIBED_PIECE:
        return load_piece(l, &d);
    case SCENE_DESCRIBED_DRAIN:
    case SCENE_DESCRIBED_SURFACE:
        return load_drain(l, &d);
    case SCENE_DESCRIBED_NEEDLE:
        return load_needle(l, &d);
    case SCENE_DESCRIBED_GRASPER:
        return load_grasper(l, &d);
    case SCENE_DESCRIBED_STATIC_MESH:
        return load_static_mesh(l, &d);
    case SCENE_DESCRIBED_RIGID_MESH:
        return load_rigid_mesh(l, &d);
    case SCENE_DESCRIBED_PLANE:
        return load_plane(l, &d);
    case SCENE_DESCRIBED_HOST_SURFACE:
    case SCENE_DESCRIBED_WALL:
    case SCENE_DESCRIBED_TEARING_WALL:
        return load_host_surface(l, &d);
    default: /* SCENE_DESCRIBED_RIGID */
        return load_rigid(l, &d);
    }
}

static vbss_result load_bodies(scene_loader *l)
{
    scene_object *s = l->s;
    vbss_scene_visit_table(&l->stream, &l->table);
    VBSS_TRY(check_stream(l));
    if (l->table.entry_count > s->body_capacity || l->table.shape_count > SCENE_MAX_SHAPES ||
        l->table.record_count > 2 * l->table.entry_count) {
        return refuse(l, "no such tables");
    }
    s->body_count = l->table.entry_count;
    vbss_result result = VBSS_OK;
    for (uint32_t i = 0; result == VBSS_OK && i < l->table.record_count; i++) {
        result = load_body(l);
    }
    forget_family(l);
    vbss_collision_skip_shapes(s->collision, l->table.shape_count);
    vbss_scene_number_nodes(s);
    return result;
}

/* Creates a scene without bodies. */
static vbss_result create_scene(vbss_context *context, vbss_stream *stream, vbss_scene **scene)
{
    vbss_scene_config config = vbss_scene_config_default();
    vbss_baseline_config baseline = vbss_baseline_config_default();
    vbss_solver_options solver = vbss_solver_options_default();
    vbss_scene_visit_config(stream, &config, &baseline, &solver);
    const vbss_result read = stream->result;
    if (read != VBSS_OK) {
        (void)vbss_fail(context, read, "scene load: %s (description, byte %llu)", stream->problem,
                        (unsigned long long)stream->position);
        return read;
    }
    vbss_result result = vbss_scene_create(context, &config, scene);
    if (result == VBSS_OK || result == VBSS_ERROR_OUT_OF_MEMORY) {
        return result;
    }
    (void)vbss_fail(context, VBSS_ERROR_CORRUPT, "scene load: no scene has such a configuration");
    return VBSS_ERROR_CORRUPT;
}

static vbss_result load_described(vbss_context *context, const vbss_snapshot_parts *parts,
                                  vbss_scene **scene)
{
    scene_loader l = {.s = NULL};
    vbss_stream_begin_read(&l.stream, parts->description, parts->description_bytes);
    const vbss_section outer =
        vbss_stream_open(&l.stream, SCENE_DESCRIPTION, SCENE_DESCRIPTION_VERSION);
    VBSS_TRY(create_scene(context, &l.stream, scene));
    l.s = ((vbss_slot *)*scene)->object;
    VBSS_TRY(load_bodies(&l));
    vbss_stream_close(&l.stream, outer);
    VBSS_TRY(check_stream(&l));
    return l.stream.position == parts->description_bytes
               ? VBSS_OK
               : refuse(&l, "data follow the description");
}

vbss_result vbss_scene_inspect_reload(vbss_scene *scene, const uint8_t *bytes, uint64_t count)
{
    vbss_slot *own = (vbss_slot *)scene, *other;
    vbss_scene *loaded = NULL;
    const vbss_result result = vbss_scene_load(own->context, bytes, count, &loaded);
    if (result != VBSS_OK || loaded == NULL) {
        return result;
    }
    other = (vbss_slot *)loaded;
    scene_object *before = own->object, *now = other->object;
    now->hook = before->hook;
    now->report.generation = before->report.generation + 1;
    own->object = now;
    own->hook = &now->hook;
    other->object = before;
    other->hook = &before->hook;
    return vbss_scene_destroy(loaded);
}

vbss_result vbss_scene_load(vbss_context *context, const uint8_t *bytes, uint64_t count,
                            vbss_scene **scene)
{
    VBSS_ENTER_WITH_RESULT(context, scene);
    vbss_snapshot_parts parts;
    vbss_scene *loaded = NULL;
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, scene, "scene"));
    VBSS_TRY(vbss_check_pointer(context, bytes, "bytes"));
    if (count > SIZE_MAX) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT, "scene load: count is too large");
    }
    VBSS_TRY(vbss_snapshot_open(context, "scene load", bytes, (size_t)count, &parts));
    if (parts.description_bytes == 0) {
        return vbss_fail(context, VBSS_ERROR_DATA_VERSION,
                         "scene load: the snapshot does not describe its scene: an older library "
                         "wrote it");
    }
    vbss_result result = load_described(context, &parts, &loaded);
    if (result == VBSS_OK) {
        result = vbss_snapshot_restore((vbss_slot *)loaded, bytes, (size_t)count);
    }
    if (result != VBSS_OK) {
        (void)vbss_scene_destroy(loaded);
        return result;
    }
    *scene = loaded;
    return VBSS_OK;
}
