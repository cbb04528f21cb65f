/* A host with tissue of its own: linear tetrahedra, implicit steps, and a scene that lays a taut thread over them.
 *
 * In each step the host computes where its nodes go without the thread, gives the surface to the scene, and then applies the
 * forces that the scene returns. How far a vertex gives way to a force in a step, a block of 3 x 3 of the inverse of the
 * host's matrix, goes to the scene once: without it a light surface is not stable. */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <vblast_ss/vblast_ss.h>

#include "fem.h"

enum { NX = 8, NY = 2, NZ = 8, ROW = NZ + 1, LAYER = (NX + 1) * ROW };
static const double h = 1e-3;
static fem tissue;

/* ---- scene */

static void check(vbss_context *context, vbss_result result)
{
    if (result != VBSS_OK) {
        const char *text = "";
        (void)vbss_context_get_last_error(context, NULL, &text);
        fprintf(stderr, "%s: %s\n", vbss_result_name(result), text);
        exit(1);
    }
}

static uint32_t add_surface(vbss_context *context, vbss_scene *scene)
{
    uint32_t triangles[2 * NX * NZ][3], body;
    static double compliance[LAYER][9];
    for (uint32_t i = 0; i < NX * NZ; i++) {
        const uint32_t a = i / NZ * ROW + i % NZ, b = a + ROW;
        const uint32_t cell[2][3] = {{a, a + 1, b + 1}, {a, b + 1, b}};
        memcpy(triangles[2 * (size_t)i], cell, sizeof cell);
    }
    vbss_scene_surface_config config = vbss_scene_surface_config_default();
    config.vertex_count = LAYER;
    config.triangle_count = 2 * NX * NZ;
    config.vertices = tissue.rest[tissue.first_surface];
    config.triangles = triangles[0];
    config.friction = 0.1;
    config.compliance_size = 9;
    check(context, vbss_scene_add_surface(scene, &config, &body));
    for (int i = 0; i < LAYER; i++) {
        fem_compliance(&tissue, i, 1, compliance[i]);
    }
    check(context, vbss_scene_set_surface_compliance(scene, body, compliance[0], 9 * LAYER));
    return body;
}

/* A thread across the tissue, beyond both sides of it, whose ends are drawn down by 50 mN each. */
static void add_thread(vbss_context *context, vbss_scene *scene)
{
    vbss_thread_config config = vbss_thread_config_default();
    vbss_thread_attachment pull;
    vbss_thread *thread;
    uint32_t body, id;
    config.length = 60e-3;
    config.segment_count = 60;
    config.start[0] = -30e-3;
    config.start[1] = 0.5e-3;
    config.start[2] = 1e-3;
    check(context, vbss_thread_create(context, &config, &thread));
    check(context, vbss_scene_add_thread(scene, thread, &body));
    for (uint32_t end = 0; end < 2; end++) {
        check(context, vbss_thread_attachment_init(&pull, sizeof pull));
        pull.kind = VBSS_THREAD_ATTACHMENT_MASS;
        pull.node = end * config.segment_count;
        pull.mass = 1e-3;
        check(context, vbss_thread_attach(thread, &pull, &id));
        pull.kind = VBSS_THREAD_ATTACHMENT_FORCE;
        pull.force[1] = -50e-3;
        check(context, vbss_thread_attach(thread, &pull, &id));
    }
}

int main(void)
{
    static double vertices[LAYER][3];
    const fem_config own = {{NX, NY, NZ}, 5e-3, 20e3, 0.4, 1000.0, 20.0, h};
    vbss_context *context;
    vbss_scene *scene;
    vbss_scene_config config = vbss_scene_config_default();
    (void)setlocale(LC_NUMERIC, "C");      /* numbers with a decimal point */
    config.mode = VBSS_SCENE_MODE_OFFLINE; /* each call finishes its step */
    check(NULL, vbss_context_create(NULL, &context));
    check(context, vbss_scene_create(context, &config, &scene));
    if (!fem_create(&tissue, &own)) {
        return 1;
    }
    const uint32_t surface = add_surface(context, scene);
    add_thread(context, scene);
    double apart = 0.0, deepest = 0.0, force = 0.0;
    for (int step = 0; step < 1000; step++) {
        fem_predict(&tissue, vertices); /* where the tissue goes without contact */
        check(context, vbss_scene_move_surface(scene, surface, vertices[0], LAYER));
        check(context, vbss_scene_step(scene, h));
        vbss_view forces, positions;
        check(context, vbss_scene_get_surface_view(scene, surface, VBSS_SCENE_SURFACE_VIEW_FORCES,
                                                   &forces, sizeof forces));
        check(context,
              vbss_scene_get_surface_view(scene, surface, VBSS_SCENE_SURFACE_VIEW_POSITIONS,
                                          &positions, sizeof positions));
        const double(*f)[3] = (const double(*)[3])forces.data,
              (*x)[3] = (const double(*)[3])positions.data;
        fem_apply(&tissue, f);
        apart = deepest = force = 0.0;
        for (int i = 0; i < LAYER; i++) {
            const int node = tissue.first_surface + i;
            const double height = tissue.rest[node][1] + tissue.u[node][1];
            apart = fmax(apart, fabs(x[i][1] - height));
            deepest = fmin(deepest, height);
            force += f[i][1];
        }
    }
    printf("force on the tissue %.4f N, deepest %.3f mm, host and scene apart by %.4f mm\n", force,
           1e3 * deepest, 1e3 * apart);
    fem_destroy(&tissue);
    check(context, vbss_context_destroy(context));
    return 0;
}
