/* Structs that cross the border: the size protocol of docs/abi.md.
 * Each starts with uint32_t struct_size. */
#ifndef VBSS_BASE_CONFIG_H
#define VBSS_BASE_CONFIG_H

#include <stdint.h>

#include <vblast_ss/base.h>

typedef struct vbss_layout {
    const char *name;
    const void *defaults;  /* of a config; NULL for a struct that only goes out */
    const uint32_t *sizes; /* of all published versions, ascending, the last is today's; then 0 */
} vbss_layout;
vbss_result vbss_config_init(const vbss_layout *layout, void *config, uint32_t struct_size);
/* Fills `own` (of today's size) with the defaults and copies a caller's config over them. */
vbss_result vbss_config_read(vbss_context *context, const vbss_layout *layout, const void *config,
                             void *own);
extern const vbss_layout vbss_view_layout;
/* Hands out a struct that the caller may know in another size. */
vbss_result vbss_struct_write(vbss_context *context, const vbss_layout *layout, const void *own,
                              void *out, uint32_t struct_size);

#endif
