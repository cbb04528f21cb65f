#include "trainer/led.h"

#include <stdio.h>
#include <string.h>

#include "trainer/task.h"

/* A metre of the arm is two of the world, so that 22 cm of the task are in the 16 of an arm. */
static vbss_result calibrate(calibration *c)
{
    TRY(calibration_init(c));
    for (int side = 0; side < HANDS; side++) {
        vbss_device_calibration *one = &c->hands[side];
        one->scale = 2.0;
        one->offset[2] = 0.05;
        one->jaw_closed = 0.6;
        one->jaw_open = 1.2;
    }
    return VBSS_OK;
}

/* What is tied may come undone again. */
static uint32_t count_throws(vbss_session *session, const vbss_session_status *status)
{
    uint32_t largest = 0;
    for (uint64_t i = status->first_event; i < status->event_count; i++) {
        vbss_session_event e;
        if (vbss_session_get_event(session, i, &e, sizeof e) == VBSS_OK &&
            e.kind == VBSS_SESSION_EVENT_THROW && e.undone == 0 && e.number >= largest) {
            largest = e.number + 1;
        }
    }
    return largest;
}

static uint32_t count_shears(const stage *s)
{
    uint32_t count = 0;
    for (int side = 0; side < HANDS; side++) {
        vbss_grasper_state tool;
        count += vbss_grasper_get_state(s->tools[side], &tool, sizeof tool) == VBSS_OK &&
                 tool.kind == VBSS_GRASPER_KIND_SHEARS;
    }
    return count;
}

static bool train(const options *o, const calibration *c, const score *log, led *found, char *why,
                  size_t bytes)
{
    static task t;
    const char *first;
    memset(&t, 0, sizeof t);
    t.options = o;
    t.calibration = c;
    t.duration = log->duration;
    t.times = found->times;
    t.time_count = LED_SLOTS;
    bool good = stage_create(&t.stage, stage_find(o->scene), log->seed, NULL) == VBSS_OK;
    rehearsal_find(&t.rehearsal, o);
    rehearsal_begin(&t.rehearsal, true);
    good = good && hardware_open(&t.hardware, o, c, &t.stage, log, why, bytes);
    if (good) {
        task_init(&t);
        (void)task_run(&t);
        good = vbss_session_get_status(t.stage.session, &found->status, sizeof found->status) ==
               VBSS_OK;
        found->tied = count_throws(t.stage.session, &found->status);
        found->shears = count_shears(&t.stage);
        hardware_close(&t.hardware);
    }
    found->now = t.now;
    found->illegal = rehearsal_illegal(&t.rehearsal, &first);
    snprintf(found->first, sizeof found->first, "%s", first);
    stage_destroy(&t.stage);
    rehearsal_end(&t.rehearsal);
    return good;
}

bool led_run(const char *log, led *found, char *why, size_t bytes)
{
    char *words[] = {
        "trainer", "--openhaptics",   "--openhaptics-library", VBSS_STAND_IN_OPENHAPTICS,
        "--nidaq", "--nidaq-library", VBSS_STAND_IN_NIDAQMX,   "--simulated",
        "--scene", "surgeon"};
    options o;
    calibration c;
    score s;
    if (!options_read(sizeof words / sizeof *words, words, &o, why, bytes) ||
        !score_read(&s, log, why, bytes)) {
        return false;
    }
    snprintf(why, bytes, "the trainer does not run");
    bool good = calibrate(&c) == VBSS_OK && train(&o, &c, &s, found, why, bytes);
    score_free(&s);
    return good;
}
