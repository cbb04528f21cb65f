/* Names and texts of statuses, and the library's version and build. */
#include <vblast_ss/base.h>

const char *vbss_result_name(vbss_result result)
{
    switch (result) {
#define VBSS_NAME_CASE(name, number, text) \
    case number:                           \
        return #name;
        VBSS_RESULTS(VBSS_NAME_CASE)
    default:
        return "unknown result";
    }
}

const char *vbss_result_string(vbss_result result)
{
    switch (result) {
#define VBSS_TEXT_CASE(name, number, text) \
    case number:                           \
        return text;
        VBSS_RESULTS(VBSS_TEXT_CASE)
    default:
        return "unknown result";
    }
}

uint32_t vbss_version(void)
{
    return VBSS_VERSION_NUM;
}

#define VBSS_TO_TEXT(x) #x
#define VBSS_TEXT(x) VBSS_TO_TEXT(x)
#define VBSS_VERSION_TEXT         \
    VBSS_TEXT(VBSS_VERSION_MAJOR) \
    "." VBSS_TEXT(VBSS_VERSION_MINOR) "." VBSS_TEXT(VBSS_VERSION_PATCH) VBSS_VERSION_SUFFIX

#if defined(__clang__)
#define VBSS_COMPILER "clang " __clang_version__
#elif defined(__GNUC__)
#define VBSS_COMPILER "gcc " __VERSION__
#else
#define VBSS_COMPILER "unknown compiler"
#endif

const char *vbss_build_info(void)
{
    return "libvblast_ss " VBSS_VERSION_TEXT " (" VBSS_BUILD_REVISION "), " VBSS_COMPILER
           ", " VBSS_BUILD_FLAGS;
}
