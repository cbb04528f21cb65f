/* Shows a needle that goes through both walls of a drain and back out: `puncture_gallery <folder>` steps the scene of
 * tests/fixtures/puncture_scenes.h, prints what happens with the forces then, and writes into that folder, which must be
 * there, entry.png, inside.png, through.png and out.png, seen from two sides; force.svg and force.png, what the hand
 * drives the needle with beside the range that was measured on Penrose drains; and force.csv. */
#include <stdio.h>

#include "decimal_point.h"
#include "force_plot.h"
#include "painter/painter.h"
#include "portrait.h"
#include "fixtures/puncture_scenes.h"

#define STEP_S 1e-3

typedef struct closest_points {
    const char *file, *title;
    double at; /* of all steps, as a share */
} moment;

static const moment moments[] = {
    {"entry", "before it enters", 0.135},
    {"inside", "through one wall", 0.26},
    {"through", "through both walls", 0.43},
    {"out", "on its way back", 0.80},
};
enum { MOMENTS = sizeof moments / sizeof moments[0] };

/* ---- pictures */

static painter_result paint_needle(painter *p, const puncture_scene *s)
{
    vbss_view points;
    if (vbss_needle_get_view(s->needle, VBSS_NEEDLE_VIEW_POINTS, &points, sizeof points) !=
        VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    return painter_add_chain(p, points.data, (size_t)points.count, 0, 0.35e-3, PAINTER_STEEL, NULL);
}

static painter_result paint_holes(painter *p, const puncture_scene *s)
{
    painter_result result = PAINTER_OK;
    vbss_scene_hole hole;
    for (uint32_t i = 0;
         result == PAINTER_OK && vbss_scene_get_hole(s->scene, i, &hole, sizeof hole) == VBSS_OK;
         i++) {
        result = painter_add_dots(p, hole.position, 1, 0, 4.0, PAINTER_ORANGE);
    }
    return result;
}

static bool paint(const char *folder, const moment *m, const puncture_scene *s)
{
    char path[512];
    painter *p;
    const double from[3] = {-1.0, -0.35, -0.25}, up[3] = {0.0, 1.0, 0.0};
    snprintf(path, sizeof path, "%s/%s.png", folder, m->file);
    if (painter_create(700, 560, &p) != PAINTER_OK) {
        return false;
    }
    bool fine = paint_drain(p, s->drain) == PAINTER_OK && paint_needle(p, s) == PAINTER_OK &&
                painter_fit_camera(p, from, up) == PAINTER_OK && paint_holes(p, s) == PAINTER_OK &&
                painter_add_scale_bar(p, 5e-3, "5 mm") == PAINTER_OK &&
                painter_add_text(p, 16.0, 28.0, m->title, PAINTER_BLACK) == PAINTER_OK &&
                painter_write_two_views(p, path) == PAINTER_OK;
    if (!fine) {
        fprintf(stderr, "%s: %s\n", path, painter_error(p));
    }
    painter_destroy(p);
    return fine;
}

/* ---- the run */

static void report(const puncture_scene *s, double travel, double push)
{
    static const struct {
        vbss_scene_event_kind kind;
        const char *name;
    } events[] = {{VBSS_SCENE_EVENT_PUNCTURE, "enters"},
                  {VBSS_SCENE_EVENT_WITHDRAWN, "is out again"},
                  {VBSS_SCENE_EVENT_PASSED, "has passed"}};
    for (int i = 0; i < 3; i++) {
        if (puncture_scene_count(s, events[i].kind) > 0) {
            printf("%-14s%8.2f mm%9.3f N\n", events[i].name, 1e3 * travel, push);
        }
    }
}

static bool run(const char *folder, puncture_scene *s, force_curve *curve)
{
    uint32_t steps = puncture_scene_steps(s, STEP_S);
    bool fine = steps <= FORCE_PLOT_POINTS;
    for (uint32_t i = 1; fine && i <= steps; i++) {
        double push = 0.0, travel = puncture_scene_travel(s->speed, i, STEP_S);
        fine =
            puncture_scene_step(s, STEP_S) == VBSS_OK && puncture_scene_push(s, &push) == VBSS_OK;
        curve->turn += s->speed * STEP_S * i <= PUNCTURE_SCENE_ON;
        curve->travel[curve->count] = travel;
        curve->force[curve->count++] = push;
        report(s, travel, push);
        for (int k = 0; fine && k < MOMENTS; k++) {
            if (i == (uint32_t)(moments[k].at * steps)) {
                fine = paint(folder, &moments[k], s);
            }
        }
    }
    return fine;
}

static bool write_numbers(const char *path, const force_curve *curve)
{
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        perror(path);
        return false;
    }
    fprintf(file, "way_mm,force_N\n");
    for (size_t i = 0; i < curve->count; i++) {
        fprintf(file, "%.4f,%.5f\n", 1e3 * curve->travel[i], curve->force[i]);
    }
    return fclose(file) == 0;
}

static bool show(const char *folder, const force_curve *curve)
{
    static const char *const names[] = {"force.svg", "force.png"};
    const force_plot plot = {"What the hand drives the needle with, over the tip's travel", 0.852,
                             2.915, "Penrose drains, both walls: 0.85 to 2.92 N"};
    char path[512];
    bool fine = true;
    for (int i = 0; i < 2; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        fine = force_plot_write(&plot, curve, path) && fine;
    }
    snprintf(path, sizeof path, "%s/force.csv", folder);
    return write_numbers(path, curve) && fine;
}

int main(int argc, char **argv)
{
    use_decimal_point();
    static force_curve curve;
    vbss_context *context;
    vbss_scene_config scene;
    vbss_drain_config drain;
    puncture_scene s;
    if (argc != 2) {
        fprintf(stderr, "usage: puncture_gallery FOLDER\n");
        return 2;
    }
    if (vbss_context_create(NULL, &context) != VBSS_OK) {
        return 1;
    }
    bool fine = puncture_scene_configs(&scene, &drain) == VBSS_OK &&
                puncture_scene_create(context, &scene, &drain, &s) == VBSS_OK &&
                run(argv[1], &s, &curve) && show(argv[1], &curve);
    fine = vbss_context_destroy(context) == VBSS_OK && fine;
    return fine ? 0 : 1;
}
