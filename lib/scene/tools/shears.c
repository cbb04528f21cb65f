/* Cuts of shears. They are scheduled before the step and made at its end, so that threads keep
 * their nodes during the step. A strand that shears cannot cut does not stop the blades. */
#include "scene/tools/tools.h"
#include "scene/world/world.h"

static double strand_arc(const scene_strand *at)
{
    const thread_object *t = at->thread->thread.thread;
    return vbss_thread_arc_length(t, at->segment) + at->fraction * t->rest[at->segment];
}

bool vbss_scene_is_at_thread_end(const thread_object *t, double arc)
{
    double length = vbss_thread_arc_length(t, t->node_count - 1);
    thread_cut cut;
    return vbss_min(arc, length - arc) < 2.0 * t->config.radius ||
           !vbss_thread_locate_cut(t, arc, &cut);
}

/* Whether the pool of pieces has one left, in addition to those of the cuts that are already
 * scheduled. */
static bool has_cuts_left(const scene_object *s, const thread_piece_pool *family)
{
    uint32_t left = 0, scheduled = 0;
    for (uint32_t i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        left +=
            b->is_reserved && b->kind == SCENE_BODY_NONE && b->thread.thread->piece_pool == family;
    }
    for (uint32_t i = 0; i < s->step.cut_count; i++) {
        scheduled +=
            vbss_scene_body(s, s->step.cuts[i].thread)->thread.thread->piece_pool == family;
    }
    return left > scheduled;
}

bool vbss_scene_exclude_uncuttable(scene_object *s, uint32_t tool, const scene_strand *at,
                                   double angle)
{
    const thread_object *t = at->thread->thread.thread;
    double arc = strand_arc(at);
    bool at_end = vbss_scene_is_at_thread_end(t, arc);
    scene_thread_grasp *g = vbss_scene_find_free_grasp(s);
    if (g == NULL || (!at_end && has_cuts_left(s, t->piece_pool))) {
        return false;
    }
    *g = (scene_thread_grasp){.id = ++s->last_grasp_id,
                              .thread = at->thread->number,
                              .tool = tool,
                              .segment = at->segment,
                              .segment_offset = at->fraction * t->rest[at->segment],
                              .angle = angle,
                              .point_spacing = t->config.radius,
                              .is_uncuttable = true,
                              .needs_reopening = true};
    if (!at_end) {
        const vec3 *x = &t->now.x[at->segment];
        vbss_scene_emit_cut_event(s, at->thread, NULL, arc, vec3_lerp(x[0], x[1], at->fraction));
    }
    return true;
}

void vbss_scene_schedule_cut(scene_object *s, const scene_strand *at)
{
    if (s->step.cut_count == SCENE_MAX_CUTS) {
        return; /* a strand that is still between the blades is cut in the next step */
    }
    double arc = strand_arc(at);
    /* in descending order of arc length, so that a cut does not change the arc lengths of later
     * ones */
    uint32_t to = s->step.cut_count++;
    while (to > 0 && s->step.cuts[to - 1].arc_length < arc) {
        s->step.cuts[to] = s->step.cuts[to - 1];
        to--;
    }
    s->step.cuts[to] = (scene_cut){at->thread->number, arc};
}
