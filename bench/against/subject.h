/* Subjects of the paired bench. A subject is a scene with a fixed script of steps. Only one subject lives in a process, so each
 * keeps its state in one static object. The subjects call the public C API, because each of them is compiled against the
 * headers of every revision that is measured. */
#ifndef VBSS_BENCH_AGAINST_SUBJECT_H
#define VBSS_BENCH_AGAINST_SUBJECT_H

#include <stdbool.h>
#include <stdint.h>

#include <vblast_ss/vblast_ss.h>

#define SUBJECT_STEP 1e-3 /* s, of all subjects */

typedef struct subject {
    const char *name; /* <suite>/<subject> */
    bool is_seeded;   /* the script depends on the seed */
    /* Builds the scene, and advances it to the first step that is timed. */
    vbss_result (*begin)(uint64_t seed);
    /* False: the script is complete. */
    bool (*goes_on)(void);
    vbss_result (*step)(void);
    /* CPU time of the last step, s. NULL: the whole call of `step` counts. */
    double (*taken)(void);
    /* Whether the script reached its aim. NULL: it has none. */
    bool (*is_done)(void);
    vbss_result (*hash)(uint64_t *hash);
    /* NULL: the subject has no scene, and no counters of one. */
    vbss_scene *(*scene)(void);
    void (*end)(void);
} subject;

extern const subject free_thread;
extern const subject held_double_overhand, tightened_fls;
extern const subject poked_drain;
extern const subject scene_at_rest;
extern const subject whole_task;

#endif
