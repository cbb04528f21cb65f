/* A thread, clamped at its first node, falls for a tenth of a second. */
#include <stdio.h>

#include <vblast_ss/vblast_ss.h>

int main(void)
{
    vbss_context *context = NULL;
    vbss_thread *thread = NULL;
    vbss_thread_attachment clamp;
    uint32_t id;
    vbss_result result = vbss_context_create(NULL, &context);
    result = result ? result : vbss_thread_create(context, NULL, &thread);
    result = result ? result : vbss_thread_attachment_init(&clamp, sizeof clamp);
    clamp.kind = VBSS_THREAD_ATTACHMENT_CLAMP;
    result = result ? result : vbss_thread_attach(thread, &clamp, &id);
    for (int i = 0; i < 100 && result == VBSS_OK; i++) {
        result = vbss_thread_step(thread, 1e-3);
    }
    printf("%s: %s\n", vbss_build_info(), vbss_result_string(result));
    return result == VBSS_OK && vbss_context_destroy(context) == VBSS_OK ? 0 : 1;
}
