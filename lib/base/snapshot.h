/* Snapshots: the state of one object as bytes with magic number, length and checksum. */
#ifndef VBSS_BASE_SNAPSHOT_H
#define VBSS_BASE_SNAPSHOT_H

#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/base.h>

#include "base/slot.h"

/* Bytes that vbss_snapshot_save writes in the present state. */
vbss_result vbss_snapshot_size(const vbss_slot *slot, size_t *bytes);
/* Writes the state. VBSS_ERROR_CAPACITY if the buffer is too small. */
vbss_result vbss_snapshot_save(const vbss_slot *slot, uint8_t *bytes, size_t capacity,
                               size_t *written);
/* Restores the state from `count` bytes. On any failure the object keeps its state.
 * VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT, VBSS_ERROR_DATA_VERSION, VBSS_ERROR_OUT_OF_MEMORY,
 * VBSS_ERROR_BUSY inside a callback. */
vbss_result vbss_snapshot_restore(vbss_slot *slot, const uint8_t *bytes, size_t count);
/* The parts of a snapshot; the description may be missing. */
typedef struct vbss_snapshot_parts {
    const uint8_t *state, *description;
    size_t state_bytes, description_bytes;
} vbss_snapshot_parts;
/* Checks the envelope, and finds the parts in it. `what` begins the error text.
 * VBSS_ERROR_TRUNCATED, VBSS_ERROR_CORRUPT or VBSS_ERROR_DATA_VERSION. */
vbss_result vbss_snapshot_open(vbss_context *context, const char *what, const uint8_t *bytes,
                               size_t count, vbss_snapshot_parts *parts);
/* XXH64 of the state, without the envelope. */
vbss_result vbss_snapshot_hash(const vbss_slot *slot, uint64_t *hash);
/* Bodies of the public functions: they check the host's arguments and work for any kind of object.
 * vbss_object_save sets *written to the bytes needed and returns VBSS_ERROR_CAPACITY if `capacity`
 * is smaller; without an error text if `bytes` is NULL and `capacity` 0. vbss_object_restore returns VBSS_ERROR_IN_SCENE for an object that has an owner. */
vbss_result vbss_object_save(const void *handle, const vbss_kind *kind, uint8_t *bytes,
                             uint64_t capacity, uint64_t *written);
vbss_result vbss_object_restore(const void *handle, const vbss_kind *kind, const uint8_t *bytes,
                                uint64_t count);
vbss_result vbss_object_hash(const void *handle, const vbss_kind *kind, uint64_t *hash);

#endif
