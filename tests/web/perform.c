#include "perform.h"

#include <string.h>

#include "surgeon/surgeon.h"
#include "web/session.h"

#define STEP 1e-3

enum { STITCH = 2, WANTED = 10 };

static surgeon performer;

/* The hands have been told; the tools go where their controllers are. */
static vbss_result step_live(void *user, double dt)
{
    (void)dt;
    return live_step(user);
}

static vbss_result perform(void)
{
    return performer.stage < SURGEON_DONE ? surgeon_step(&performer, STEP)
                                          : live_step(&page_get()->live);
}

static vbss_result make(page_session *p, uint32_t seed)
{
    static throw_rig_host host;
    task k;
    const surgeon_options options = {.seed = seed, .until = SURGEON_DONE, .log = PAGE_LOG};
    throw_rig *rig = &performer.stitch.site.rig;
    TRY(surgeon_create(&performer, &options));
    TRY(task_create(&k, &performer.stitch, rig->record, NULL));
    rig->session = k.session;
    host = (throw_rig_host){.step = step_live, .user = &p->live};
    rig->host = &host;
    p->script = perform;
    return live_take_over(&p->live, live_at(STITCH), tracked_arms(), &performer.stitch, &k);
}

int32_t page_perform(uint32_t seed)
{
    page_session *p = page_get();
    page_clear(p);
    return page_complete(p, make(p, seed));
}

const double *page_wanted(int32_t side)
{
    static double wanted[WANTED];
    const hand *h = side == RIGHT ? &performer.stitch.right : &performer.stitch.left;
    v_store(wanted, h->shown);
    memcpy(wanted + 3, h->shown_orientation, sizeof h->shown_orientation);
    wanted[7] = h->opening;
    wanted[8] = h->tool == VBSS_DEVICE_TOOL_SHEARS ? 1.0 : 0.0;
    wanted[9] = performer.stage >= SURGEON_DONE ? 1.0 : 0.0;
    return wanted;
}

const char *page_doing(void)
{
    return performer.stage == SURGEON_FAILED ? performer.why : surgeon_doing(&performer);
}
