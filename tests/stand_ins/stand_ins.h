/* Stand-ins for the libraries of vendors: the same symbols, the documented behaviour, a simulated hand, faults on demand,
 * and a referee who counts every illegal call. Built as shared libraries, which the adapters load in place of the real ones.
 *
 * A test gets at the world behind them by one function each, `stand_in_hd` and `stand_in_daq`, which return a table. */
#ifndef VBSS_TESTS_STAND_INS_H
#define VBSS_TESTS_STAND_INS_H

#include <stdint.h>

#ifdef _WIN32
#define STAND_IN_API __declspec(dllexport)
#define STAND_IN_CALL __stdcall
#else
#define STAND_IN_API __attribute__((visibility("default")))
#define STAND_IN_CALL
#endif

/* ---- haptic arms: "Left" (also the default) and "Device2" */

enum { STAND_IN_ARMS = 2 };

typedef enum stand_in_hd_fault {
    STAND_IN_UNPLUGGED,    /* every frame: communication failed */
    STAND_IN_COMM_ERROR,   /* the next frame only */
    STAND_IN_NAN_POSE,     /* a NaN in the transform */
    STAND_IN_WARM,         /* hot motors: the error with every frame, no force */
    STAND_IN_TOO_FAST,     /* the next frame only: velocity error */
    STAND_IN_UNCALIBRATED, /* needs the inkwell */
    STAND_IN_STALLED,      /* the servo does not tick, for all arms */
    STAND_IN_NO_LICENCE,   /* the scheduler does not start */
    STAND_IN_CONSTANT,     /* the same pose to the bit, though the arm counts as calibrated */
    STAND_IN_NO_DEFAULT,   /* there is no default device, but one called "Default PHANToM" */
    STAND_IN_HD_FAULTS
} stand_in_hd_fault;

/* A hand on an arm: a mass on a spring and a damper to where it wants to be. The gimbal has no motors, so how it is turned
 * is the hand's alone: the angle to `turn` that is left falls as exp(-t / wrist). SI units. */
typedef struct stand_in_hand {
    double mass, stiffness, damping;
    double target[3];
    double turn[4]; /* w, x, y, z, unit: how it wants the stylus to be turned; all 0: as it is */
    double wrist;   /* s; 0: at once */
} stand_in_hand;

typedef struct stand_in_arm {
    double position[3], velocity[3];
    double turn[4], spin[3]; /* of the stylus: w, x, y, z, unit; rad/s, in the arm's frame */
    double force[3];         /* that the motors put out now, N */
    double work;             /* done by the motors on the hand so far, J */
    double cpu_worst;        /* longest callback, s of its thread */
    uint64_t ticks;
} stand_in_arm;

typedef struct stand_in_hd_table {
    /* Everything as after loading. `threaded`: the scheduler ticks in a thread of its own at its rate; else by `tick`. */
    void (*reset)(int threaded);
    void (*tick)(int count);
    void (*set_fault)(int arm, stand_in_hd_fault fault, int on);
    void (*set_hand)(int arm, const stand_in_hand *hand);
    /* Where the hand is, at rest, and how it is turned; NULL: as it was. */
    void (*place)(int arm, const double position[3], const double *turn);
    /* Bits of the buttons that are held. At first one is stuck: 1 of the first arm, 2 of the second. */
    void (*press)(int arm, int buttons);
    void (*get_state)(int arm, stand_in_arm *arm_now);
    /* Illegal calls so far, and the first of them. What is left open counts. */
    int (*illegal)(const char **first);
} stand_in_hd_table;

STAND_IN_API const stand_in_hd_table *stand_in_hd(void);

/* ---- lines: device "Dev1", a USB-6008; built a second time with the names of NI-DAQmx Base */

enum { STAND_IN_INPUTS = 8, STAND_IN_LINES = 8 };

typedef enum stand_in_daq_fault {
    STAND_IN_READ_TIMEOUT,
    STAND_IN_WRITE_TIMEOUT,
    STAND_IN_REMOVED, /* all calls fail, and nobody drives the lines */
    STAND_IN_RESERVED,
    STAND_IN_WARNING, /* reads succeed with a warning */
    STAND_IN_UNKNOWN, /* the driver knows no device */
    STAND_IN_DAQ_FAULTS
} stand_in_daq_fault;

typedef struct stand_in_daq_table {
    void (*reset)(void);
    void (*set_fault)(stand_in_daq_fault fault, int on);
    void (*set_volts)(int input, double volts);
    /* The next `count` reads, or writes, end with `code`; -1: all of them until their task is created again. */
    void (*set_code)(int is_write, int32_t code, int count);
    /* Each read and write takes so long, s, and times out if it may not. `sleeps`: in real time. */
    void (*set_call_time)(double seconds, int sleeps);
    /* Simulated time that calls have taken since it was asked last, s. */
    double (*waited)(void);
    /* 0, or 1 also where nobody drives the line. */
    int (*level)(int line);
    uint64_t (*reads)(void);
    uint64_t (*writes)(void);
    /* Whether reads and writes from the calling thread are illegal. */
    void (*forbid_this_thread)(int yes);
    int (*illegal)(const char **first);
} stand_in_daq_table;

STAND_IN_API const stand_in_daq_table *stand_in_daq(void);

#endif
