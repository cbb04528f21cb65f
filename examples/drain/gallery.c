/* Shows what a drain does when it is touched: `drain_gallery <folder>` steps the scenes of tests/fixtures/tissue_scenes.h up to
 * their most telling moment, prints how the drain is then, and writes <scene>.png, seen from two sides, into that folder,
 * which must be there. The slit's edges are red, the marks blue. */
#include <stdio.h>

#include "base/error.h"
#include "decimal_point.h"
#include "painter/painter.h"
#include "portrait.h"
#include "fixtures/tissue_scenes.h"

#define STEP_S 1e-3

typedef struct exhibit {
    const char *file, *title;
    tissue_scene_kind kind;
    uint32_t steps;
    vec3 from; /* the way one looks */
} exhibit;

static const exhibit exhibits[] = {
    {"rest", "at rest", TISSUE_SCENE_POKED, 0, {-0.5, -0.8, -0.6}},
    {"poked", "poked beside the slit", TISSUE_SCENE_POKED, 200, {-0.5, -0.8, -0.6}},
    {"pinched", "pinched flat by a rod", TISSUE_SCENE_PINCHED, 450, {-1.0, -0.3, -0.25}},
    {"shut", "marks drawn together", TISSUE_SCENE_SHUT, 100, {-0.8, -0.55, -0.3}},
    {"opened", "slit pulled open", TISSUE_SCENE_OPENED, 300, {-0.4, -0.9, -0.4}},
    {"inverted", "wall pushed into the lumen", TISSUE_SCENE_INVERTED, 350, {-1.0, -0.3, -0.25}},
    {"lifted", "torn off its block", TISSUE_SCENE_LIFTED, 330, {-0.5, -0.5, -0.8}},
    {"laden", "a loaded thread across it", TISSUE_SCENE_LADEN, 400, {-0.5, -0.6, -0.6}},
};
enum { EXHIBITS = sizeof exhibits / sizeof exhibits[0] };

/* ---- a scene up to its moment */

static vbss_result play(vbss_context *context, const exhibit *e, tissue_scene *t)
{
    vbss_scene_config scene;
    vbss_drain_config drain;
    VBSS_TRY(tissue_scene_configs(e->kind, VBSS_METHOD_IMPLICIT, &scene, &drain));
    VBSS_TRY(tissue_scene_create(context, e->kind, &scene, &drain, t));
    for (uint32_t i = 0; i < e->steps; i++) {
        VBSS_TRY(tissue_scene_step(t, STEP_S));
    }
    return VBSS_OK;
}

static vbss_result report(const exhibit *e, const tissue_scene *t)
{
    vbss_drain_gap gap;
    vbss_drain_energies energies;
    vbss_drain_statistics drain;
    vbss_scene_statistics scene;
    VBSS_TRY(vbss_drain_get_gap(t->drain, &gap, sizeof gap));
    VBSS_TRY(vbss_drain_get_energies(t->drain, &energies, sizeof energies));
    VBSS_TRY(vbss_drain_get_statistics(t->drain, &drain, sizeof drain));
    VBSS_TRY(vbss_scene_get_statistics(t->scene, &scene, sizeof scene));
    printf("%-10s%8.2f%10.2f%12.3f%10u%10u%9u%14.1f\n", e->file, 1e3 * gap.gap, 1e3 * gap.largest,
           1e3 * energies.total, (unsigned)drain.inverted, (unsigned)drain.torn,
           (unsigned)scene.contacts, 1e6 * scene.penetration);
    return VBSS_OK;
}

/* ---- the picture */

static painter_result paint_others(painter *p, const tissue_scene *t)
{
    painter_result result = PAINTER_OK;
    for (int i = 0; result == PAINTER_OK && i < TISSUE_TOOLS; i++) {
        vec3 axis[2];
        double a[3], b[3], radius = tissue_scene_tool(t, i, axis);
        if (radius > 0.0) {
            vec3_store(a, axis[0]);
            vec3_store(b, axis[1]);
            result = painter_add_capsule(p, a, b, radius, PAINTER_STEEL);
        }
    }
    vbss_view x;
    if (result == PAINTER_OK && t->thread != NULL &&
        vbss_thread_get_view(t->thread, VBSS_THREAD_VIEW_POSITIONS, &x, sizeof x) == VBSS_OK) {
        result = painter_add_chain(p, x.data, (size_t)x.count, 0, 0.125e-3, PAINTER_VIOLET, NULL);
    }
    return result;
}

static bool paint(const char *folder, const exhibit *e, const tissue_scene *t)
{
    char path[512];
    painter *p;
    double from[3];
    const double up[3] = {0.0, 1.0, 0.0};
    vec3_store(from, e->from);
    snprintf(path, sizeof path, "%s/%s.png", folder, e->file);
    if (painter_create(700, 560, &p) != PAINTER_OK) {
        return false;
    }
    bool fine = paint_drain(p, t->drain) == PAINTER_OK &&
                painter_fit_camera(p, from, up) == PAINTER_OK && paint_others(p, t) == PAINTER_OK &&
                painter_add_scale_bar(p, 5e-3, "5 mm") == PAINTER_OK &&
                painter_add_text(p, 16.0, 28.0, e->title, PAINTER_BLACK) == PAINTER_OK &&
                painter_write_two_views(p, path) == PAINTER_OK;
    if (!fine) {
        fprintf(stderr, "%s: %s\n", path, painter_error(p));
    }
    painter_destroy(p);
    return fine;
}

/* ---- all of them */

static bool show(const char *folder, const exhibit *e)
{
    vbss_context *context;
    tissue_scene t;
    bool fine = vbss_context_create(NULL, &context) == VBSS_OK;
    if (!fine) {
        return false;
    }
    vbss_result result = play(context, e, &t);
    if (result == VBSS_OK) {
        result = report(e, &t);
    }
    if (result != VBSS_OK) {
        fprintf(stderr, "%s: %s\n", e->file, vbss_result_string(result));
        fine = false;
    }
    fine = fine && paint(folder, e, &t);
    return vbss_context_destroy(context) == VBSS_OK && fine;
}

int main(int argc, char **argv)
{
    use_decimal_point();
    bool fine = true;
    if (argc != 2) {
        fprintf(stderr, "usage: drain_gallery FOLDER\n");
        return 2;
    }
    printf("%-10s%8s%10s%12s%10s%10s%9s%14s\n", "scene", "gap", "largest", "energy", "inverted",
           "torn off", "touches", "penetration");
    printf("%-10s%8s%10s%12s%10s%10s%9s%14s\n", "", "mm", "mm", "mJ", "triangles", "anchors", "",
           "um");
    for (int i = 0; i < EXHIBITS; i++) {
        fine = show(argv[1], &exhibits[i]) && fine;
    }
    return fine ? 0 : 1;
}
