/* Rows that hold threads in the jaws of graspers: three springs a grasp, the same in all directions.
 *
 * A row is bilateral: its gap and what it has slid are where the thread's point is, seen from where it is
 * held, so that nothing of it is remembered but what the grasp itself knows. */
#include "scene/holes.h"
#include "scene/rows.h"
#include "scene/scene.h"
#include "scene/tools.h"

/* Where along the thread a point is held: on a segment, and which share of it. */
typedef struct place {
    uint32_t segment;
    double share;
} place;

/* From the segment of the grasp's middle, which is at hand. */
static place place_of(const thread_object *t, const scene_grasp *g, double ahead)
{
    place p = {g->segment, g->into + ahead};
    while (p.share < 0.0 && p.segment > 0) {
        p.share += t->rest[--p.segment];
    }
    while (p.share > t->rest[p.segment] && p.segment + 2 < t->node_count) {
        p.share -= t->rest[p.segment++];
    }
    p.share /= t->rest[p.segment];
    p.share = p.share < 0.0 ? 0.0 : p.share > 1.0 ? 1.0 : p.share; /* the thread ends before */
    return p;
}

static place place_of_point(const thread_object *t, const scene_grasp *g, uint32_t point)
{
    double half = 0.5 * (GRASPER_THREAD_POINTS - 1) * g->spacing;
    return place_of(t, g, g->spacing * point - half);
}

vec3 vbss_scene_held_point(const scene_grasp *g, const thread_object *t, const vec3 *x,
                           uint32_t point)
{
    place p = place_of_point(t, g, point);
    return vec3_lerp(x[p.segment], x[p.segment + 1], p.share);
}

pose vbss_scene_jaws_of(const scene_rigid *r, pose principal)
{
    pose tool = pose_mul(principal, pose_inverse(r->frame));
    return pose_mul(tool, vbss_grasper_jaw_frame(r->grasper));
}

void vbss_scene_lay_spring(contact_constraint *row, const scene_rigid *tool, vec3 here, vec3 there)
{
    pose jaws = vbss_scene_jaws_of(tool, tool->trial);
    row->normal = quat_rotate(jaws.orientation, vec3_make(1.0, 0.0, 0.0));
    row->relative_displacement = vec3_sub(here, there);
    row->gap = vec3_dot(row->normal, row->relative_displacement);
    row->point = there;
    row->jacobian_block_count = 0;
    row->friction = 1.0; /* it has a stiffness along the plane too */
    row->previous_force = row->solution.tangential_force = vec3_zero();
    row->solution.status = CONTACT_STICK;
}

static void lay(scene_object *s, contact_constraint *row)
{
    const scene_grasp *g = &s->grasps[row->key.feature_a / GRASPER_THREAD_POINTS];
    const scene_body *b = vbss_scene_body(s, g->thread);
    const scene_rigid *r = &vbss_scene_body(s, g->tool)->rigid;
    const thread_object *t = b->thread.thread;
    uint32_t point = row->key.feature_a % GRASPER_THREAD_POINTS;
    place p = place_of_point(t, g, point);
    vec3 held = pose_apply(vbss_scene_jaws_of(r, r->trial), g->grip.anchor[point]);
    vec3 here = vec3_lerp(t->trial[p.segment], t->trial[p.segment + 1], p.share);
    vbss_scene_lay_spring(row, r, here, held);
    row->stiffness = GRASPER_NORMAL_STIFFNESS_RATIO *
                     (r->grasper->config.grip_stiffness / GRASPER_THREAD_POINTS);
    row->tangential_stiffness_ratio = 1.0 / GRASPER_NORMAL_STIFFNESS_RATIO;
    row->barycentric[0] = p.share;
    vbss_scene_add_node_term(s, row, b, p.segment, 1.0 - p.share);
    vbss_scene_add_node_term(s, row, b, p.segment + 1, p.share);
    vbss_scene_add_rigid_terms(row, r, held, -1.0);
}

void vbss_scene_lay_grasp_row(scene_object *s, contact_constraint *row)
{
    if (row->key.kind == VBSS_CONTACT_HOLE) {
        vbss_scene_lay_hole_row(s, row);
        return;
    }
    body_kind held = vbss_scene_body(s, row->key.body_a)->kind;
    if (held == BODY_RIGID) {
        vbss_scene_lay_hold_row(s, row);
        return;
    }
    if (held == BODY_DRAIN) {
        vbss_scene_lay_pinch_row(s, row);
        return;
    }
    lay(s, row);
}

contact_constraint *vbss_scene_add_tie(scene_object *s, const contact_key *key)
{
    contact_constraint *row = vbss_contact_add(s->contacts, key);
    if (row != NULL) {
        row->is_bilateral = true;
        row->thickness = 1.0; /* it overlaps nothing */
    }
    return row;
}

bool vbss_scene_add_grasp_rows(scene_object *s)
{
    for (uint32_t i = 0; i < s->config.grasp_capacity; i++) {
        const scene_grasp *g = &s->grasps[i];
        for (uint32_t k = 0; g->id != 0 && !g->let_go && k < GRASPER_THREAD_POINTS; k++) {
            const contact_key key = {VBSS_CONTACT_GRASP, g->thread, GRASPER_THREAD_POINTS * i + k,
                                     g->tool, 0};
            if (vbss_scene_add_tie(s, &key) == NULL) {
                return false;
            }
        }
    }
    return true;
}
