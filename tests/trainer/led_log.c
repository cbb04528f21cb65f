#include "trainer/led.h"

#include "surgeon/surgeon.h"

#define STEP 1e-3
#define LONGEST 120.0 /* s */

static vbss_result perform(uint64_t seed, const char *path)
{
    static surgeon s;
    const surgeon_options o = {.seed = seed, .until = SURGEON_DONE, .log = path};
    TRY(surgeon_create(&s, &o));
    throw_rig *rig = &s.stitch.site.rig;
    while (s.stage < SURGEON_DONE && rig->time < LONGEST) {
        TRY(surgeon_step(&s, STEP));
    }
    TRY(throw_rig_end(rig));
    throw_rig_destroy(rig);
    return VBSS_OK;
}

bool led_write_log(uint64_t seed, const char *path)
{
    return perform(seed, path) == VBSS_OK;
}
