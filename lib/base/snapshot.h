/* Snapshots: the state of one object as bytes with magic, length and checksum. */
#ifndef VBSS_BASE_SNAPSHOT_H
#define VBSS_BASE_SNAPSHOT_H

#include <stddef.h>
#include <stdint.h>

#include <vblast_ss/base.h>

#include "base/slot.h"

vbss_result vbss_snapshot_size(const vbss_slot *slot, size_t *bytes);
vbss_result vbss_snapshot_save(const vbss_slot *slot, uint8_t *bytes, size_t capacity,
                               size_t *written);
/* All or nothing: on any failure the object is as it was. */
vbss_result vbss_snapshot_restore(vbss_slot *slot, const uint8_t *bytes, size_t count);
vbss_result vbss_snapshot_hash(const vbss_slot *slot, uint64_t *hash);
/* The same as hosts ask for them, with their arguments checked: of any kind of object. */
vbss_result vbss_object_save(const void *handle, const vbss_kind *kind, uint8_t *bytes,
                             uint64_t capacity, uint64_t *written);
vbss_result vbss_object_restore(const void *handle, const vbss_kind *kind, const uint8_t *bytes,
                                uint64_t count);
vbss_result vbss_object_hash(const void *handle, const vbss_kind *kind, uint64_t *hash);

#endif
