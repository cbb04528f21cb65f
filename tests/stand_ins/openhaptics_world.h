/* The world behind the stand-in for OpenHaptics: arms with hands, the scheduler, the stack of errors. */
#ifndef VBSS_TESTS_STAND_INS_OPENHAPTICS_WORLD_H
#define VBSS_TESTS_STAND_INS_OPENHAPTICS_WORLD_H

#include <pthread.h>
#include <stdbool.h>

#include "stand_ins/referee.h"
#include "stand_ins/stand_ins.h"

typedef struct hd_error {
    uint32_t code;
    int32_t internal;
    uint32_t device;
} hd_error;
typedef uint32_t(STAND_IN_CALL *hd_callback)(void *user);

#define NO_DEVICE 0xFFFFFFFFu
enum { ERRORS = 32 };
enum {
    INVALID_ENUM = 0x0100,
    INVALID_VALUE = 0x0101,
    INVALID_OPERATION = 0x0102,
    INVALID_INPUT_TYPE = 0x0103,
    BAD_HANDLE = 0x0104,
    WARM_MOTORS = 0x0200,
    EXCEEDED_MAX_FORCE = 0x0201,
    EXCEEDED_MAX_VELOCITY = 0x0203,
    ALREADY_INITIATED = 0x0301,
    COMM_ERROR = 0x0302,
    ILLEGAL_BEGIN = 0x0400,
    ILLEGAL_END = 0x0401,
    FRAME_ERROR = 0x0402,
    INVALID_LICENCE = 0x0600
};

typedef struct haptic_arm {
    bool is_open, in_frame, enabled, faults[STAND_IN_HD_FAULTS];
    uint64_t framed_at; /* tick of the last frame */
    double staged[3];   /* N, until the frame ends */
    stand_in_hand hand;
    int32_t buttons;
    stand_in_arm now;
} arm;

typedef struct hd_world {
    pthread_mutex_t lock;
    referee judge;
    arm arms[STAND_IN_ARMS];
    hd_error errors[ERRORS];
    int error_count;
    uint32_t current;
    hd_callback callback;
    void *user;
    bool threaded, running, in_callback, callback_done;
    unsigned long rate;
    uint64_t tick;
    pthread_t servo, caller; /* caller: of the callback that runs */
    double began;            /* s */
} hd_world;

extern hd_world world;

/* All of the world stands behind one lock. */
void enter(void);
void leave(void);
void push(uint32_t code, uint32_t device);
/* An illegal call: counted, and an error for the caller. */
void refuse(const char *call, const char *why, uint32_t code);
/* Whether the caller is the callback that runs now. */
bool in_servo(void);
/* A tick of the scheduler, or of the hands alone where it stands still. */
void tick_once(void);
/* What the scheduler's thread does. */
void *serve(void *nothing);

#endif
