/* Whether anything passed through anything in a performance, asked once more and exactly (tests/oracle), of every part that a step
 * takes: threads with themselves, with the axes of tools, with the needle, with the drain's wall; needle and tools with that wall. What
 * goes through a registered hole may: beside it neither the wall round it nor anything else. What jaws hold is kept between them by a clamp, not by contact, and may come
 * to lie across the axis of one of them; ends that blades have just cut are between them: both is counted apart. The drain with itself is not asked. */
#ifndef VBSS_BENCH_TASK_PASSED_H
#define VBSS_BENCH_TASK_PASSED_H

#include <vblast_ss/scene.h>

#include <stdbool.h>
#include <stdint.h>

typedef struct passed passed;

typedef struct passed_counts {
    uint64_t parts;         /* looked at */
    uint64_t threads;       /* pairs that met: of threads and tools, */
    uint64_t thread_needle; /* of thread and needle, */
    uint64_t thread_drain;  /* of wall and thread, */
    uint64_t needle_drain;  /* and needle, */
    uint64_t tool_drain;    /* and tool */
    uint64_t
        in_jaws; /* of a thread and the jaws that hold it there, and at fresh cuts; not in the sum */
    uint64_t first_step; /* in which the first of them was seen, from 1 on; 0: none was */
} passed_counts;

/* Watches the scene, which ends before this does; NULL: no memory. */
passed *passed_create(vbss_scene *scene, uint32_t drain_body);
/* After every step. False: something could not be asked. */
bool passed_observe(passed *p);
passed_counts passed_get(const passed *p);
uint64_t passed_sum(const passed_counts *c);
void passed_destroy(passed *p);

#endif
