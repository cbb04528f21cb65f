/* Suite collision: what a continuous test costs beside what it gets wrong, with peers; and what finding
 * the pairs to test costs. */
#include "collision/bench_collision.h"

#include <stdio.h>

#include <vblast_ss/collision.h>

static void add_cases(bench *b)
{
    static void (*const groups[])(bench *) = {
        add_query_cases,
        add_broad_cases,
    };
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
        groups[i](b);
    }
}

int main(int argc, char **argv)
{
    static const char peers[] = ""
#if defined(VBSS_HAVE_FCL)
                                "FCL " VBSS_HAVE_FCL ", "
#endif
#if defined(VBSS_HAVE_LIBCCD)
                                "libccd " VBSS_HAVE_LIBCCD ", "
#endif
        ;
    char library[512];
    /* Peers first: the report cuts long lists of flags. */
    snprintf(library, sizeof library, "%s%s", peers, vbss_build_info());
    const bench_suite suite = {"collision", library, add_cases};
    int status = bench_main(argc, argv, &suite);
    print_query_notes();
    end_query_cases();
    return status;
}
