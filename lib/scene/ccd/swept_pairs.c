/* Pairs of features that may meet on the way to the trial state. */
#include "scene/ccd/pair.h"
#include "scene/world/world.h"

typedef struct vertex_motion {
    uint32_t count;
    const vec3 *start, *expected, *end;
} vertex_motion;

static vertex_motion vertex_motion_of(scene_object *s, const scene_body *b)
{
    if (b->kind == SCENE_BODY_THREAD) {
        const thread_object *t = b->thread.thread;
        return (vertex_motion){t->node_count, t->now.x,
                               s->step.expected_displacements + b->thread.first_node, t->trial};
    }
    if (b->kind == SCENE_BODY_DRAIN) {
        const drain_object *d = b->drain.drain;
        return (vertex_motion){d->mesh.node_count, d->x, b->drain.expected_displacements, d->trial};
    }
    const scene_host_surface *h = scene_host_surface_of(b);
    if (h != NULL) {
        return (vertex_motion){h->vertex_count, h->now, h->expected_displacements, h->trial};
    }
    const scene_rigid *r = &b->rigid;
    uint32_t count = 2 * r->capsule_count;
    vec3 *start = s->scratch.vertices, *end = start + count;
    for (uint32_t i = 0; i < count; i++) {
        start[i] = s->capsules[r->first_capsule + i / 2].now[i % 2];
        end[i] = s->capsules[r->first_capsule + i / 2].trial[i % 2];
    }
    const vec3 *expected =
        s->step.expected_displacements + s->config.node_capacity + 2 * (size_t)r->first_capsule;
    return (vertex_motion){count, start, expected, end};
}

/* Whether all vertices stay within their motion bounds, up to half of the contact margin. The broad
 * phase has swept its boxes over these bounds and enlarged them by the margin. So a vertex within
 * them meets only features of listed pairs. */
static bool is_inside_motion_bounds(const scene_object *s, const vertex_motion *m)
{
    const double margin = SCENE_CCD_MARGIN_RATIO * s->solver.contact_margin;
    for (uint32_t i = 0; i < m->count; i++) {
        vec3 expected = vec3_scale(m->expected[i], SCENE_EXTRAPOLATION_RATIO),
             displacement = vec3_sub(m->end[i], m->start[i]);
        bool inside = displacement.x >= vbss_min(0.0, expected.x) - margin &&
                      displacement.x <= vbss_max(0.0, expected.x) + margin &&
                      displacement.y >= vbss_min(0.0, expected.y) - margin &&
                      displacement.y <= vbss_max(0.0, expected.y) + margin &&
                      displacement.z >= vbss_min(0.0, expected.z) - margin &&
                      displacement.z <= vbss_max(0.0, expected.z) + margin;
        if (!inside) { /* also for NaN */
            return false;
        }
    }
    return true;
}

/* Whether all pairs start at about their contact distance: contacts show it for pairs that are
 * near. Pairs excluded at pins and cuts need no CCD. */
static bool do_pairs_start_apart(const scene_object *s)
{
    bool is_apart = !s->step.has_unlisted_pairs;
    for (uint32_t i = 0; is_apart && i < s->contacts->count; i++) {
        const contact_constraint *constraint = &s->contacts->constraints[i];
        const scene_contact_geometry *geometry = scene_geometry_of(s, constraint);
        is_apart =
            constraint->is_bilateral || geometry->start_gap - geometry->overlap_allowance >=
                                            -SCENE_CCD_DEEP_RATIO * geometry->contact_distance;
    }
    return is_apart;
}

/* Whether all vertices of a rigid mesh end where the broad phase expected them, up to half of the contact margin. */
static bool does_end_as_expected(const scene_object *s, const scene_body *mesh)
{
    const double margin = SCENE_CCD_MARGIN_RATIO * s->solver.contact_margin;
    const scene_rigid *r = &mesh->rigid;
    return vbss_collision_largest_offset(s->collision->shapes[mesh->shape], r->expected,
                                         r->trial) <= margin;
}

static double find_max_displacement(const vertex_motion *m)
{
    double largest = 0.0;
    for (uint32_t i = 0; i < m->count; i++) {
        double square = vec3_norm_squared(vec3_sub(m->end[i], m->start[i]));
        largest = square > largest ? square : largest;
    }
    return sqrt(largest);
}

scene_substep_outcome vbss_scene_list_ccd_pairs(scene_object *s)
{
    bool is_expected = true;
    for (uint32_t i = 0; i < s->body_count; i++) {
        scene_body *b = &s->bodies[i];
        if (scene_is_rigid_mesh(b)) {
            is_expected = is_expected && does_end_as_expected(s, b);
            b->max_displacement = vbss_collision_largest_distance(
                s->collision->shapes[b->shape], b->rigid.body.now.pose, b->rigid.trial);
        } else if (b->kind != SCENE_BODY_NONE) {
            const vertex_motion m = vertex_motion_of(s, b);
            is_expected = is_expected && is_inside_motion_bounds(s, &m);
            /* Pairs at holes use it in either case. */
            b->max_displacement = find_max_displacement(&m);
        }
    }
    s->step.can_skip_slow_pairs = is_expected && do_pairs_start_apart(s);
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_NONE || scene_is_static_mesh(b) || scene_is_plane(b)) {
            continue;
        }
        if (scene_is_rigid_mesh(b)) {
            if (is_expected) {
                vbss_collision_set_end_pose(s->collision->shapes[b->shape], b->rigid.trial);
            } else if (vbss_collision_set_pose_motion(s->collision, b->shape,
                                                      b->rigid.body.now.pose, b->rigid.trial,
                                                      1.0) != VBSS_OK) {
                return SCENE_SUBSTEP_SINGULAR;
            }
            continue;
        }
        const vertex_motion m = vertex_motion_of(s, b);
        if (is_expected) {
            vbss_collision_set_end_positions(s->collision->shapes[b->shape], m.end);
        } else if (vbss_collision_set_motion(scene_collision(s), b->shape, &m.start->x, &m.end->x,
                                             m.count) != VBSS_OK) {
            return SCENE_SUBSTEP_SINGULAR; /* not finite, or out of range */
        }
        vbss_collision_update_displacements(s->collision->shapes[b->shape]);
    }
    if (!is_expected && vbss_scene_run_broad_phase(s) != VBSS_OK) {
        return SCENE_SUBSTEP_OUT_OF_CAPACITY;
    }
    return SCENE_SUBSTEP_ACCEPTED;
}
