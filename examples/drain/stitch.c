/* Shows how a double throw shuts the slit: `stitch_gallery <folder>` steps the scene of tests/fixtures/stitch_scenes.h, prints
 * gap and forces, and writes into that folder, which must be there, open.png, closing.png, shut.png, seen from aside and from
 * above, and lumen.png, shut, seen along the lumen. */
#include <stdio.h>

#include "decimal_point.h"
#include "painter/painter.h"
#include "portrait.h"
#include "fixtures/stitch_scenes.h"

#define STEP_S 1e-3

typedef struct closest_points {
    const char *file, *title;
    uint32_t at; /* step */
} moment;

static const moment moments[] = {
    {"open", "a double throw above the slit", 99},
    {"closing", "the limbs are drawn apart", 420},
    {"shut", "shut, 2 N in each limb", STITCH_TIE_STEPS - 1},
};
enum { MOMENTS = sizeof moments / sizeof moments[0], REPORT_INTERVAL = 100 };

/* As far round the drain as is worth a look. */
#define NEAR 20e-3

static painter_result paint_thread(painter *p, const stitch_scene *s)
{
    vbss_view x;
    static double near[3 * STITCH_NODES];
    size_t count = 0;
    if (vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x) != VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    for (uint64_t i = 0; i < x.count && count < STITCH_NODES; i++) {
        const double *node = (const double *)x.data + 3 * i;
        if (node[2] * node[2] < NEAR * NEAR) {
            for (int k = 0; k < 3; k++) {
                near[3 * count + (size_t)k] = node[k];
            }
            count++;
        }
    }
    return painter_add_chain(p, near, count, 0, 0.125e-3, PAINTER_VIOLET, NULL);
}

static bool paint(const char *folder, const char *file, const char *title, const stitch_scene *s,
                  const double from[3], bool two)
{
    char path[512];
    painter *p;
    const double up[3] = {0.0, 1.0, 0.0};
    snprintf(path, sizeof path, "%s/%s.png", folder, file);
    if (painter_create(700, 560, &p) != PAINTER_OK) {
        return false;
    }
    bool fine = paint_drain(p, s->drain) == PAINTER_OK && paint_thread(p, s) == PAINTER_OK &&
                painter_fit_camera(p, from, up) == PAINTER_OK &&
                painter_add_scale_bar(p, 5e-3, "5 mm") == PAINTER_OK &&
                painter_add_text(p, 16.0, 28.0, title, PAINTER_BLACK) == PAINTER_OK &&
                (two ? painter_write_two_views(p, path) : painter_write_png(p, path)) == PAINTER_OK;
    if (!fine) {
        fprintf(stderr, "%s: %s\n", path, painter_error(p));
    }
    painter_destroy(p);
    return fine;
}

static void report(const stitch_scene *s, uint32_t step)
{
    vbss_drain_gap gap;
    vbss_scene_hole left, right;
    if (vbss_drain_get_gap(s->drain, &gap, sizeof gap) == VBSS_OK &&
        stitch_scene_hole(s, 0, &left) && stitch_scene_hole(s, 1, &right)) {
        printf("%4u ms  gap %.2f mm  hands %.2f and %.2f N  between the holes %.1f mm of thread\n",
               step, 1e3 * gap.gap, stitch_scene_pull(s, 0), stitch_scene_pull(s, 1),
               1e3 * (right.arc_length - left.arc_length));
    }
}

static bool run(const char *folder, stitch_scene *s)
{
    const double aside[3] = {-1.0, -0.6, -0.5}, along[3] = {-1.0, -0.12, -0.05};
    bool fine = true;
    for (uint32_t i = 0; fine && i < STITCH_TIE_STEPS; i++) {
        fine = stitch_scene_tie(s, i, STEP_S) == VBSS_OK;
        if (i % REPORT_INTERVAL == 0 || i + 1 == STITCH_TIE_STEPS) {
            report(s, i);
        }
        for (int k = 0; fine && k < MOMENTS; k++) {
            if (i == moments[k].at) {
                fine = paint(folder, moments[k].file, moments[k].title, s, aside, true);
            }
        }
    }
    return fine && paint(folder, "lumen", "shut, along the lumen", s, along, false);
}

int main(int argc, char **argv)
{
    use_decimal_point();
    static stitch_scene s;
    static stitch_scene_options options;
    vbss_context *context;
    if (argc != 2) {
        fprintf(stderr, "usage: stitch_gallery <folder>\n");
        return 2;
    }
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        return 1;
    }
    bool fine = stitch_scene_init(&options) == VBSS_OK;
    options.crossings = 5;
    fine = fine && stitch_scene_create(context, &options, &s) == VBSS_OK && run(argv[1], &s);
    (void)vbss_context_destroy(context);
    return fine ? 0 : 1;
}
