#include "determinism/performance.h"

#include <string.h>

#include "surgeon/surgeon.h"
#include "surgeon/task.h"

#define STEP 1e-3 /* s */

/* Too large for a stack. */
typedef struct performance {
    surgeon surgeon;
    task task;
} performance;

static vbss_result begin(performance *p, uint64_t seed)
{
    const surgeon_options o = {.seed = seed, .until = SURGEON_DONE};
    throw_rig *place = &p->surgeon.stitch.site.rig;
    TRY(surgeon_create(&p->surgeon, &o));
    TRY(task_create(&p->task, &p->surgeon.stitch, place->record, NULL));
    place->session = p->task.session;
    return VBSS_OK;
}

static vbss_result hash_of(const performance *p, uint64_t *hash)
{
    uint64_t scene, session;
    TRY(vbss_scene_get_hash(p->surgeon.stitch.site.rig.scene, &scene));
    TRY(vbss_session_get_hash(p->task.session, &session));
    *hash = 31 * scene + session;
    return VBSS_OK;
}

static vbss_result perform(performance *p, uint32_t every, uint64_t *hashes, size_t limit,
                           size_t *count)
{
    for (uint32_t steps = 1; *count < limit; steps++) {
        TRY(surgeon_step(&p->surgeon, STEP));
        bool over = p->surgeon.stage >= SURGEON_DONE;
        if (over || steps % every == 0) {
            TRY(hash_of(p, &hashes[*count]));
            ++*count;
        }
        if (over) {
            break;
        }
    }
    return VBSS_OK;
}

vbss_result performance_run(uint64_t seed, uint32_t every, uint64_t *hashes, size_t limit,
                            size_t *count)
{
    static performance p;
    memset(&p, 0, sizeof p);
    *count = 0;
    vbss_result result = begin(&p, seed);
    if (result == VBSS_OK) {
        result = perform(&p, every, hashes, limit, count);
    }
    throw_rig_destroy(&p.surgeon.stitch.site.rig);
    return result;
}
