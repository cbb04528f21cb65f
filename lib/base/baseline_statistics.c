/* Writes the counters of method VBLAST to the caller. */
#include "base/baseline_statistics.h"
#include "base/config.h"
#include "base/error.h"

_Static_assert(sizeof(vbss_baseline_statistics) == 64, "published size");

static const uint32_t sizes[] = {64, 0};
static const vbss_layout layout = {"vbss_baseline_statistics", NULL, sizes};

vbss_result vbss_baseline_write_statistics(vbss_context *context,
                                           const vbss_baseline_statistics *own,
                                           vbss_baseline_statistics *statistics,
                                           uint32_t struct_size)
{
    if (own == NULL) {
        return vbss_fail(context, VBSS_ERROR_INCOMPATIBLE,
                         "only method VBLAST has statistics of the baseline");
    }
    vbss_baseline_statistics written = *own;
    written.struct_size = sizeof written;
    return vbss_struct_write(context, &layout, &written, statistics, struct_size);
}
