/* Tuned numbers of lib/device.
 *
 * Each entry gives its unit, and whether it is relative or absolute; its origin: derived, fitted, chosen or
 * published; and its test: the scenes of determinism.golden that fail when it is halved or doubled, among the
 * five of the bench tuning (docs/notebook/tuning.md).
 * Absolute numbers stay absolute: a value relative to thread, step or mass would change the bits of scenes
 * whose threads or steps are not the defaults. */
#ifndef VBSS_DEVICE_TUNING_H
#define VBSS_DEVICE_TUNING_H

#include "base/tune.h"

/* ---- Samples (sample_check.c, motion.c) */

/* A sample that is newer by less is not a new one.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define DEVICE_MIN_SAMPLE_SPACING VBSS_TUNE(DEVICE_MIN_SAMPLE_SPACING, 1e-6)
/* The clock of an adapter has restarted when all its samples are old for this time.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define DEVICE_CLOCK_RESTART_TIME VBSS_TUNE(DEVICE_CLOCK_RESTART_TIME, 0.1)
/* A sample of a shared clock is at most this far ahead.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define DEVICE_MAX_CLOCK_LEAD VBSS_TUNE(DEVICE_MAX_CLOCK_LEAD, 0.1)

/* The host's clock has jumped, or the host was stopped, when two writes are this far apart.
 * Unit: s, absolute. Origin: chosen. Test: device.hardware_table. */
#define DEVICE_CLOCK_JUMP VBSS_TUNE(DEVICE_CLOCK_JUMP, 0.1)

/* ---- Output (output_limiter.c, solenoid.c) */

/* Longest time for which a force may rise in one step.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define DEVICE_MAX_RISE_TIME VBSS_TUNE(DEVICE_MAX_RISE_TIME, 0.01)
/* Forces are reduced from this load on.
 * Unit: 1, relative to the continuous load. Origin: chosen. Test: none known. */
#define DEVICE_LOAD_KNEE VBSS_TUNE(DEVICE_LOAD_KNEE, 0.75)

/* ---- OpenHaptics (openhaptics.c, openhaptics_servo.c) */

/* Longest wait for the servo to stop.
 * Unit: ms. Origin: chosen. Test: none known. */
#define DEVICE_SERVO_STOP_TIME VBSS_TUNE(DEVICE_SERVO_STOP_TIME, 200)
/* Ticks between two polls of slowly changing values.
 * Unit: ticks of the servo. Origin: chosen. Test: none known. */
#define DEVICE_SLOW_POLL_TICKS VBSS_TUNE(DEVICE_SLOW_POLL_TICKS, 100)
/* A failing arm is lost for at least this time.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define DEVICE_LOST_TIME VBSS_TUNE(DEVICE_LOST_TIME, 0.1)
/* An arm that refuses forces gets none for this time.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define DEVICE_REFUSED_TIME VBSS_TUNE(DEVICE_REFUSED_TIME, 1.0)
/* An arm whose pose has not changed by a bit for this time counts as not calibrated.
 * Unit: s, absolute. Origin: chosen, longer than a period of tremor. Test: device.hardware_table. */
#define DEVICE_CONSTANT_POSE_TIME VBSS_TUNE(DEVICE_CONSTANT_POSE_TIME, 1.0)

/* ---- NI-DAQmx (nidaqmx_recovery.c) */

/* First timeout of a call, if the library chooses it.
 * Unit: s, absolute. Origin: chosen, for a round within 10 ms. Test: device.hardware_table. */
#define DEVICE_DAQ_FIRST_TIMEOUT VBSS_TUNE(DEVICE_DAQ_FIRST_TIMEOUT, 0.004)
/* Longest timeout of a call, if the library chooses it.
 * Unit: s, absolute. Origin: chosen, above the slowest devices known (24 ms). Test: device.hardware_table. */
#define DEVICE_DAQ_LONGEST_TIMEOUT VBSS_TUNE(DEVICE_DAQ_LONGEST_TIMEOUT, 0.064)
/* Quick calls in a row after which the timeout is shortened.
 * Unit: calls. Origin: chosen. Test: none known. */
#define DEVICE_DAQ_QUICK_CALLS VBSS_TUNE(DEVICE_DAQ_QUICK_CALLS, 1000)
/* Time between two attempts to open the lines again.
 * Unit: s, absolute. Origin: chosen. Test: none known. */
#define DEVICE_DAQ_REOPEN_INTERVAL VBSS_TUNE(DEVICE_DAQ_REOPEN_INTERVAL, 0.05)
/* A device that cannot be opened again for this time is lost.
 * Unit: s, absolute. Origin: chosen, for a device that enumerates again. Test: device.hardware_table. */
#define DEVICE_DAQ_GRACE_TIME VBSS_TUNE(DEVICE_DAQ_GRACE_TIME, 1.0)
/* Slow lines are fast again when their rounds are shorter than this part of the limit.
 * Unit: 1, relative. Origin: chosen. Test: none known. */
#define DEVICE_DAQ_RATE_HYSTERESIS VBSS_TUNE(DEVICE_DAQ_RATE_HYSTERESIS, 0.8)

/* ---- Handles (takeover.c) */

/* A handle that is this near takes over the jaws: two steps of an 11-bit converter.
 * Unit: 1, relative to the range of the handle. Origin: chosen. Test: device.takeover. */
#define DEVICE_TAKEOVER_DISTANCE VBSS_TUNE(DEVICE_TAKEOVER_DISTANCE, 0.04)

#endif
