/* Describes a scene: its configuration, and the data to create each body again. */
#include "base/stream.h"
#include "scene/snapshot/describe.h"
#include "scene/snapshot/snapshot.h"
#include "scene/topology/topology.h"
#include "scene/world/world.h"

/* ---- one body */

static void visit_thread(vbss_stream *stream, scene_body_description *d)
{
    vbss_thread_visit_config(stream, &d->thread, &d->baseline);
    vbss_stream_u32(stream, 10, &d->rest_count, 1);
    if (d->rest_count != 0 && d->rest_count != d->thread.segment_count) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "another number of segments");
        d->rest_count = 0;
    }
}

static void visit_rigid(vbss_stream *stream, scene_rigid_description *d)
{
    vbss_stream_i32(stream, 20, &d->kind, 1);
    vbss_stream_u32(stream, 21, &d->capsule_count, 1);
    vbss_stream_f64(stream, 22, &d->friction, 1);
    vbss_stream_f64(stream, 23, &d->mass, 1);
    vbss_stream_f64(stream, 24, &d->inertia.x, 3);
    vbss_stream_f64(stream, 25, &d->frame.position.x, 3);
    vbss_stream_f64(stream, 26, &d->frame.orientation.w, 4);
}

static void visit_mesh(vbss_stream *stream, scene_static_mesh_description *d)
{
    vbss_stream_u32(stream, 50, &d->vertex_count, 1);
    vbss_stream_u32(stream, 51, &d->triangle_count, 1);
    vbss_stream_f64(stream, 52, &d->friction, 1);
    vbss_stream_f64(stream, 53, &d->thickness, 1);
    vbss_stream_u32(stream, 56, &d->one_sided, 1);
}

static void visit_plane(vbss_stream *stream, scene_plane_description *d)
{
    vbss_stream_f64(stream, 57, &d->plane.normal.x, 3);
    vbss_stream_f64(stream, 58, &d->plane.height, 1);
    vbss_stream_f64(stream, 59, &d->friction, 1);
}

void vbss_scene_visit_body_description(vbss_stream *stream, scene_body_description *d)
{
    vbss_stream_u32(stream, 1, &d->type, 1);
    vbss_stream_u32(stream, 2, &d->entry, 1);
    vbss_stream_u32(stream, 3, &d->shape, 1);
    vbss_stream_u32(stream, 4, &d->number, 1);
    switch (d->type) {
    case SCENE_DESCRIBED_THREAD:
    case SCENE_DESCRIBED_GONE_THREAD:
        visit_thread(stream, d);
        break;
    case SCENE_DESCRIBED_PIECE:
        break;
    case SCENE_DESCRIBED_DRAIN:
        vbss_drain_visit_config(stream, &d->drain, &d->baseline);
        break;
    case SCENE_DESCRIBED_SURFACE:
        vbss_drain_visit_config(stream, &d->drain, &d->baseline);
        vbss_stream_u32(stream, 40, &d->surface.nodes, 5);
        break;
    case SCENE_DESCRIBED_NEEDLE:
        vbss_needle_visit_config(stream, &d->needle);
        break;
    case SCENE_DESCRIBED_GRASPER:
        vbss_grasper_visit_config(stream, &d->grasper, &d->baseline);
        break;
    case SCENE_DESCRIBED_RIGID:
        visit_rigid(stream, &d->rigid);
        break;
    case SCENE_DESCRIBED_RIGID_MESH:
        visit_rigid(stream, &d->rigid_mesh.rigid);
        visit_mesh(stream, &d->rigid_mesh.mesh);
        break;
    case SCENE_DESCRIBED_STATIC_MESH:
        visit_mesh(stream, &d->static_mesh);
        break;
    case SCENE_DESCRIBED_HOST_SURFACE:
    case SCENE_DESCRIBED_WALL:
    case SCENE_DESCRIBED_TEARING_WALL:
        visit_mesh(stream, &d->host_surface.mesh);
        vbss_stream_f64(stream, 57, &d->host_surface.jump_limit, 1);
        vbss_stream_u32(stream, 58, &d->host_surface.compliance_size, 1);
        if (d->type != SCENE_DESCRIBED_HOST_SURFACE) {
            vbss_scene_visit_hole_parameters(stream, 59, &d->host_surface.law);
        }
        if (d->type == SCENE_DESCRIBED_TEARING_WALL) {
            vbss_stream_f64(stream, 60, &d->host_surface.law.tear_energy, 1);
        }
        break;
    case SCENE_DESCRIBED_PLANE:
        visit_plane(stream, &d->plane);
        break;
    default:
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such type of body");
    }
}

void vbss_scene_visit_described_capsule(vbss_stream *stream, scene_capsule *capsule)
{
    vbss_stream_f64(stream, 30, &capsule->local[0].x, 3);
    vbss_stream_f64(stream, 31, &capsule->local[1].x, 3);
    vbss_stream_f64(stream, 32, &capsule->radius, 1);
}

void vbss_scene_visit_described_static_mesh(vbss_stream *stream,
                                            const scene_static_mesh_description *d,
                                            double *vertices, uint32_t *triangles)
{
    vbss_stream_f64(stream, 54, vertices, 3 * (size_t)d->vertex_count);
    vbss_stream_u32(stream, 55, triangles, 3 * (size_t)d->triangle_count);
}

void vbss_scene_visit_described_surface(vbss_stream *stream, const scene_surface_counts *counts,
                                        const scene_surface_arrays *arrays)
{
    vbss_stream_f64(stream, 41, arrays->positions, 3 * (size_t)counts->nodes);
    vbss_stream_u32(stream, 42, arrays->triangles, 3 * (size_t)counts->triangles);
    vbss_stream_u32(stream, 43, arrays->anchors, counts->anchors);
    vbss_stream_f64(stream, 44, arrays->thickness, counts->thicknesses);
    vbss_stream_f64(stream, 45, arrays->young_modulus, counts->moduli);
}

void vbss_scene_visit_described_rest(vbss_stream *stream, double *rest_lengths, uint32_t count)
{
    if (count > 0) {
        vbss_stream_f64(stream, 11, rest_lengths, count);
    }
}

/* ---- writing */

static scene_body_description describe_thread(const thread_object *t, uint32_t type)
{
    const bool is_of_its_lengths = !scene_thread_resizes(t) && type == SCENE_DESCRIBED_THREAD;
    return (scene_body_description){.type = type,
                                    .thread = t->config,
                                    .baseline = t->baseline_config,
                                    .rest_count = is_of_its_lengths ? t->config.segment_count : 0};
}

static scene_rigid_description describe_motion(const scene_rigid *r)
{
    return (scene_rigid_description){.kind = r->kind,
                                     .capsule_count = r->capsule_count,
                                     .friction = r->created_friction,
                                     .mass = r->body.mass,
                                     .inertia = r->body.inertia,
                                     .frame = r->frame};
}

static scene_body_description describe_rigid(const scene_rigid *r)
{
    scene_body_description d = {.type = SCENE_DESCRIBED_RIGID};
    if (r->grasper != NULL) {
        d.type = SCENE_DESCRIBED_GRASPER;
        d.grasper = r->grasper->config;
        d.baseline = r->grasper->baseline_config;
    } else if (r->needle != NULL) {
        d.type = SCENE_DESCRIBED_NEEDLE;
        d.needle = r->needle->config;
    } else if (r->is_plane) {
        d.type = SCENE_DESCRIBED_PLANE;
        d.plane = (scene_plane_description){r->plane, r->created_friction};
    } else {
        d.rigid = describe_motion(r);
    }
    return d;
}

static scene_body_description describe_drain(const drain_object *d)
{
    scene_body_description description = {
        .type = SCENE_DESCRIBED_DRAIN, .drain = d->config, .baseline = d->baseline_config};
    if (d->config.surface != NULL) {
        description.type = SCENE_DESCRIBED_SURFACE;
        description.surface = (scene_surface_counts){
            .nodes = d->surface.node_count,
            .triangles = d->surface.triangle_count,
            .anchors = d->surface.anchor_count,
            .thicknesses = d->surface.thickness != NULL ? d->surface.triangle_count : 0,
            .moduli = d->surface.young_modulus != NULL ? d->surface.triangle_count : 0};
    }
    return description;
}

static void visit_surface(vbss_stream *stream, drain_object *d, const scene_surface_counts *counts)
{
    const scene_surface_arrays arrays = {.positions = &d->mesh.rest->x,
                                         .triangles = d->mesh.triangles[0],
                                         .anchors = d->mesh.anchors,
                                         .thickness = d->triangle_thickness,
                                         .young_modulus = d->triangle_young_modulus};
    vbss_scene_visit_described_surface(stream, counts, &arrays);
}

static scene_body_description describe_mesh(const scene_rigid *r, const collision_shape *shape)
{
    const scene_static_mesh_description mesh = {.vertex_count = shape->node_count,
                                                .triangle_count = shape->triangle_count,
                                                .one_sided = r->mesh.is_one_sided ? 1 : 0,
                                                .friction = r->created_friction,
                                                .thickness = 2.0 * shape->radius};
    if (r->surface != NULL) {
        return (scene_body_description){
            .type = r->surface->law.tear_energy > 0.0 ? SCENE_DESCRIBED_TEARING_WALL
                                                      : SCENE_DESCRIBED_WALL,
            .host_surface = {mesh, r->surface->jump_limit, r->surface->compliance_size,
                             r->surface->law}};
    }
    if (r->is_rigid_mesh) {
        return (scene_body_description){.type = SCENE_DESCRIBED_RIGID_MESH,
                                        .rigid_mesh = {describe_motion(r), mesh}};
    }
    return (scene_body_description){.type = SCENE_DESCRIBED_STATIC_MESH, .static_mesh = mesh};
}

static scene_body_description describe_body(const scene_object *s, const scene_body *b)
{
    if (scene_is_mesh(b)) {
        return describe_mesh(&b->rigid, s->collision->shapes[b->shape]);
    }
    switch (b->kind) {
    case SCENE_BODY_THREAD:
        return describe_thread(b->thread.thread, SCENE_DESCRIBED_THREAD);
    case SCENE_BODY_DRAIN:
        return describe_drain(b->drain.drain);
    default:
        return describe_rigid(&b->rigid);
    }
}

void vbss_scene_visit_body(vbss_stream *stream, scene_object *s, uint32_t entry)
{
    scene_body *b = &s->bodies[entry];
    scene_body_description d = describe_body(s, b);
    d.entry = entry;
    d.shape = b->shape;
    d.number = b->number;
    vbss_scene_visit_body_description(stream, &d);
    if (d.type == SCENE_DESCRIBED_THREAD) {
        vbss_scene_visit_described_rest(stream, b->thread.thread->rest, d.rest_count);
    }
    if (d.type == SCENE_DESCRIBED_SURFACE) {
        visit_surface(stream, b->drain.drain, &d.surface);
    }
    if (d.type == SCENE_DESCRIBED_STATIC_MESH) {
        collision_shape *shape = s->collision->shapes[b->shape];
        vbss_scene_visit_described_static_mesh(stream, &d.static_mesh, &shape->start->x,
                                               shape->triangles[0]);
    }
    if (d.type == SCENE_DESCRIBED_RIGID_MESH) {
        collision_shape *shape = s->collision->shapes[b->shape];
        vbss_scene_visit_described_static_mesh(stream, &d.rigid_mesh.mesh, &shape->posed->local->x,
                                               shape->triangles[0]);
    }
    if (scene_host_surface_of(b) != NULL) {
        vbss_scene_visit_described_static_mesh(stream, &d.host_surface.mesh,
                                               &b->rigid.surface->now->x,
                                               s->collision->shapes[b->shape]->triangles[0]);
    }
    for (uint32_t i = 0; d.type == SCENE_DESCRIBED_RIGID && i < d.rigid.capsule_count; i++) {
        vbss_scene_visit_described_capsule(stream, &s->capsules[b->rigid.first_capsule + i]);
    }
}

/* Pieces follow their thread. If that has left the scene, a description without a body stands in
 * for it. */
static void visit_piece(vbss_stream *stream, const scene_object *s, uint32_t entry,
                        const thread_piece_pool **family)
{
    const scene_body *b = &s->bodies[entry];
    const thread_object *t = b->thread.thread;
    if (t->piece_pool != *family) {
        scene_body_description gone = describe_thread(t, SCENE_DESCRIBED_GONE_THREAD);
        vbss_scene_visit_body_description(stream, &gone);
        *family = t->piece_pool;
    }
    scene_body_description d = {
        .type = SCENE_DESCRIBED_PIECE, .entry = entry, .shape = b->shape, .number = b->number};
    vbss_scene_visit_body_description(stream, &d);
}

static uint32_t count_records(const scene_object *s)
{
    const thread_piece_pool *family = NULL;
    uint32_t count = 0;
    for (uint32_t shape = 0; shape < s->collision->shape_count; shape++) {
        if (s->collision->shapes[shape] == NULL) {
            continue;
        }
        const scene_body *b = &s->bodies[s->body_of_shape[shape]];
        const bool is_thread = b->kind == SCENE_BODY_THREAD || b->is_reserved;
        count += b->is_reserved && b->thread.thread->piece_pool != family ? 2 : 1;
        family = is_thread ? b->thread.thread->piece_pool : family;
    }
    return count;
}

void vbss_scene_describe(vbss_stream *stream, void *object)
{
    scene_object *s = object;
    const thread_piece_pool *family = NULL;
    scene_table_description table = {s->body_count, s->collision->shape_count, count_records(s)};
    vbss_section outer = vbss_stream_open(stream, SCENE_DESCRIPTION, SCENE_DESCRIPTION_VERSION);
    vbss_scene_visit_config(stream, &s->config, &s->baseline_config, &s->solver);
    vbss_scene_visit_table(stream, &table);
    for (uint32_t shape = 0; shape < table.shape_count; shape++) {
        const uint32_t entry = s->body_of_shape[shape];
        if (s->collision->shapes[shape] == NULL) {
            continue;
        }
        if (s->bodies[entry].is_reserved) {
            visit_piece(stream, s, entry, &family);
            continue;
        }
        vbss_scene_visit_body(stream, s, entry);
        if (s->bodies[entry].kind == SCENE_BODY_THREAD) {
            family = s->bodies[entry].thread.thread->piece_pool;
        }
    }
    vbss_stream_close(stream, outer);
}

void vbss_scene_visit_table(vbss_stream *stream, scene_table_description *table)
{
    vbss_stream_u32(stream, 5, &table->entry_count, 1);
    vbss_stream_u32(stream, 6, &table->shape_count, 1);
    vbss_stream_u32(stream, 7, &table->record_count, 1);
}
