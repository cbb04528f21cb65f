/* The functions that hosts call on attachments of a thread. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/edit_hook.h"
#include "base/error.h"
#include "thread/twist.h"

_Static_assert(sizeof(vbss_thread_attachment) == 112, "published size");
_Static_assert(sizeof(vbss_thread_reaction) == 56, "published size");

static const vbss_thread_attachment defaults = {
    .struct_size = sizeof(vbss_thread_attachment),
    .kind = VBSS_THREAD_ATTACHMENT_PIN,
    .direction = {1.0, 0.0, 0.0},
};
static const uint32_t attachment_sizes[] = {112, 0};
static const vbss_layout attachment_layout = {"vbss_thread_attachment", &defaults,
                                              attachment_sizes};

static const uint32_t reaction_sizes[] = {56, 0};
static const vbss_layout reaction_layout = {"vbss_thread_reaction", NULL, reaction_sizes};

vbss_result vbss_thread_attachment_init(vbss_thread_attachment *attachment, uint32_t struct_size)
{
    return vbss_config_init(&attachment_layout, attachment, struct_size);
}

static vbss_result check_direction(vbss_context *context, const double v[3])
{
    VBSS_TRY(vbss_check_finite(context, v, 3, "direction"));
    return vbss_check_range(context, vec3_norm(vec3_load(v)), 1e-100, 1e100, "length of direction");
}

static bool excludes(const thread_attachment *other, const vbss_thread_attachment *a)
{
    const bool holds_section =
        a->kind == VBSS_THREAD_ATTACHMENT_CLAMP || a->kind == VBSS_THREAD_ATTACHMENT_ROLL;
    return (vbss_thread_prescribes_motion(other->kind) && vbss_thread_prescribes_motion(a->kind)) ||
           (thread_holds_section(other) && holds_section);
}

static vbss_result check_attachment(const thread_object *t, const vbss_thread_attachment *a)
{
    vbss_context *context = t->context;
    VBSS_TRY(vbss_check_range(context, a->kind, VBSS_THREAD_ATTACHMENT_PIN,
                              VBSS_THREAD_ATTACHMENT_ROLL, "kind"));
    VBSS_TRY(vbss_check_range(context, a->node, 0.0, t->node_count - 1.0, "node"));
    VBSS_TRY(vbss_check_range(context, a->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_vector(context, a->position, 1e3, "position"));
    VBSS_TRY(check_direction(context, a->direction));
    VBSS_TRY(vbss_check_vector(context, a->force, 1e6, "force"));
    VBSS_TRY(vbss_check_range(context, a->stiffness, 0.0, 1e9, "stiffness"));
    VBSS_TRY(vbss_check_range(context, a->damping, 0.0, 1e6, "damping"));
    VBSS_TRY(vbss_check_range(context, a->mass, 0.0, 1e3, "mass"));
    if (a->kind == VBSS_THREAD_ATTACHMENT_ROLL && !thread_has_twist(t)) {
        return vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                         "a roll needs a thread with a torsional_stiffness above 0");
    }
    if (t->welded[a->node] != 0 && vbss_thread_prescribes_motion(a->kind)) {
        return vbss_fail(context, VBSS_ERROR_IN_USE, "node %u is held by a body of its scene",
                         a->node);
    }
    for (uint32_t i = 0; i < t->config.attachment_capacity; i++) {
        const thread_attachment *other = &t->attachments[i];
        if (other->id != 0 && other->node == a->node && excludes(other, a)) {
            return vbss_fail(context, VBSS_ERROR_IN_USE, "node %u is held by attachment %u",
                             a->node, other->id);
        }
    }
    return VBSS_OK;
}

static vec3 load_unit(const double v[3])
{
    return vec3_unit_or(vec3_load(v), vec3_make(1.0, 0.0, 0.0));
}

/* Direction of the thread at a node. */
static vec3 chord_direction(const thread_object *t, uint32_t node, vec3 fallback)
{
    uint32_t low = node > 0 ? node - 1 : 0;
    uint32_t high = node + 1 < t->node_count ? node + 1 : node;
    return vec3_unit_or(vec3_sub(t->now.x[high], t->now.x[low]), fallback);
}

vbss_result vbss_thread_attach(vbss_thread *thread, const vbss_thread_attachment *attachment,
                               uint32_t *id)
{
    VBSS_ENTER(thread);
    thread_object *t;
    vbss_thread_attachment own;
    VBSS_TRY(vbss_thread_edit(thread, &t));
    VBSS_TRY(vbss_check_pointer(t->context, id, "id"));
    VBSS_TRY(vbss_config_read(t->context, &attachment_layout, attachment, &own));
    VBSS_TRY(check_attachment(t, &own));
    uint32_t free_index = 0;
    while (free_index < t->config.attachment_capacity && t->attachments[free_index].id != 0) {
        free_index++;
    }
    if (free_index == t->config.attachment_capacity || t->last_id == UINT32_MAX) {
        return vbss_fail(t->context, VBSS_ERROR_CAPACITY, "more than %u attachments", free_index);
    }
    vbss_edit input = {.kind = VBSS_EDIT_ATTACH, .words = {0, (uint32_t)own.kind, own.node}};
    vbss_edit_set_numbers(&input, 0, own.position, 3);
    vbss_edit_set_numbers(&input, 3, own.direction, 3);
    vbss_edit_set_numbers(&input, 6, own.force, 3);
    input.numbers[9] = own.stiffness;
    input.numbers[10] = own.damping;
    input.numbers[11] = own.mass;
    VBSS_TRY(vbss_edit_begin(thread, &input));
    thread_attachment *a = &t->attachments[free_index];
    a->id = *id = ++t->last_id;
    a->kind = own.kind;
    a->node = own.node;
    a->target = vec3_load(own.position);
    /* A prescribed node moves to its target during the next step, and a clamp turns the thread
     * during it. The end of a spring is at its target at once. */
    a->position = vbss_thread_prescribes_motion(own.kind) ? t->now.x[own.node] : a->target;
    a->target_direction = load_unit(own.direction);
    a->direction =
        t->is_in_setup ? a->target_direction : chord_direction(t, own.node, a->target_direction);
    a->force = vec3_load(own.force);
    a->stiffness = own.stiffness;
    a->damping = own.damping;
    a->mass = own.mass;
    vbss_thread_save_target(a);
    if (thread_has_twist(t) && thread_holds_section(a)) {
        vbss_thread_add_section_holder(t, free_index);
    }
    vbss_thread_invalidate(t);
    return vbss_edit_end(thread, &input, VBSS_OK);
}

vbss_result vbss_thread_set_attachment_target(vbss_thread *thread, uint32_t id,
                                              const double target[3], const double *direction)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_edit(thread, &t));
    VBSS_TRY(vbss_check_pointer(t->context, target, "target"));
    thread_attachment *a;
    VBSS_TRY(vbss_thread_find_attachment(t, id, &a));
    if (a->kind == VBSS_THREAD_ATTACHMENT_MASS) {
        return vbss_fail(t->context, VBSS_ERROR_INCOMPATIBLE, "attachment %u is a mass", id);
    }
    bool force = a->kind == VBSS_THREAD_ATTACHMENT_FORCE;
    VBSS_TRY(vbss_check_vector(t->context, target, force ? 1e6 : 1e3, "target"));
    if (direction != NULL) {
        VBSS_TRY(check_direction(t->context, direction));
    }
    vbss_edit input = {.kind = VBSS_EDIT_ATTACHMENT_TARGET, .words = {0, id, direction != NULL}};
    vbss_edit_set_numbers(&input, 0, target, 3);
    vbss_edit_set_numbers(&input, 3, direction, 3);
    VBSS_TRY(vbss_edit_begin(thread, &input));
    if (direction != NULL) {
        a->target_direction = load_unit(direction);
    }
    *(force ? &a->force : &a->target) = vec3_load(target);
    t->generation++;
    return vbss_edit_end(thread, &input, VBSS_OK);
}

vbss_result vbss_thread_set_roll(vbss_thread *thread, uint32_t id, double roll)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_edit(thread, &t));
    thread_attachment *a;
    VBSS_TRY(vbss_thread_find_attachment(t, id, &a));
    if (!thread_has_twist(t)) {
        return vbss_fail(t->context, VBSS_ERROR_INCOMPATIBLE,
                         "a roll needs a thread with a torsional_stiffness above 0");
    }
    if (!thread_holds_section(a)) {
        return vbss_fail(t->context, VBSS_ERROR_INCOMPATIBLE,
                         "attachment %u does not hold the section", id);
    }
    VBSS_TRY(vbss_check_finite(t->context, &roll, 1, "roll"));
    VBSS_TRY(vbss_check_range(t->context, roll, -1e6, 1e6, "roll"));
    vbss_edit input = {.kind = VBSS_EDIT_ROLL, .words = {0, id}, .numbers = {roll}};
    VBSS_TRY(vbss_edit_begin(thread, &input));
    a->target_roll = roll;
    t->generation++;
    return vbss_edit_end(thread, &input, VBSS_OK);
}

vbss_result vbss_thread_detach(vbss_thread *thread, uint32_t id)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_edit(thread, &t));
    thread_attachment *a;
    VBSS_TRY(vbss_thread_find_attachment(t, id, &a));
    vbss_edit input = {.kind = VBSS_EDIT_DETACH, .words = {0, id}};
    VBSS_TRY(vbss_edit_begin(thread, &input));
    if (thread_has_twist(t) && thread_holds_section(a)) {
        vbss_thread_remove_section_holder(t, (uint32_t)(a - t->attachments));
    }
    *a = (thread_attachment){0};
    vbss_thread_invalidate(t);
    return vbss_edit_end(thread, &input, VBSS_OK);
}

vbss_result vbss_thread_get_reaction(vbss_thread *thread, uint32_t id,
                                     vbss_thread_reaction *reaction, uint32_t struct_size)
{
    VBSS_ENTER(thread);
    thread_object *t;
    VBSS_TRY(vbss_thread_open(thread, &t));
    thread_attachment *a;
    VBSS_TRY(vbss_thread_find_attachment(t, id, &a));
    vbss_thread_reaction own = {.struct_size = sizeof own, .node = a->node};
    vec3_store(own.force, a->reaction);
    vec3_store(own.torque, a->reaction_torque);
    return vbss_struct_write(t->context, &reaction_layout, &own, reaction, struct_size);
}
