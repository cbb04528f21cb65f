/* Attachments that hold the section of a thread with twist: holders that come and go, and those that belong
 * to bodies of a scene. */
#include "thread/twist.h"

/* The nearest holder on either side of a node; NULL: there is none. */
static const thread_attachment *find_holder_beside(const thread_object *t, uint32_t node,
                                                   bool after)
{
    const thread_attachment *found = NULL;
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        const bool is_beside = after ? a->node > node : a->node < node;
        if (a->id != 0 && thread_holds_section(a) && is_beside &&
            (found == NULL || (after ? a->node < found->node : a->node > found->node))) {
            found = a;
        }
    }
    return found;
}

void vbss_thread_add_section_holder(thread_object *t, uint32_t attachment)
{
    const thread_attachment *new = &t->attachments[attachment];
    const thread_attachment *low = find_holder_beside(t, new->node, false),
                            *high = find_holder_beside(t, new->node, true);
    thread_section_frame *frame = &t->now.frames[attachment],
                         *low_frame = low != NULL ? &t->now.frames[low - t->attachments] : NULL;
    double before = 0.0, after = 0.0;
    if (thread_has_friction_torque(t)) { /* each segment knows its twist */
        t->now.held_rolls[attachment] = new->roll;
    } else if (low != NULL && high != NULL) {
        const double from = vbss_thread_arc_length(t, low->node),
                     to = vbss_thread_arc_length(t, high->node);
        const double whole = low_frame->shape_twist + high->roll - low->roll;
        before = whole * ((vbss_thread_arc_length(t, new->node) - from) / (to - from));
        after = whole - before;
    }
    const thread_section_holder holder = {.node = new->node,
                                          .is_clamp = new->kind == VBSS_THREAD_ATTACHMENT_CLAMP,
                                          .direction = new->direction};
    frame->direction = vbss_thread_holder_direction(t->now.x, t->node_count, &holder);
    frame->director = vec3_any_normal(frame->direction);
    frame->shape_twist = high != NULL ? after - (high->roll - new->roll) : 0.0;
    if (low_frame != NULL) {
        low_frame->shape_twist = before - (new->roll - low->roll);
    }
}

void vbss_thread_remove_section_holder(thread_object *t, uint32_t attachment)
{
    if (thread_has_friction_torque(t)) {
        return;
    }
    const uint32_t node = t->attachments[attachment].node;
    const thread_attachment *low = find_holder_beside(t, node, false);
    if (low != NULL && find_holder_beside(t, node, true) != NULL) {
        t->now.frames[low - t->attachments].shape_twist += t->now.frames[attachment].shape_twist;
    }
}

/* ---- holders of scenes */

thread_attachment *vbss_thread_find_section_owner(thread_object *t, uint32_t owner)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        if (t->attachments[i].id != 0 && t->attachments[i].owner == owner) {
            return &t->attachments[i];
        }
    }
    return NULL;
}

static bool has_holder(const thread_object *t, uint32_t node)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *a = &t->attachments[i];
        if (a->id != 0 && a->node == node && thread_holds_section(a)) {
            return true;
        }
    }
    return false;
}

static thread_attachment *add_owned(thread_object *t, uint32_t owner, uint32_t node)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity && t->last_id < UINT32_MAX; i++) {
        thread_attachment *a = &t->attachments[i];
        if (a->id == 0) {
            *a = (thread_attachment){.id = ++t->last_id,
                                     .kind = VBSS_THREAD_ATTACHMENT_ROLL,
                                     .node = node,
                                     .position = t->now.x[node],
                                     .target = t->now.x[node],
                                     .direction = vec3_make(1.0, 0.0, 0.0),
                                     .target_direction = vec3_make(1.0, 0.0, 0.0),
                                     .owner = owner};
            vbss_thread_save_target(a);
            vbss_thread_add_section_holder(t, i);
            vbss_thread_list_section_holders(t);
            return a;
        }
    }
    return NULL;
}

void vbss_thread_release_section(thread_object *t, uint32_t attachment)
{
    vbss_thread_remove_section_holder(t, attachment);
    t->attachments[attachment] = (thread_attachment){0};
    vbss_thread_list_section_holders(t);
}

/* The piece of thread that the holder passes keeps its twist, and belongs to the other span afterwards. */
static void move_holder(thread_object *t, thread_attachment *a, uint32_t node)
{
    const thread_attachment *low = find_holder_beside(t, a->node, false),
                            *high = find_holder_beside(t, a->node, true);
    const thread_attachment *from = node > a->node ? a : low, *to = node > a->node ? high : a;
    thread_section_frame *frames = t->now.frames;
    if (from != NULL && to != NULL && !thread_has_friction_torque(t)) {
        const double whole = frames[from - t->attachments].shape_twist + to->roll - from->roll;
        const double here = vbss_thread_arc_length(t, a->node);
        const double passed =
            whole * (vbss_thread_arc_length(t, node) - here) /
            (vbss_thread_arc_length(t, to->node) - vbss_thread_arc_length(t, from->node));
        frames[a - t->attachments].shape_twist -= high != NULL ? passed : 0.0;
        if (low != NULL) {
            frames[low - t->attachments].shape_twist += passed;
        }
    }
    a->node = node;
    vbss_thread_list_section_holders(t);
}

/* Whether a move would pass, or end at, another holder. */
static bool is_blocked(const thread_object *t, const thread_attachment *a, uint32_t node)
{
    const thread_attachment *low = find_holder_beside(t, a->node, false),
                            *high = find_holder_beside(t, a->node, true);
    return (low != NULL && node <= low->node) || (high != NULL && node >= high->node);
}

thread_attachment *vbss_thread_hold_section(thread_object *t, uint32_t owner, uint32_t node,
                                            bool *is_new)
{
    thread_attachment *a = vbss_thread_find_section_owner(t, owner);
    *is_new = a == NULL;
    if (a == NULL) {
        return has_holder(t, node) ? NULL : add_owned(t, owner, node);
    }
    if (is_blocked(t, a, node)) {
        vbss_thread_release_section(t, (uint32_t)(a - t->attachments));
        return NULL;
    }
    if (a->node != node) {
        move_holder(t, a, node);
    }
    return a;
}

double vbss_thread_section_stiffness(const thread_object *t, const thread_attachment *a)
{
    const double here = vbss_thread_arc_length(t, a->node);
    double sum = 0.0;
    for (int side = 0; side < 2; side++) {
        const thread_attachment *other = find_holder_beside(t, a->node, side == 1);
        double distance = other != NULL ? fabs(vbss_thread_arc_length(t, other->node) - here) : 0.0;
        if (thread_has_friction_torque(t)) {
            distance = vbss_thread_distance_to_torque(t, a->node, side == 1, distance);
        }
        if (distance > 0.0) {
            sum += t->config.torsional_stiffness / distance;
        }
    }
    return sum;
}

void vbss_thread_release_owned_sections(thread_object *t)
{
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        if (t->attachments[i].id != 0 && t->attachments[i].owner != 0) {
            vbss_thread_release_section(t, i);
        }
    }
}
