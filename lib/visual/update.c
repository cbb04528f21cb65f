/* A frame: a part for each body of what is shown. It is written beside the one that is seen, and takes its place when all of it
 * fits. */
#include "base/check.h"
#include "base/error.h"
#include "visual/visual.h"

/* ---- parts and spots */

static void end_part(const visual_object *v, visual_frame *f)
{
    if (f->part_count > 0 && f->part_count <= v->config.part_capacity) {
        visual_part *p = &f->parts[f->part_count - 1];
        p->vertex_count = f->vertex_count - p->first_vertex;
        p->triangle_count = f->triangle_count - p->first_triangle;
    }
}

void vbss_visual_begin_part(const visual_object *v, visual_frame *f, vbss_visual_kind kind,
                            uint32_t source, uint32_t body)
{
    end_part(v, f);
    if (f->part_count < v->config.part_capacity) {
        f->parts[f->part_count] = (visual_part){.kind = (uint32_t)kind,
                                                .source = source,
                                                .body = body,
                                                .first_vertex = f->vertex_count,
                                                .first_triangle = f->triangle_count};
    }
    f->part_count++;
}

void vbss_visual_add_decal(const visual_object *v, visual_frame *f, vbss_spot_kind kind,
                           vec3 material, double radius)
{
    if (f->decal_count < v->config.spot_capacity) {
        visual_decal *decal = &f->decals[f->decal_count];
        decal->part = (float)(f->part_count - 1);
        decal->kind = (float)kind;
        visual_store(decal->material, material);
        decal->radius = visual_to_float(radius);
    }
    f->decal_count++;
}

bool vbss_visual_fits(const visual_object *v, const visual_frame *f)
{
    return f->vertex_count <= v->config.vertex_capacity &&
           f->triangle_count <= v->config.triangle_capacity &&
           f->part_count <= v->config.part_capacity && f->decal_count <= v->config.spot_capacity;
}

/* ---- bodies */

static vbss_result check_node_count(const visual_object *v, uint32_t count, const char *what)
{
    if (count > v->config.node_capacity) {
        return vbss_fail(v->context, VBSS_ERROR_CAPACITY,
                         "a %s to draw has %u nodes, node_capacity is %u", what, count,
                         v->config.node_capacity);
    }
    return VBSS_OK;
}

static vbss_result draw_thread(visual_object *v, visual_frame *f, uint32_t source, uint32_t body,
                               const vbss_slot *slot)
{
    const thread_object *t = slot->object;
    VBSS_TRY(check_node_count(v, t->node_count, "thread"));
    vbss_visual_begin_part(v, f, VBSS_VISUAL_THREAD, source, body);
    vbss_visual_draw_thread(v, f, slot);
    return VBSS_OK;
}

static vbss_result draw_drain(visual_object *v, visual_frame *f, uint32_t source, uint32_t body,
                              const drain_object *d)
{
    VBSS_TRY(check_node_count(v, d->mesh.node_count, "drain"));
    vbss_visual_begin_part(v, f, VBSS_VISUAL_DRAIN, source, body);
    vbss_visual_draw_drain(v, f, d);
    return VBSS_OK;
}

static void draw_needle(const visual_object *v, visual_frame *f, uint32_t source, uint32_t body,
                        const needle_object *n)
{
    vbss_visual_begin_part(v, f, VBSS_VISUAL_NEEDLE, source, body);
    vbss_visual_draw_needle(v, f, n);
}

static void draw_grasper(const visual_object *v, visual_frame *f, uint32_t source, uint32_t body,
                         const grasper_object *g)
{
    vbss_visual_begin_part(v, f,
                           g->kind == VBSS_GRASPER_SHEARS ? VBSS_VISUAL_SHEARS : VBSS_VISUAL_DRIVER,
                           source, body);
    vbss_visual_draw_grasper(v, f, g);
}

/* ---- scenes */

static void add_holes(const visual_object *v, visual_frame *f, const scene_object *s,
                      const scene_body *body)
{
    const drain_object *d = body->drain.drain;
    for (uint32_t i = 0; i < s->config.hole_capacity; i++) {
        const suture_hole *hole = &s->holes[i];
        if (hole->id == 0 || hole->drain != body->number) {
            continue;
        }
        const scene_body *occupant =
            vbss_scene_body(s, hole->needle != 0 ? hole->needle : hole->thread);
        if (occupant != NULL) {
            double radius = hole->needle != 0 ? occupant->rigid.needle->config.wire_radius
                                              : occupant->thread.thread->config.radius;
            vbss_visual_add_decal(
                v, f, VBSS_SPOT_HOLE,
                vbss_drain_point(d, d->mesh.rest, hole->triangle, hole->barycentric), radius);
        }
    }
}

static vbss_result draw_body(visual_object *v, visual_frame *f, uint32_t source, scene_object *s,
                             const scene_body *body)
{
    const scene_rigid *rigid = &body->rigid;
    switch (body->kind) {
    case SCENE_BODY_THREAD:
        return draw_thread(v, f, source, body->number, body->thread.slot);
    case SCENE_BODY_DRAIN:
        VBSS_TRY(draw_drain(v, f, source, body->number, body->drain.drain));
        add_holes(v, f, s, body);
        return VBSS_OK;
    case SCENE_BODY_RIGID:
        if (rigid->needle != NULL) {
            draw_needle(v, f, source, body->number, rigid->needle);
        } else if (rigid->grasper != NULL) {
            draw_grasper(v, f, source, body->number, rigid->grasper);
        } else {
            vbss_visual_begin_part(v, f, VBSS_VISUAL_RIGID, source, body->number);
            vbss_visual_draw_rigid(v, f, s, rigid);
        }
        return VBSS_OK;
    default:
        return VBSS_OK;
    }
}

/* A square in the floor's plane, round the place that is nearest to the origin of vertices. */
static void draw_floor(const visual_object *v, visual_frame *f, uint32_t source,
                       const scene_object *s)
{
    const double corners[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    const vec3 up = s->floor_normal;
    const vec3 across = vec3_any_normal(up), along = vec3_cross(up, across);
    double height = vec3_dot(v->origin, up) - s->config.floor_height;
    const vec3 centre = vec3_add_scaled(v->origin, -height, up);
    vbss_visual_begin_part(v, f, VBSS_VISUAL_FLOOR, source, 0);
    const uint32_t first = f->vertex_count;
    f->vertex_count += 4;
    for (uint32_t i = 0; i < 4; i++) {
        double a = corners[i][0] * v->config.floor_size, b = corners[i][1] * v->config.floor_size;
        visual_point p = {vec3_add_scaled(vec3_add_scaled(centre, a, across), b, along),
                          up,
                          {a, b},
                          vec3_make(a, b, 0.0),
                          0.0};
        visual_set_vertex(v, f, first + i, &p);
    }
    visual_add_triangle(v, f, first, first + 1, first + 2);
    visual_add_triangle(v, f, first, first + 2, first + 3);
}

static vbss_result draw_scene(visual_object *v, visual_frame *f, uint32_t source, scene_object *s)
{
    for (uint32_t i = 0; i < s->body_count && vbss_visual_fits(v, f); i++) {
        VBSS_TRY(draw_body(v, f, source, s, &s->bodies[i]));
    }
    if (s->config.floor) {
        draw_floor(v, f, source, s);
    }
    return VBSS_OK;
}

/* ---- sources */

/* One that was destroyed shows nothing. */
static vbss_result draw_source(visual_object *v, visual_frame *f, const visual_source *source)
{
    vbss_slot *slot;
    if (source->number == 0 || vbss_slot_open(source->handle, source->kind, &slot) != VBSS_OK) {
        return VBSS_OK;
    }
    if (source->kind == &vbss_scene_kind) {
        return draw_scene(v, f, source->number, slot->object);
    }
    if (source->kind == &vbss_thread_kind) {
        return draw_thread(v, f, source->number, 0, slot);
    }
    if (source->kind == &vbss_drain_kind) {
        return draw_drain(v, f, source->number, 0, slot->object);
    }
    if (source->kind == &vbss_needle_kind) {
        draw_needle(v, f, source->number, 0, slot->object);
    } else {
        draw_grasper(v, f, source->number, 0, slot->object);
    }
    return VBSS_OK;
}

static vbss_result fail_capacity(const visual_object *v, const visual_frame *f)
{
    return vbss_fail(v->context, VBSS_ERROR_CAPACITY,
                     "what is drawn does not fit: at least %u vertices, %u triangles, %u parts, %u "
                     "spots",
                     f->vertex_count, f->triangle_count, f->part_count, f->decal_count);
}

vbss_result vbss_visual_update(vbss_visual *visual)
{
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(visual, &vbss_visual_kind_of_slot, &slot));
    visual_object *v = slot->object;
    VBSS_TRY(vbss_check_arithmetic(v->context));
    visual_frame *f = &v->frames[1 - v->front];
    f->vertex_count = f->triangle_count = f->part_count = f->decal_count = f->tube_start_count = 0;
    for (uint32_t i = 0; i < v->config.source_capacity && vbss_visual_fits(v, f); i++) {
        VBSS_TRY(draw_source(v, f, &v->sources[i]));
    }
    end_part(v, f);
    if (!vbss_visual_fits(v, f)) {
        return fail_capacity(v, f);
    }
    v->front = 1 - v->front;
    v->generation++;
    v->updates++;
    return VBSS_OK;
}
