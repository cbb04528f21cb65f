/* Threads and tools thrown at static meshes, host surfaces and rigid meshes in turn. Each seed lives six thousand
 * steps in all, the default number of seeds 1.2 million. Nothing passes through a mesh in any part of any step, decided exactly. */
#include "scene/mesh_life.h"

enum { LIVES = 30, STEPS = 200 };

static void run(harness_soak *out)
{
    vbss_random random;
    mesh_life_result result = {0};
    vbss_random_seed(&random, out->seed, 11);
    for (int i = 0; i < LIVES && out->failures == 0; i++) {
        const vbss_result done = mesh_life_run(&random, STEPS, (mesh_life_kind)(i % 3), &result);
        if (done != VBSS_OK || result.passed > 0) {
            harness_soak_fail(out, "life %d: %s, %llu passed", i, vbss_result_name(done),
                              (unsigned long long)result.passed);
        }
    }
    harness_soak_figure(out, "steps", (double)result.steps);
    harness_soak_figure(out, "parts", (double)result.parts);
    harness_soak_figure(out, "asked", (double)result.asked);
    harness_soak_figure(out, "touched", (double)result.touched);
    harness_soak_figure(out, "clamped", (double)result.clamped);
    harness_soak_figure(out, "fastest", result.fastest);
    harness_soak_figure(out, "fastest_vertex", result.fastest_vertex);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
