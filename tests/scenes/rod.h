/* A small body that keeps every rule of the house: the model for modules and the subject of the
 * harness' own tests, of the determinism table and of the bench. Not physics anyone should use: a
 * chain of points under gravity held at its first node, extended position-based, with a spinning
 * frame on its end and random gusts. */
#ifndef VBSS_TESTS_SCENES_ROD_H
#define VBSS_TESTS_SCENES_ROD_H

#include "base/slot.h"

typedef struct rod rod; /* the handle */

typedef struct rod_config {
    uint32_t struct_size;
    uint32_t node_count; /* 2 .. 4096, default 64 */
    double length;       /* m, 1e-6 .. 1e3, default 0.15 */
    double gust;         /* m/s added to a random node each step, default 0.01 */
    uint64_t seed;       /* of the gusts, default 1; not in the first version */
} rod_config;
/* Its sizes, as if seed had come with a second version; then 0. */
extern const uint32_t rod_config_sizes[3];

extern const vbss_kind rod_kind;

vbss_result rod_config_init(rod_config *config, uint32_t struct_size);
vbss_result rod_create(vbss_context *context, const rod_config *config, rod **handle);
vbss_result rod_destroy(rod *handle);
vbss_result rod_step(rod *handle, double h); /* h in s, 1e-9 .. 0.1 */
vbss_result rod_get_tip(const rod *handle, double tip[3]);

#endif
