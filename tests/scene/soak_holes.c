/* Threads that tools draw to and fro through holes of host surfaces: at up to 0.5 m/s, and in every second life at up to
 * 2 m/s, while the thread is thrown about at up to 20 m/s. Each seed lives five thousand steps, the default number of
 * seeds a million. At the speed of hands a thread crosses its surface in its hole only, but for one step in a
 * hundred, which fast pulls may need to bring a corner through. Steps of the fast lives are counted. */
#include "scene/hole_life.h"

enum { LIVES = 10, STEPS = 500, MAX_IN_A_LIFE = STEPS / 100 };

static void run(harness_soak *out)
{
    static const hole_life_hands drawn = {.speed = 0.5}, thrown = {.speed = 2.0, .thrown = 20.0};
    vbss_random random;
    hole_life_result slow = {0}, fast = {0};
    vbss_random_seed(&random, out->seed, 19);
    for (int i = 0; i < LIVES && out->failures == 0; i++) {
        const bool is_fast = i % 2 == 1;
        const hole_life_result before = slow;
        const vbss_result done =
            hole_life_run(&random, STEPS, is_fast ? &thrown : &drawn, is_fast ? &fast : &slow);
        const uint64_t wrong = slow.several - before.several + slow.far - before.far;
        if (done != VBSS_OK || wrong > MAX_IN_A_LIFE) {
            harness_soak_fail(out, "life %d: %s, %llu steps with a crossing away from the hole", i,
                              vbss_result_name(done), (unsigned long long)wrong);
        }
    }
    harness_soak_figure(out, "steps", (double)(slow.steps + fast.steps));
    harness_soak_figure(out, "slid", slow.slid + fast.slid);
    harness_soak_figure(out, "several", (double)slow.several);
    harness_soak_figure(out, "far", (double)slow.far);
    harness_soak_figure(out, "clamped", (double)slow.clamped);
    harness_soak_figure(out, "fast_several", (double)fast.several);
    harness_soak_figure(out, "fast_far", (double)fast.far);
    harness_soak_figure(out, "fast_clamped", (double)fast.clamped);
}

int main(int argc, char **argv)
{
    return harness_soak_main(argc, argv, run);
}
