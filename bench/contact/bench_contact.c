/* Suite contact: what a step with contact costs, beside penetration, stretch and what became of the knot. */
#include "contact/bench_contact.h"

#include <vblast_ss/base.h>

static void add_cases(bench *b)
{
    add_knot_cases(b);
    add_throw_cases(b);
    add_resolution_cases(b);
    add_adaptive_cases(b);
    add_peer_cases(b);
}

int main(int argc, char **argv)
{
    const bench_suite suite = {"contact", vbss_build_info(), add_cases};
    return bench_main(argc, argv, &suite);
}
