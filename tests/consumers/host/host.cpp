// The smallest host in C++.
#include <vblast_ss/vblast_ss.h>

int main()
{
    vbss_context *context = nullptr;
    if (vbss_version() != VBSS_VERSION_NUM || vbss_context_create(nullptr, &context) != VBSS_OK) {
        return 1;
    }
    return vbss_context_destroy(context) == VBSS_OK ? 0 : 1;
}
