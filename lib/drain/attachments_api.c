/* The functions that hosts call on attachments of a drain. */
#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/edit_hook.h"
#include "base/error.h"
#include "drain/drain.h"

_Static_assert(sizeof(vbss_drain_attachment) == 72, "published size");

static const vbss_drain_attachment defaults = {.struct_size = sizeof(vbss_drain_attachment),
                                               .kind = VBSS_DRAIN_ATTACHMENT_PIN};
static const uint32_t attachment_sizes[] = {72, 0};
static const vbss_layout attachment_layout = {"vbss_drain_attachment", &defaults, attachment_sizes};

vbss_result vbss_drain_attachment_init(vbss_drain_attachment *attachment, uint32_t struct_size)
{
    return vbss_config_init(&attachment_layout, attachment, struct_size);
}

static vbss_result check(const drain_object *d, const vbss_drain_attachment *a)
{
    vbss_context *context = d->context;
    VBSS_TRY(vbss_check_range(context, a->kind, VBSS_DRAIN_ATTACHMENT_PIN,
                              VBSS_DRAIN_ATTACHMENT_SPRING, "kind"));
    VBSS_TRY(vbss_check_range(context, a->node, 0.0, d->mesh.node_count - 1.0, "node"));
    VBSS_TRY(vbss_check_range(context, a->reserved, 0.0, 0.0, "reserved"));
    VBSS_TRY(vbss_check_vector(context, a->position, 1e3, "position"));
    VBSS_TRY(vbss_check_vector(context, a->force, 1e6, "force"));
    VBSS_TRY(vbss_check_range(context, a->stiffness, 0.0, 1e9, "stiffness"));
    if (d->anchored[a->node]) {
        return vbss_fail(context, VBSS_ERROR_IN_USE, "node %u is anchored", a->node);
    }
    if (a->kind == VBSS_DRAIN_ATTACHMENT_PIN && vbss_drain_find_pin(d, a->node) != NULL) {
        return vbss_fail(context, VBSS_ERROR_IN_USE, "node %u is pinned already", a->node);
    }
    return VBSS_OK;
}

static vbss_result find_attachment(drain_object *d, uint32_t id, drain_attachment **found)
{
    for (uint32_t i = 0; id != 0 && i < d->config.attachment_capacity; i++) {
        if (d->attachments[i].id == id) {
            *found = &d->attachments[i];
            return VBSS_OK;
        }
    }
    *found = NULL;
    (void)vbss_fail(d->context, VBSS_ERROR_NOT_FOUND, "the drain has no attachment %u", id);
    return VBSS_ERROR_NOT_FOUND;
}

vbss_result vbss_drain_attach(vbss_drain *drain, const vbss_drain_attachment *attachment,
                              uint32_t *id)
{
    VBSS_ENTER(drain);
    drain_object *d;
    vbss_drain_attachment own;
    VBSS_TRY(vbss_drain_edit(drain, &d));
    VBSS_TRY(vbss_check_pointer(d->context, id, "id"));
    VBSS_TRY(vbss_config_read(d->context, &attachment_layout, attachment, &own));
    VBSS_TRY(check(d, &own));
    uint32_t free_index = 0;
    while (free_index < d->config.attachment_capacity && d->attachments[free_index].id != 0) {
        free_index++;
    }
    if (free_index == d->config.attachment_capacity || d->last_id == UINT32_MAX) {
        return vbss_fail(d->context, VBSS_ERROR_CAPACITY, "more than %u attachments", free_index);
    }
    vbss_edit input = {.kind = VBSS_EDIT_DRAIN_ATTACH, .words = {0, (uint32_t)own.kind, own.node}};
    vbss_edit_set_numbers(&input, 0, own.position, 3);
    vbss_edit_set_numbers(&input, 3, own.force, 3);
    input.numbers[6] = own.stiffness;
    VBSS_TRY(vbss_edit_begin(drain, &input));
    drain_attachment *a = &d->attachments[free_index];
    *a = (drain_attachment){.id = ++d->last_id,
                            .kind = own.kind,
                            .node = own.node,
                            .target = vec3_load(own.position),
                            .force = vec3_load(own.force),
                            .stiffness = own.stiffness};
    /* A pinned node moves to its target during the next step. The end of a spring is there
     * at once. */
    a->position = own.kind == VBSS_DRAIN_ATTACHMENT_PIN ? d->x[own.node] : a->target;
    a->alternate_target = a->target;
    a->alternate_force = a->force;
    *id = a->id;
    vbss_drain_invalidate(d);
    return vbss_edit_end(drain, &input, VBSS_OK);
}

vbss_result vbss_drain_set_attachment_target(vbss_drain *drain, uint32_t id, const double target[3])
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_edit(drain, &d));
    VBSS_TRY(vbss_check_pointer(d->context, target, "target"));
    drain_attachment *a;
    VBSS_TRY(find_attachment(d, id, &a));
    bool force = a->kind == VBSS_DRAIN_ATTACHMENT_FORCE;
    VBSS_TRY(vbss_check_vector(d->context, target, force ? 1e6 : 1e3, "target"));
    vbss_edit input = {.kind = VBSS_EDIT_DRAIN_TARGET, .words = {0, id}};
    vbss_edit_set_numbers(&input, 0, target, 3);
    VBSS_TRY(vbss_edit_begin(drain, &input));
    *(force ? &a->force : &a->target) = vec3_load(target);
    d->generation++;
    return vbss_edit_end(drain, &input, VBSS_OK);
}

vbss_result vbss_drain_detach(vbss_drain *drain, uint32_t id)
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_edit(drain, &d));
    drain_attachment *a;
    VBSS_TRY(find_attachment(d, id, &a));
    vbss_edit input = {.kind = VBSS_EDIT_DRAIN_DETACH, .words = {0, id}};
    VBSS_TRY(vbss_edit_begin(drain, &input));
    *a = (drain_attachment){0};
    vbss_drain_invalidate(d);
    return vbss_edit_end(drain, &input, VBSS_OK);
}

vbss_result vbss_drain_get_reaction(vbss_drain *drain, uint32_t id, double force[3])
{
    VBSS_ENTER(drain);
    drain_object *d;
    VBSS_TRY(vbss_drain_open(drain, &d));
    VBSS_TRY(vbss_check_pointer(d->context, force, "force"));
    drain_attachment *a;
    VBSS_TRY(find_attachment(d, id, &a));
    vec3_store(force, a->reaction);
    return VBSS_OK;
}
