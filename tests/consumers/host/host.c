/* The smallest host: links, creates a context, agrees with its headers about the version. */
#include <stddef.h>

#include <vblast_ss/vblast_ss.h>

int main(void)
{
    vbss_context *context;
    if (vbss_version() != VBSS_VERSION_NUM || vbss_context_create(NULL, &context) != VBSS_OK) {
        return 1;
    }
    return vbss_context_destroy(context) == VBSS_OK ? 0 : 1;
}
