/* Suite task: what each part of the task costs, what finer threads cost, and the whole task by scripted surgeons. */
#include "task/bench_task.h"

#include <vblast_ss/base.h>

static void add_cases(bench *b)
{
    add_part_cases(b);
    add_tying_cases(b);
    add_drawn_cases(b);
    add_performances(b);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"task", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
