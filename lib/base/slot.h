/* Handles. A public handle is a slot in disguise. Slots belong to the context and are
 * never used twice, so a destroyed handle is told and never read as something else. */
#ifndef VBSS_BASE_SLOT_H
#define VBSS_BASE_SLOT_H

#include <stdint.h>

#include <vblast_ss/base.h>

typedef struct vbss_stream vbss_stream;
typedef struct vbss_kind {
    const char *name; /* for error texts */
    uint32_t code;    /* four-character code of its section in a snapshot */
    uint16_t version; /* of that section */
    void (*destroy)(vbss_context *context, void *object);
    void (*serialise)(vbss_stream *stream, void *object); /* visits every field of the state */
} vbss_kind;
typedef struct vbss_slot {
    uint32_t tag;
    uint32_t status;
    const vbss_kind *kind;
    vbss_context *context;
    void *object;
    uint64_t ordinal;  /* order of creation in the context: the object's identity in logs */
    const void *owner; /* the object that has it, which alone may step or end it; NULL: the host */
} vbss_slot;
/* Puts a finished object behind a new handle; on failure the caller still owns the object. */
vbss_result vbss_slot_create(vbss_context *context, const vbss_kind *kind, void *object,
                             vbss_slot **slot);
/* The same in two parts, for objects that come to life where nothing may be allocated: a reserved
 * slot waits, as no handle of anybody, until it is filled or the context ends. */
vbss_result vbss_slot_reserve(vbss_context *context, const vbss_kind *kind, vbss_slot **slot);
void vbss_slot_fill(vbss_slot *slot, void *object);
/* It waits again: the object is still there, but its handle is none until the slot is filled with it. */
void vbss_slot_empty(vbss_slot *slot);
/* The slot of a living handle of that kind; any other handle is VBSS_ERROR_INVALID_HANDLE. */
vbss_result vbss_slot_open(const void *handle, const vbss_kind *kind, vbss_slot **slot);
/* The same for a call that changes something: VBSS_ERROR_BUSY inside a callback of the context. */
vbss_result vbss_slot_edit(void *handle, const vbss_kind *kind, vbss_slot **slot);
/* The same for what only the host may do while nobody else has the object: VBSS_ERROR_IN_SCENE. */
vbss_result vbss_slot_edit_unowned(void *handle, const vbss_kind *kind, vbss_slot **slot);
/* Destroys the object; the handle is told from then on. NULL is VBSS_OK. */
vbss_result vbss_slot_destroy(void *handle, const vbss_kind *kind);
/* A handle for an object inside another, which uses it by its public functions. The context does not know
 * it: whoever made the object ends it. */
vbss_slot vbss_slot_inside(vbss_context *context, const vbss_kind *kind, void *object);
/* A context pointer from the host, to look at or to change what it owns. */
vbss_result vbss_context_open(const vbss_context *context);
vbss_result vbss_context_edit(vbss_context *context);

#endif
