/* Slots behind handles: each is handed out once in the life of a context. */
#include "base/context.h"
#include "base/error.h"
#include "base/memory.h"

/* Values far from 0 and 1, so that a stray write is unlikely to produce one of them. */
enum { SLOT_ALIVE = 0x11fe, SLOT_DEAD = 0xdead, SLOT_RESERVED = 0x3a17 };

vbss_result vbss_slot_reserve(vbss_context *context, const vbss_kind *kind, vbss_slot **slot)
{
    slot_block *block = context->newest_block;
    if (block == NULL || block->used == VBSS_SLOTS_PER_BLOCK) {
        slot_block *new_block = vbss_allocate(context, 1, sizeof *new_block, "handles");
        if (new_block == NULL) {
            return VBSS_ERROR_OUT_OF_MEMORY;
        }
        new_block->older = block;
        context->newest_block = block = new_block;
    }
    vbss_slot *reserved = &block->slots[block->used++];
    reserved->tag = VBSS_TAG_SLOT;
    reserved->status = SLOT_RESERVED;
    reserved->kind = kind;
    reserved->context = context;
    *slot = reserved;
    return VBSS_OK;
}

void vbss_slot_fill(vbss_slot *slot, void *object)
{
    slot->status = SLOT_ALIVE;
    slot->object = object;
    slot->ordinal = slot->ordinal != 0 ? slot->ordinal : ++slot->context->last_ordinal;
    slot->context->objects_alive++;
}

void vbss_slot_empty(vbss_slot *slot)
{
    slot->status = SLOT_RESERVED;
    slot->object = NULL;
    vbss_slot_set_owner(slot, NULL, NULL);
    slot->context->objects_alive--;
}

vbss_result vbss_slot_create(vbss_context *context, const vbss_kind *kind, void *object,
                             vbss_slot **slot)
{
    VBSS_TRY(vbss_slot_reserve(context, kind, slot));
    vbss_slot_fill(*slot, object);
    return VBSS_OK;
}

/* The valid slot behind a handle, or NULL with the failure reported. */
static vbss_slot *find_slot(const void *handle, const vbss_kind *kind)
{
    /* The memory behind a handle is writable; const only promises that the call changes nothing. */
    vbss_slot *slot = (vbss_slot *)handle;
    if (slot == NULL || slot->tag != VBSS_TAG_SLOT) {
        return NULL; /* there is no context that could store a text */
    }
    if (slot->kind != kind) {
        vbss_fail(slot->context, VBSS_ERROR_INVALID_HANDLE,
                  "handle %llu is a %s where a %s is needed", (unsigned long long)slot->ordinal,
                  slot->kind->name, kind->name);
        return NULL;
    }
    if (slot->status != SLOT_ALIVE) {
        vbss_fail(slot->context, VBSS_ERROR_INVALID_HANDLE, "%s %llu was destroyed before",
                  kind->name, (unsigned long long)slot->ordinal);
        return NULL;
    }
    return slot;
}

vbss_result vbss_slot_open(const void *handle, const vbss_kind *kind, vbss_slot **slot)
{
    *slot = find_slot(handle, kind);
    return *slot != NULL ? VBSS_OK : VBSS_ERROR_INVALID_HANDLE;
}

vbss_result vbss_slot_open_shared(const void *handle, const vbss_kind *kind, vbss_slot **slot)
{
    *slot = (vbss_slot *)handle;
    const bool is_valid = handle != NULL && (*slot)->tag == VBSS_TAG_SLOT &&
                          (*slot)->kind == kind && (*slot)->status == SLOT_ALIVE;
    return is_valid ? VBSS_OK : VBSS_ERROR_INVALID_HANDLE;
}

vbss_result vbss_slot_edit(void *handle, const vbss_kind *kind, vbss_slot **slot)
{
    *slot = NULL;
    vbss_slot *found = find_slot(handle, kind);
    if (found == NULL) {
        return VBSS_ERROR_INVALID_HANDLE;
    }
    VBSS_TRY(vbss_context_edit(found->context));
    *slot = found;
    return VBSS_OK;
}

static vbss_result check_unowned(const vbss_slot *slot)
{
    if (slot->owner != NULL) {
        return vbss_fail(slot->context, VBSS_ERROR_IN_SCENE, "%s %llu belongs to a scene",
                         slot->kind->name, (unsigned long long)slot->ordinal);
    }
    return vbss_context_edit(slot->context);
}

vbss_result vbss_slot_edit_unowned(void *handle, const vbss_kind *kind, vbss_slot **slot)
{
    *slot = NULL;
    vbss_slot *found = find_slot(handle, kind);
    if (found == NULL) {
        return VBSS_ERROR_INVALID_HANDLE;
    }
    VBSS_TRY(check_unowned(found));
    *slot = found;
    return VBSS_OK;
}

vbss_result vbss_slot_check_other(vbss_context *context, const void *handle, const char *name)
{
    const vbss_slot *slot = handle;
    if (slot == NULL) {
        return vbss_fail(context, VBSS_ERROR_INVALID_HANDLE, "%s is NULL", name);
    }
    if (slot->tag != VBSS_TAG_SLOT) {
        return vbss_fail(context, VBSS_ERROR_INVALID_HANDLE, "%s is no handle", name);
    }
    return slot->context == context ? VBSS_OK
                                    : vbss_fail(context, VBSS_ERROR_INVALID_HANDLE,
                                                "%s belongs to another context", name);
}

vbss_slot vbss_slot_inside(vbss_context *context, const vbss_kind *kind, void *object)
{
    vbss_slot slot = {.tag = VBSS_TAG_SLOT,
                      .status = SLOT_ALIVE,
                      .kind = kind,
                      .context = context,
                      .object = object};
    return slot;
}

/* Marks a slot as dead. Returns its object. */
static void *empty(vbss_slot *slot)
{
    void *object = slot->object;
    slot->status = SLOT_DEAD;
    slot->object = NULL;
    slot->context->objects_alive--;
    return object;
}

static void retire(vbss_slot *slot)
{
    slot->kind->destroy(slot->context, empty(slot));
}

vbss_result vbss_slot_destroy(void *handle, const vbss_kind *kind)
{
    if (handle == NULL) {
        return VBSS_OK;
    }
    vbss_slot *slot = find_slot(handle, kind);
    if (slot == NULL) {
        return VBSS_ERROR_INVALID_HANDLE;
    }
    VBSS_TRY(check_unowned(slot));
    retire(slot);
    return VBSS_OK;
}

vbss_result vbss_slot_discard(void *handle, const vbss_kind *kind)
{
    if (handle == NULL) {
        return VBSS_OK;
    }
    vbss_slot *slot = find_slot(handle, kind);
    if (slot == NULL) {
        return VBSS_ERROR_INVALID_HANDLE;
    }
    VBSS_TRY(vbss_context_edit(slot->context));
    if (slot->owner != NULL) {
        slot->is_owned_for_good = true;
    } else {
        retire(slot);
    }
    return VBSS_OK;
}

void vbss_slot_destroy_owned(vbss_slot *slot)
{
    if (slot->is_owned_for_good && slot->status == SLOT_ALIVE) {
        /* A body owns nothing, so that this is no recursion. */
        void (*const destroy_body)(vbss_context *, void *) = slot->kind->destroy;
        vbss_slot_set_owner(slot, NULL, NULL);
        destroy_body(slot->context, empty(slot));
    }
}

void vbss_slots_release(vbss_context *context)
{
    /* Destroy all objects before freeing any slot, because the destruction of one object may read
     * the handle of another. */
    for (slot_block *block = context->newest_block; block != NULL; block = block->older) {
        for (uint32_t i = block->used; i > 0; i--) {
            if (block->slots[i - 1].status == SLOT_ALIVE) {
                retire(&block->slots[i - 1]);
            }
        }
    }
    while (context->newest_block != NULL) {
        slot_block *block = context->newest_block;
        context->newest_block = block->older;
        vbss_release(context, block, 1, sizeof *block);
    }
}
