/* task/surgeon: the scripted surgeon of examples/surgeon performs the whole task in its default configuration, once a seed.
 * A step is a call of 1 ms with devices, session and record. The time that the hands need to decide is not part of it. */
#include "against/subject.h"
#include "surgeon/surgeon.h"
#include "surgeon/task.h"

enum { LONGEST = 300000 };

static struct {
    surgeon surgeon;
    task task;
} own;

static vbss_result begin(uint64_t seed)
{
    const surgeon_options options = {
        .seed = seed, .until = SURGEON_DONE, .skill = skill_named("expert")};
    TRY(surgeon_create(&own.surgeon, &options));
    throw_rig *s = &own.surgeon.stitch.site.rig;
    TRY(task_create(&own.task, &own.surgeon.stitch, s->record, NULL));
    s->session = own.task.session;
    return VBSS_OK;
}

static bool goes_on(void)
{
    return own.surgeon.stage < SURGEON_DONE && own.surgeon.steps < LONGEST;
}

static vbss_result step(void)
{
    return surgeon_step(&own.surgeon, SUBJECT_STEP);
}

static double taken(void)
{
    return own.surgeon.stitch.site.rig.took;
}

static bool is_done(void)
{
    vbss_session_status status;
    return vbss_session_get_status(own.task.session, &status, sizeof status) == VBSS_OK &&
           status.phase == VBSS_SESSION_PHASE_DONE;
}

static vbss_result hash(uint64_t *value)
{
    return vbss_scene_get_hash(own.surgeon.stitch.site.rig.scene, value);
}

static vbss_scene *scene(void)
{
    return own.surgeon.stitch.site.rig.scene;
}

static void end(void)
{
    throw_rig_destroy(&own.surgeon.stitch.site.rig);
}

const subject whole_task = {.name = "task/surgeon",
                            .is_seeded = true,
                            .begin = begin,
                            .goes_on = goes_on,
                            .step = step,
                            .taken = taken,
                            .is_done = is_done,
                            .hash = hash,
                            .scene = scene,
                            .end = end};
