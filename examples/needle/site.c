#include "needle/site.h"

#include <stdbool.h>

#define GRAVITY (-9.81)

enum { CUTS = 4 }; /* of the thread: both tails, and two more */

/* ---- made */

static void choose(double *value, double wanted)
{
    *value = wanted > 0.0 ? wanted : *value;
}

static vbss_result make_scene(site *s, const site_plan *plan)
{
    vbss_scene_config c;
    TRY(vbss_scene_config_init(&c, sizeof c));
    c.contact_capacity = 4096;
    c.candidate_capacity = 65536;
    c.thread_capacity = 1 + CUTS;
    c.solver = plan->solver;
    c.floor = 1;
    c.floor_normal[1] = 0.0;
    c.floor_normal[2] = 1.0;
    c.floor_height = s->floor;
    choose(&c.thread_friction, plan->material.friction);
    return vbss_scene_create(s->rig.context, &c, &s->rig.scene);
}

/* Its x, y, z are the world's y, z, x. */
static vbss_result add_drain(site *s, const site_plan *plan)
{
    vbss_drain_config c;
    TRY(vbss_drain_config_init(&c, sizeof c));
    s->tube = c.radius;
    s->wall = c.thickness;
    s->floor = -2.0 * c.radius - c.thickness;
    c.position[2] = -c.radius - 0.5 * c.thickness;
    for (int i = 0; i < 4; i++) {
        c.orientation[i] = 0.5;
    }
    TRY(vbss_drain_create(s->rig.context, &c, &s->drain));
    TRY(vbss_drain_get_places(s->drain, &s->places, sizeof s->places));
    TRY(make_scene(s, plan));
    return (plan->without & SITE_NO_DRAIN) != 0
               ? VBSS_OK
               : vbss_scene_add_drain(s->rig.scene, s->drain, &s->drain_body);
}

/* It lies so that turning it clockwise, as seen from above, drives its tip, and counterclockwise if it is mirrored. */
static vbss_result add_needle(site *s, vec place, double turn, const site_plan *plan)
{
    vbss_needle_config c;
    TRY(vbss_needle_config_init(&c, sizeof c));
    s->radius = c.radius;
    s->arc = c.arc;
    s->wire = c.wire_radius;
    c.gravity[2] = GRAVITY;
    place.z = s->floor + c.wire_radius;
    const double turned[4] = {0.0, vbss_cos(0.5 * turn), vbss_sin(0.5 * turn), 0.0};
    v_store(c.position, mirror_vec(plan->mirrored, place));
    mirror_needle(plan->mirrored, turned, c.orientation);
    TRY(vbss_needle_create(s->rig.context, &c, &s->needle));
    return (plan->without & SITE_NO_NEEDLE) != 0
               ? VBSS_OK
               : vbss_scene_add_needle(s->rig.scene, s->needle, &s->needle_body);
}

/* Straight on from the needle's end. */
static vbss_result add_thread(site *s, const site_plan *plan)
{
    const uint32_t segments = plan->segments;
    static vec x[MAX_THREAD_NODES];
    vbss_thread_config c;
    vbss_needle_state needle;
    uint32_t pin;
    double swage[3] = {-s->radius, 0.0, 0.0};
    TRY(vbss_needle_get_state(s->needle, &needle, sizeof needle));
    for (uint32_t i = 0; i <= segments; i++) {
        x[i] = v_along(v_load(needle.swage), i * THREAD_LENGTH / segments,
                       v_load(needle.swage_direction));
    }
    TRY(vbss_thread_config_init(&c, sizeof c));
    TRY(vbss_thread_config_preset(&c, VBSS_THREAD_PRESET_VBLAST));
    c.segment_count = segments;
    c.length = THREAD_LENGTH;
    c.positions = &x[0].x;
    c.gravity[1] = 0.0;
    c.gravity[2] = GRAVITY;
    c.damping = 2.0;
    c.drag = 1.0;
    c.cut_capacity = CUTS;
    choose(&c.bending_stiffness, plan->material.bending_stiffness);
    choose(&c.yield_curvature, plan->material.yield_curvature);
    choose(&c.yield_hardening, plan->material.yield_hardening);
    TRY(vbss_thread_create(s->rig.context, &c, &s->rig.thread));
    s->rig.nodes = segments + 1;
    s->rig.reversed = true;
    if ((plan->without & SITE_NO_THREAD) != 0) {
        return VBSS_OK;
    }
    TRY(vbss_scene_add_thread(s->rig.scene, s->rig.thread, &s->rig.thread_body));
    if ((plan->without & SITE_NO_NEEDLE) != 0) { /* nobody holds its begin */
        return VBSS_OK;
    }
    return vbss_scene_pin_thread(s->rig.scene, s->rig.thread_body, 0, s->needle_body, swage, &pin);
}

vbss_result site_create(site *s, vec place, double turn, const site_plan *plan)
{
    memset(s, 0, sizeof *s);
    s->rig.mirrored = plan->mirrored;
    TRY(vbss_context_create(NULL, &s->rig.context));
    TRY(add_drain(s, plan));
    TRY(add_needle(s, place, turn, plan));
    return add_thread(s, plan);
}

/* ---- looked at */

pose site_needle(const site *s)
{
    vbss_needle_state now;
    (void)vbss_needle_get_state(s->needle, &now, sizeof now);
    pose p = {.at = mirror_vec(s->rig.mirrored, v_load(now.position))};
    mirror_needle(s->rig.mirrored, now.orientation, p.q);
    return p;
}

vec site_outward(const site *s, double arc_length)
{
    double angle = -arc_length / s->radius;
    return v3(vbss_cos(angle), vbss_sin(angle), 0.0);
}

vec site_forward(const site *s, double arc_length)
{
    double angle = -arc_length / s->radius;
    return v3(-vbss_sin(angle), vbss_cos(angle), 0.0);
}

static const vec *view_of(const site *s, vbss_drain_field field)
{
    vbss_view view;
    return vbss_drain_get_view(s->drain, field, &view, sizeof view) == VBSS_OK ? view.data : NULL;
}

static uint32_t mark_of(const site *s, int side)
{
    return s->places.marks[mirror_side(s->rig.mirrored, side)];
}

vec site_mark(const site *s, int side)
{
    return mirror_vec(s->rig.mirrored, view_of(s, VBSS_DRAIN_VIEW_POSITIONS)[mark_of(s, side)]);
}

static vec rest(const site *s, int side)
{
    return view_of(s, VBSS_DRAIN_VIEW_REST_POSITIONS)[mark_of(s, side)];
}

static vec out_of_drain(vec v)
{
    return v3(v.z, v.x, v.y);
}

vec site_mark_at_rest(const site *s, int side)
{
    vec x = mirror_vec(s->rig.mirrored, out_of_drain(rest(s, side)));
    return v3(x.x, x.y, x.z - s->tube - 0.5 * s->wall);
}

vec site_normal_at_rest(const site *s, int side)
{
    vec x = rest(s, side);
    return mirror_vec(s->rig.mirrored, v_unit(out_of_drain(v3(0.0, x.y, x.z))));
}

bool site_find_hole(const site *s, uint32_t id, vbss_scene_hole *hole)
{
    for (uint32_t i = 0; vbss_scene_get_hole(s->rig.scene, i, hole, sizeof *hole) == VBSS_OK; i++) {
        if (hole->id == id) {
            v_store(hole->position, mirror_vec(s->rig.mirrored, v_load(hole->position)));
            return true;
        }
    }
    return false;
}

vec site_normal(const site *s, int side)
{
    vbss_view view;
    const vec *x = view_of(s, VBSS_DRAIN_VIEW_POSITIONS);
    vec sum = v3(0.0, 0.0, 0.0);
    uint32_t mark = mark_of(s, side);
    if (vbss_drain_get_view(s->drain, VBSS_DRAIN_VIEW_TRIANGLES, &view, sizeof view) != VBSS_OK) {
        return sum;
    }
    for (uint64_t i = 0; i < view.count; i++) {
        const uint32_t *node = (const uint32_t *)view.data + 3 * i;
        if (node[0] == mark || node[1] == mark || node[2] == mark) {
            vec a = v_sub(x[node[1]], x[node[0]]), b = v_sub(x[node[2]], x[node[0]]);
            sum = v_add(sum, v_cross(a, b)); /* by its size */
        }
    }
    return mirror_vec(s->rig.mirrored, v_unit(sum));
}

double site_deviation(const site *s, const vbss_scene_hole *hole, int side)
{
    vec mark = rest(s, side), at = v_load(hole->rest_position);
    double turned = vbss_atan2(at.z, at.y) - vbss_atan2(mark.z, mark.y);
    return v_hypotenuse(s->tube * turned, at.x - mark.x);
}
