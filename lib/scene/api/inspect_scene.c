/* Reads a scene, its table of bodies, its holes and its grasps, for the folders after scene. */
#include "base/error.h"
#include "scene/api/api.h"
#include "scene/api/inspect.h"
#include "scene/snapshot/snapshot.h"
#include "scene/world/world.h"

_Static_assert((int)SCENE_INSPECT_TIME_LOST == (int)SCENE_LOGGED_TIME_LOST &&
                   (int)SCENE_INSPECT_LOST == (int)SCENE_LOGGED_LOST,
               "the kinds of logged events");

static const scene_object *object_of(const vbss_scene *scene)
{
    return ((const vbss_slot *)scene)->object;
}

/* ---- the scene */

static scene_info describe_scene(const scene_object *s)
{
    return (scene_info){.context = s->context,
                        .config = &s->config,
                        .floor_normal = s->floor_normal,
                        .steps = s->report.statistics.steps,
                        .time = s->report.statistics.time,
                        .entry_count = s->body_count,
                        .event_count = s->report.logged_event_count,
                        .events = s->report.logged_events};
}

vbss_result vbss_scene_inspect(const vbss_scene *scene, scene_info *info)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open(scene, &s));
    *info = describe_scene(s);
    return VBSS_OK;
}

void vbss_scene_inspect_visit_config(vbss_stream *stream, vbss_scene_config *config,
                                     vbss_baseline_config *baseline, vbss_solver_options *solver)
{
    vbss_scene_visit_config(stream, config, baseline, solver);
}

const char *vbss_scene_inspect_config_difference(const vbss_scene_config *a,
                                                 const vbss_scene_config *b)
{
    return vbss_scene_find_config_difference(a, b);
}

vbss_result vbss_scene_inspect_for_edit(vbss_scene *scene, scene_info *info)
{
    scene_object *s;
    VBSS_TRY(vbss_scene_open_mutable(scene, &s));
    *info = describe_scene(s);
    return VBSS_OK;
}

/* The sums never repeat: no generation decreases, and that of the scene increases when a body comes
 * or goes. */
vbss_edit_hook *vbss_scene_inspect_hook(const vbss_scene *scene)
{
    scene_object *s = ((const vbss_slot *)scene)->object;
    return s != NULL ? &s->hook : NULL;
}

uint32_t vbss_scene_inspect_number(const vbss_scene *scene, const void *handle)
{
    const scene_object *s = object_of(scene);
    uint32_t number = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        number = vbss_scene_slot_of_body(&s->bodies[i]) == handle ? s->bodies[i].number : number;
    }
    return number;
}

scene_edit_counts vbss_scene_inspect_edits(const vbss_scene *scene)
{
    const scene_object *s = object_of(scene);
    scene_edit_counts edits = {.scene = s->report.generation};
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        if (b->kind == SCENE_BODY_THREAD) {
            edits.threads += b->thread.thread->generation;
        } else if (b->kind == SCENE_BODY_RIGID && b->rigid.grasper != NULL) {
            edits.graspers += b->rigid.grasper->generation;
        } else if (b->kind == SCENE_BODY_DRAIN) {
            edits.drains += b->drain.drain->generation;
        }
    }
    return edits;
}

/* ---- bodies */

static scene_body_info describe_rigid(uint32_t number, const scene_rigid *r)
{
    return (scene_body_info){.number = number,
                             .needle = r->needle != NULL ? (vbss_needle *)r->slot : NULL,
                             .grasper = r->grasper != NULL ? (vbss_grasper *)r->slot : NULL,
                             .first_capsule = r->first_capsule,
                             .capsule_count = r->capsule_count,
                             .pose = r->body.now.pose,
                             .host_pose = pose_mul(r->body.now.pose, pose_inverse(r->frame))};
}

static scene_body_info describe_body(const scene_body *b)
{
    switch (b->kind) {
    case SCENE_BODY_THREAD:
        return (scene_body_info){.number = b->number, .thread = (vbss_thread *)b->thread.slot};
    case SCENE_BODY_DRAIN:
        return (scene_body_info){.number = b->number, .drain = (vbss_drain *)b->drain.slot};
    case SCENE_BODY_RIGID:
        return describe_rigid(b->number, &b->rigid);
    default:
        return (scene_body_info){.number = 0};
    }
}

scene_body_info vbss_scene_inspect_body(const vbss_scene *scene, uint32_t number)
{
    const scene_body *b = vbss_scene_body(object_of(scene), number);
    return b != NULL ? describe_body(b) : (scene_body_info){.number = 0};
}

scene_body_info vbss_scene_inspect_entry(const vbss_scene *scene, uint32_t entry)
{
    return describe_body(&object_of(scene)->bodies[entry]);
}

scene_capsule_info vbss_scene_inspect_capsule(const vbss_scene *scene, const scene_body_info *body,
                                              uint32_t index)
{
    const scene_capsule *c = &object_of(scene)->capsules[body->first_capsule + index];
    scene_capsule_info info = {.radius = c->radius};
    vbss_scene_transform_capsule(c, body->pose, info.axis);
    return info;
}

/* ---- contacts, holes and grasps */

scene_contacts_info vbss_scene_inspect_contacts(const vbss_scene *scene)
{
    const scene_report *r = &object_of(scene)->report;
    return (scene_contacts_info){.count = r->contact_count,
                                 .features = (const uint32_t(*)[5])r->contact_features,
                                 .points = r->contact_points,
                                 .normals = r->contact_normals,
                                 .forces = r->contact_forces,
                                 .gaps = r->contact_gaps};
}

/* Radius of the body in the hole, m; 0: it has left the scene. */
static double radius_in_hole(const scene_object *s, const suture_hole *h)
{
    const scene_body *b = vbss_scene_body(s, h->needle != 0 ? h->needle : h->thread);
    if (b == NULL) {
        return 0.0;
    }
    return h->needle != 0 ? b->rigid.needle->config.wire_radius : b->thread.thread->config.radius;
}

scene_hole_info vbss_scene_inspect_hole(const vbss_scene *scene, uint32_t entry)
{
    const scene_object *s = object_of(scene);
    const suture_hole *h = &s->holes[entry];
    const scene_body *body = h->id != 0 ? vbss_scene_body(s, h->wall) : NULL;
    if (body == NULL) {
        return (scene_hole_info){.id = 0};
    }
    const suture_wall wall = vbss_scene_wall_of(body);
    return (scene_hole_info){.id = h->id,
                             .needle = h->needle,
                             .thread = h->thread,
                             .drain = h->wall,
                             .arc_length = h->arc,
                             .radius = radius_in_hole(s, h),
                             .position = vbss_hole_point(h, &wall, wall.now),
                             .rest_position = vbss_hole_point(h, &wall, wall.rest)};
}

scene_grasp_info vbss_scene_inspect_grasp(const vbss_scene *scene, uint32_t entry)
{
    const scene_object *s = object_of(scene);
    const scene_thread_grasp *g = &s->thread_grasps[entry];
    const scene_body *thread = scene_holds_strand(g) ? vbss_scene_body(s, g->thread) : NULL;
    if (thread == NULL) {
        return (scene_grasp_info){.tool = 0};
    }
    const thread_object *t = thread->thread.thread;
    return (scene_grasp_info){.tool = g->tool,
                              .thread = g->thread,
                              .arc_length =
                                  vbss_thread_arc_length(t, g->segment) + g->segment_offset};
}
