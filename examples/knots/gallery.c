/* Ties the knots of surgery, tight, round a drain where they belong there; prints how that went and what the knot
 * detector says of them, and paints them: `knot_gallery <folder>` writes <knot>.png (tight, from two sides,
 * coloured by tension), <knot>.svg, <knot>-stages.png (loose, in between, tight) and <knot>-throws.png and .svg
 * (loose and tight, coloured by throw) into that folder, which must be there. */
#include <stdio.h>
#include <stdlib.h>

#include "decimal_point.h"
#include "knots/gallery.h"

static gallery_knot knots[] = {
    {.file = "overhand",
     .title = "overhand",
     .notation = "1",
     .kind = KNOT_OVERHAND,
     .width = 3e-3},
    {.file = "double-overhand",
     .title = "double overhand",
     .notation = "2",
     .kind = KNOT_DOUBLE_OVERHAND,
     .width = 3.5e-3},
    {.file = "square",
     .title = "square 1=1",
     .notation = "1=1",
     .kind = KNOT_SQUARE,
     .cylinder = true,
     .width = 5.5e-3,
     .azimuth = 0.0,
     .elevation = 0.3},
    {.file = "granny",
     .title = "granny 1x1",
     .notation = "1x1",
     .kind = KNOT_GRANNY,
     .cylinder = true,
     .width = 5.5e-3,
     .azimuth = 0.0,
     .elevation = 0.3},
    {.file = "surgeon",
     .title = "surgeon's 2=1",
     .notation = "2=1",
     .kind = KNOT_SURGEON,
     .cylinder = true,
     .width = 5.5e-3,
     .azimuth = 0.0,
     .elevation = 0.3},
    {.file = "fls",
     .title = "FLS 2=1=1",
     .notation = "2=1=1",
     .kind = KNOT_FLS,
     .cylinder = true,
     .width = 5.5e-3,
     .azimuth = 0.0,
     .elevation = 0.3},
    {.file = "half-hitches",
     .title = "half hitches",
     .notation = "1x1",
     .kind = KNOT_HALF_HITCHES,
     .cylinder = true,
     .width = 5.5e-3,
     .azimuth = 0.0,
     .elevation = 0.3},
};
enum { KNOTS = sizeof knots / sizeof knots[0] };

static void print_head(void)
{
    printf("%-16s%6s%7s%8s%8s%8s%8s%10s%14s%10s%9s%9s  %s\n", "knot", "nodes", "s", "median", "p99",
           "held", "force", "taken up", "penetration", "stretch", "retries", "clamped", "topology");
    printf("%-16s%6s%7s%8s%8s%8s%8s%10s%14s%10s\n", "", "", "", "us", "us", "us", "N", "mm",
           "% of diameter", "error");
}

static void print_row(const gallery_knot *g)
{
    double diameter = 2.0 * g->knot.options.thread.radius;
    printf("%-16s%6u%7.2f%8.0f%8.0f%8.0f%8.2f%10.2f%14.1f%10.1e%9llu%9llu  %s%s\n", g->title,
           (unsigned)g->knot.node_count, g->seconds, g->median, g->p99, g->held, g->force,
           1e3 * g->taken_up, 100.0 * g->penetration / diameter, g->stretch,
           (unsigned long long)g->retries, (unsigned long long)g->clamped,
           g->topology_kept ? "kept" : "LOST", g->tight ? "" : ", NOT TIGHT");
    fflush(stdout);
}

/* Ties, prints, judges and paints one; false when it is not as it should be. */
static bool show(gallery_knot *g, const char *folder)
{
    bool tied = gallery_tie(g);
    if (tied) {
        print_row(g);
    }
    bool good = tied && g->tight && g->topology_kept && gallery_judge(g) &&
                gallery_paint(g, folder) && gallery_paint_throws(g, folder);
    gallery_end(g);
    return good;
}

int main(int argc, char **argv)
{
    use_decimal_point();
    bool good = true;
    if (argc != 2) {
        fprintf(stderr, "usage: %s <folder for the pictures>\n", argv[0]);
        return EXIT_FAILURE;
    }
    print_head();
    for (int i = 0; i < KNOTS && good; i++) {
        good = show(&knots[i], argv[1]);
    }
    for (int i = 0; i < KNOTS && knots[i].frames_judged > 0; i++) {
        good = gallery_report(&knots[i]) && good;
    }
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
