/* Public handles.
 *
 * A handle is the address of a slot. Slots belong to the context and are never reused, so a
 * destroyed handle is always detected. */
#ifndef VBSS_BASE_SLOT_H
#define VBSS_BASE_SLOT_H

#include <stdbool.h>
#include <stdint.h>

#include <vblast_ss/base.h>

typedef struct vbss_stream vbss_stream;
/* A type of object that hosts hold handles of. */
typedef struct vbss_kind {
    const char *name; /* type of the object in error texts */
    uint32_t code;    /* four-character code of its section in a snapshot */
    uint16_t version; /* current version of that section */
    void (*destroy)(vbss_context *context, void *object);
    void (*serialise)(vbss_stream *stream, void *object); /* visits every field of the state */
    /* Visits what is needed to create an equal object, for snapshots; NULL: the kind has no
     * description. It is no part of the hash. */
    void (*serialise_description)(vbss_stream *stream, void *object);
} vbss_kind;
typedef struct vbss_slot {
    uint32_t tag;
    uint32_t status;
    const vbss_kind *kind;
    vbss_context *context;
    void *object;
    /* order of creation in the context, starting at 1: the object's identity in logs */
    uint64_t ordinal;
    /* NULL if the host owns the object; otherwise the owner, which alone may step or destroy it */
    const void *owner;
    struct vbss_edit_hook *hook; /* called for edits of the object; may be NULL */
    bool is_owned_for_good;      /* the owner destroys the object when it gives the object up */
} vbss_slot;
/* Creates a handle for a complete object. On failure the caller still owns the object. */
vbss_result vbss_slot_create(vbss_context *context, const vbss_kind *kind, void *object,
                             vbss_slot **slot);
/* Allocates a slot for an object that will be created where allocation is not allowed. The slot is
 * not a valid handle until vbss_slot_fill. */
vbss_result vbss_slot_reserve(vbss_context *context, const vbss_kind *kind, vbss_slot **slot);
/* Makes a reserved slot a valid handle of the object. */
void vbss_slot_fill(vbss_slot *slot, void *object);
/* Turns a filled slot back into a reserved one without destroying the object. The handle is invalid
 * until the slot is filled again. */
void vbss_slot_empty(vbss_slot *slot);
/* Slot of a valid handle of this kind. VBSS_ERROR_INVALID_HANDLE for any other pointer. */
vbss_result vbss_slot_open(const void *handle, const vbss_kind *kind, vbss_slot **slot);
/* As vbss_slot_open, for a call that does not enter the context because another thread may be in it.
 * It touches nothing but the slot, so there is no error text. */
vbss_result vbss_slot_open_shared(const void *handle, const vbss_kind *kind, vbss_slot **slot);
/* Slot for a call that changes the object. VBSS_ERROR_INVALID_HANDLE, or VBSS_ERROR_BUSY inside a
 * callback of the context. */
vbss_result vbss_slot_edit(void *handle, const vbss_kind *kind, vbss_slot **slot);
/* Slot for a call that changes an object that only the host may change while no other object owns
 * it. VBSS_ERROR_INVALID_HANDLE, VBSS_ERROR_IN_SCENE if it has an owner, or VBSS_ERROR_BUSY inside
 * a callback. */
vbss_result vbss_slot_edit_unowned(void *handle, const vbss_kind *kind, vbss_slot **slot);
/* Destroys the object and makes its handle invalid. VBSS_OK for NULL; VBSS_ERROR_INVALID_HANDLE,
 * VBSS_ERROR_IN_SCENE or VBSS_ERROR_BUSY on failure. */
vbss_result vbss_slot_destroy(void *handle, const vbss_kind *kind);
/* As vbss_slot_destroy, but an object with an owner is destroyed when the owner gives it up. Never
 * VBSS_ERROR_IN_SCENE. */
vbss_result vbss_slot_discard(void *handle, const vbss_kind *kind);
/* Gives the object to an owner, whose hook hears of its edits; NULL, NULL: back to the host. */
static inline void vbss_slot_set_owner(vbss_slot *slot, const void *owner,
                                       struct vbss_edit_hook *hook)
{
    slot->owner = owner;
    slot->hook = hook;
}
/* Destroys an object that its owner has given up, if it was owned for good. */
void vbss_slot_destroy_owned(vbss_slot *slot);
/* Handle for an object that is part of another and is used through its public functions. The
 * context does not track it; the owner destroys the object. */
vbss_slot vbss_slot_inside(vbss_context *context, const vbss_kind *kind, void *object);
/* Checks a handle that a call gets beside the one that it was made on, before it is opened. The call
 * is inside `context` only, so it must not touch another one. VBSS_ERROR_INVALID_HANDLE, with a text
 * that starts with `name`, for NULL, for a pointer that is not a handle, and for a handle of another
 * context. */
vbss_result vbss_slot_check_other(vbss_context *context, const void *handle, const char *name);
/* Checks a context pointer from the host: for reading, and for changes. VBSS_ERROR_INVALID_HANDLE,
 * or VBSS_ERROR_BUSY for a change inside a callback. */
vbss_result vbss_context_open(const vbss_context *context);
vbss_result vbss_context_edit(vbss_context *context);

#endif
