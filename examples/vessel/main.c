/* A ligature: a double throw is drawn tight round a vessel that lies on a pelvis-like surface.
 *
 *     vessel [folder for pictures [s between frames of a film]]
 *
 * The vessel is a tube of the shell, the surface a static mesh of 4,608 triangles, the thread a suture of its own. Two hands pull
 * at its ends. Prints lumen and forces; exits 0 if the vessel is shut and the thread has stayed above the surface. */
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "decimal_point.h"
#include "painter/painter.h"
#include "vessel.h"

#define MILLI 1e3
enum { STEPS = 1800, EVERY = 200 };
static const double pull = 1.5 /* N */, shut = 0.25 /* of the area */,
                    touch = 0.05e-3 /* m: twice what its triangles differ from the surface */;

static painter_result paint(painter *p, const vessel_scene *s, const char *text)
{
    vbss_view nodes, triangles, thread;
    if (vbss_drain_get_view(s->vessel, VBSS_DRAIN_VIEW_POSITIONS, &nodes, sizeof nodes) !=
            VBSS_OK ||
        vbss_drain_get_view(s->vessel, VBSS_DRAIN_VIEW_TRIANGLES, &triangles, sizeof triangles) !=
            VBSS_OK ||
        vbss_thread_get_view(s->thread, VBSS_THREAD_VIEW_POSITIONS, &thread, sizeof thread) !=
            VBSS_OK) {
        return PAINTER_ERROR_NULL;
    }
    const painter_camera camera = {
        {0.035, -0.07, 0.06}, {0.0, 0.0, -0.003}, {0.0, 0.0, 1.0}, 0.072, 0.0};
    painter_result result = painter_add_triangles(
        p, s->vertices[0], PELVIS_VERTICES, 0, s->triangles[0], PELVIS_TRIANGLES, PAINTER_TISSUE);
    if (result == PAINTER_OK) {
        result = painter_add_triangles(p, nodes.data, (size_t)nodes.count, 0, triangles.data,
                                       (size_t)triangles.count, PAINTER_VERMILION);
    }
    if (result == PAINTER_OK) {
        result = painter_add_chain(p, thread.data, (size_t)thread.count, 0, VESSEL_THREAD_RADIUS,
                                   PAINTER_VIOLET, NULL);
    }
    if (result == PAINTER_OK) {
        result = painter_set_camera(p, &camera);
    }
    if (result == PAINTER_OK) {
        result = painter_add_scale_bar(p, 10e-3, "10 mm");
    }
    return result != PAINTER_OK ? result : painter_add_text(p, 16.0, 28.0, text, PAINTER_BLACK);
}

static bool save(const char *folder, const char *name, const vessel_scene *s)
{
    char path[512], text[96];
    painter *p;
    if (painter_create(900, 640, &p) != PAINTER_OK) {
        return false;
    }
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    snprintf(text, sizeof text, "%.2f and %.2f N, lumen %.0f %%", s->force[0], s->force[1],
             100.0 * vessel_narrowest(s) / s->initial_area);
    const bool good = paint(p, s, text) == PAINTER_OK && painter_write_png(p, path) == PAINTER_OK;
    if (!good) {
        fprintf(stderr, "%s: %s\n", path, painter_error(p));
    }
    painter_destroy(p);
    return good;
}

static void report(const vessel_scene *s, int step)
{
    printf("%5.2f s  hands %.2f and %.2f N  lumen %5.1f %%  thread %6.3f mm clear of the surface\n",
           step * VESSEL_STEP, s->force[0], s->force[1],
           100.0 * vessel_narrowest(s) / s->initial_area, MILLI * vessel_clearance(s));
}

/* `clearance`: the smallest of those that are told, m. */
static vbss_result run(vessel_scene *s, const char *folder, double interval, double *clearance,
                       bool *painted)
{
    vbss_result result = VBSS_OK;
    int frames = 0;
    *painted = folder == NULL || save(folder, "loose", s);
    *clearance = vessel_clearance(s);
    for (int step = 1; step <= STEPS && result == VBSS_OK; step++) {
        result = vessel_pull(s, pull);
        *clearance = fmin(*clearance, vessel_clearance(s));
        if (step % EVERY == 0) {
            report(s, step);
        }
        if (interval > 0.0 && step * VESSEL_STEP >= frames * interval) {
            char name[32];
            snprintf(name, sizeof name, "frame-%04d", frames++);
            *painted = *painted && save(folder, name, s);
        }
    }
    *painted = *painted && (folder == NULL || save(folder, "tied", s));
    return result;
}

int main(int count, char **words)
{
    use_decimal_point();
    static vessel_scene s;
    vbss_context *context;
    vbss_scene_statistics counted;
    uint64_t hash = 0;
    bool painted = false;
    double clearance = 0.0;
    const double interval = count > 2 ? strtod(words[2], NULL) : 0.0;
    if (count > 3 || vbss_context_create(NULL, &context) != VBSS_OK) {
        fprintf(stderr, "usage: vessel [folder for pictures [s between frames of a film]]\n");
        return 2;
    }
    vbss_result result = vessel_create(context, &s);
    if (result == VBSS_OK) {
        result = run(&s, count > 1 ? words[1] : NULL, interval, &clearance, &painted);
    }
    result =
        result == VBSS_OK ? vbss_scene_get_statistics(s.scene, &counted, sizeof counted) : result;
    result = result == VBSS_OK ? vbss_scene_get_hash(s.scene, &hash) : result;
    if (result != VBSS_OK) {
        const char *text = "";
        (void)vbss_context_get_last_error(context, NULL, &text);
        fprintf(stderr, "%s: %s\n", vbss_result_name(result), text);
        (void)vbss_context_destroy(context);
        return 1;
    }
    const double lumen = vessel_narrowest(&s) / s.initial_area;
    printf("lumen %.1f %% of %.2f mm2; the thread kept %.3f mm clear; %" PRIu64
           " steps cut short; hash %016" PRIx64 "\n",
           100.0 * lumen, MILLI * MILLI * s.initial_area, MILLI * clearance, counted.clamped, hash);
    (void)vbss_context_destroy(context);
    return lumen < shut && clearance > -touch && painted ? 0 : 1;
}
