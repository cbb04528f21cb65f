/* Suite thread: what a step of the suture thread costs beside what it gets wrong, with peers. */
#include "thread/bench_thread.h"

#include <stdio.h>

#include <vblast_ss/thread.h>

static void add_cases(bench *b)
{
    static void (*const groups[])(bench *) = {
        add_cantilever_cases,
        add_growth_cases,
        add_stage_cases,
        add_option_cases,
    };
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
        groups[i](b);
    }
}

int main(int argc, char **argv)
{
    static const char peers[] = ""
#if defined(BENCH_HAVE_BULLET)
                                "Bullet " BENCH_HAVE_BULLET ", "
#endif
#if defined(BENCH_HAVE_MUJOCO)
                                "MuJoCo " BENCH_HAVE_MUJOCO ", "
#endif
        ;
    char library[512];
    /* Peers first: the report cuts long lists of flags. */
    snprintf(library, sizeof library, "%s%s", peers, vbss_build_info());
    const bench_suite suite = {"thread", library, add_cases};
    int status = bench_main(argc, argv, &suite);
    print_cantilever_notes();
    return status;
}
