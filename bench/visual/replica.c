/* What the stepping thread pays for a renderer in another thread. The scene has a thread with a double throw that is drawn tight, a
 * drain, a needle and two tools. The budget is 60 us.
 *   memcpy   of as many bytes as a publication copies, in one block
 *   publish  vbss_replica_publish */
#include <string.h>

#include <vblast_ss/replica.h>

#include "base/error.h"
#include "bench_visual.h"
#include "fixtures/session_scenes.h"

enum { STEPS = 200, CROSSINGS = 5 };
#define BUDGET_US 60.0

/* One case runs at a time. */
static vbss_context *context;
static session_scene task;
static vbss_replica *replica;
static vbss_replica_state taken;
static unsigned char block[2][1u << 20]; /* larger than a publication */

static void end_case(void *user)
{
    (void)user;
    (void)vbss_context_destroy(context);
    context = NULL;
}

static vbss_result make_case(void)
{
    VBSS_TRY(vbss_context_create(NULL, &context));
    VBSS_TRY(session_scene_tying(context, CROSSINGS, &task));
    return vbss_replica_create(task.scene, NULL, &replica);
}

static int begin_case(void *user)
{
    end_case(user);
    return (int)make_case();
}

/* A step, as it evicts what a publication reads. */
static int move_on(void *user, uint32_t index)
{
    (void)user;
    return (int)stitch_scene_tie(&task.stitch, index, SESSION_SCENE_STEP);
}

static int publish(void *user, uint32_t index)
{
    (void)user;
    (void)index;
    return (int)vbss_replica_publish(replica, task.scene);
}

static int copy(void *user, uint32_t index)
{
    (void)user;
    (void)index;
    memcpy(block[1], block[0], (size_t)taken.bytes);
    return 0;
}

/* Takes every state. The copies are as long as the publication after the step. */
static int publish_before(void *user, uint32_t index)
{
    VBSS_TRY(move_on(user, index));
    VBSS_TRY(publish(user, index));
    VBSS_TRY(vbss_replica_take(replica, &taken, sizeof taken));
    return taken.bytes <= sizeof block[0] ? 0 : (int)VBSS_ERROR_CAPACITY;
}

static int take(void *user, uint32_t index)
{
    (void)user;
    (void)index;
    return (int)vbss_replica_take(replica, &taken, sizeof taken);
}

static uint64_t hash_case(void *user)
{
    uint64_t hash;
    (void)user;
    return vbss_scene_get_hash(task.scene, &hash) == VBSS_OK ? hash : 0;
}

static void report(void *user, bench_result *result)
{
    (void)user;
    bench_counter(result, "kilobytes", 1e-3 * (double)taken.bytes);
}

void add_replica_cases(bench *b)
{
    const bench_stepped cases[2] = {{.name = "visual/replica/memcpy",
                                     .steps = STEPS,
                                     .deadline_us = BUDGET_US,
                                     .restore = begin_case,
                                     .before = publish_before,
                                     .step = copy,
                                     .hash = hash_case,
                                     .finish = report,
                                     .teardown = end_case},
                                    {.name = "visual/replica/publish",
                                     .steps = STEPS,
                                     .deadline_us = BUDGET_US,
                                     .restore = begin_case,
                                     .before = move_on,
                                     .step = publish,
                                     .after = take,
                                     .hash = hash_case,
                                     .finish = report,
                                     .teardown = end_case}};
    for (int i = 0; i < 2; i++) {
        bench_add_stepped(b, &cases[i]);
    }
}
