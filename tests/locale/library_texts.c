/* Prints a number as the locale has it, then texts of the library about numbers. */
#include <stdio.h>

#include <vblast_ss/vblast_ss.h>

static void show(vbss_context *context, const char *call)
{
    const char *text;
    if (vbss_context_get_last_error(context, NULL, &text) == VBSS_OK) {
        printf("%s: %s\n", call, text);
    }
}

int main(void)
{
    vbss_context *context;
    vbss_thread_config thread;
    vbss_thread *made;
    vbss_metrics *metrics;
    vbss_metrics_sample sample;
    printf("%g\n", 0.5);
    if (vbss_context_create(NULL, &context) != VBSS_OK ||
        vbss_thread_config_init(&thread, sizeof thread) != VBSS_OK ||
        vbss_metrics_create(context, NULL, &metrics) != VBSS_OK ||
        vbss_metrics_sample_init(&sample, sizeof sample) != VBSS_OK) {
        return 1;
    }
    thread.radius = -0.0625;
    (void)vbss_thread_create(context, &thread, &made);
    show(context, "radius");
    sample.time = 2.5;
    (void)vbss_metrics_add_sample(metrics, &sample);
    sample.time = 1.75;
    (void)vbss_metrics_add_sample(metrics, &sample);
    show(context, "time");
    return vbss_context_destroy(context) == VBSS_OK ? 0 : 1;
}
