/* The task: what happens in each slot of 1 ms, in a thread of its own. Hands are read, tools told, the scene stepped, and
 * what the tools feel is handed to the servo as a coupling, before the slot is over. */
#ifndef VBSS_EXAMPLES_TRAINER_TASK_H
#define VBSS_EXAMPLES_TRAINER_TASK_H

#include "trainer/figures.h"
#include "trainer/grip.h"
#include "trainer/hardware.h"
#include "trainer/step_clock.h"
#include "trainer/rehearsal.h"

typedef struct task_hand {
    grip grip;
    uint32_t wanted, on;    /* solenoid, in the last slot */
    vbss_grasper_kind kind; /* which tool a stand-in's hand has asked for, */
    double pressed;         /* when it pressed its button for that, s */
    double noted[16];       /* when an event of that bit was told last, s */
} task_hand;

typedef struct task {
    const options *options;
    const calibration *calibration;
    char limits[CORE_SPEED_WORDS]; /* what the report says of the limits of work; may be empty */
    double duration;               /* s; below 0: no end */
    double clock; /* of the devices, s: real time, which goes on where slots are missed */
    stage stage;
    hardware hardware;
    rehearsal rehearsal;
    step_clock step_clock;
    task_hand hands[HANDS];
    figures now;
    double *times; /* thread CPU time of each slot, s, for whoever measures; NULL: nobody does */
    size_t time_count; /* room for so many */
    exchange shown;
    double stopped_since; /* s; below 0: it is not */
    bool failed;          /* the scene */
    atomic_bool end;      /* somebody wants it to; */
    atomic_bool ended;    /* it has */
} task;

void task_init(task *t);
/* As pthread_create wants it. */
void *task_run(void *t);

/* ---- watch.c: faults that are caused, and events that are told */

/* Before the slot's work: moves the stand-ins' hands, begins and ends faults, lets their clock tick. */
vbss_result task_rehearse(task *t);
/* The step of the clock that a fault has caused, s. */
double task_clock_step(const task *t);
/* After it: whether what was to be safe is. */
void task_judge(task *t);
/* What a read has found. */
void task_report(task *t, int side, const vbss_device_input *in);

#endif
