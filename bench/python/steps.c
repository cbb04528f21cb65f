/* What measure.py does, without Python: steps of a scene, ns of processor time each. usage: steps SEGMENTS STEPS */
#define _POSIX_C_SOURCE 200809L

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <vblast_ss/vblast_ss.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static vbss_result add_thread(vbss_context *context, vbss_scene *scene, uint32_t segments)
{
    vbss_thread_config config;
    vbss_thread_attachment pin;
    vbss_thread *thread;
    uint32_t name;
    vbss_result r = vbss_thread_config_init(&config, sizeof config);
    config.segment_count = segments;
    r = r ? r : vbss_thread_create(context, &config, &thread);
    r = r ? r : vbss_thread_attachment_init(&pin, sizeof pin);
    r = r ? r : vbss_thread_attach(thread, &pin, &name);
    return r ? r : vbss_scene_add_thread(scene, thread, &name);
}

int main(int count, char **words)
{
    (void)setlocale(LC_NUMERIC, "C"); /* numbers with a decimal point */
    if (count != 3) {
        return 2;
    }
    uint32_t segments = (uint32_t)atoi(words[1]);
    int steps = atoi(words[2]);
    vbss_context *context;
    vbss_scene *scene;
    uint64_t hash = 0;
    vbss_result r = vbss_context_create(NULL, &context);
    r = r ? r : vbss_scene_create(context, NULL, &scene);
    r = r || segments == 0 ? r : add_thread(context, scene, segments);
    double begin = now();
    for (int i = 0; i < steps && r == VBSS_OK; i++) {
        r = vbss_scene_step(scene, 1e-3);
    }
    double end = now();
    r = r ? r : vbss_scene_get_hash(scene, &hash);
    printf("%.17g %llu\n", 1e9 * (end - begin) / steps, (unsigned long long)hash);
    return r != VBSS_OK || vbss_context_destroy(context) != VBSS_OK;
}
