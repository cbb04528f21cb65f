/* Writes a frame, with a part for each body. The frame is written to the back buffer, which becomes
 * the front buffer if everything fits. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/error.h"
#include "visual/visual.h"

/* The source of a part, and the number of its body in a scene, or 0. */
typedef struct visual_label {
    uint32_t source, body;
} visual_label;

/* ---- parts and decals */

static void end_part(const visual_object *v, visual_frame *f)
{
    if (f->part_count > 0 && f->part_count <= v->config.part_capacity) {
        visual_part *p = &f->parts[f->part_count - 1];
        p->vertex_count = f->vertex_count - p->first_vertex;
        p->triangle_count = f->triangle_count - p->first_triangle;
    }
}

/* Begins a part. All vertices and triangles belong to it until the next part begins. */
static void begin_part(const visual_object *v, visual_frame *f, vbss_visual_kind kind,
                       const visual_label *label)
{
    end_part(v, f);
    if (f->part_count < v->config.part_capacity) {
        f->parts[f->part_count] = (visual_part){.kind = (uint32_t)kind,
                                                .source = label->source,
                                                .body = label->body,
                                                .first_vertex = f->vertex_count,
                                                .first_triangle = f->triangle_count};
    }
    f->part_count++;
}

void vbss_visual_add_decal(const visual_object *v, visual_frame *f, vbss_visual_spot_kind kind,
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

static vbss_result draw_thread(visual_object *v, visual_frame *f, const visual_label *label,
                               const scene_geometry *g)
{
    VBSS_TRY(check_node_count(v, g->thread.node_count, "thread"));
    begin_part(v, f, VBSS_VISUAL_KIND_THREAD, label);
    vbss_visual_draw_thread(v, f, &g->thread, g->identity);
    return VBSS_OK;
}

static vbss_result draw_drain(visual_object *v, visual_frame *f, const visual_label *label,
                              const scene_geometry *g)
{
    VBSS_TRY(check_node_count(v, g->drain.node_count, "drain"));
    begin_part(v, f, VBSS_VISUAL_KIND_DRAIN, label);
    vbss_visual_draw_drain(v, f, &g->drain, g->identity);
    return VBSS_OK;
}

static void draw_grasper(visual_object *v, visual_frame *f, const visual_label *label,
                         const scene_grasper_info *g)
{
    begin_part(v, f,
               g->kind == VBSS_GRASPER_KIND_SHEARS ? VBSS_VISUAL_KIND_SHEARS
                                                   : VBSS_VISUAL_KIND_DRIVER,
               label);
    vbss_visual_draw_grasper(v, f, g);
}

/* Draws a body other than a rigid one that is only capsules. */
static vbss_result draw_geometry(visual_object *v, visual_frame *f, const visual_label *label,
                                 const scene_geometry *g)
{
    switch (g->type) {
    case SCENE_GEOMETRY_THREAD:
        return draw_thread(v, f, label, g);
    case SCENE_GEOMETRY_DRAIN:
        return draw_drain(v, f, label, g);
    case SCENE_GEOMETRY_NEEDLE:
        begin_part(v, f, VBSS_VISUAL_KIND_NEEDLE, label);
        vbss_visual_draw_needle(v, f, &g->needle);
        return VBSS_OK;
    default:
        draw_grasper(v, f, label, &g->grasper);
        return VBSS_OK;
    }
}

/* ---- scenes */

/* A hole that no body goes through is not drawn. */
static void add_hole(const visual_object *v, visual_frame *f, const scene_hole_info *hole,
                     uint32_t drain)
{
    if (hole->id != 0 && hole->drain == drain && hole->radius > 0.0) {
        vbss_visual_add_decal(v, f, VBSS_VISUAL_SPOT_HOLE, hole->rest_position, hole->radius);
    }
}

/* Draws a square in the plane of the floor, centred at the point nearest to the origin of the
 * vertices. */
static void draw_floor(const visual_object *v, visual_frame *f, uint32_t source, vec3 up,
                       double floor_height)
{
    const double corners[4][2] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    const vec3 across = vec3_any_normal(up), along = vec3_cross(up, across);
    double height = vec3_dot(v->origin, up) - floor_height;
    const vec3 centre = vec3_add_scaled(v->origin, -height, up);
    begin_part(v, f, VBSS_VISUAL_KIND_FLOOR, &(visual_label){source, 0});
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

static vbss_result draw_body(visual_object *v, visual_frame *f, uint32_t source,
                             const vbss_scene *scene, const scene_body_info *body)
{
    const visual_label label = {source, body->number};
    const scene_geometry geometry = vbss_scene_inspect_geometry(body);
    if (geometry.type != SCENE_GEOMETRY_CAPSULES) {
        return draw_geometry(v, f, &label, &geometry);
    }
    begin_part(v, f, VBSS_VISUAL_KIND_RIGID, &label);
    for (uint32_t i = 0; i < body->capsule_count; i++) {
        const scene_capsule_info capsule = vbss_scene_inspect_capsule(scene, body, i);
        vbss_visual_draw_capsule(v, f, body->pose.orientation, &capsule);
    }
    return VBSS_OK;
}

static vbss_result draw_scene(visual_object *v, visual_frame *f, uint32_t source,
                              const vbss_scene *scene)
{
    scene_info info;
    VBSS_TRY(vbss_scene_inspect(scene, &info));
    for (uint32_t i = 0; i < info.entry_count && vbss_visual_fits(v, f); i++) {
        const scene_body_info body = vbss_scene_inspect_entry(scene, i);
        if (body.number == 0) {
            continue;
        }
        VBSS_TRY(draw_body(v, f, source, scene, &body));
        for (uint32_t k = 0; body.drain != NULL && k < info.config->hole_capacity; k++) {
            const scene_hole_info hole = vbss_scene_inspect_hole(scene, k);
            add_hole(v, f, &hole, body.number);
        }
    }
    if (info.config->floor) {
        draw_floor(v, f, source, info.floor_normal, info.config->floor_height);
    }
    return VBSS_OK;
}

/* ---- replicas of scenes */

static vbss_result draw_copied_body(visual_object *v, visual_frame *f, uint32_t source,
                                    const replica_state *state, const replica_body *body)
{
    const visual_label label = {source, body->number};
    if (body->geometry.type != SCENE_GEOMETRY_CAPSULES) {
        return draw_geometry(v, f, &label, &body->geometry);
    }
    begin_part(v, f, VBSS_VISUAL_KIND_RIGID, &label);
    for (uint32_t i = 0; i < body->capsule_count; i++) {
        vbss_visual_draw_capsule(v, f, body->orientation,
                                 &state->capsules[body->first_capsule + i]);
    }
    return VBSS_OK;
}

static vbss_result draw_state(visual_object *v, visual_frame *f, uint32_t source,
                              const replica_state *state)
{
    for (uint32_t i = 0; i < state->body_count && vbss_visual_fits(v, f); i++) {
        const replica_body *body = &state->bodies[i];
        VBSS_TRY(draw_copied_body(v, f, source, state, body));
        for (uint32_t k = 0; k < state->hole_count; k++) {
            add_hole(v, f, &state->holes[k], body->number);
        }
    }
    if (state->has_floor) {
        draw_floor(v, f, source, state->floor_normal, state->floor_height);
    }
    return VBSS_OK;
}

/* A replica that was destroyed draws nothing. */
static vbss_result draw_replica(visual_object *v, visual_frame *f, const visual_source *source)
{
    const replica_state *state;
    const vbss_result result = vbss_replica_begin_reading(source->handle, &state);
    if (result == VBSS_ERROR_INVALID_HANDLE) {
        return VBSS_OK;
    }
    if (result != VBSS_OK) {
        return vbss_fail(v->context, result, "another thread reads the replica of source %u",
                         source->number);
    }
    const vbss_result drawn = draw_state(v, f, source->number, state);
    vbss_replica_end_reading(source->handle);
    return drawn;
}

/* ---- sources */

/* A source that was destroyed draws nothing. */
static vbss_result draw_source(visual_object *v, visual_frame *f, const visual_source *source)
{
    vbss_slot *slot;
    scene_body_info body = {.number = 0};
    if (source->is_replica) {
        return draw_replica(v, f, source);
    }
    if (source->number == 0 ||
        vbss_scene_inspect_handle(source->type, source->handle, &slot) != VBSS_OK) {
        return VBSS_OK;
    }
    switch (source->type) {
    case SCENE_HANDLE_SCENE:
        return draw_scene(v, f, source->number, (const vbss_scene *)source->handle);
    case SCENE_HANDLE_THREAD:
        body.thread = (vbss_thread *)source->handle;
        break;
    case SCENE_HANDLE_DRAIN:
        body.drain = (vbss_drain *)source->handle;
        break;
    case SCENE_HANDLE_NEEDLE:
        body.needle = (vbss_needle *)source->handle;
        break;
    default:
        body.grasper = (vbss_grasper *)source->handle;
        break;
    }
    const scene_geometry geometry = vbss_scene_inspect_geometry(&body);
    return draw_geometry(v, f, &(visual_label){source->number, 0}, &geometry);
}

static vbss_result fail_capacity(const visual_object *v, const visual_frame *f)
{
    return vbss_fail(v->context, VBSS_ERROR_CAPACITY,
                     "what is drawn does not fit: at least %u vertices, %u triangles, %u parts, %u "
                     "spots",
                     f->vertex_count, f->triangle_count, f->part_count, f->decal_count);
}

/* Records that an update has not replaced are out of date after it, also if it failed. */
static void forget_records(const visual_object *v, visual_frame *f)
{
    const uint32_t parts = v->config.part_capacity;
    for (uint32_t i = f->wall_count; i < parts; i++) {
        f->walls[i].drain = NULL;
    }
    for (uint32_t i = f->loft_count; i < VISUAL_LOFTS_PER_PART * parts; i++) {
        f->lofts[i].sides = 0;
    }
}

static vbss_result draw_frame(visual_object *v, visual_frame *f)
{
    f->vertex_count = f->triangle_count = f->part_count = f->decal_count = 0;
    f->tube_start_count = f->wall_count = f->loft_count = 0;
    for (uint32_t i = 0; i < v->config.source_capacity && vbss_visual_fits(v, f); i++) {
        VBSS_TRY(draw_source(v, f, &v->sources[i]));
    }
    end_part(v, f);
    return vbss_visual_fits(v, f) ? VBSS_OK : fail_capacity(v, f);
}

vbss_result vbss_visual_update(vbss_visual *visual)
{
    VBSS_ENTER(visual);
    vbss_slot *slot;
    VBSS_TRY(vbss_slot_edit(visual, &vbss_visual_kind_of_slot, &slot));
    visual_object *v = slot->object;
    visual_frame *f = &v->frames[1 - v->front];
    const vbss_result result = draw_frame(v, f);
    forget_records(v, f);
    VBSS_TRY(result);
    v->front = 1 - v->front;
    v->generation++;
    v->updates++;
    return VBSS_OK;
}
