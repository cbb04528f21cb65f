/* The size protocol of public structs (docs/reference/abi.md). Each such struct starts with uint32_t
 * struct_size. */
#ifndef VBSS_BASE_CONFIG_H
#define VBSS_BASE_CONFIG_H

#include <stdint.h>

#include <vblast_ss/base.h>

/* A public struct in all its published versions. */
typedef struct vbss_layout {
    const char *name;
    const void *defaults; /* NULL for a struct that the library only writes */
    /* sizes of all published versions, ascending, with a final 0; the last one is the current
     * size */
    const uint32_t *sizes;
} vbss_layout;
/* Size of a public struct, or of an earlier version of it, whose fields take `bytes` beside this number
 * of pointers. Where pointers have four bytes, doubles are aligned to four (i386) or eight (armhf, wasm32),
 * and the end is padded to that. */
#define VBSS_SIZE_WITH_POINTERS(type, bytes, pointers)                                         \
    (uint32_t)(((bytes) + (pointers) * sizeof(void *) + _Alignof(type) - 1) / _Alignof(type) * \
               _Alignof(type))
/* The same for a struct with two pointers that have doubles between them: each is padded separately. */
#define VBSS_SIZE_WITH_SPLIT_POINTERS(type, bytes) \
    (VBSS_SIZE_WITH_POINTERS(type, bytes, 1u) + VBSS_SIZE_WITH_POINTERS(type, 0u, 1u))
/* Fills a config of `struct_size` bytes with the defaults and sets its struct_size.
 * VBSS_ERROR_NULL_ARGUMENT, or VBSS_ERROR_STRUCT_SIZE for a size that no version has; without an
 * error text. */
vbss_result vbss_config_init(const vbss_layout *layout, void *config, uint32_t struct_size);
/* Fills `own`, a struct of the current size, with the defaults and copies the caller's config over
 * them. VBSS_ERROR_NULL_ARGUMENT, VBSS_ERROR_STRUCT_SIZE for a size that no version has, or
 * VBSS_ERROR_UNKNOWN_FIELD if a newer config sets a field that this version does not have. */
vbss_result vbss_config_read(vbss_context *context, const vbss_layout *layout, const void *config,
                             void *own);
/* Layout of the public vbss_view. */
extern const vbss_layout vbss_view_layout;
/* Copies `own`, a struct of the current size, to the caller's struct of `struct_size` bytes. An
 * older caller gets its shorter version; a newer caller gets zeros at the end.
 * VBSS_ERROR_NULL_ARGUMENT, or VBSS_ERROR_STRUCT_SIZE for a size that no version has. */
vbss_result vbss_struct_write(vbss_context *context, const vbss_layout *layout, const void *own,
                              void *out, uint32_t struct_size);

#endif
