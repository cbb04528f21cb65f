/* Copies what is visible of a scene into a state of a replica. */
#include "replica/replica.h"

#include <string.h>

#include "base/error.h"

/* Where the copy is under way. */
typedef struct copier {
    const replica_object *replica;
    replica_state *state;
    const vbss_scene *scene;
} copier;

/* Copies an array, and counts its bytes. */
static void copy(const copier *c, void *to, const void *from, size_t count, size_t size)
{
    if (count > 0) {
        memcpy(to, from, count * size);
        c->state->bytes += count * size;
    }
}

static vbss_result check_room(const copier *c, uint32_t used, uint32_t more, uint32_t capacity,
                              const char *what)
{
    if (more <= capacity && used <= capacity - more) {
        return VBSS_OK;
    }
    return vbss_fail(c->replica->context, VBSS_ERROR_CAPACITY,
                     "the replica has room for %u %s, the scene has more", capacity, what);
}

/* ---- bodies */

static vbss_result copy_thread(const copier *c, scene_thread_info *t, replica_body_row *row)
{
    replica_state *s = c->state;
    const uint32_t thread_nodes = s->node_count - s->drain_node_count;
    VBSS_TRY(check_room(c, thread_nodes, t->node_count, c->replica->capacities.thread_nodes,
                        "nodes of threads"));
    const uint32_t first = s->node_count, segments = t->node_count - 1;
    copy(c, &s->nodes[first], t->positions, t->node_count, sizeof *s->nodes);
    copy(c, &s->tensions[first], t->tensions, segments, sizeof *s->tensions);
    copy(c, &s->rest_lengths[first], t->rest_lengths, segments, sizeof *s->rest_lengths);
    s->tensions[first + segments] = 0.0;
    t->positions = &s->nodes[first];
    t->tensions = &s->tensions[first];
    t->rest_lengths = &s->rest_lengths[first];
    row->first_node = first;
    row->node_count = t->node_count;
    s->node_count += t->node_count;
    return VBSS_OK;
}

/* Copies the arrays of a mesh, unless this state has them from an earlier publication. */
static void copy_mesh(const copier *c, const scene_drain_info *d, const void *identity)
{
    replica_state *s = c->state;
    const uint32_t node = s->drain_node_count, triangle = s->triangle_count, edge = s->edge_count;
    if (s->mesh_identities[s->drain_count] == identity) {
        return; /* at the same place, too: the drains before it are the same */
    }
    for (uint32_t i = s->drain_count + 1; i < c->replica->capacities.drains; i++) {
        s->mesh_identities[i] = NULL; /* this mesh may overwrite them in part */
    }
    copy(c, &s->rest_positions[node], d->rest_positions, d->node_count, sizeof *s->rest_positions);
    copy(c, &s->material_coordinates[node], d->material_coordinates, d->node_count,
         sizeof *s->material_coordinates);
    copy(c, &s->first_edge[node], d->first_edge, d->node_count, sizeof *s->first_edge);
    copy(c, &s->triangles[triangle], d->triangles, d->triangle_count, sizeof *s->triangles);
    copy(c, &s->edges[edge], d->edges, d->edge_count, sizeof *s->edges);
    copy(c, &s->next_edge[edge], d->next_edge, d->edge_count, sizeof *s->next_edge);
    s->mesh_identities[s->drain_count] = identity;
}

static vbss_result copy_drain(const copier *c, scene_drain_info *d, const void *identity,
                              replica_body_row *row)
{
    replica_state *s = c->state;
    const replica_capacities *room = &c->replica->capacities;
    VBSS_TRY(check_room(c, s->drain_count, 1, room->drains, "drains"));
    VBSS_TRY(
        check_room(c, s->drain_node_count, d->node_count, room->drain_nodes, "nodes of drains"));
    const uint32_t first = s->node_count, node = s->drain_node_count;
    copy_mesh(c, d, identity);
    copy(c, &s->nodes[first], d->positions, d->node_count, sizeof *s->nodes);
    memset(&s->tensions[first], 0, d->node_count * sizeof *s->tensions);
    d->positions = &s->nodes[first];
    d->rest_positions = &s->rest_positions[node];
    d->material_coordinates = (const double(*)[2]) & s->material_coordinates[node];
    d->first_edge = &s->first_edge[node];
    d->triangles = (const uint32_t(*)[3]) & s->triangles[s->triangle_count];
    d->edges = (const uint32_t(*)[4]) & s->edges[s->edge_count];
    d->next_edge = &s->next_edge[s->edge_count];
    row->first_node = first;
    row->node_count = d->node_count;
    row->first_triangle = s->triangle_count;
    row->triangle_count = d->triangle_count;
    s->drain_count++;
    s->node_count += d->node_count;
    s->drain_node_count += d->node_count;
    s->triangle_count += d->triangle_count;
    s->edge_count += d->edge_count;
    return VBSS_OK;
}

static vbss_result copy_capsules(const copier *c, const scene_body_info *body, replica_body *copied)
{
    replica_state *s = c->state;
    VBSS_TRY(check_room(c, s->capsule_count, body->capsule_count, c->replica->capacities.capsules,
                        "capsules"));
    copied->first_capsule = s->capsule_count;
    copied->capsule_count = body->capsule_count;
    for (uint32_t i = 0; i < body->capsule_count; i++) {
        s->capsules[s->capsule_count++] = vbss_scene_inspect_capsule(c->scene, body, i);
    }
    s->bytes += body->capsule_count * sizeof *s->capsules;
    return VBSS_OK;
}

static vbss_replica_kind kind_of(const scene_geometry *g)
{
    switch (g->type) {
    case SCENE_GEOMETRY_THREAD:
        return VBSS_REPLICA_KIND_THREAD;
    case SCENE_GEOMETRY_DRAIN:
        return VBSS_REPLICA_KIND_DRAIN;
    case SCENE_GEOMETRY_NEEDLE:
        return VBSS_REPLICA_KIND_NEEDLE;
    case SCENE_GEOMETRY_GRASPER:
        return g->grasper.kind == VBSS_GRASPER_KIND_SHEARS ? VBSS_REPLICA_KIND_SHEARS
                                                           : VBSS_REPLICA_KIND_DRIVER;
    default:
        return VBSS_REPLICA_KIND_RIGID;
    }
}

/* Writes the two sizes of a row: radius or half thickness, and the angle of the jaws. */
static void write_sizes(const scene_geometry *g, double sizes[2])
{
    sizes[0] = g->type == SCENE_GEOMETRY_THREAD   ? g->thread.radius
               : g->type == SCENE_GEOMETRY_DRAIN  ? 0.5 * g->drain.thickness
               : g->type == SCENE_GEOMETRY_NEEDLE ? g->needle.wire_radius
                                                  : 0.0;
    sizes[1] = g->type == SCENE_GEOMETRY_GRASPER ? g->grasper.jaw_angle : 0.0;
}

static vbss_result copy_body(const copier *c, const scene_body_info *body)
{
    replica_state *s = c->state;
    VBSS_TRY(check_room(c, s->body_count, 1, c->replica->capacities.bodies, "bodies"));
    replica_body *copied = &s->bodies[s->body_count];
    replica_body_row *row = &s->body_rows[s->body_count];
    *copied = (replica_body){.number = body->number,
                             .orientation = body->pose.orientation,
                             .geometry = vbss_scene_inspect_geometry(body)};
    scene_geometry *g = &copied->geometry;
    *row = (replica_body_row){.kind = (uint32_t)kind_of(g), .number = body->number};
    pose shown = body->host_pose;
    if (g->type == SCENE_GEOMETRY_THREAD) {
        VBSS_TRY(copy_thread(c, &g->thread, row));
        shown = pose_identity();
    } else if (g->type == SCENE_GEOMETRY_DRAIN) {
        VBSS_TRY(copy_drain(c, &g->drain, g->identity, row));
        shown = pose_identity();
    } else {
        VBSS_TRY(copy_capsules(c, body, copied));
        row->first_capsule = copied->first_capsule;
        row->capsule_count = copied->capsule_count;
    }
    pose_store(shown, &s->poses[s->body_count][0], &s->poses[s->body_count][3]);
    write_sizes(g, s->sizes[s->body_count]);
    s->bytes += sizeof *copied + sizeof *row + sizeof *s->poses + sizeof *s->sizes;
    s->body_count++;
    return VBSS_OK;
}

/* ---- holes and contacts */

static vbss_result copy_holes(const copier *c, uint32_t entry_count)
{
    replica_state *s = c->state;
    for (uint32_t i = 0; i < entry_count; i++) {
        const scene_hole_info hole = vbss_scene_inspect_hole(c->scene, i);
        if (hole.id == 0) {
            continue;
        }
        VBSS_TRY(check_room(c, s->hole_count, 1, c->replica->capacities.holes, "holes"));
        const uint32_t bodies[4] = {hole.id, hole.needle, hole.thread, hole.drain};
        replica_hole_row *row = &s->hole_rows[s->hole_count];
        s->holes[s->hole_count] = hole;
        memcpy(s->hole_bodies[s->hole_count], bodies, sizeof bodies);
        vec3_store(row->position, hole.position);
        vec3_store(row->rest_position, hole.rest_position);
        row->radius = hole.radius;
        row->arc_length = hole.arc_length;
        s->hole_count++;
        s->bytes += sizeof hole + sizeof bodies + sizeof *row;
    }
    return VBSS_OK;
}

static vbss_result copy_contacts(const copier *c)
{
    replica_state *s = c->state;
    const scene_contacts_info contacts = vbss_scene_inspect_contacts(c->scene);
    const uint32_t n = contacts.count;
    VBSS_TRY(check_room(c, 0, n, c->replica->capacities.contacts, "contacts"));
    copy(c, s->contact_features, contacts.features, n, sizeof *s->contact_features);
    copy(c, s->contact_points, contacts.points, n, sizeof *s->contact_points);
    copy(c, s->contact_normals, contacts.normals, n, sizeof *s->contact_normals);
    copy(c, s->contact_forces, contacts.forces, n, sizeof *s->contact_forces);
    copy(c, s->contact_gaps, contacts.gaps, n, sizeof *s->contact_gaps);
    s->contact_count = n;
    return VBSS_OK;
}

vbss_result vbss_replica_copy_scene(const replica_object *r, replica_state *state,
                                    const vbss_scene *scene)
{
    scene_info info;
    VBSS_TRY(vbss_scene_inspect(scene, &info));
    const copier c = {r, state, scene};
    state->steps = info.steps;
    state->time = info.time;
    state->has_floor = info.config->floor != 0;
    state->floor_normal = info.floor_normal;
    state->floor_height = info.config->floor_height;
    state->bytes = 0;
    state->body_count = state->node_count = state->capsule_count = state->hole_count = 0;
    state->drain_count = state->drain_node_count = state->triangle_count = state->edge_count = 0;
    for (uint32_t i = 0; i < info.entry_count; i++) {
        const scene_body_info body = vbss_scene_inspect_entry(scene, i);
        if (body.number != 0) {
            VBSS_TRY(copy_body(&c, &body));
        }
    }
    VBSS_TRY(copy_holes(&c, info.config->hole_capacity));
    return copy_contacts(&c);
}
