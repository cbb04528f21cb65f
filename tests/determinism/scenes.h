/* The golden scenes: what the determinism table hashes and tests/golden/ keeps.
 *
 * A module adds its scenes to the list in scenes.c. A scene runs at most 2 s natively in full and
 * 0.2 s under emulation in its short form, which is the beginning of the same run. */
#ifndef VBSS_TESTS_DETERMINISM_SCENES_H
#define VBSS_TESTS_DETERMINISM_SCENES_H

#include <stddef.h>
#include <stdint.h>

typedef struct golden_scene {
    const char *name;
    size_t count, short_count; /* hashes in full, and under emulation */
    void (*run)(uint64_t *hashes, size_t count);
} golden_scene;

extern const golden_scene golden_scenes[];
extern const size_t golden_scene_count;

#endif
